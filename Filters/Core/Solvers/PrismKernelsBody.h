// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The bodies of PrismKernels.h; included once for each instruction set.
 *
 * Everything is in an unnamed namespace, so that no two files share a function.
 */
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

/// Sums over nodes: partial sums of 64 nodes, so that single precision keeps its digits.
template <typename Real>
struct Sums
{
  Pack<Real> part[3];
  double total[BatchWidth];

  Sums()
  {
    for (Pack<Real>& sum : part)
    {
      sum = zero<Real>();
    }
    for (double& sum : total)
    {
      sum = 0.0;
    }
  }

  void add(Size node, int component, const Pack<Real>& value)
  {
    part[component] = part[component] + value;
    if (node % 64 == 0)
    {
      flush(component);
    }
  }

  void flush(int component)
  {
    Real values[LanesPerBatch];
    store(values, part[component]);
    for (int i = 0; i < LanesPerBatch; ++i)
    {
      total[component * LanesPerBatch + i] += static_cast<double>(values[i]);
    }
    part[component] = zero<Real>();
  }

  void get(double* sums)
  {
    for (int c = 0; c < 3; ++c)
    {
      flush(c);
    }
    for (int i = 0; i < BatchWidth; ++i)
    {
      sums[i] = total[i];
    }
  }
};

template <typename Real>
struct Node
{
  Pack<Real> v[3];
};

template <typename Real>
inline Node<Real> loadNode(const Real* from, Size node)
{
  Node<Real> result;
  for (int c = 0; c < 3; ++c)
  {
    result.v[c] = load(from + node * BatchWidth + c * LanesPerBatch);
  }
  return result;
}

template <typename Real>
inline void storeNode(Real* to, Size node, const Node<Real>& value)
{
  // No loop: GCC would take the values through memory.
  store(to + node * BatchWidth, value.v[0]);
  store(to + node * BatchWidth + LanesPerBatch, value.v[1]);
  store(to + node * BatchWidth + 2 * LanesPerBatch, value.v[2]);
}

/// sum - (a part of a row) x
template <typename Real>
inline void subtractRow(const Size* begin, const int* column, const Real* stiffness,
  const Real* mass, Size row, const Pack<Real>& lambda, const Real* x, Node<Real>& sum)
{
  for (Size e = begin[row]; e < begin[row + 1]; ++e)
  {
    const Pack<Real> weight = entry(stiffness[e], mass[e], lambda);
    const Node<Real> other = loadNode(x, column[e]);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = sum.v[c] - weight * other.v[c];
    }
  }
}

template <typename Real>
inline void subtractLower(const HelmholtzSystem<Real>& a, Size row, const Pack<Real>& lambda,
  const Real* x, Node<Real>& sum)
{
  subtractRow(a.lowerBegin, a.lowerColumn, a.lowerStiffness, a.lowerMass, row, lambda, x, sum);
}

template <typename Real>
inline void subtractUpper(const HelmholtzSystem<Real>& a, Size row, const Pack<Real>& lambda,
  const Real* x, Node<Real>& sum)
{
  subtractRow(a.upperBegin, a.upperColumn, a.upperStiffness, a.upperMass, row, lambda, x, sum);
}

template <typename Real>
void factorize(
  const HelmholtzSystem<Real>& a, Real relaxation, Real least, Real* pivot, Real* inverse)
{
  const Pack<Real> lambda = load(a.lambda);
  const Pack<Real> one = spread(Real(1));
  const Pack<Real> kept = spread(Real(1) - relaxation);
  const Pack<Real> moved = spread(relaxation);
  const Pack<Real> floor = spread(least);
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<Real> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    Pack<Real> value = diagonal;
    for (Size e = a.lowerBegin[i]; e < a.lowerBegin[i + 1]; ++e)
    {
      const Size k = a.lowerColumn[e];
      const Pack<Real> weight = entry(a.lowerStiffness[e], a.lowerMass[e], lambda);
      const Pack<Real> row = entry(a.upperStiffnessSum[k], a.upperMassSum[k], lambda);
      // Fill is moved where entries are negative only: where the mass matrix prevails, all are
      // positive, and moving it makes the triangular solves unstable.
      const Pack<Real> square = weight * weight;
      const Pack<Real> fill = kept * square + moved * negative(weight) * negative(row);
      value = value - load(inverse + k * LanesPerBatch) * greater(square, fill);
    }
    value = greater(value, floor * diagonal);
    store(pivot + i * LanesPerBatch, value);
    store(inverse + i * LanesPerBatch, one / value);
  }
}

template <typename Real>
void start(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* pivot, const Real* b,
  Real* r, double* rho)
{
  const Pack<Real> lambda = load(a.lambda);
  Sums<Real> sums;
  for (Size i = 0; i < a.size; ++i)
  {
    Node<Real> value = loadNode(b, i);
    subtractLower(a, i, lambda, r, value);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      value.v[c] = value.v[c] * scale;
      sums.add(i, c, weight * value.v[c] * value.v[c]);
    }
    storeNode(r, i, value);
  }
  sums.get(rho);
}

template <typename Real>
void backward(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* r,
  const double* beta, Real* p, Real* t)
{
  const Pack<Real> lambda = load(a.lambda);
  Node<Real> factor;
  for (int c = 0; c < 3; ++c)
  {
    factor.v[c] = narrow<Real>(beta + c * LanesPerBatch);
  }
  for (Size i = a.size - 1; i >= 0; --i)
  {
    Node<Real> direction = loadNode(p, i);
    const Node<Real> residual = loadNode(r, i);
    Node<Real> sum;
    for (int c = 0; c < 3; ++c)
    {
      direction.v[c] = residual.v[c] + factor.v[c] * direction.v[c];
      sum.v[c] = zero<Real>();
    }
    storeNode(p, i, direction);
    subtractUpper(a, i, lambda, t, sum);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = direction.v[c] + scale * sum.v[c];
    }
    storeNode(t, i, sum);
  }
}

template <typename Real>
void forward(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* pivot, const Real* p,
  const Real* t, Real* s, double* curvature)
{
  const Pack<Real> lambda = load(a.lambda);
  Sums<Real> sums;
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<Real> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    const Node<Real> solved = loadNode(t, i);
    Node<Real> sum;
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = diagonal * solved.v[c];
    }
    subtractLower(a, i, lambda, s, sum);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    const Node<Real> direction = loadNode(p, i);
    for (int c = 0; c < 3; ++c)
    {
      const Pack<Real> rest = direction.v[c] - solved.v[c];
      // s + t first: it is what counts.
      const Pack<Real> product = rest + scale * sum.v[c];
      sums.add(i, c, weight * direction.v[c] * product);
      sum.v[c] = product - solved.v[c];
    }
    storeNode(s, i, sum);
  }
  sums.get(curvature);
}

template <typename Real>
void update(const HelmholtzSystem<Real>& a, const Real* pivot, const Real* t, const Real* s,
  const double* alpha, Real* x, Real* r, double* rho)
{
  Sums<Real> sums;
  Node<Real> factor;
  for (int c = 0; c < 3; ++c)
  {
    factor.v[c] = narrow<Real>(alpha + c * LanesPerBatch);
  }
  for (Size i = 0; i < a.size; ++i)
  {
    Node<Real> place = loadNode(x, i);
    Node<Real> residual = loadNode(r, i);
    const Node<Real> solved = loadNode(t, i);
    const Node<Real> rest = loadNode(s, i);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      place.v[c] = place.v[c] + factor.v[c] * solved.v[c];
      residual.v[c] = residual.v[c] - factor.v[c] * (solved.v[c] + rest.v[c]);
      sums.add(i, c, weight * residual.v[c] * residual.v[c]);
    }
    storeNode(x, i, place);
    storeNode(r, i, residual);
  }
  sums.get(rho);
}

void residual(const HelmholtzSystem<double>& a, const double* x, double* r)
{
  const Pack<double> lambda = load(a.lambda);
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<double> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    Node<double> sum = loadNode(r, i);
    const Node<double> own = loadNode(x, i);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = sum.v[c] - diagonal * own.v[c];
    }
    subtractLower(a, i, lambda, x, sum);
    subtractUpper(a, i, lambda, x, sum);
    storeNode(r, i, sum);
  }
}

constexpr int DoublesPerVector = sizeof(Simd<double>::Vector) / sizeof(double);
/// Columns whose sums stay in registers.
constexpr int VectorsAtOnce = DoublesPerVector == 2 ? 2 : 3;
constexpr int ColumnsAtOnce = VectorsAtOnce * DoublesPerVector;
static_assert(PanelWidth % ColumnsAtOnce == 0, "");

template <int Rows>
inline void multiplyBlock(
  Size inner, const double* a, Size strideOfA, const double* b, Size strideOfB, double* c)
{
  using Vector = Simd<double>::Vector;
  Vector sum[Rows][VectorsAtOnce] = {};
  for (Size j = 0; j < inner; ++j)
  {
    Vector row[VectorsAtOnce];
    for (int v = 0; v < VectorsAtOnce; ++v)
    {
      row[v] = loadVector<Vector>(b + j * strideOfB + v * DoublesPerVector);
    }
    for (int i = 0; i < Rows; ++i)
    {
      const double factor = a[i * strideOfA + j];
      for (int v = 0; v < VectorsAtOnce; ++v)
      {
        sum[i][v] = sum[i][v] + factor * row[v];
      }
    }
  }
  for (int i = 0; i < Rows; ++i)
  {
    for (int v = 0; v < VectorsAtOnce; ++v)
    {
      storeVector(c + i * PanelWidth + v * DoublesPerVector, sum[i][v]);
    }
  }
}

void multiply(Size rows, Size inner, const double* a, Size strideOfA, const double* b,
  Size strideOfB, double* c)
{
  for (int column = 0; column < PanelWidth; column += ColumnsAtOnce)
  {
    Size row = 0;
    for (; row + 4 <= rows; row += 4)
    {
      multiplyBlock<4>(inner, a + row * strideOfA, strideOfA, b + column, strideOfB,
        c + row * PanelWidth + column);
    }
    const double* restA = a + row * strideOfA;
    double* restC = c + row * PanelWidth + column;
    switch (rows - row)
    {
      case 3:
        multiplyBlock<3>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      case 2:
        multiplyBlock<2>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      case 1:
        multiplyBlock<1>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      default:
        break;
    }
  }
}

constexpr PrismKernels makeKernels(const char* name)
{
  return { name, { factorize<float>, start<float>, backward<float>, forward<float>, update<float> },
    residual, multiply };
}
}
}
