// SPDX-License-Identifier: BSD-3-Clause
// Volumes that share faces become one conforming mesh: stacked, and side by side.
#include "BlockSolids.h"

#include "HexSweepArrays.h"

#include <vtkMeshQuality.h>

#include <memory>

namespace TestSweepChains
{
using namespace test;

constexpr double Pi = 3.14159265358979323846;
constexpr int QuadsU = 6;
constexpr int QuadsV = 5;
constexpr int Layers = 4;

Point along(const Point& p, double t, const Point& direction)
{
  return { p[0] + t * direction[0], p[1] + t * direction[1], p[2] + t * direction[2] };
}

/// Away from the axes, so that nothing is exact by chance.
Point turned(const Point& p)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Point q = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
}

/// A wedge with a slanted top, a bulging right side and columns that bend.
Point wedge(double u, double v, double w)
{
  return turned({ 3.0 * u + 0.4 * v + 0.5 * w + 0.35 * u * u * std::sin(Pi * v) * (1.0 + 0.3 * w) +
      0.3 * u * w * w,
    2.0 * v + 0.3 * u, (1.5 + 0.4 * u - 0.2 * v) * w });
}

Point onWedge(double u, double v, double w)
{
  return along(wedge(u, v, 1.0), w, turned({ 0.2, 0.1 * w, 1.2 + 0.3 * u }));
}

Point onTop(double u, double v, double w)
{
  const Point middle = onWedge(0.5, 0.5, 1.0);
  const Point p = onWedge(u, v, 1.0);
  const Point inward = { middle[0] - p[0], middle[1] - p[1], middle[2] - p[2] };
  return along(along(p, w, turned({ 0.3, 0.0, 0.9 })), 0.4 * w, inward);
}

const std::array<int, 3> Tessellation = { 2 * QuadsU, 2 * QuadsV, 8 };

std::unique_ptr<SolidSweep> sweep(
  vtkUnstructuredGrid* solid, vtkUnstructuredGrid* quads, int source, vtkIdType layers)
{
  auto result = std::make_unique<SolidSweep>(solid, quads);
  result->name({ source }, {});
  result->filter->SetNumberOfLayers(layers);
  result->filter->Update();
  EXPECT_EQ(result->messages(), "");
  vtkUnstructuredGrid* hexes = result->hexes();
  EXPECT_GT(hexes->GetNumberOfCells(), 0);
  EXPECT_EQ(report(hexes, hexsweep::reports::NotCertified), 0.0);
  return result;
}

std::unique_ptr<SolidSweep> sweepWedge()
{
  const Grid quads = blockFaces(blockOf({ QuadsU, QuadsV, 1 }, wedge), { Bottom }, { Bottom });
  return sweep(blockFaces(blockOf(Tessellation, wedge), allFaces()), quads, Bottom, Layers);
}

/// Point of the wedge's hexahedra on layer k, from its grid of source quads.
Point nodeOf(SolidSweep& swept, int i, int j, int k)
{
  return pointOf(swept.hexes(), (k * (QuadsV + 1) + j) * (QuadsU + 1) + i);
}

double volumeOf(vtkUnstructuredGrid* hexes)
{
  double volume = 0.0;
  for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
  {
    volume += vtkMeshQuality::HexVolume(hexes->GetCell(c));
  }
  return volume;
}

void expectConforming(const std::vector<SolidSweep*>& sweeps, std::size_t points, std::size_t hexes,
  int innerFaces, int outerFaces)
{
  std::vector<vtkUnstructuredGrid*> grids;
  for (SolidSweep* sweep : sweeps)
  {
    grids.push_back(sweep->hexes());
  }
  const MergedHexes mesh = merged(grids);
  EXPECT_EQ(mesh.points.size(), points);
  EXPECT_EQ(mesh.hexes.size(), hexes);
  std::map<int, int> faces;
  for (const auto& [face, count] : mesh.faces)
  {
    ++faces[count];
  }
  EXPECT_EQ(faces, (std::map<int, int>{ { 1, outerFaces }, { 2, innerFaces } }));
}

void expectVolume(SolidSweep& sweep, const SolidBlock& block)
{
  const double volume = enclosedVolume(blockFaces(block, allFaces()));
  EXPECT_NEAR(volumeOf(sweep.hexes()) / std::abs(volume), 1.0, 0.02);
}

TEST(SweepChains, ThreeStackedAndOneBeside)
{
  const auto first = sweepWedge();
  // On top: the target quads of each are the source quads of the next.
  const SolidBlock secondBlock = blockOf(Tessellation, onWedge);
  const auto second = sweep(blockFaces(secondBlock, allFaces()),
    cellsWith(first->boundary(), hexsweep::arrays::BoundaryPart, 1), Bottom, 3);
  const SolidBlock thirdBlock = blockOf(Tessellation, onTop);
  const auto third = sweep(blockFaces(thirdBlock, allFaces()),
    cellsWith(second->boundary(), hexsweep::arrays::BoundaryPart, 1), Bottom, 2);

  // Beside: the quads of the first one's right face stand for the left face of the neighbour.
  constexpr int Beside = 4;
  const SolidBlock block = { { Beside, QuadsV, Layers }, [&](int i, int j, int k) {
                              const double t = static_cast<double>(i) / Beside;
                              const double bend = 0.2 * t * (1.0 - t);
                              return along(nodeOf(*first, QuadsU, j, k), t,
                                turned({ 2.0, 0.1 * j + bend, 0.1 * k + bend }));
                            } };
  Grid besideSolid = blockFaces(block, { Bottom, Top, Right, Front, Back });
  addFace(besideSolid, cellsWith(first->boundary(), hexsweep::arrays::BoundaryId, Right), Left);
  const auto beside = sweep(besideSolid, blockFaces(block, { Bottom }, { Bottom }), Bottom, Layers);

  constexpr int LayersInAll = Layers + 3 + 2;
  constexpr int NodesOfStack = (QuadsU + 1) * (QuadsV + 1) * (LayersInAll + 1);
  constexpr int Hexes = QuadsU * QuadsV * LayersInAll + Beside * QuadsV * Layers;
  constexpr int Shared = QuadsV * Layers;
  constexpr int Outer = 2 * QuadsU * QuadsV + 2 * (QuadsU + QuadsV) * LayersInAll +
    2 * Beside * QuadsV + 2 * (Beside + QuadsV) * Layers - 2 * Shared;
  expectConforming({ first.get(), second.get(), third.get(), beside.get() },
    NodesOfStack + Beside * (QuadsV + 1) * (Layers + 1), Hexes, (6 * Hexes - Outer) / 2, Outer);
  expectVolume(*second, secondBlock);
  expectVolume(*third, thirdBlock);
  expectVolume(*beside, block);
}

/// Where the neighbour is, which way it is swept, and how its shared quads are turned.
struct Neighbour
{
  BlockFace face; ///< of the first volume
  bool downward;  ///< swept from the first one's target to its source
  bool inside;    ///< shared quads face into the neighbour
};

void PrintTo(const Neighbour& neighbour, std::ostream* os)
{
  *os << neighbour.face << (neighbour.downward ? " down" : " up")
      << (neighbour.inside ? " in" : " out");
}

class SweepNeighbours : public testing::TestWithParam<Neighbour>
{
};

TEST_P(SweepNeighbours, SharedNodesAreKept)
{
  const Neighbour& neighbour = GetParam();
  const auto first = sweepWedge();
  // Index a runs along the shared face, b away from it.
  const bool alongV = neighbour.face == Left || neighbour.face == Right;
  const bool high = neighbour.face % 2 == 0;
  const int length = alongV ? QuadsV : QuadsU;
  constexpr int Away = 3;
  const double sign = high ? 1.0 : -1.0;
  const Point direction = alongV ? Point{ 1.6 * sign, 0.3, 0.1 } : Point{ 0.3, 1.2 * sign, 0.2 };
  const auto at = [&](int a, int b, int k) {
    const int end = high ? (alongV ? QuadsU : QuadsV) : 0;
    const double t = static_cast<double>(b) / Away;
    Point away = direction;
    away[2] += 0.2 * t * k / Layers;
    return along(nodeOf(*first, alongV ? end : a, alongV ? a : end, k), t, turned(away));
  };
  // Right-handed (a, b, k) or (b, a, k).
  const bool swap = alongV == high;
  const SolidBlock block = { swap ? std::array<int, 3>{ Away, length, Layers }
                                  : std::array<int, 3>{ length, Away, Layers },
    [&](int i, int j, int k) { return swap ? at(j, i, k) : at(i, j, k); } };
  const int shared = swap ? Left : Front;
  std::set<int> others = allFaces();
  others.erase(shared);
  Grid solid = blockFaces(block, others);
  Grid quads = cellsWith(first->boundary(), hexsweep::arrays::BoundaryId, neighbour.face);
  quads = shuffledCells(neighbour.inside ? quads : turnedOver(quads), 7);
  addFace(solid, quads, shared);
  const int source = neighbour.downward ? Top : Bottom;
  const Grid sourceQuads = shuffledCells(blockFaces(block, { source }, { source }), 3);
  const auto second = sweep(solid, sourceQuads, source, Layers);

  constexpr int FirstHexes = QuadsU * QuadsV * Layers;
  const int hexes = FirstHexes + length * Away * Layers;
  const int outer = 2 * QuadsU * QuadsV + 2 * (QuadsU + QuadsV) * Layers + 2 * length * Away +
    2 * (length + Away) * Layers - 2 * length * Layers;
  expectConforming({ first.get(), second.get() },
    static_cast<std::size_t>(((QuadsU + 1) * (QuadsV + 1) + (length + 1) * Away) * (Layers + 1)),
    static_cast<std::size_t>(hexes), (6 * hexes - outer) / 2, outer);
  expectVolume(*second, block);
}

INSTANTIATE_TEST_SUITE_P(Chains, SweepNeighbours,
  testing::Values(Neighbour{ Right, false, false }, Neighbour{ Right, true, true },
    Neighbour{ Left, false, true }, Neighbour{ Left, true, false },
    Neighbour{ Front, false, false }, Neighbour{ Back, true, false }));

/// A block, some of whose faces are meshed with quads.
struct MeshedBlock
{
  SolidBlock block;
  std::set<int> quads;

  Grid solid() const { return blockFaces(this->block, allFaces(), this->quads); }
  Grid source() const { return blockFaces(this->block, { Bottom }, { Bottom }); }
};

/// Every boundary node of the hexahedra that lies on one of the faces is one of the quads' there.
void expectKept(SolidSweep& swept, const MeshedBlock& meshed, int face)
{
  std::set<Point> expected;
  const Grid quads = blockFaces(meshed.block, { face }, { face });
  for (vtkIdType i = 0; i < quads->GetNumberOfPoints(); ++i)
  {
    expected.insert(pointOf(quads, i));
  }
  const Grid found = cellsWith(swept.boundary(), hexsweep::arrays::BoundaryId, face);
  std::set<Point> nodes;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    nodes.insert(pointOf(found, i));
  }
  EXPECT_EQ(nodes, expected) << "face " << face;
  EXPECT_EQ(found->GetNumberOfCells(), quads->GetNumberOfCells());
}

TEST(SweepChains, OppositeSidesAreKept)
{
  const MeshedBlock meshed{ blockOf({ 5, 4, 3 }, wedge), { Left, Right } };
  const auto swept = sweep(meshed.solid(), meshed.source(), Bottom, 3);
  expectKept(*swept, meshed, Left);
  expectKept(*swept, meshed, Right);
}

TEST(SweepChains, AllSidesAreKept)
{
  const MeshedBlock meshed{ blockOf({ 5, 4, 3 }, wedge), { Left, Right, Front, Back } };
  const auto swept = sweep(meshed.solid(), meshed.source(), Bottom, 3);
  for (const int face : { Left, Right, Front, Back })
  {
    expectKept(*swept, meshed, face);
  }
}

TEST(SweepChains, QuadsOfTheSolidItselfAreTheSource)
{
  const MeshedBlock meshed{ blockOf({ 5, 4, 3 }, wedge), { Bottom, Left, Back } };
  const auto swept = sweep(meshed.solid(), nullptr, Bottom, 3);
  EXPECT_EQ(textReport(swept->hexes(), hexsweep::reports::SourceQuads), "Solid");
  expectKept(*swept, meshed, Bottom);
  expectKept(*swept, meshed, Left);
  expectKept(*swept, meshed, Back);
}

TEST(SweepChains, MadeQuadsBeginAtTheNodesOfMeshedSides)
{
  const MeshedBlock meshed{ blockOf({ 6, 4, 3 }, wedge), { Left, Back } };
  const auto swept = sweep(meshed.solid(), nullptr, Bottom, 3);
  EXPECT_EQ(textReport(swept->hexes(), hexsweep::reports::SourceQuads), "made");
  expectKept(*swept, meshed, Left);
  expectKept(*swept, meshed, Back);
}

/// The left face in two: quads below or beside a border, triangles beyond it.
Grid withHalfOfLeftFace(const SolidBlock& block, int quads, int triangles, bool besideEachOther)
{
  Grid solid = blockFaces(block, { Bottom, Top, Right, Front, Back });
  const auto part = [&](int from, int to, bool asQuads) {
    SolidBlock half = block;
    half.n[besideEachOther ? 1 : 2] = to - from;
    half.at = [=](int i, int j, int k) {
      return besideEachOther ? block.at(i, j + from, k) : block.at(i, j, k + from);
    };
    return blockFaces(half, { Left }, asQuads ? std::set<int>{ Left } : std::set<int>{});
  };
  addFace(solid, part(0, quads, true), Left);
  addFace(solid, part(quads, quads + triangles, false), 17);
  return solid;
}

TEST(SweepChains, PartOfASideIsKept)
{
  const SolidBlock block = blockOf({ 5, 6, 3 }, wedge);
  const Grid solid = withHalfOfLeftFace(block, 2, 4, true);
  const auto swept = sweep(solid, MeshedBlock{ block, {} }.source(), Bottom, 3);
  const Grid found = cellsWith(swept->boundary(), hexsweep::arrays::BoundaryId, Left);
  ASSERT_EQ(found->GetNumberOfCells(), 2 * 3);
  std::set<Point> nodes;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    nodes.insert(pointOf(found, i));
  }
  for (int j = 0; j <= 2; ++j)
  {
    for (int k = 0; k <= 3; ++k)
    {
      EXPECT_EQ(nodes.count(block.at(0, j, k)), 1u) << j << " " << k;
    }
  }
}

TEST(SweepChains, QuadsThatEndBelowTheTargetAreNotKept)
{
  const SolidBlock block = blockOf({ 5, 4, 6 }, wedge);
  const Grid solid = withHalfOfLeftFace(block, 2, 4, false);
  SolidSweep swept(solid, MeshedBlock{ block, {} }.source());
  swept.name({ Bottom }, { Top });
  swept.filter->SetNumberOfLayers(5);
  swept.filter->Update();
  EXPECT_EQ(swept.events.errors, std::vector<std::string>{});
  ASSERT_EQ(swept.events.warnings.size(), 1u);
  EXPECT_NE(swept.events.warnings[0].find("target cap"), std::string::npos)
    << swept.events.warnings[0];
  EXPECT_EQ(report(swept.hexes(), hexsweep::reports::NotCertified), 0.0);
}

TEST(SweepChains, OtherNumberOfLayersIsRefused)
{
  const MeshedBlock meshed{ blockOf({ 5, 4, 3 }, wedge), { Left } };
  SolidSweep swept(meshed.solid(), meshed.source());
  swept.name({ Bottom }, {});
  swept.filter->SetNumberOfLayers(7);
  expectOneError(swept.filter, "3 layers");
}
}
