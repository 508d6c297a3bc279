// SPDX-License-Identifier: BSD-3-Clause
// Plane quads carried to caps that are no graph over any plane: hemispheres and three quarters of a
// sphere, with and without a hole, at the pole and off it.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkSweepQuadProjector.h>

#include <complex>

namespace TestCurvedCaps
{
using test::Corners;
using test::Grid;
using test::report;
using test::SweepGrids;
using Complex = std::complex<double>;
using Place = std::array<double, 3>;

const double Pi = std::acos(-1.0);

/// A flat mesh of the unit disk, and its boundary nodes loop by loop.
struct FlatMesh
{
  std::vector<Complex> points;
  std::vector<Corners> cells;
  std::vector<std::vector<vtkIdType>> loops;
};

std::vector<vtkIdType> circleNodes(vtkIdType first, int around)
{
  std::vector<vtkIdType> nodes;
  for (int j = 0; j < around; ++j)
  {
    nodes.push_back(first + j);
  }
  return nodes;
}

/// Cells between circles of nodes that begin at the point `first`.
void addRings(FlatMesh& mesh, vtkIdType first, int rings, int around)
{
  for (int k = 0; k < rings; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      const vtkIdType a = first + k * around + j;
      const vtkIdType b = first + k * around + (j + 1) % around;
      mesh.cells.push_back({ a, a + around, b + around, b });
    }
  }
}

/// Quads between the hole and the unit circle; a Moebius map of the disk moves the hole's middle
/// from 0 to about `shift`.
FlatMesh ring(double hole, Complex shift, int rings, int around)
{
  FlatMesh mesh;
  for (int k = 0; k <= rings; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      const double radius = hole + (1.0 - hole) * k / rings;
      const Complex z = std::polar(radius, 2.0 * Pi * j / around);
      mesh.points.push_back((z + shift) / (1.0 + std::conj(shift) * z));
    }
  }
  addRings(mesh, 0, rings, around);
  mesh.loops = { circleNodes(rings * around, around), circleNodes(0, around) };
  return mesh;
}

/// Quads of the whole disk: a square of n x n in the middle, rings round it.
FlatMesh disk(int n, int rings)
{
  FlatMesh mesh;
  const double half = 0.45;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.points.emplace_back(half * (2.0 * i / n - 1.0), half * (2.0 * j / n - 1.0));
    }
  }
  const auto square = [n](int i, int j) { return static_cast<vtkIdType>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      mesh.cells.push_back(
        { square(i, j), square(i + 1, j), square(i + 1, j + 1), square(i, j + 1) });
    }
  }
  std::vector<vtkIdType> rim;
  for (int i = 0; i < n; ++i)
  {
    rim.push_back(square(i, 0));
  }
  for (int i = 0; i < n; ++i)
  {
    rim.push_back(square(n, i));
  }
  for (int i = 0; i < n; ++i)
  {
    rim.push_back(square(n - i, n));
  }
  for (int i = 0; i < n; ++i)
  {
    rim.push_back(square(0, n - i));
  }
  const int around = 4 * n;
  const vtkIdType first = static_cast<vtkIdType>(mesh.points.size());
  for (int k = 1; k <= rings; ++k)
  {
    for (int j = 0; j < around; ++j)
    {
      const double t = 1.0 * k / rings;
      const Complex onCircle = std::polar(1.0, 2.0 * Pi * (1.0 * j / around - 0.375));
      mesh.points.push_back(
        (1.0 - t) * mesh.points[static_cast<std::size_t>(rim[j])] + t * onCircle);
    }
  }
  for (int j = 0; j < around; ++j)
  {
    const auto here = static_cast<std::size_t>(j);
    const auto next = static_cast<std::size_t>((j + 1) % around);
    mesh.cells.push_back({ rim[here], first + j, first + (j + 1) % around, rim[next] });
  }
  addRings(mesh, first, rings - 1, around);
  mesh.loops = { circleNodes(first + (rings - 1) * around, around) };
  return mesh;
}

/// Every quad cut in two along one diagonal or the other.
std::vector<Corners> halved(const std::vector<Corners>& quads)
{
  std::vector<Corners> triangles;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    const std::size_t s = q % 2;
    const Corners& c = quads[q];
    triangles.push_back({ c[s], c[s + 1], c[s + 2] });
    triangles.push_back({ c[s], c[s + 2], c[(s + 3) % 4] });
  }
  return triangles;
}

/// How a cap bends: the disk point p goes to the unit sphere, |p| times `opening` from the pole; a
/// wave lifts the rim five times.
Place onSphere(double opening, double wave, Complex p)
{
  const double radius = std::abs(p);
  const double angle = opening * radius * (1.0 - wave * (1.0 + std::cos(5.0 * std::arg(p))));
  const Complex way = std::abs(p) > 0.0 ? std::polar(std::sin(angle), std::arg(p)) : Complex(0.0);
  return { way.real(), way.imag(), std::cos(angle) };
}

std::vector<Place> shaped(
  const std::vector<Complex>& points, const std::function<Place(Complex)>& f)
{
  std::vector<Place> places;
  for (const Complex& p : points)
  {
    places.push_back(f(p));
  }
  return places;
}

struct CurvedCase
{
  std::string name;
  double opening;      ///< from the pole to the rim
  double hole;         ///< radius in the disk, 0 for none
  Complex sourceShift; ///< of the hole
  Complex targetShift;
  bool straightColumns; ///< else they end along the sphere's normal
  double growth = 1.3;  ///< of the hole's radius in the disk
  int turn = 0;         ///< of the hole's columns, in fortieths
  double wave = 0.0;    ///< of the rim, five times round
};

std::ostream& operator<<(std::ostream& out, const CurvedCase& curved)
{
  return out << curved.name;
}

/// The target surface has twice the nodes round its loops, and a hole of another radius.
SweepGrids curvedSweep(const CurvedCase& curved)
{
  const int around = 40;
  const bool whole = curved.hole == 0.0;
  const FlatMesh quads =
    whole ? disk(around / 4, 8) : ring(curved.hole, curved.sourceShift, 12, around);
  const FlatMesh target = whole
    ? disk(around / 2, 18)
    : ring(curved.growth * curved.hole, curved.targetShift, 28, 2 * around);
  const auto plane = [](Complex p) { return Place{ p.real(), p.imag(), -2.0 }; };
  const auto sphere = [&](Complex p) { return onSphere(curved.opening, curved.wave, p); };

  SweepGrids sweep;
  const std::vector<Place> source = shaped(quads.points, plane);
  const std::vector<Place> surface = shaped(target.points, sphere);
  sweep.sourceQuads = test::gridOf(source, quads.cells, VTK_QUAD);
  sweep.sourceSurface = test::gridOf(source, halved(quads.cells), VTK_TRIANGLE);
  sweep.targetSurface = test::gridOf(surface, halved(target.cells), VTK_TRIANGLE);

  std::vector<Place> points;
  std::vector<Corners> cells;
  for (std::size_t l = 0; l < quads.loops.size(); ++l)
  {
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    for (int j = 0; j < around; ++j)
    {
      const auto here = static_cast<std::size_t>(j);
      const auto end = static_cast<std::size_t>(l == 0 ? j : (j + curved.turn) % around);
      const Place from = source[static_cast<std::size_t>(quads.loops[l][here])];
      const Place to = surface[static_cast<std::size_t>(target.loops[l][2 * end])];
      const double inside = curved.straightColumns ? 0.5 : 0.8;
      Place middle;
      for (std::size_t c = 0; c < 3; ++c)
      {
        middle[c] = curved.straightColumns ? 0.5 * (from[c] + to[c]) : inside * to[c];
      }
      points.insert(points.end(), { from, middle, to });
    }
    for (int j = 0; j < around; ++j)
    {
      for (int k = 0; k < 2; ++k)
      {
        const vtkIdType a = first + 3 * j + k;
        const vtkIdType b = first + 3 * ((j + 1) % around) + k;
        cells.push_back({ a, b, b + 1, a + 1 });
      }
    }
  }
  sweep.linkingSides = test::gridOf(points, cells, VTK_QUAD);
  return sweep;
}

/// On the unit sphere the true normal is the place itself: all corners turn the same way about it.
void expectUpright(vtkUnstructuredGrid* quads)
{
  vtkIdType positive = 0;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    const Corners corners = test::cornersOf(quads, q);
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Place p = test::pointOf(quads, corners[c]);
      const Place a = test::pointOf(quads, corners[(c + 1) % 4]);
      const Place b = test::pointOf(quads, corners[(c + 3) % 4]);
      // det(a - p, b - p, p) = det(a, b, p)
      const double turn = a[0] * (b[1] * p[2] - b[2] * p[1]) - a[1] * (b[0] * p[2] - b[2] * p[0]) +
        a[2] * (b[0] * p[1] - b[1] * p[0]);
      positive += turn > 0.0 ? 1 : 0;
    }
  }
  EXPECT_EQ(positive, 4 * quads->GetNumberOfCells());
}

class CurvedCaps : public testing::TestWithParam<CurvedCase>
{
};

TEST_P(CurvedCaps, EveryQuadLandsUprightOnTheSurface)
{
  const SweepGrids sweep = curvedSweep(GetParam());
  for (const bool ownSurface : { true, false })
  {
    vtkNew<vtkSweepQuadProjector> filter;
    filter->SetInputData(0, sweep.sourceQuads);
    filter->SetInputData(1, sweep.targetSurface);
    filter->SetInputData(2, sweep.linkingSides);
    if (ownSurface)
    {
      filter->SetInputData(3, sweep.sourceSurface);
    }
    test::Events events(filter);
    filter->Update();
    ASSERT_TRUE(events.errors.empty()) << events.errors[0];
    vtkUnstructuredGrid* output = filter->GetOutput();
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
    // Where the hole turns that far, quads are carried along the sides, without disk maps.
    const bool isCarried = !output->GetFieldData()->HasArray(hexsweep::reports::FlipsAfter);
    EXPECT_EQ(isCarried, std::string(GetParam().name) == "ThreeQuartersHoleTurnsAndShrinks");
    EXPECT_EQ(isCarried ? 0.0 : report(output, hexsweep::reports::FlipsAfter), 0);
    EXPECT_EQ(report(output, hexsweep::reports::Outside), 0);
    EXPECT_TRUE(events.warnings.empty()) << events.warnings[0];
    // A wavy rim folds quads that the projection carries over; elsewhere it is upright by itself.
    EXPECT_EQ(
      report(output, hexsweep::reports::InvertedBefore) > 0, GetParam().wave > 0.0 || isCarried);
    expectUpright(output);

    std::map<Place, Place> ends;
    for (vtkIdType i = 0; i < sweep.linkingSides->GetNumberOfPoints(); i += 3)
    {
      ends[test::pointOf(sweep.linkingSides, i)] = test::pointOf(sweep.linkingSides, i + 2);
    }
    test::expectOnTarget(output, sweep, ends);
  }
}

INSTANTIATE_TEST_SUITE_P(Spheres, CurvedCaps,
  testing::Values(CurvedCase{ "Hemisphere", Pi / 2, 0.0, 0.0, 0.0, true },
    CurvedCase{ "HemisphereAlongNormals", Pi / 2, 0.0, 0.0, 0.0, false },
    CurvedCase{ "HemisphereHoleAtThePole", Pi / 2, 0.2, 0.0, 0.0, true },
    CurvedCase{ "HemisphereHoleOffThePole", Pi / 2, 0.2, 0.3, 0.45, true },
    CurvedCase{ "HemisphereHoleMovesToTheOtherSide", Pi / 2, 0.2, 0.3, -0.4, false },
    CurvedCase{ "ThreeQuarters", 2 * Pi / 3, 0.0, 0.0, 0.0, true },
    CurvedCase{ "ThreeQuartersAlongNormals", 2 * Pi / 3, 0.0, 0.0, 0.0, false },
    CurvedCase{ "ThreeQuartersHoleAtThePole", 2 * Pi / 3, 0.2, 0.0, 0.0, true },
    CurvedCase{ "ThreeQuartersHoleOffThePole", 2 * Pi / 3, 0.2, 0.3, { 0.3, 0.3 }, true },
    CurvedCase{ "ThreeQuartersHoleMovesToTheOtherSide", 2 * Pi / 3, 0.2, 0.3, -0.4, false },
    CurvedCase{ "HemisphereHoleTurnsAndGrows", Pi / 2, 0.2, 0.3, -0.3, true, 2.5, 8 },
    CurvedCase{ "ThreeQuartersHoleTurnsAndGrows", 2 * Pi / 3, 0.2, 0.3, -0.3, false, 2.5, 13 },
    CurvedCase{ "ThreeQuartersHoleTurnsAndShrinks", 2 * Pi / 3, 0.4, 0.3, -0.3, false, 0.3, 16 },
    CurvedCase{ "HemisphereWavyRim", Pi / 2, 0.0, 0.0, 0.0, true, 1.0, 0, 0.3 },
    CurvedCase{ "ThreeQuartersWavyRim", 2 * Pi / 3, 0.0, 0.0, 0.0, false, 1.0, 0, 0.3 },
    CurvedCase{ "ThreeQuartersWavyRimHole", 2 * Pi / 3, 0.2, 0.3, -0.3, false, 2.0, 8, 0.25 }),
  [](const auto& curved) { return curved.param.name; });
}
