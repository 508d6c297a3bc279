// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyIntervals.h"

#include "Core/Assemblies/IntervalProgramme.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hexsweep
{
namespace
{
/// Radians of a curve's bends that one edge takes at most.
constexpr double MostTurn = 0.2 * Pi;
/// Fewer edges round a closed curve are no ring of quads.
constexpr Index LeastClosed = 8;

double turnOf(const AssemblyComplex& complex, const ComplexCurve& curve)
{
  const Points places = placesOf(complex, curve);
  double turn = 0.0;
  for (Index k = 1; k + 1 < places.rows(); ++k)
  {
    const Eigen::RowVector3d in = places.row(k) - places.row(k - 1);
    const Eigen::RowVector3d out = places.row(k + 1) - places.row(k);
    turn += std::atan2(in.cross(out).norm(), in.dot(out));
  }
  return turn;
}

std::vector<Index> curvesOf(const std::vector<CurveUse>& chain)
{
  std::vector<Index> curves;
  for (const CurveUse& use : chain)
  {
    curves.push_back(use.curve);
  }
  return curves;
}

/// Writes the programme: a number a curve, then one a tube, then one a volume.
class ProgrammeWriter
{
public:
  ProgrammeWriter(const AssemblyComplex& complex, const AssemblyPlan& plan, double size,
    const std::vector<Index>& layers)
    : Complex(complex)
    , Plan(plan)
    , Size(size)
    , Layers(layers)
  {
  }

  IntervalProgramme write()
  {
    this->wishForCurves();
    std::set<Index> done;
    for (std::size_t v = 0; v < this->Plan.sweeps.size(); ++v)
    {
      for (const SideFace& side : this->Plan.sweeps[v].sides)
      {
        if (done.insert(side.face).second)
        {
          this->addFace(side);
        }
      }
      this->addVolume(static_cast<Index>(v));
      for (const CarriedCurve& curve : this->Plan.sweeps[v].carried)
      {
        this->Programme.equations.push_back({ curvesOf(curve.source), { curve.target.curve },
          "volume " + std::to_string(v + 1) + " has the borders of its target on its source" });
      }
    }
    return std::move(this->Programme);
  }

  const std::map<Index, Index>& rowOfTube() const { return this->RowOfTube; }
  const std::vector<Index>& rowOfVolume() const { return this->RowOfVolume; }

private:
  void wishForCurves()
  {
    std::set<Index> onCaps;
    for (const SweepLayout& sweep : this->Plan.sweeps)
    {
      for (const std::vector<Index>* cap : { &sweep.sources, &sweep.targets })
      {
        for (const Index face : *cap)
        {
          for (const std::vector<CurveUse>& loop : this->Complex.faces[at(face)].loops)
          {
            for (const CurveUse& use : loop)
            {
              onCaps.insert(use.curve);
            }
          }
        }
      }
    }
    for (std::size_t c = 0; c < this->Complex.curves.size(); ++c)
    {
      const ComplexCurve& curve = this->Complex.curves[c];
      IntervalWish wish;
      wish.number = std::max(
        lengthOf(this->Complex, curve) / this->Size, turnOf(this->Complex, curve) / MostTurn);
      wish.even = onCaps.count(static_cast<Index>(c)) > 0;
      wish.least = curve.closed() ? LeastClosed : wish.even ? 2 : 1;
      this->Programme.wishes.push_back(wish);
    }
  }

  void addFace(const SideFace& side)
  {
    const std::string name =
      "face " + std::to_string(this->Complex.faces[at(side.face)].id) + " has opposite sides";
    this->Programme.equations.push_back(
      { curvesOf(side.chains[0]), curvesOf(side.chains[2]), name });
    if (!side.isTube())
    {
      this->Programme.equations.push_back(
        { curvesOf(side.chains[1]), curvesOf(side.chains[3]), name });
      return;
    }
    IntervalWish wish;
    wish.number = std::max(1e-6, this->heightOf(side) / this->Size);
    this->RowOfTube[side.face] = static_cast<Index>(this->Programme.wishes.size());
    this->Programme.wishes.push_back(wish);
  }

  /// Area over the mean length of the loops.
  double heightOf(const SideFace& side) const
  {
    double area = 0.0;
    for (const Index t : this->Complex.faces[at(side.face)].triangles)
    {
      const Eigen::RowVector3d a = this->Complex.points.row(this->Complex.triangles(t, 0));
      const Eigen::RowVector3d b = this->Complex.points.row(this->Complex.triangles(t, 1));
      const Eigen::RowVector3d c = this->Complex.points.row(this->Complex.triangles(t, 2));
      area += 0.5 * (b - a).cross(c - a).norm();
    }
    double length = 0.0;
    for (const std::size_t chain : { std::size_t(0), std::size_t(2) })
    {
      for (const CurveUse& use : side.chains[chain])
      {
        length += 0.5 * lengthOf(this->Complex, this->Complex.curves[at(use.curve)]);
      }
    }
    return area / length;
  }

  /// Numbers whose sum are the layers of a side face.
  std::vector<Index> layersOf(const SideFace& side) const
  {
    return side.isTube() ? std::vector<Index>{ this->RowOfTube.at(side.face) }
                         : curvesOf(side.chains[1]);
  }

  void addVolume(Index volume)
  {
    const SweepLayout& sweep = this->Plan.sweeps[at(volume)];
    const Index row = static_cast<Index>(this->Programme.wishes.size());
    this->RowOfVolume.push_back(row);
    IntervalWish any;
    any.free = true;
    any.most = this->Layers[at(volume)];
    any.least = std::max<Index>(1, any.most);
    this->Programme.wishes.push_back(any);
    // The way down to the source cap, by the face at whose bottom a curve is.
    std::map<Index, const SideFace*> above;
    for (const SideFace& side : sweep.sides)
    {
      for (const CurveUse& use : side.chains[0])
      {
        above[use.curve] = &side;
      }
    }
    const auto isAtSource = [&](Index curve) {
      const std::vector<Index>& faces = this->Complex.curves[at(curve)].faces;
      return std::any_of(faces.begin(), faces.end(), [&](Index face) {
        return std::binary_search(sweep.sources.begin(), sweep.sources.end(), face);
      });
    };
    for (const auto& [curve, first] : above)
    {
      if (!isAtSource(curve))
      {
        continue;
      }
      for (const bool last : { false, true })
      {
        std::vector<Index> way;
        const SideFace* side = first;
        // Layouts have no circles: each face is reached from below once.
        while (side)
        {
          const std::vector<Index> own = this->layersOf(*side);
          way.insert(way.end(), own.begin(), own.end());
          const std::vector<CurveUse>& top = side->chains[2];
          const auto next = above.find((last ? top.back() : top.front()).curve);
          side = next == above.end() ? nullptr : next->second;
        }
        this->Programme.equations.push_back({ std::move(way), { row },
          "volume " + std::to_string(volume + 1) +
            " has as many layers everywhere between its caps" });
      }
    }
  }

  const AssemblyComplex& Complex;
  const AssemblyPlan& Plan;
  double Size;
  const std::vector<Index>& Layers;
  IntervalProgramme Programme;
  std::map<Index, Index> RowOfTube;
  std::vector<Index> RowOfVolume;
};
}

AssemblyIntervals assemblyIntervals(const AssemblyComplex& complex, const AssemblyPlan& plan,
  double size, const std::vector<Index>& layers)
{
  ProgrammeWriter writer(complex, plan, size, layers);
  const IntervalProgramme programme = writer.write();
  const std::vector<Index> numbers = solveIntervals(programme);
  AssemblyIntervals result;
  result.curves.assign(
    numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(complex.curves.size()));
  result.tubeLayers.assign(complex.faces.size(), 0);
  for (const auto& [face, row] : writer.rowOfTube())
  {
    result.tubeLayers[at(face)] = numbers[at(row)];
  }
  for (const Index row : writer.rowOfVolume())
  {
    result.layers.push_back(numbers[at(row)]);
  }
  return result;
}
}
