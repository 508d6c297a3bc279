// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vector register as a number; for HexKernelsBody.h only.
 */
#ifndef hexsweep_HexKernelsLanes_h
#define hexsweep_HexKernelsLanes_h

#include "Core/Hexahedra/BezierHex.h"
#include "Core/Hexahedra/HexKernels.h"

#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace hexsweep
{
namespace
{
#if defined(__GNUC__)
#if defined(__AVX__)
constexpr int Width = 4;
#else
constexpr int Width = 2; // the lanes that every x86-64 and ARMv8 processor has
#endif
using Register = double __attribute__((vector_size(Width * sizeof(double))));
#else
constexpr int Width = 1;
struct Register
{
  double value;
  double& operator[](int) { return this->value; }
  double operator[](int) const { return this->value; }
  friend Register operator+(Register a, Register b) { return { a.value + b.value }; }
  friend Register operator-(Register a, Register b) { return { a.value - b.value }; }
  friend Register operator*(Register a, Register b) { return { a.value * b.value }; }
  friend Register operator/(Register a, Register b) { return { a.value / b.value }; }
  friend Register operator-(Register a) { return { -a.value }; }
  friend bool operator<(Register a, Register b) { return a.value < b.value; }
  friend bool operator>(Register a, Register b) { return a.value > b.value; }
};
#endif
static_assert(HexLanesSize % Width == 0, "batches are whole registers");

/// A type of this file alone, so that no template of it is shared with another file.
struct Lanes
{
  Register v;

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return { a.v + b.v }; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return { a.v - b.v }; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return { a.v * b.v }; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return { a.v / b.v }; }
  friend Lanes operator-(const Lanes& a) { return { -a.v }; }
  friend Lanes operator*(double a, const Lanes& b);
};

inline Lanes spread(double value)
{
  Lanes result;
  for (int i = 0; i < Width; ++i)
  {
    result.v[i] = value;
  }
  return result;
}

inline Lanes operator*(double a, const Lanes& b)
{
  return spread(a) * b;
}

inline Lanes lesser(const Lanes& a, const Lanes& b)
{
  return { a.v < b.v ? a.v : b.v };
}

inline Lanes greater(const Lanes& a, const Lanes& b)
{
  return { a.v > b.v ? a.v : b.v };
}

/// `value` where `measure` is positive, 0 elsewhere.
inline Lanes wherePositive(const Lanes& measure, const Lanes& value)
{
  const Lanes zero = spread(0.0);
  return { measure.v > zero.v ? value.v : zero.v };
}

inline Lanes root(const Lanes& a)
{
#if defined(__AVX__)
  return { static_cast<Register>(_mm256_sqrt_pd(static_cast<__m256d>(a.v))) };
#elif defined(__SSE2__) && defined(__GNUC__)
  return { static_cast<Register>(_mm_sqrt_pd(static_cast<__m128d>(a.v))) };
#else
  Lanes result;
  for (int i = 0; i < Width; ++i)
  {
    result.v[i] = std::sqrt(a.v[i]);
  }
  return result;
#endif
}

using LanesVector = Vector3<Lanes>;

inline LanesVector operator*(const Lanes& a, const LanesVector& b)
{
  return { a * b.x, a * b.y, a * b.z };
}

inline LanesVector cross(const LanesVector& a, const LanesVector& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/// Coordinate of corner `corner` of the hexahedra that are the lanes of a register.
inline Lanes coordinate(const double* const* corners, int corner, int axis)
{
  const double* const* of = corners + corner;
#if defined(__AVX__) && defined(__GNUC__)
  return { Register{ of[0][axis], of[8][axis], of[16][axis], of[24][axis] } };
#elif defined(__GNUC__)
  return { Register{ of[0][axis], of[8][axis] } };
#else
  return { Register{ of[0][axis] } };
#endif
}

inline LanesVector point(const double* const* corners, int corner)
{
  return { coordinate(corners, corner, 0), coordinate(corners, corner, 1),
    coordinate(corners, corner, 2) };
}
}
}

#endif
