// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Predicates.h"

#include "Core/Common/ErrorFree.h"

#include <array>

namespace hexsweep
{
namespace
{
/// A sum of doubles that do not overlap, smallest first; grows one exact term at a time.
class ProductSum
{
public:
  void add(double term)
  {
    for (int i = 0; i < this->Size; ++i)
    {
      const TwoTerms sum = exactSum(term, this->Terms[static_cast<std::size_t>(i)]);
      this->Terms[static_cast<std::size_t>(i)] = sum.low;
      term = sum.high;
    }
    this->Terms[static_cast<std::size_t>(this->Size++)] = term;
  }
  int sign() const
  {
    // The largest nonzero component outweighs all smaller ones together.
    for (int i = this->Size - 1; i >= 0; --i)
    {
      const double term = this->Terms[static_cast<std::size_t>(i)];
      if (term != 0.0)
      {
        return term > 0.0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  std::array<double, 12> Terms{};
  int Size = 0;
};
}

int exactOrientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  ProductSum exact;
  const auto addProduct = [&exact](double u, double v) {
    const TwoTerms product = exactProduct(u, v);
    exact.add(product.low);
    exact.add(product.high);
  };
  addProduct(a.x(), b.y());
  addProduct(-a.x(), c.y());
  addProduct(-c.x(), b.y());
  addProduct(-a.y(), b.x());
  addProduct(a.y(), c.x());
  addProduct(c.y(), b.x());
  return exact.sign();
}
}
