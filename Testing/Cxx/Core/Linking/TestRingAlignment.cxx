// SPDX-License-Identifier: BSD-3-Clause
// Rings of pipes whose sections are known in closed form.
#include "Core/Linking/LinkingSides.h"

#include "Support/SideTubes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestRingAlignment
{
using hexsweep::Index;
using hexsweep::LinkingMesh;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::SideTube;
using test::tube;
using test::TwoPi;

constexpr Index Layers = 12;
constexpr Index Around = 24;

/// A pipe in the x z plane: an arc about the y axis, then straight on.
struct Bend
{
  double radius;
  double angle;
  double straight;

  double length() const { return this->radius * this->angle + this->straight; }

  /// Of a place (x, y) of the section, so far along the middle line.
  Eigen::RowVector3d place(double x, double y, double way) const
  {
    const double turned = std::min(way / this->radius, this->angle);
    const double ahead = way - this->radius * turned;
    const double distance = this->radius + x;
    return { distance * std::cos(turned) - ahead * std::sin(turned), y,
      distance * std::sin(turned) + ahead * std::cos(turned) };
  }

  /// How far along the middle line a place is whose section contains it.
  double wayOf(const Eigen::RowVector3d& place) const
  {
    const double turned = std::atan2(place.z(), place.x());
    if (turned < this->angle)
    {
      return this->radius * turned;
    }
    const double ahead = -place.x() * std::sin(this->angle) + place.z() * std::cos(this->angle);
    return this->radius * this->angle + ahead;
  }
};

/// A circle of the section.
struct Circle
{
  double x;
  double y;
  double radius;
};

test::TubePlace onPipe(const Bend& bend, const Circle& circle)
{
  return [=](double v, double u) {
    return bend.place(circle.x + circle.radius * std::cos(TwoPi * v),
      circle.y + circle.radius * std::sin(TwoPi * v), u * bend.length());
  };
}

LinkingMesh meshed(const Bend& bend, const std::vector<Circle>& circles)
{
  std::vector<SideTube> sides;
  std::vector<Loop> loops;
  Points ring(static_cast<Index>(circles.size()) * Around, 3);
  for (const Circle& circle : circles)
  {
    sides.push_back(tube(96, 80, onPipe(bend, circle), {}, 0.2));
    Loop& loop = loops.emplace_back();
    for (Index j = 0; j < Around; ++j)
    {
      loop.push_back(static_cast<Index>(loops.size() - 1) * Around + j);
      ring.row(loop.back()) =
        onPipe(bend, circle)(static_cast<double>(j) / static_cast<double>(Around), 0.0);
    }
  }
  hexsweep::LayerRequest request;
  request.layers = Layers;
  return hexsweep::meshLinkingSides(ring, loops, sides, request);
}

Eigen::RowVector3d node(const LinkingMesh& mesh, std::size_t side, Index k, Index j)
{
  return mesh.rings.points.row(mesh.rings.tables[side](k, j));
}

TEST(RingAlignment, SectionsOfABendAreTurnedSources)
{
  const Bend bend{ 2.0, 2.1, 0.0 };
  const std::vector<Circle> circles = { { 0.0, 0.0, 1.5 }, { 0.6, 0.3, 0.4 } };
  const LinkingMesh mesh = meshed(bend, circles);
  for (std::size_t side = 0; side < circles.size(); ++side)
  {
    for (Index k = 0; k <= Layers; ++k)
    {
      for (Index j = 0; j < Around; ++j)
      {
        const Eigen::RowVector3d wanted =
          onPipe(bend, circles[side])(static_cast<double>(j) / static_cast<double>(Around),
            static_cast<double>(k) / static_cast<double>(Layers));
        // A tenth of the way from node to node.
        EXPECT_LT((node(mesh, side, k, j) - wanted).norm(),
          0.1 * circles[side].radius * TwoPi / static_cast<double>(Around))
          << "side " << side << " ring " << k << " column " << j;
      }
    }
  }
}

TEST(RingAlignment, RingsLieAcrossAPipeThatIsBentAndStraight)
{
  const Bend bend{ 2.0, 1.5, 4.0 };
  const std::vector<Circle> circles = { { 0.0, 0.0, 0.6 }, { -0.25, 0.2, 0.15 } };
  const LinkingMesh mesh = meshed(bend, circles);
  // At equal fractions of their lengths, which are 5.2 + 0.9 and 7.0 + 0.9, the inner and the outer
  // column would be a whole unit apart where the bend ends.
  for (Index k = 1; k < Layers; ++k)
  {
    double least = bend.length();
    double most = 0.0;
    for (std::size_t side = 0; side < circles.size(); ++side)
    {
      for (Index j = 0; j < Around; ++j)
      {
        const double way = bend.wayOf(node(mesh, side, k, j));
        least = std::min(least, way);
        most = std::max(most, way);
      }
    }
    EXPECT_LT(most - least, 0.25) << "ring " << k;
  }
}

TEST(RingAlignment, SectionsThatChangeTheirShapeStayAsTheyAre)
{
  // A cone is a harmonic strip with straight columns: nothing to gain.
  const LinkingMesh mesh = [] {
    const test::TubePlace cone = [](double v, double u) -> Eigen::RowVector3d {
      const double radius = 1.0 + u;
      return { radius * std::cos(TwoPi * v), radius * std::sin(TwoPi * v), 2.0 * u };
    };
    Points ring(Around, 3);
    Loop loop;
    for (Index j = 0; j < Around; ++j)
    {
      ring.row(j) = cone(static_cast<double>(j) / static_cast<double>(Around), 0.0);
      loop.push_back(j);
    }
    hexsweep::LayerRequest request;
    request.layers = Layers;
    return hexsweep::meshLinkingSides(ring, { loop }, { tube(96, 40, cone, {}, 0.2) }, request);
  }();
  for (Index k = 0; k <= Layers; ++k)
  {
    for (Index j = 0; j < Around; ++j)
    {
      EXPECT_NEAR(node(mesh, 0, k, j).z(), 2.0 * static_cast<double>(k) / Layers, 1e-3);
    }
  }
}
}
