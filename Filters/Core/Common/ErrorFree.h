// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums and products of two doubles without rounding error.
 *
 * After T. J. Dekker \cite Dekker1971 and D. E. Knuth (\cite Knuth1997, section 4.2.2). Exact as
 * long as nothing overflows, and products do not underflow either.
 */
#ifndef hexsweep_ErrorFree_h
#define hexsweep_ErrorFree_h

#include <cmath>

namespace hexsweep
{
/// The exact value is high + low; high is that value rounded to double.
struct TwoTerms
{
  double high;
  double low;
};

inline TwoTerms exactSum(double a, double b)
{
  const double sum = a + b;
  const double virtualB = sum - a;
  const double virtualA = sum - virtualB;
  return { sum, (a - virtualA) + (b - virtualB) };
}

inline TwoTerms exactProduct(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}
}

#endif
