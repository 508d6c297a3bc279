// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SectionMarch.h"

#include "Core/Common/Errors.h"
#include "Core/Linking/SectionDescent.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// Largest change of an edge in one part of a step, relative to its length.
constexpr double LargestStrain = 0.25;
constexpr double MaximumParts = 16.0;
/// Of a step; quads that a part as small as this folds are untangled.
constexpr double LeastPart = 1.0 / 64.0;
constexpr int UntanglingRounds = 20;
constexpr int RelaxingSteps = 6;

class SectionMarch
{
public:
  SectionMarch(const PointsRef& source, const PointsRef& target, const QuadsRef& quads,
    const SweepSections& sections)
    : SectionQuads(quads)
    , Sections(sections)
    , Fixed(fixedNodes(sections, source.rows()))
    , Descent(quads, this->Fixed, source, target)
  {
  }

  void wantShapes(double share) { this->Descent.wantShapes(share); }

  /// @return corners that are still inverted.
  Index improve(PlanePoints& layer)
  {
    const Index left =
      this->Descent.inverted(layer) > 0 ? this->Descent.untangle(layer, UntanglingRounds) : 0;
    this->Descent.relax(layer, RelaxingSteps);
    return left;
  }

  PlanePoints advance(const PlanePoints& layer, const PlanePoints& from, const PlanePoints& to)
  {
    const PlanePoints whole = this->displacement(layer, to - from);
    PlanePoints reached = layer;
    double part =
      1.0 / std::clamp(std::ceil(this->strain(layer, whole) / LargestStrain), 1.0, MaximumParts);
    for (double done = 0.0; done < 1.0;)
    {
      const double end = done + part < 1.0 - 0.5 * LeastPart ? done + part : 1.0;
      PlanePoints next = reached + this->displacement(reached, (end - done) * (to - from));
      this->setRing(next, from + end * (to - from));
      const bool folds = this->Descent.inverted(next) > 0;
      if (folds && part > LeastPart)
      {
        part *= 0.5;
        continue;
      }
      this->improve(next);
      reached = std::move(next);
      done = end;
      part = std::min(1.0, folds ? part : 2.0 * part);
    }
    this->setRing(reached, to);
    return reached;
  }

private:
  static std::vector<bool> fixedNodes(const SweepSections& sections, Index numberOfPoints)
  {
    std::vector<bool> fixed(static_cast<std::size_t>(numberOfPoints), false);
    for (const Index i : sections.nodes)
    {
      fixed[static_cast<std::size_t>(i)] = true;
    }
    return fixed;
  }

  void setRing(PlanePoints& layer, const PlanePoints& ring) const
  {
    for (std::size_t j = 0; j < this->Sections.nodes.size(); ++j)
    {
      layer.row(this->Sections.nodes[j]) = ring.row(static_cast<Index>(j));
    }
  }

  /// Harmonic on the layer as it lies. @param move of the ring's nodes.
  PlanePoints displacement(const PlanePoints& layer, const PlanePoints& move)
  {
    Points flat = Points::Zero(layer.rows(), 3);
    flat.leftCols<2>() = layer;
    const SparseMatrix stiffness = quadLaplacian(flat, this->SectionQuads).stiffness;
    if (this->Solver)
    {
      this->Solver->factorize(stiffness);
    }
    else
    {
      this->Solver.emplace(stiffness, this->Fixed, flat);
    }
    PlanePoints values = PlanePoints::Zero(layer.rows(), 2);
    for (std::size_t j = 0; j < this->Sections.nodes.size(); ++j)
    {
      values.row(this->Sections.nodes[j]) = move.row(static_cast<Index>(j));
    }
    return this->Solver->solve(values);
  }

  /// Largest change of an edge with a free end, relative to its length.
  double strain(const PlanePoints& layer, const PlanePoints& move) const
  {
    double largest = 0.0;
    for (Index q = 0; q < this->SectionQuads.rows(); ++q)
    {
      for (int c = 0; c < 4; ++c)
      {
        const Index a = this->SectionQuads(q, c);
        const Index b = this->SectionQuads(q, (c + 1) % 4);
        if (!this->Fixed[static_cast<std::size_t>(a)] || !this->Fixed[static_cast<std::size_t>(b)])
        {
          const double change = (move.row(a) - move.row(b)).norm();
          largest =
            std::max(largest, change > 0.0 ? change / (layer.row(a) - layer.row(b)).norm() : 0.0);
        }
      }
    }
    return largest;
  }

  QuadsRef SectionQuads;
  const SweepSections& Sections;
  std::vector<bool> Fixed;
  SectionDescent Descent;
  std::optional<DirichletSolver> Solver;
};
}

bool CarriedQuads::valid() const
{
  return std::all_of(
    this->inverted.begin(), this->inverted.end(), [](Index count) { return count == 0; });
}

CarriedQuads carryQuads(const PointsRef& source, const PointsRef& target,
  const std::vector<double>& fractions, const QuadsRef& quads, const SweepSections& sections,
  const Progress& progress)
{
  SectionMarch march(source, target, quads, sections);
  const double layers = static_cast<double>(sections.rings.size());
  CarriedQuads carried;
  PlanePoints layer = sections.frames.front().flatten(source);
  for (std::size_t k = 0; k < sections.rings.size(); ++k)
  {
    reportProgress(progress, static_cast<double>(k) / layers);
    march.wantShapes(fractions[k]);
    if (k > 0)
    {
      layer = march.advance(layer, sections.rings[k - 1], sections.rings[k]);
    }
    carried.inverted.push_back(march.improve(layer));
    carried.layers.push_back(layer);
  }
  reportProgress(progress, 1.0);
  return carried;
}

CarriedQuads carryQuads(const PointsRef& source, const QuadsRef& quads,
  const SweepSections& sections, const Progress& progress)
{
  return carryQuads(
    source, source, std::vector<double>(sections.rings.size(), 0.0), quads, sections, progress);
}
}
