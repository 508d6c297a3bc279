// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SectionInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Linking/SectionMarch.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <optional>

namespace hexsweep
{
namespace
{
constexpr double CarryingShare = 0.8;

std::optional<SweepSections> sectionsOf(const SweepBoundary& boundary)
{
  return sweepSections(boundary.nodes, boundary.begins, boundary.rings);
}

/// Harmonic functions on the layers, in one elimination order.
class LayerHeights
{
public:
  explicit LayerHeights(const SweepCage& cage)
    : Cage(cage)
    , Fixed(static_cast<std::size_t>(cage.source.rows()), false)
  {
    for (const Index i : cage.boundary.nodes)
    {
      this->Fixed[static_cast<std::size_t>(i)] = true;
    }
  }

  /// @param ring heights of the loop nodes. @return one a point.
  Eigen::VectorXd over(const PlanePoints& layer, const Eigen::VectorXd& ring)
  {
    Points flat = Points::Zero(layer.rows(), 3);
    flat.leftCols<2>() = layer;
    const SparseMatrix stiffness = quadLaplacian(flat, this->Cage.quads).stiffness;
    if (this->Solver)
    {
      this->Solver->factorize(stiffness);
    }
    else
    {
      this->Solver.emplace(stiffness, this->Fixed, flat);
    }
    Eigen::VectorXd values = Eigen::VectorXd::Zero(layer.rows());
    for (std::size_t j = 0; j < this->Cage.boundary.nodes.size(); ++j)
    {
      values[this->Cage.boundary.nodes[j]] = ring[static_cast<Index>(j)];
    }
    return this->Solver->solve(values);
  }

private:
  const SweepCage& Cage;
  std::vector<bool> Fixed;
  std::optional<DirichletSolver> Solver;
};
}

double windingOf(const SweepBoundary& boundary)
{
  const std::optional<SweepSections> sections = sectionsOf(boundary);
  return sections ? loopWinding(*sections).greatest() : 0.0;
}

Points sectionInterior(const SweepCage& cage, const Progress& progress, const ParallelFor&)
{
  const SweepBoundary& boundary = cage.boundary;
  const std::optional<SweepSections> sections = sectionsOf(boundary);
  if (!sections)
  {
    throw SolverFailure("the rings of the linking sides have no planes to carry the quads in.");
  }
  const Index n = cage.source.rows();
  const Index layers = boundary.numberOfLayers();
  const CarriedQuads carried = carryQuads(cage.source, cage.target, boundary.fractions, cage.quads,
    *sections, progressPart(progress, 0.0, CarryingShare));
  const SectionFrame& first = sections->frames.front();
  const SectionFrame& last = sections->frames.back();
  const PlanePoints atSource = first.flatten(cage.source) - carried.layers.front();
  const PlanePoints atTarget = last.flatten(cage.target) - carried.layers.back();
  LayerHeights heights(cage);
  const auto ringHeights = [&](Index k) {
    const auto layer = static_cast<std::size_t>(k);
    return heights.over(
      carried.layers[layer], sections->frames[layer].heights(boundary.rings[layer]));
  };
  const Eigen::VectorXd sourceBulge = first.heights(cage.source) - ringHeights(0);
  const Eigen::VectorXd targetBulge = last.heights(cage.target) - ringHeights(layers);
  Points swept((layers + 1) * n, 3);
  for (Index k = 1; k < layers; ++k)
  {
    reportProgress(progress,
      CarryingShare + (1.0 - CarryingShare) * static_cast<double>(k) / static_cast<double>(layers));
    const auto layer = static_cast<std::size_t>(k);
    const double t = boundary.fractions[layer];
    swept.middleRows(k * n, n) =
      sections->frames[layer].lift(carried.layers[layer] + (1.0 - t) * atSource + t * atTarget,
        ringHeights(k) + (1.0 - t) * sourceBulge + t * targetBulge);
  }
  reportProgress(progress, 1.0);
  setGivenPoints(cage.source, cage.target, cage.quads, boundary, swept);
  return swept;
}
}
