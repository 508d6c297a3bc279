// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers of any length, for the few signs that rounding leaves open.
 */
#ifndef hexsweep_Expansion_h
#define hexsweep_Expansion_h

#include <vector>

namespace hexsweep
{
/**
 * An exact number: the sum of doubles that do not overlap.
 *
 * Section 2 of J. R. Shewchuk (\cite Shewchuk1997): grow-expansion, and compression after every
 * operation, so that the number of terms stays near the number of digits over 53. Sums, differences
 * and products are exact as long as no term of them overflows or underflows.
 */
class Expansion
{
public:
  Expansion() = default;
  Expansion(double value); // NOLINT(google-explicit-constructor): a double is an expansion

  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b);
  friend Expansion operator*(const Expansion& a, const Expansion& b);

  /// The value rounded; the sign is exact, zero only for zero.
  friend double toDouble(const Expansion& value);

private:
  void grow(double term);
  void compress();

  /// Of rising magnitude, none of them zero.
  std::vector<double> Terms;
};
}

#endif
