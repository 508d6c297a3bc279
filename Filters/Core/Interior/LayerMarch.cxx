// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/LayerMarch.h"

#include "Core/Common/Errors.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace hexsweep
{
namespace
{
/// Largest change of an edge in one step, relative to its length. A quad can fold where it is 1.
constexpr double LargestStrain = 0.25;
constexpr double MaximumSubSteps = 8.0;

/// Carries a cap through the rings.
class March
{
public:
  March(const QuadsRef& quads, const SweepBoundary& boundary, Index numberOfPoints)
    : CapQuads(quads)
    , Boundary(boundary)
    , Fixed(static_cast<std::size_t>(numberOfPoints), false)
  {
    for (const Index i : boundary.nodes)
    {
      this->Fixed[static_cast<std::size_t>(i)] = true;
    }
  }

  /// The layer on ring `to` that belongs to a layer on ring `from`.
  Points advance(const Points& layer, Index from, Index to)
  {
    const Points& start = this->Boundary.rings[static_cast<std::size_t>(from)];
    const Points& end = this->Boundary.rings[static_cast<std::size_t>(to)];
    try
    {
      const Step whole = this->step(layer, start, end);
      const double parts =
        std::min(MaximumSubSteps, std::ceil(this->strain(whole) / LargestStrain));
      return parts > 1.0 ? this->inParts(layer, start, end, parts) : whole.reached();
    }
    catch (const SolverFailure&)
    {
      throw SolverFailure("the layers cannot be marched on from layer " + std::to_string(from) +
        ": its quads have collapsed, or a coordinate is not finite. With Blend no layer depends "
        "on the one before.");
    }
  }

private:
  struct Step
  {
    Points affine;
    Points correction;
    Points reached() const { return this->affine + this->correction; }
  };

  Step step(const Points& layer, const Points& start, const Points& end)
  {
    const auto outer = [&](const Points& ring) {
      return areaVector(ring.middleRows(this->Boundary.outerBegin, this->Boundary.outerSize));
    };
    Step step{ fitAffineMap(start, end, outer(start), outer(end)).apply(layer),
      Points::Zero(layer.rows(), 3) };
    const std::vector<Index>& nodes = this->Boundary.nodes;
    for (std::size_t j = 0; j < nodes.size(); ++j)
    {
      step.correction.row(nodes[j]) = end.row(static_cast<Index>(j)) - step.affine.row(nodes[j]);
    }
    step.correction = this->solverOf(layer).solve(step.correction);
    if (!step.reached().allFinite())
    {
      throw SolverFailure("a layer is not finite.");
    }
    return step;
  }

  /// All layers have one elimination order.
  const DirichletSolver& solverOf(const Points& layer)
  {
    const SparseMatrix stiffness = quadLaplacian(layer, this->CapQuads).stiffness;
    if (this->Solver)
    {
      this->Solver->factorize(stiffness);
    }
    else
    {
      this->Solver.emplace(stiffness, this->Fixed, layer);
    }
    return *this->Solver;
  }

  Points inParts(const Points& layer, const Points& start, const Points& end, double parts)
  {
    Points reached = layer;
    Points ring = start;
    for (double part = 1.0; part <= parts; ++part)
    {
      const Points next = start + part / parts * (end - start);
      reached = this->step(reached, ring, next).reached();
      ring = next;
    }
    return reached;
  }

  /// Largest change by the correction of an edge with a free end, relative to its length.
  double strain(const Step& step) const
  {
    double largest = 0.0;
    for (Index q = 0; q < this->CapQuads.rows(); ++q)
    {
      for (int c = 0; c < 4; ++c)
      {
        const Index a = this->CapQuads(q, c);
        const Index b = this->CapQuads(q, (c + 1) % 4);
        if (!this->Fixed[static_cast<std::size_t>(a)] || !this->Fixed[static_cast<std::size_t>(b)])
        {
          const double change = (step.correction.row(a) - step.correction.row(b)).norm();
          const double length = (step.affine.row(a) - step.affine.row(b)).norm();
          largest = std::max(largest, change > 0.0 ? change / length : 0.0);
        }
      }
    }
    return largest;
  }

  QuadsRef CapQuads;
  const SweepBoundary& Boundary;
  std::vector<bool> Fixed;
  std::optional<DirichletSolver> Solver;
};
}

Points layerMarchInterior(const SweepCage& cage, const Progress& progress, const ParallelFor&)
{
  const Points& sourcePoints = cage.source;
  const Points& targetPoints = cage.target;
  const Quads& quads = cage.quads;
  const SweepBoundary& boundary = cage.boundary;
  const Index n = sourcePoints.rows();
  const Index layers = boundary.numberOfLayers();
  March march(quads, boundary, n);
  const double steps = 2.0 * static_cast<double>(layers);
  Points swept((layers + 1) * n, 3);

  Points layer = sourcePoints;
  for (Index k = 1; k < layers; ++k)
  {
    reportProgress(progress, static_cast<double>(k - 1) / steps);
    layer = march.advance(layer, k - 1, k);
    swept.middleRows(k * n, n) = layer;
  }
  layer = targetPoints;
  for (Index k = layers - 1; k > 0; --k)
  {
    reportProgress(progress, static_cast<double>(2 * layers - k - 1) / steps);
    layer = march.advance(layer, k + 1, k);
    const double t = boundary.fractions[static_cast<std::size_t>(k)];
    const double share = t * t * (3.0 - 2.0 * t);
    auto met = swept.middleRows(k * n, n);
    met = (1.0 - share) * met + share * layer;
  }
  reportProgress(progress, 1.0);
  setGivenPoints(sourcePoints, targetPoints, quads, boundary, swept);
  return swept;
}
}
