// SPDX-License-Identifier: BSD-3-Clause
// The source pinned to the disk of the target: where it must hold, and where it must fold.
#include "Core/DiskMaps/PaperDiskMap.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Support/CapMeshes.h"

#include <complex>
#include <tuple>

namespace TestPaperHarmonic
{
using namespace hexsweep;
using test::Pi;

/// The annulus inner <= |z| <= 1 and its loops, from angle 0 on, counter-clockwise both.
struct Ring
{
  TriangleMesh mesh;
  Loop hole;
  Loop outer;
};

/// `around` nodes on each circle; circles in geometric progression, so that all cells are alike:
/// `length` times as long as they are wide.
Ring evenRing(double inner, Index around, double length = 1.0)
{
  const double step = length * 2.0 * Pi / static_cast<double>(around);
  const Index rings = std::max<Index>(4, 1 + std::lround(-std::log(inner) / step));
  Ring ring{ test::annulus(inner, 1.0, rings, around), {}, {} };
  for (Index k = 0; k < rings; ++k)
  {
    const double radius =
      std::pow(inner, 1.0 - static_cast<double>(k) / static_cast<double>(rings - 1));
    for (Index j = 0; j < around; ++j)
    {
      auto point = ring.mesh.points.row(k * around + j);
      point *= radius / point.norm();
    }
  }
  for (Index j = 0; j < around; ++j)
  {
    ring.hole.push_back(j);
    ring.outer.push_back((rings - 1) * around + j);
  }
  return ring;
}

/// Source and target as the linking sides tie them: the hole turned by a number of cells.
std::vector<LoopPair> pairsOf(const Ring& source, const Ring& target, Index cells)
{
  const Index around = static_cast<Index>(source.hole.size());
  LoopPair outer{ Points(around, 3), Points(around, 3) };
  LoopPair hole = outer;
  for (Index j = 0; j < around; ++j)
  {
    const auto at = [](const Ring& ring, const Loop& loop, Index k) {
      return ring.mesh.points.row(loop[static_cast<std::size_t>(k)]);
    };
    outer.first.row(j) = at(source, source.outer, j);
    outer.second.row(j) = at(target, target.outer, j);
    hole.first.row(j) = at(source, source.hole, j);
    hole.second.row(j) = at(target, target.hole, (j + cells) % around);
  }
  return { outer, hole };
}

/// The same map as paperDiskMap(), by its parts, with the source's matrix factored once.
class PinnedRing
{
public:
  PinnedRing(double radius, Index around, Index cells)
    : Source(evenRing(radius, around))
    , Solver(cotangentLaplacian(this->Source.mesh.points, this->Source.mesh.triangles),
        boundaryFlags(this->Source.mesh.points.rows(), { this->Source.outer, this->Source.hole }))
    , Around(around)
    , Cells(cells)
  {
  }

  /// H2's inner radius, and the source's triangles that are flipped in it.
  struct Image
  {
    double radius;
    std::vector<Index> flipped;
  };

  /// @param radius of the target; its cells are long, since H2 is all that matters of it.
  Image mapTo(double radius) const
  {
    const Ring target = evenRing(radius, this->Around, static_cast<double>(this->Around) / 48.0);
    const Loop hole(target.hole.rbegin(), target.hole.rend());
    const CanonicalBoundary boundary = canonicalBoundary(target.mesh, { target.outer, hole },
      { std::vector<double>(target.outer.size()), std::vector<double>(hole.size()) });
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(this->Source.mesh.points.rows(), 2);
    for (Index j = 0; j < this->Around; ++j)
    {
      const auto column = static_cast<std::size_t>(j);
      values.row(this->Source.outer[column]) = boundary.places[0].row(j);
      values.row(this->Source.hole[column]) =
        boundary.places[1].row(this->Around - 1 - (j + this->Cells) % this->Around);
    }
    const PlanePoints disk = this->Solver.solve(values);
    return { boundary.holes[0].radius,
      domainTriangles(boundary.domain, disk, this->Source.mesh.triangles).flipped };
  }

  /// H2's inner radius at which the first triangle flips, to 5e-5 of it.
  double threshold(double low, double high) const
  {
    EXPECT_TRUE(this->mapTo(low).flipped.empty());
    Image folded = this->mapTo(high);
    EXPECT_FALSE(folded.flipped.empty());
    while (high - low > 5e-5 * low)
    {
      const double middle = 0.5 * (low + high);
      Image image = this->mapTo(middle);
      if (image.flipped.empty())
      {
        low = middle;
      }
      else
      {
        high = middle;
        folded = std::move(image);
      }
    }
    // Points below Around are those of the hole.
    for (const Index t : folded.flipped)
    {
      EXPECT_LT(this->Source.mesh.triangles.row(t).minCoeff(), this->Around)
        << "folds away from the hole first";
    }
    return folded.radius;
  }

private:
  Ring Source;
  DirichletSolver Solver;
  Index Around;
  Index Cells;
};

class NitscheBound : public testing::TestWithParam<std::tuple<double, int>>
{
protected:
  double radius = std::get<0>(GetParam());
  int degrees = std::get<1>(GetParam());
  double bound =
    2.0 * this->radius * std::cos(this->degrees * Pi / 180.0) / (1.0 + this->radius * this->radius);
};

// The error is of first order in the cells: the derivative along a radius is taken half a cell away
// from the hole (folds later), and across a diagonal when the hole turns (folds earlier).
TEST_P(NitscheBound, IsWhereTheMapFoldsOnFineMeshes)
{
  std::vector<double> errors;
  for (const Index around : { 96, 192, 384 })
  {
    const PinnedRing ring(this->radius, around, around * this->degrees / 360);
    const double found = ring.threshold(0.93 * this->bound, 1.06 * this->bound);
    RecordProperty("threshold" + std::to_string(around), std::to_string(found));
    errors.push_back(found / this->bound - 1.0);
    EXPECT_LT(std::abs(errors.back()), 0.65 * 2.0 * Pi / static_cast<double>(around));
  }
  EXPECT_LT(std::abs(errors[2]), 0.01);
  EXPECT_LT(std::abs(errors[1]), 0.55 * std::abs(errors[0]) + 5e-4);
  EXPECT_LT(std::abs(errors[2]), 0.55 * std::abs(errors[1]) + 5e-4);
  // Extrapolated to cells of no size.
  EXPECT_NEAR(2.0 * errors[2] - errors[1], 0.0, 1e-3);
}

TEST_P(NitscheBound, IsReportedAndDoesNotBindTheCommonDomain)
{
  const Index around = 192;
  const Ring source = evenRing(this->radius, around);
  for (const double part : { 0.96, 1.04 })
  {
    const Ring target = evenRing(part * this->bound, around, 2.0);
    const std::vector<LoopPair> pairs = pairsOf(source, target, around * this->degrees / 360);
    const PaperDisks pinned = paperDiskMap(hexsweep::makeCap(source.mesh, "source"),
      hexsweep::makeCap(target.mesh, "target"), pairs, Weights::Cotangent, 1e-6);
    EXPECT_EQ(pinned.disks.first.flipped.empty(), part < 1.0) << part;
    EXPECT_TRUE(pinned.disks.second.flipped.empty());
    ASSERT_TRUE(pinned.nitsche);
    EXPECT_NEAR(pinned.nitsche->ratio(), 1.0 / part, 2e-3);
    EXPECT_NEAR(pinned.nitsche->sourceRadius, this->radius, 1e-3 * this->radius);
    EXPECT_NEAR(std::abs(pinned.nitsche->turn), this->degrees * Pi / 180.0, 1e-9);

    const CommonDisks common = commonDiskMap(hexsweep::makeCap(source.mesh, "source"),
      hexsweep::makeCap(target.mesh, "target"), pairs, Weights::Cotangent, 1e-6);
    EXPECT_TRUE(common.first.flipped.empty());
    EXPECT_TRUE(common.second.flipped.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(PaperHarmonic, NitscheBound,
  testing::Combine(testing::Values(0.2, 0.5), testing::Values(0, 15, 30, 45, 60)));

TEST(PaperHarmonic, FoldsBeyondAQuarterTurnHoweverSmallTheHole)
{
  const Ring source = evenRing(0.2, 72);
  const Ring target = evenRing(0.05, 72);
  const PaperDisks pinned =
    paperDiskMap(hexsweep::makeCap(source.mesh, "source"), hexsweep::makeCap(target.mesh, "target"),
      pairsOf(source, target, 20), Weights::Cotangent, 1e-6);
  EXPECT_FALSE(pinned.disks.first.flipped.empty());
  EXPECT_LT(pinned.nitsche->ratio(), 0.0);
}

// The closed form a z + b / conj(z) of the header, at all nodes.
TEST(PaperHarmonic, IsTheKnownMapOfAnAnnulus)
{
  const double r = 0.4;
  const double rho = 0.3;
  double last = 0.0;
  for (const Index around : { 36, 72, 144 })
  {
    const Ring source = evenRing(r, around);
    const Ring target = evenRing(rho, around);
    const PaperDisks pinned = paperDiskMap(hexsweep::makeCap(source.mesh, "source"),
      hexsweep::makeCap(target.mesh, "target"), pairsOf(source, target, around / 12),
      Weights::Cotangent, 1e-6);
    const std::complex<double> inner = std::polar(rho, Pi / 6.0);
    const std::complex<double> a = (1.0 - r * inner) / (1.0 - r * r);
    const std::complex<double> b = 1.0 - a;
    const auto complexOf = [](const auto& row) { return std::complex<double>(row[0], row[1]); };
    // Conformal angles begin anywhere: compare after the rotation that fits the first outer node.
    const Index first = source.outer[0];
    const std::complex<double> rotation = complexOf(pinned.disks.first.disk.row(first));
    EXPECT_NEAR(std::abs(rotation), 1.0, 1e-14);
    double error = 0.0;
    for (Index i = 0; i < source.mesh.points.rows(); ++i)
    {
      const std::complex<double> z = complexOf(source.mesh.points.row(i));
      const std::complex<double> expected = rotation * (a * z + b / std::conj(z));
      error = std::max(error, std::abs(complexOf(pinned.disks.first.disk.row(i)) - expected));
    }
    EXPECT_LT(error, last > 0.0 ? last / 3.5 : 0.01) << around;
    last = error;
  }
}

TEST(PaperHarmonic, PutsTheOuterLoopWhereTheTargetHasIt)
{
  // One loop: the target's own arc length, not the mean of both.
  const TriangleMesh source = test::plate(12, {}, 0.2, 1);
  TriangleMesh target = test::plate(12, {}, 0.2, 1);
  target.points.col(0) *= 3.0;
  const std::vector<Loop> loops = test::loopsOf(source);
  const PaperDisks pinned =
    paperDiskMap(hexsweep::makeCap(source, "source"), hexsweep::makeCap(target, "target"),
      test::pairsOf(source.points, target.points, loops), Weights::Cotangent, 1e-6);
  EXPECT_FALSE(pinned.nitsche);
  EXPECT_EQ(pinned.disks.first.domain, DiskDomain::Disk);
  EXPECT_TRUE(pinned.disks.first.flipped.empty());
  EXPECT_TRUE(pinned.disks.second.flipped.empty());
  const double whole = test::loopLength(target.points, loops[0]);
  double length = 0.0;
  for (std::size_t k = 0; k < loops[0].size(); ++k)
  {
    const Index next = loops[0][(k + 1) % loops[0].size()];
    length += (target.points.row(next) - target.points.row(loops[0][k])).norm();
    const Eigen::RowVector2d start = pinned.disks.first.disk.row(loops[0][0]);
    const Eigen::RowVector2d place = pinned.disks.first.disk.row(next);
    const double angle = 2.0 * Pi * length / whole;
    EXPECT_NEAR(start.dot(place), std::cos(angle), 1e-12);
    EXPECT_NEAR(start.x() * place.y() - start.y() * place.x(), std::sin(angle), 1e-12);
    EXPECT_EQ(place, pinned.disks.second.disk.row(next).eval());
  }
}

TEST(PaperHarmonic, PutsHolesOnTheCirclesOfTheTarget)
{
  const TriangleMesh source = test::plate(24, { { 4, 4, 4, 4 }, { 14, 6, 6, 4 }, { 8, 14, 4, 6 } });
  TriangleMesh target = source;
  target.points = test::lifted(target.points, test::bump);
  const std::vector<Loop> loops = test::loopsOf(source);
  const PaperDisks pinned =
    paperDiskMap(hexsweep::makeCap(source, "source"), hexsweep::makeCap(target, "target"),
      test::pairsOf(source.points, target.points, loops), Weights::Cotangent, 1e-6);
  EXPECT_FALSE(pinned.nitsche);
  EXPECT_EQ(pinned.disks.first.domain, DiskDomain::Circles);
  ASSERT_EQ(pinned.disks.second.holes.size(), 3u);
  for (const CapDisk* cap : { &pinned.disks.first, &pinned.disks.second })
  {
    EXPECT_TRUE(cap->flipped.empty());
    for (std::size_t h = 0; h < 3; ++h)
    {
      for (const Index v : cap->loops[h + 1])
      {
        EXPECT_NEAR((cap->disk.row(v) - pinned.disks.second.holes[h].center).norm(),
          pinned.disks.second.holes[h].radius, 1e-14);
      }
    }
  }
}

TEST(PaperHarmonic, PinsTheSourceWhicheverCapTheLinkingSidesBeginWith)
{
  const QuadMesh narrow = test::quadPlate(10, {}, 0.2, 1);
  QuadMesh wide = narrow;
  wide.points.col(0) *= 3.0;
  wide.points.col(2).setConstant(2.0);
  const std::vector<Loop> loops = checkSurface(narrow.quads, narrow.points.rows(), "plate").loops;
  for (const bool widens : { true, false })
  {
    const QuadMesh& source = widens ? narrow : wide;
    const QuadMesh& target = widens ? wide : narrow;
    SweepProjectionInput input;
    input.source = source;
    input.target = { target.points, halveQuads(target.points, target.quads) };
    input.linking = test::traced(source, test::linkingSides(narrow.points, wide.points, loops));
    input.method = ProjectionMethod::PaperHarmonic;
    const SweepProjection result = projectSweep(input);
    EXPECT_EQ(result.quality.inverted, 0);
    // The target's arc length makes the angles in the disk.
    const double whole = test::loopLength(target.points, loops[0]);
    for (std::size_t k = 0; k < loops[0].size(); ++k)
    {
      const Index a = loops[0][k];
      const Index b = loops[0][(k + 1) % loops[0].size()];
      const double length = (target.points.row(b) - target.points.row(a)).norm();
      for (const CapDisk* cap : { &*result.source, &*result.target })
      {
        EXPECT_NEAR(
          cap->disk.row(a).dot(cap->disk.row(b)), std::cos(2.0 * Pi * length / whole), 1e-12);
      }
    }
  }
}
}
