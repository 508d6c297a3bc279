// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The modes of a batch in vector registers; for PrismKernelsBody.h only.
 */
#ifndef hexsweep_PrismKernelsPack_h
#define hexsweep_PrismKernelsPack_h

#include "Core/Solvers/PrismKernels.h"

namespace hexsweep
{
namespace
{
using Size = std::int64_t;

#if defined(__AVX512F__)
constexpr int RegisterBytes = 64;
#elif defined(__AVX__)
constexpr int RegisterBytes = 32;
#else
constexpr int RegisterBytes = 16;
#endif

constexpr int registerBytes(int needed)
{
  return needed < RegisterBytes ? needed : RegisterBytes;
}

template <typename Real>
struct Simd;

#if defined(__GNUC__)
template <>
struct Simd<double>
{
  using Vector = double __attribute__((vector_size(registerBytes(8 * LanesPerBatch))));
};
template <>
struct Simd<float>
{
  using Vector = float __attribute__((vector_size(registerBytes(4 * LanesPerBatch))));
};
#else
template <>
struct Simd<double>
{
  typedef double Vector;
};
template <>
struct Simd<float>
{
  typedef float Vector;
};
#endif

/// The modes of a batch, one number each.
template <typename Real>
struct Pack
{
  using Vector = typename Simd<Real>::Vector;
  static constexpr int Registers = LanesPerBatch * sizeof(Real) / sizeof(Vector);
  Vector v[Registers];
};

// One register at a time: a longer copy is split otherwise than it is read, and waits for itself.
template <typename Vector, typename Real>
inline Vector loadVector(const Real* from)
{
  Vector result;
  __builtin_memcpy(&result, from, sizeof(result));
  return result;
}

template <typename Vector, typename Real>
inline void storeVector(Real* to, const Vector& value)
{
  __builtin_memcpy(to, &value, sizeof(value));
}

template <typename Real>
inline Pack<Real> load(const Real* from)
{
  Pack<Real> result;
  constexpr int Width = sizeof(result.v[0]) / sizeof(Real);
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = loadVector<typename Pack<Real>::Vector>(from + i * Width);
  }
  return result;
}

template <typename Real>
inline void store(Real* to, const Pack<Real>& value)
{
  constexpr int Width = sizeof(value.v[0]) / sizeof(Real);
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    storeVector(to + i * Width, value.v[i]);
  }
}

template <typename Real>
inline Pack<Real> zero()
{
  Pack<Real> result;
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = typename Pack<Real>::Vector{};
  }
  return result;
}

#define HEXSWEEP_PACK_OPERATOR(OP)                                                                 \
  template <typename Real>                                                                         \
  inline Pack<Real> operator OP(const Pack<Real>& a, const Pack<Real>& b)                          \
  {                                                                                                \
    Pack<Real> result;                                                                             \
    for (int i = 0; i < Pack<Real>::Registers; ++i)                                                \
    {                                                                                              \
      result.v[i] = a.v[i] OP b.v[i];                                                              \
    }                                                                                              \
    return result;                                                                                 \
  }
HEXSWEEP_PACK_OPERATOR(+)
HEXSWEEP_PACK_OPERATOR(-)
HEXSWEEP_PACK_OPERATOR(*)
HEXSWEEP_PACK_OPERATOR(/)
#undef HEXSWEEP_PACK_OPERATOR

template <typename Real>
inline Pack<Real> spread(Real value)
{
  Pack<Real> result = zero<Real>();
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = result.v[i] + value;
  }
  return result;
}

template <typename Real>
inline Pack<Real> greater(const Pack<Real>& a, const Pack<Real>& b)
{
  Pack<Real> result;
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  }
  return result;
}

template <typename Real>
inline Pack<Real> negative(const Pack<Real>& a)
{
  Pack<Real> result;
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = a.v[i] < 0 ? a.v[i] : 0 * a.v[i];
  }
  return result;
}

/// K + lambda M.
template <typename Real>
inline Pack<Real> entry(Real stiffness, Real mass, const Pack<Real>& lambda)
{
  Pack<Real> result;
  for (int i = 0; i < Pack<Real>::Registers; ++i)
  {
    result.v[i] = mass * lambda.v[i] + stiffness;
  }
  return result;
}

template <typename Real>
inline Pack<Real> narrow(const double* from)
{
  Real values[LanesPerBatch];
  for (int i = 0; i < LanesPerBatch; ++i)
  {
    values[i] = static_cast<Real>(from[i]);
  }
  return load(values);
}
}
}

#endif
