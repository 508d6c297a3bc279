// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CurveImages.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
std::vector<Index> innerCurves(const AssemblyComplex& complex, const std::vector<Index>& cap)
{
  std::vector<Index> rows;
  for (std::size_t c = 0; c < complex.curves.size(); ++c)
  {
    const std::vector<Index>& faces = complex.curves[c].faces;
    const auto own = std::count_if(faces.begin(), faces.end(),
      [&](Index face) { return std::binary_search(cap.begin(), cap.end(), face); });
    if (own > 1)
    {
      rows.push_back(static_cast<Index>(c));
    }
  }
  return rows;
}

ChainPlace nearestOnChain(const ArcLengthChain& chain, const Eigen::RowVector3d& place)
{
  ChainPlace nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (Index k = 1; k < chain.nodes().rows(); ++k)
  {
    const Eigen::RowVector3d a = chain.nodes().row(k - 1);
    const Eigen::RowVector3d edge = chain.nodes().row(k) - a;
    const double along = std::clamp((place - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double distance = (a + along * edge - place).norm();
    if (distance < nearest.distance)
    {
      nearest = { k - 1, along, chain.reached(k - 1) + along * edge.norm(), distance };
    }
  }
  return nearest;
}

CurveImages::CurveImages(
  const AssemblyComplex& complex, const std::vector<Index>& sources, double tolerance)
  : Complex(complex)
  , Tolerance(tolerance)
{
  for (const Index c : innerCurves(complex, sources))
  {
    this->Inner.push_back({ c, ArcLengthChain(placesOf(complex, complex.curves[at(c)])) });
  }
}

std::optional<CurveImages::Part> CurveImages::partOf(
  const Curve& curve, const ArcLengthChain& image, bool closed) const
{
  std::vector<double> places;
  for (const double share : { 0.25, 0.4, 0.5, 0.6, 0.75 })
  {
    const ChainPlace place = nearestOnChain(image, curve.chain.at(share * curve.chain.length()));
    if (place.distance > this->Tolerance)
    {
      return std::nullopt;
    }
    places.push_back(place.length);
  }
  double ahead = places[3] - places[1];
  if (closed && std::abs(ahead) > 0.5 * image.length())
  {
    ahead -= std::copysign(image.length(), ahead); // over the start
  }
  return Part{ places[2], { curve.row, ahead < 0.0 } };
}

std::vector<CurveUse> CurveImages::find(const Points& image, bool closed) const
{
  const ArcLengthChain chain(image);
  std::vector<Part> parts;
  for (const Curve& curve : this->Inner)
  {
    if (const std::optional<Part> part = this->partOf(curve, chain, closed))
    {
      parts.push_back(*part);
    }
  }
  if (parts.empty())
  {
    return {};
  }
  std::sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.place < b.place; });
  std::vector<CurveUse> path;
  for (const Part& part : parts)
  {
    if (!path.empty() &&
      lastPointOf(this->Complex, path.back()) != firstPointOf(this->Complex, part.use))
    {
      return {};
    }
    path.push_back(part.use);
  }
  const Index first = firstPointOf(this->Complex, path.front());
  const Index last = lastPointOf(this->Complex, path.back());
  const bool fits = closed
    ? first == last
    : this->isAt(first, image.row(0)) && this->isAt(last, image.row(image.rows() - 1));
  return fits ? path : std::vector<CurveUse>();
}
}
