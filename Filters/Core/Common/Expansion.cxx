// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Expansion.h"

#include "Core/Common/ErrorFree.h"

namespace hexsweep
{
Expansion::Expansion(double value)
{
  if (value != 0.0)
  {
    this->Terms.push_back(value);
  }
}

void Expansion::grow(double term)
{
  std::size_t kept = 0;
  for (const double own : this->Terms)
  {
    const TwoTerms sum = exactSum(term, own);
    term = sum.high;
    if (sum.low != 0.0)
    {
      this->Terms[kept++] = sum.low;
    }
  }
  this->Terms.resize(kept);
  if (term != 0.0)
  {
    this->Terms.push_back(term);
  }
}

void Expansion::compress()
{
  if (this->Terms.size() < 2)
  {
    return;
  }
  // Downwards, so that each term takes in what it can of the next smaller one ...
  std::vector<double> falling;
  double carried = this->Terms.back();
  for (std::size_t i = this->Terms.size() - 1; i-- > 0;)
  {
    const TwoTerms sum = exactSum(carried, this->Terms[i]);
    carried = sum.high;
    if (sum.low != 0.0)
    {
      falling.push_back(sum.high);
      carried = sum.low;
    }
  }
  // ... and up again, so that the largest one is the value rounded.
  this->Terms.clear();
  for (std::size_t i = falling.size(); i-- > 0;)
  {
    const TwoTerms sum = exactSum(falling[i], carried);
    carried = sum.high;
    if (sum.low != 0.0)
    {
      this->Terms.push_back(sum.low);
    }
  }
  if (carried != 0.0)
  {
    this->Terms.push_back(carried);
  }
}

Expansion operator+(const Expansion& a, const Expansion& b)
{
  Expansion sum = a;
  for (const double term : b.Terms)
  {
    sum.grow(term);
  }
  sum.compress();
  return sum;
}

Expansion operator-(const Expansion& a, const Expansion& b)
{
  Expansion difference = a;
  for (const double term : b.Terms)
  {
    difference.grow(-term);
  }
  difference.compress();
  return difference;
}

Expansion operator*(const Expansion& a, const Expansion& b)
{
  Expansion product;
  for (const double left : a.Terms)
  {
    for (const double right : b.Terms)
    {
      const TwoTerms terms = exactProduct(left, right);
      product.grow(terms.low);
      product.grow(terms.high);
    }
  }
  product.compress();
  return product;
}

double toDouble(const Expansion& value)
{
  double sum = 0.0;
  for (const double term : value.Terms)
  {
    sum += term;
  }
  return sum;
}
}
