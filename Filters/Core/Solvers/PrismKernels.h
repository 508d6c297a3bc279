// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The inner loops of the prism solver, compiled for several instruction sets.
 *
 * Their bodies (PrismKernelsBody.h) use raw pointers only: an inline function of Eigen or the
 * standard library, compiled for AVX2 in one file and for any processor in another, would be merged
 * by the linker, and the program would end on processors without AVX2.
 */
#ifndef hexsweep_PrismKernels_h
#define hexsweep_PrismKernels_h

#include <cstdint>

namespace hexsweep
{
/// Modes that are solved side by side; three components each.
constexpr int LanesPerBatch = 8;
/// Numbers at one node of a batch, [component][mode].
constexpr int BatchWidth = 3 * LanesPerBatch;
/// Columns of the products from modes to layers: eight points.
constexpr int PanelWidth = 24;

/**
 * The matrices A = K + lambda M of one batch on the first n nodes: compressed rows of the parts
 * below and above the diagonal, the same for all modes, columns rising. Rows may point to nodes
 * behind the n-th; vectors have zeros there.
 */
template <typename Real>
struct HelmholtzSystem
{
  std::int64_t size;
  const std::int64_t* lowerBegin;
  const int* lowerColumn;
  const Real* lowerStiffness;
  const Real* lowerMass;
  const std::int64_t* upperBegin;
  const int* upperColumn;
  const Real* upperStiffness;
  const Real* upperMass;
  const Real* stiffness; ///< diagonal
  const Real* mass;
  const Real* upperStiffnessSum; ///< of each row of the upper part
  const Real* upperMassSum;
  Real lambda[LanesPerBatch];
};

/**
 * One conjugate gradient iteration in three passes over the nodes. With A = L + D_A + L^T, the
 * preconditioner is (D + L) D^-1 (D + L^T), an incomplete Cholesky factorisation that changes the
 * diagonal only; S. C. Eisenstat's form \cite Eisenstat1981 costs no product with A besides the two
 * triangular solves.
 *
 * Vectors are size x BatchWidth; pivots D and their inverses size x LanesPerBatch.
 */
struct HelmholtzKernels
{
  using System = HelmholtzSystem<float>;
  /// D. `relaxation` is how much of the neglected fill is added to the diagonal (0 ... 1), `least`
  /// the least pivot over the diagonal entry; 0 and 1 give the symmetric Gauss-Seidel method.
  void (*factorize)(
    const System& system, float relaxation, float least, float* pivot, float* inverse);
  /// r = (D + L)^-1 b; returns sum r D r of each lane.
  void (*start)(const System& system, const float* inverse, const float* pivot, const float* b,
    float* r, double* rho);
  /// p = r + beta p; t = (D + L^T)^-1 D p.
  void (*backward)(const System& system, const float* inverse, const float* r, const double* beta,
    float* p, float* t);
  /// s = (D + L)^-1 (D p - (2 D - D_A) t); returns sum p D (s + t).
  void (*forward)(const System& system, const float* inverse, const float* pivot, const float* p,
    const float* t, float* s, double* curvature);
  /// x += alpha t; r -= alpha (s + t); returns sum r D r.
  void (*update)(const System& system, const float* pivot, const float* t, const float* s,
    const double* alpha, float* x, float* r, double* rho);
};

struct PrismKernels
{
  const char* name;
  HelmholtzKernels iteration;
  /// r -= (K + lambda M) x
  void (*residual)(const HelmholtzSystem<double>& system, const double* x, double* r);
  /// C = A B, row-major; A rows x inner, B inner x PanelWidth, C rows x PanelWidth, its rows one
  /// after the other.
  void (*multiply)(std::int64_t rows, std::int64_t inner, const double* a, std::int64_t strideOfA,
    const double* b, std::int64_t strideOfB, double* c);
};

/**
 * The kernels for this processor. Sums are grouped alike in all of them, but some round a product
 * before they add it and some do not: results of different processors may differ in the last bits;
 * on one processor they never do.
 */
const PrismKernels& prismKernels();

/// All kernels that this processor runs, the plainest first.
/// @return how many; `kernels` holds up to three.
int availablePrismKernels(const PrismKernels* kernels[3]);
}

#endif
