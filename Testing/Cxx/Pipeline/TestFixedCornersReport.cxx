// SPDX-License-Identifier: BSD-3-Clause
// Quads whose corner lies between two boundary edges of the target cap at 180 degrees or more: no
// place of the inner nodes makes them valid.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkSweepQuadProjector.h>

#include <vtkDataArray.h>

namespace TestFixedCornersReport
{
using test::Corners;
using test::report;
using test::SweepGrids;
using Place = std::array<double, 3>;

const double Pi = std::acos(-1.0);

/// A round rim, pulled in by `dent` at 45, 135, 225 and 315 degrees: smooth, and concave there from
/// about 1/17 on.
Place onRim(double angle, double dent)
{
  const double radius = 1.0 + dent * std::cos(4.0 * angle);
  return { radius * std::cos(angle), radius * std::sin(angle), 2.0 };
}

/// A square of n x n quads below a plane disk, its corners below the dents of the rim.
SweepGrids squareOntoDisk(int n, double dent)
{
  std::vector<Place> source;
  std::vector<Corners> quads;
  const auto node = [n](int i, int j) { return static_cast<vtkIdType>(j * (n + 1) + i); };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      source.push_back({ 1.4 * i / n - 0.7, 1.4 * j / n - 0.7, 0.0 });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      quads.push_back({ node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1) });
    }
  }

  const int around = 4 * n;
  const int rings = n;
  std::vector<Place> target{ { 0.0, 0.0, 2.0 } };
  std::vector<Corners> triangles;
  for (int k = 1; k <= rings; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      const Place p = onRim(2.0 * Pi * j / around - 0.75 * Pi, dent);
      target.push_back({ p[0] * k / rings, p[1] * k / rings, p[2] });
      const vtkIdType a = 1 + (k - 1) * around + j;
      const vtkIdType b = 1 + (k - 1) * around + (j + 1) % around;
      if (k == 1)
      {
        triangles.push_back({ 0, a, b });
      }
      else
      {
        triangles.push_back({ a - around, a, b });
        triangles.push_back({ a - around, b, b - around });
      }
    }
  }

  std::vector<vtkIdType> rim; // from (0, 0) on, which lands at -135 degrees
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < n; ++i)
    {
      const int along[4][2] = { { i, 0 }, { n, i }, { n - i, n }, { 0, n - i } };
      rim.push_back(node(along[side][0], along[side][1]));
    }
  }
  std::vector<Place> columns;
  std::vector<Corners> sides;
  for (int j = 0; j < around; ++j)
  {
    const Place from = source[static_cast<std::size_t>(rim[static_cast<std::size_t>(j)])];
    const Place to = target[static_cast<std::size_t>(1 + (rings - 1) * around + j)];
    columns.insert(columns.end(), { from, { to[0], to[1], 1.0 }, to });
    for (int k = 0; k < 2; ++k)
    {
      const vtkIdType a = 3 * j + k;
      const vtkIdType b = 3 * ((j + 1) % around) + k;
      sides.push_back({ a, b, b + 1, a + 1 });
    }
  }
  return { test::gridOf(source, quads, VTK_QUAD), nullptr,
    test::gridOf(target, triangles, VTK_TRIANGLE), test::gridOf(columns, sides, VTK_QUAD) };
}

struct Result
{
  vtkNew<vtkSweepQuadProjector> filter;
  test::Events events;
  vtkUnstructuredGrid* output = nullptr;

  explicit Result(const SweepGrids& sweep)
    : events(filter)
  {
    this->filter->SetInputData(0, sweep.sourceQuads);
    this->filter->SetInputData(1, sweep.targetSurface);
    this->filter->SetInputData(2, sweep.linkingSides);
  }
  void run()
  {
    this->filter->Update();
    ASSERT_TRUE(this->events.errors.empty()) << this->events.errors[0];
    this->output = this->filter->GetOutput();
  }
};

/// Sine of the rim's inner angle at a dent, from the rim's nodes.
double sineAtDent(int n, double dent)
{
  const Place p = onRim(0.25 * Pi, dent);
  const Place a = onRim(0.25 * Pi + 0.5 * Pi / n, dent);
  const Place b = onRim(0.25 * Pi - 0.5 * Pi / n, dent);
  const double u[2] = { a[0] - p[0], a[1] - p[1] };
  const double v[2] = { b[0] - p[0], b[1] - p[1] };
  return (u[0] * v[1] - u[1] * v[0]) / (std::hypot(u[0], u[1]) * std::hypot(v[0], v[1]));
}

/// Cells with a corner that turns the wrong way in the plane of the target cap.
std::set<vtkIdType> invertedCells(vtkUnstructuredGrid* quads)
{
  std::set<vtkIdType> inverted;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    const Corners corners = test::cornersOf(quads, q);
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Place p = test::pointOf(quads, corners[c]);
      const Place a = test::pointOf(quads, corners[(c + 1) % 4]);
      const Place b = test::pointOf(quads, corners[(c + 3) % 4]);
      if (!((a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0]) > 0.0))
      {
        inverted.insert(q);
      }
    }
  }
  return inverted;
}

std::set<vtkIdType> cornerCells(vtkIdType n)
{
  return { 0, n - 1, n * (n - 1), n * n - 1 };
}

TEST(FixedCorners, OnlyTheQuadsAtConcaveRimNodesStayInverted)
{
  for (const int n : { 8, 16 })
  {
    const double dent = 0.12;
    Result result(squareOntoDisk(n, dent));
    result.run();
    ASSERT_NE(result.output, nullptr);
    EXPECT_LT(sineAtDent(n, dent), -0.05);
    EXPECT_NEAR(
      report(result.output, hexsweep::reports::FloorScaledJacobian), sineAtDent(n, dent), 1e-12);
    EXPECT_EQ(report(result.output, hexsweep::reports::MinScaledJacobian),
      report(result.output, hexsweep::reports::FloorScaledJacobian));
    EXPECT_EQ(report(result.output, hexsweep::reports::FixedInvertedQuads), 4);
    EXPECT_EQ(report(result.output, hexsweep::reports::InvertedQuads), 4);
    EXPECT_LT(report(result.output, hexsweep::reports::Rounds), 40);
    EXPECT_EQ(invertedCells(result.output), cornerCells(n));
  }
}

TEST(FixedCorners, TheWarningNamesThemAndSaysWhatToDo)
{
  const int n = 8;
  Result result(squareOntoDisk(n, 0.12));
  result.run();
  ASSERT_EQ(result.events.warnings.size(), 1u);
  const std::string& text = result.events.warnings[0];
  for (const char* part : { "4 of 64 quads are inverted", "4 of them", "fixed boundary edges",
         " cell 0 at ", ", cell 7 at ", ", cell 56 at ", ", cell 63 at ", "Move the boundary nodes",
         "change the source quads" })
  {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  }
  EXPECT_EQ(text.find("The others"), std::string::npos) << text;
}

TEST(FixedCorners, AreToldFromQuadsThatCouldBeCured)
{
  // A dent so deep that the affine map leaves inner nodes beyond the rim, and nobody to cure them.
  Result result(squareOntoDisk(12, 0.4));
  result.filter->SetMethodToAffineLeastSquares();
  result.filter->EnsureValidOff();
  result.filter->ImproveQualityOff();
  result.run();
  ASSERT_NE(result.output, nullptr);
  const std::set<vtkIdType> inverted = invertedCells(result.output);
  EXPECT_GT(inverted.size(), 4u);
  EXPECT_EQ(report(result.output, hexsweep::reports::InvertedQuads), inverted.size());
  EXPECT_EQ(report(result.output, hexsweep::reports::FixedInvertedQuads), 4);
  EXPECT_NEAR(
    report(result.output, hexsweep::reports::FloorScaledJacobian), sineAtDent(12, 0.4), 1e-12);
  ASSERT_FALSE(result.events.warnings.empty());
  EXPECT_NE(result.events.warnings.back().find("The others:"), std::string::npos);
}

TEST(FixedCorners, ARoundRimHasAFloorThatIsReached)
{
  // Obtuse corners of the rim's polygon: valid, and the worst of the mesh whatever is done.
  const int n = 8;
  Result result(squareOntoDisk(n, 0.0));
  result.run();
  ASSERT_NE(result.output, nullptr);
  EXPECT_TRUE(result.events.warnings.empty()) << result.events.warnings[0];
  EXPECT_EQ(report(result.output, hexsweep::reports::FixedInvertedQuads), 0);
  // The angle of a regular polygon of 4 n sides is pi - 2 pi / (4 n).
  EXPECT_NEAR(
    report(result.output, hexsweep::reports::FloorScaledJacobian), std::sin(0.5 * Pi / n), 1e-12);
  EXPECT_EQ(report(result.output, hexsweep::reports::MinScaledJacobian),
    report(result.output, hexsweep::reports::FloorScaledJacobian));
}
}
