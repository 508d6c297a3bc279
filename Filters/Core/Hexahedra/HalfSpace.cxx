// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HalfSpace.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
namespace
{
using Vector = Eigen::RowVector3d;

constexpr double Rounding = 1e-14;

class HalfSpaceSearch
{
public:
  HalfSpaceSearch(const PointsRef& vectors, const Vector& preferred)
    : Units(vectors.rows(), 3)
    , Preferred(preferred)
    , Inside(static_cast<std::size_t>(vectors.rows()), false)
  {
    for (Index i = 0; i < this->Units.rows(); ++i)
    {
      this->Units.row(i) = vectors.row(i).stableNormalized();
    }
  }

  /// @param normal of any length: towards the inside.
  void look(const Vector& normal)
  {
    const double length = normal.norm();
    if (!(length > 0.0))
    {
      return;
    }
    const Vector direction = normal / length;
    const Eigen::VectorXd products = this->Units * direction.transpose();
    const Index count = (products.array() > Rounding).count();
    const double worth = direction.dot(this->Preferred);
    if (count > this->Count || (count == this->Count && worth > this->Worth))
    {
      this->Count = count;
      this->Worth = worth;
      for (std::size_t i = 0; i < this->Inside.size(); ++i)
      {
        this->Inside[i] = products[static_cast<Index>(i)] > Rounding;
      }
    }
  }

  std::vector<bool> search() &&
  {
    const Index k = this->Units.rows();
    this->look(this->Preferred);
    if (this->Count == k) // the rule: nothing holds more
    {
      return std::move(this->Inside);
    }
    for (Index a = 0; a < k; ++a)
    {
      const Vector u = this->Units.row(a);
      this->look(u);
      for (Index b = a + 1; b < k; ++b)
      {
        const Vector v = this->Units.row(b);
        this->look(u + v);
        for (Index c = b + 1; c < k; ++c)
        {
          const Vector axis = (v - u).cross(this->Units.row(c) - u);
          this->look(axis.dot(u) < 0.0 ? Vector(-axis) : axis);
        }
      }
    }
    return std::move(this->Inside);
  }

private:
  Points Units;
  Vector Preferred;
  std::vector<bool> Inside;
  Index Count = 0;
  double Worth = 0.0;
};
}

std::vector<bool> largestHalfSpace(
  const PointsRef& vectors, const Eigen::Ref<const Eigen::RowVector3d>& preferred)
{
  return HalfSpaceSearch(vectors, preferred).search();
}
}
