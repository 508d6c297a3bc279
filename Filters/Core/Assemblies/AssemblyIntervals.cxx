// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyIntervals.h"

#include "Core/Assemblies/CapSizes.h"
#include "Core/Assemblies/IntervalProgramme.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/SurfaceArea.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Radians of a curve's bends that one edge takes at most.
constexpr double MostTurn = 0.2 * Pi;
/// Fewer edges round a closed curve are no ring of quads.
constexpr Index LeastClosed = 8;

std::vector<Index> curvesOf(const std::vector<DirectedUse>& uses)
{
  std::vector<Index> curves;
  for (const DirectedUse& use : uses)
  {
    curves.push_back(use.use.curve);
  }
  return curves;
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
      this->addCarried(static_cast<Index>(v));
    }
    return std::move(this->Programme);
  }

  const std::map<Index, Index>& rowOfTube() const { return this->RowOfTube; }
  const std::vector<Index>& rowOfVolume() const { return this->RowOfVolume; }
  const std::map<Index, std::array<Index, 2>>& rowsBeside() const { return this->RowsBeside; }

private:
  void wishForCurves()
  {
    const std::map<Index, double> capSizes = capCurveSizes(this->Complex, this->Plan, this->Size);
    for (std::size_t c = 0; c < this->Complex.curves.size(); ++c)
    {
      const ComplexCurve& curve = this->Complex.curves[c];
      const auto onCap = capSizes.find(static_cast<Index>(c));
      IntervalWish wish;
      wish.even = onCap != capSizes.end();
      wish.number =
        std::max(lengthOf(this->Complex, curve) / (wish.even ? onCap->second : this->Size),
          turnOf(this->Complex, curve) / MostTurn);
      wish.least = curve.closed() ? LeastClosed : wish.even ? 2 : 1;
      this->Programme.wishes.push_back(wish);
    }
  }

  /// Borders of the target have as many edges as their images, and end at the same columns.
  void addCarried(Index volume)
  {
    const SweepLayout& sweep = this->Plan.sweeps[at(volume)];
    const std::string words =
      "volume " + std::to_string(volume + 1) + " has the borders of its target on its source";
    std::map<Index, Index> imageOf; // of points of the source cap where borders end
    for (const CarriedCurve& curve : sweep.carried)
    {
      this->Programme.equations.push_back(
        { curvesOf(curve.source), { curve.target.curve }, words });
      imageOf[firstPointOf(this->Complex, curve.source.front())] =
        firstPointOf(this->Complex, curve.target);
      imageOf[lastPointOf(this->Complex, curve.source.back())] =
        lastPointOf(this->Complex, curve.target);
    }
    for (const SideFace& side : sweep.sides)
    {
      if (!side.isPolygon())
      {
        this->addEnds(side, imageOf, words);
      }
    }
  }

  /// Where points of the lower chain of a side have images on the upper one, as many rows lie
  /// before both (on a tube: between two of them and between their images).
  void addEnds(
    const SideFace& side, const std::map<Index, Index>& imageOf, const std::string& words)
  {
    std::vector<CurveUse> top(side.chains[2].rbegin(), side.chains[2].rend());
    for (CurveUse& use : top)
    {
      use.reversed = !use.reversed;
    }
    const std::vector<CurveUse>& bottom = side.chains[0];
    std::map<Index, std::size_t> placeAtTop;
    for (std::size_t j = 0; j < top.size(); ++j)
    {
      placeAtTop[firstPointOf(this->Complex, top[j])] = j;
    }
    struct End
    {
      std::size_t below;
      std::size_t above;
    };
    std::vector<End> ends;
    if (!side.isTube())
    {
      ends.push_back({ 0, 0 });
    }
    for (std::size_t i = side.isTube() ? 0 : 1; i < bottom.size(); ++i)
    {
      const auto image = imageOf.find(firstPointOf(this->Complex, bottom[i]));
      const auto above = image == imageOf.end() ? placeAtTop.end() : placeAtTop.find(image->second);
      if (above != placeAtTop.end())
      {
        ends.push_back({ i, above->second });
      }
    }
    const auto between = [](const std::vector<CurveUse>& chain, std::size_t from, std::size_t to) {
      std::vector<Index> curves;
      for (std::size_t k = from; k != to; k = (k + 1) % chain.size())
      {
        curves.push_back(chain[k].curve);
      }
      return curves;
    };
    // The last part follows from the others.
    for (std::size_t e = 1; e < ends.size(); ++e)
    {
      this->Programme.equations.push_back({ between(bottom, ends[e - 1].below, ends[e].below),
        between(top, ends[e - 1].above, ends[e].above), words });
    }
  }

  void addFace(const SideFace& side)
  {
    const std::string name =
      "face " + std::to_string(this->Complex.faces[at(side.face)].id) + " has opposite sides";
    if (side.isTube())
    {
      this->Programme.equations.push_back(
        { curvesOf(side.chains[0]), curvesOf(side.chains[2]), name });
      IntervalWish wish;
      wish.number = std::max(1e-6, this->heightOf(side) / this->Size);
      this->RowOfTube[side.face] = this->addWish(wish);
      return;
    }
    SideFace outer = side;
    if (side.isPolygon())
    {
      outer.rims.resize(1);
    }
    this->addOpposite(outer, name);
    if (side.rims.size() > 1)
    {
      SideFace inner;
      inner.rims.push_back(side.rims[1]);
      this->addOpposite(inner, name);
      this->placeInner(side, outer, inner, name);
    }
  }

  void addOpposite(const SideFace& side, const std::string& name)
  {
    for (const int direction : { 0, 1 })
    {
      this->Programme.equations.push_back({ curvesOf(curvesAlong(side, direction)),
        curvesOf(curvesAlong(side, direction + 2)), name });
    }
  }

  /// A patch inside another one: so many rows and layers lie on each of its sides.
  void placeInner(
    const SideFace& side, const SideFace& outer, const SideFace& inner, const std::string& name)
  {
    for (const int direction : { 0, 1 })
    {
      const Eigen::RowVector3d axis =
        chordOf(this->Complex, curvesAlong(outer, direction)).normalized();
      const auto [outerLow, outerHigh] = this->extentOf(outer, axis);
      const auto [innerLow, innerHigh] = this->extentOf(inner, axis);
      std::vector<Index> sum;
      for (const double gap : { innerLow - outerLow, outerHigh - innerHigh })
      {
        IntervalWish wish;
        wish.number = std::max(0.5, gap / this->Size);
        sum.push_back(this->addWish(wish));
      }
      this->RowsBeside[side.face][static_cast<std::size_t>(direction)] = sum.front();
      // The inner rim runs the other way round.
      const std::vector<Index> own = curvesOf(curvesAlong(inner, direction));
      sum.insert(sum.end(), own.begin(), own.end());
      this->Programme.equations.push_back(
        { curvesOf(curvesAlong(outer, direction)), std::move(sum), name });
    }
  }

  std::pair<double, double> extentOf(const SideFace& side, const Eigen::RowVector3d& axis) const
  {
    std::pair<double, double> extent{ std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity() };
    for (int direction = 0; direction < 4; ++direction)
    {
      for (const DirectedUse& use : curvesAlong(side, direction))
      {
        const Eigen::VectorXd along =
          placesOf(this->Complex, this->Complex.curves[at(use.use.curve)]) * axis.transpose();
        extent = { std::min(extent.first, along.minCoeff()),
          std::max(extent.second, along.maxCoeff()) };
      }
    }
    return extent;
  }

  Index addWish(const IntervalWish& wish)
  {
    this->Programme.wishes.push_back(wish);
    return static_cast<Index>(this->Programme.wishes.size()) - 1;
  }

  /// Area over the mean length of the loops.
  double heightOf(const SideFace& side) const
  {
    const ComplexFace& face = this->Complex.faces[at(side.face)];
    const double area =
      surfaceArea(meshOfFaces(this->Complex, face.volumes.front(), { side.face }));
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

  /// The layers below a curve; nothing at the source cap.
  using Level = std::optional<Index>;

  void addVolume(Index volume)
  {
    const SweepLayout& sweep = this->Plan.sweeps[at(volume)];
    IntervalWish any;
    any.free = true;
    any.most = this->Layers[at(volume)];
    any.least = std::max<Index>(1, any.most);
    const Index layers = this->addWish(any);
    this->RowOfVolume.push_back(layers);
    IntervalWish free;
    free.free = true;
    std::map<Index, Level> levels;
    const auto levelOf = [&](Index curve) {
      const auto known = levels.find(curve);
      if (known != levels.end())
      {
        return known->second;
      }
      const std::vector<Index>& faces = this->Complex.curves[at(curve)].faces;
      const auto isAt = [&](const std::vector<Index>& cap) {
        return std::any_of(faces.begin(), faces.end(),
          [&](Index face) { return std::binary_search(cap.begin(), cap.end(), face); });
      };
      const Level level = isAt(sweep.sources) ? Level()
        : isAt(sweep.targets)                 ? Level(layers)
                                              : Level(this->addWish(free));
      levels[curve] = level;
      return level;
    };
    this->Words =
      "volume " + std::to_string(volume + 1) + " has as many layers everywhere between its caps";
    for (const SideFace& side : sweep.sides)
    {
      if (side.isTube())
      {
        for (const CurveUse& use : side.chains[2])
        {
          this->addRise(levelOf(side.chains[0].front().curve), { this->RowOfTube.at(side.face) },
            {}, levelOf(use.curve));
        }
        continue;
      }
      std::vector<std::vector<DirectedUse>> rims = side.rims;
      if (rims.empty())
      {
        rims.emplace_back();
        for (int direction = 0; direction < 4; ++direction)
        {
          const std::vector<DirectedUse> own = curvesAlong(side, direction);
          rims.front().insert(rims.front().end(), own.begin(), own.end());
        }
      }
      for (const std::vector<DirectedUse>& rim : rims)
      {
        this->climb(rim, levelOf);
      }
      if (rims.size() > 1)
      {
        this->addRise(levelOf(lowest(rims[0])), { this->RowsBeside.at(side.face)[1] }, {},
          levelOf(lowest(rims[1])));
      }
    }
  }

  /// The first curve of a rim that leads along the rows and comes after one that leads down: for a
  /// rectangle its bottom (of an inner rim, which runs the other way: the one below it).
  static Index lowest(const std::vector<DirectedUse>& rim)
  {
    for (std::size_t k = 0; k < rim.size(); ++k)
    {
      const DirectedUse& before = rim[(k + rim.size() - 1) % rim.size()];
      if (before.direction == 3 && rim[k].direction % 2 == 0)
      {
        return rim[k].use.curve;
      }
    }
    return rim.front().use.curve;
  }

  /// Goes round a rim from one curve along the rows to the next.
  template <typename LevelOf>
  void climb(const std::vector<DirectedUse>& rim, const LevelOf& levelOf)
  {
    const std::size_t n = rim.size();
    std::size_t start = 0;
    while (start < n && rim[start].direction % 2 != 0)
    {
      ++start;
    }
    std::vector<Index> up;
    std::vector<Index> down;
    Index last = rim[start % n].use.curve;
    for (std::size_t k = 1; k <= n; ++k)
    {
      const DirectedUse& next = rim[(start + k) % n];
      if (next.direction % 2 != 0)
      {
        (next.direction == 1 ? up : down).push_back(next.use.curve);
        continue;
      }
      this->addRise(levelOf(last), std::move(up), std::move(down), levelOf(next.use.curve));
      up.clear();
      down.clear();
      last = next.use.curve;
    }
  }

  /// The level `to` is that of `from`, up and down by some numbers.
  void addRise(Level from, std::vector<Index> up, std::vector<Index> down, Level to)
  {
    if (from)
    {
      up.push_back(*from);
    }
    if (to)
    {
      down.push_back(*to);
    }
    if (up != down && !(up.empty() && down.empty()))
    {
      this->Programme.equations.push_back({ std::move(up), std::move(down), this->Words });
    }
  }

  const AssemblyComplex& Complex;
  const AssemblyPlan& Plan;
  double Size;
  const std::vector<Index>& Layers;
  IntervalProgramme Programme;
  std::map<Index, Index> RowOfTube;
  /// By face: how many rows lie left of the patch inside it, how many layers below that.
  std::map<Index, std::array<Index, 2>> RowsBeside;
  std::vector<Index> RowOfVolume;
  std::string Words;
};

/// Numbers of layers that were asked for and differ, though the volumes share a side.
std::string askedApart(
  const AssemblyComplex& complex, const AssemblyPlan& plan, const std::vector<Index>& layers)
{
  const auto isSide = [&](Index volume, Index face) {
    const std::vector<SideFace>& sides = plan.sweeps[at(volume)].sides;
    return std::any_of(
      sides.begin(), sides.end(), [face](const SideFace& side) { return side.face == face; });
  };
  std::string words;
  for (std::size_t f = 0; f < complex.faces.size(); ++f)
  {
    const ComplexFace& face = complex.faces[f];
    if (face.volumes.size() < 2)
    {
      continue;
    }
    const Index one = face.volumes[0];
    const Index other = face.volumes[1];
    const Index row = static_cast<Index>(f);
    if (layers[at(one)] > 0 && layers[at(other)] > 0 && layers[at(one)] != layers[at(other)] &&
      isSide(one, row) && isSide(other, row))
    {
      words += " Volume " + std::to_string(one + 1) + " is to have " +
        std::to_string(layers[at(one)]) + " layers and volume " + std::to_string(other + 1) + " " +
        std::to_string(layers[at(other)]) + ", and they share face " + std::to_string(face.id) +
        ": ask for as many, or for one of them only.";
    }
  }
  return words;
}
}

AssemblyIntervals assemblyIntervals(const AssemblyComplex& complex, const AssemblyPlan& plan,
  double size, const std::vector<Index>& layers)
{
  ProgrammeWriter writer(complex, plan, size, layers);
  const IntervalProgramme programme = writer.write();
  std::vector<Index> numbers;
  try
  {
    numbers = solveIntervals(programme);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(error.what() + askedApart(complex, plan, layers));
  }
  AssemblyIntervals result;
  result.curves.assign(
    numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(complex.curves.size()));
  result.tubeLayers.assign(complex.faces.size(), 0);
  for (const auto& [face, row] : writer.rowOfTube())
  {
    result.tubeLayers[at(face)] = numbers[at(row)];
  }
  result.inside.assign(complex.faces.size(), { 0, 0 });
  for (const auto& [face, rows] : writer.rowsBeside())
  {
    result.inside[at(face)] = { numbers[at(rows[0])], numbers[at(rows[1])] };
  }
  for (const Index row : writer.rowOfVolume())
  {
    result.layers.push_back(numbers[at(row)]);
  }
  return result;
}
}
