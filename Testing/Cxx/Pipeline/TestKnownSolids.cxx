// SPDX-License-Identifier: BSD-3-Clause
// The parts of the solids of Data/solids against their case.json, and against filters of VTK.
#include "HexSweepSolidReader.h"

#include "SolidGrids.h"
#include "Support/SolidShapes.h"

#include "Core/Solids/SolidInput.h"
#include "Core/Solids/TargetFaces.h"
#include "HexSweepArrays.h"

#include <vtkDataSetSurfaceFilter.h>
#include <vtkFeatureEdges.h>
#include <vtkMassProperties.h>

namespace TestKnownSolids
{
using hexsweep::findSweepTopology;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::readSolid;
using hexsweep::SolidData;
using hexsweep::SolidSurface;
using hexsweep::SweepSide;
using hexsweep::SweepTopology;
using test::Grid;
using test::volumeOf;
using Ids = std::vector<Index>;

/// What case.json says of a side.
struct KnownSide
{
  Ids faceIds;
  std::size_t sourceNodes;
  std::size_t targetNodes;
};

struct KnownSolid
{
  std::string name;
  Index source;
  Index target;
  Index points;
  double volume;
  std::vector<KnownSide> sides;
};

std::vector<KnownSolid> knownSolids()
{
  return {
    { "bracket", 26, 36, 4318, 50679.69289690332,
      { { { 25, 27, 28, 29, 30, 31, 32, 33, 34, 35, 37, 38, 39, 40, 41, 42 }, 114, 123 },
        { { 19, 20 }, 16, 21 }, { { 23, 24 }, 16, 21 } } },
    { "elbow", 1, 4, 2619, 68395.33254599791, { { { 2 }, 42, 40 }, { { 3 }, 28, 26 } } },
    { "flange", 3, 2, 4153, 92227.36378867207,
      { { { 1 }, 104, 105 }, { { 8 }, 34, 34 }, { { 4 }, 14, 15 }, { { 5 }, 14, 15 },
        { { 6 }, 14, 15 }, { { 7 }, 14, 15 }, { { 9 }, 14, 15 }, { { 10 }, 14, 15 } } },
    { "loft", 9, 11, 6192, 43454.817111882534,
      { { { 8, 10, 12, 13 }, 128, 68 }, { { 7 }, 44, 20 } } },
    { "wing", 3, 4, 7692, 113618.89429478726, { { { 1, 2 }, 82, 53 } } },
  };
}

TEST(SolidReader, TheSolidsComeApartAsTheirCasesSay)
{
  for (const KnownSolid& known : knownSolids())
  {
    SCOPED_TRACE(known.name);
    const Grid grid = test::solidGrid(known.name);
    const SolidData data = readSolid(grid);
    EXPECT_EQ(data.faceIdArray, hexsweep::arrays::FaceId);
    EXPECT_FALSE(data.fromVolume);
    EXPECT_EQ(data.surface.quads.rows(), 0);
    const SolidSurface solid = makeSolidSurface(data.surface);
    EXPECT_EQ(solid.mergedPoints + solid.turnedTriangles + solid.collapsedTriangles, 0);
    EXPECT_EQ(solid.points.rows(), known.points);
    EXPECT_NEAR(volumeOf(solid) / known.volume, 1.0, 1e-9);

    for (const bool exchanged : { false, true })
    {
      const Ids first = { exchanged ? known.target : known.source };
      const Ids last = { exchanged ? known.source : known.target };
      const SweepTopology topology = findSweepTopology(solid, first, last);
      ASSERT_EQ(topology.sides.size(), known.sides.size());
      EXPECT_EQ(topology.sides[0].faceIds, known.sides[0].faceIds);
      std::multiset<Ids> found;
      for (const SweepSide& side : topology.sides)
      {
        found.insert(side.faceIds);
        for (const KnownSide& own : known.sides)
        {
          if (own.faceIds == side.faceIds)
          {
            EXPECT_EQ(side.sourceLoop.size(), exchanged ? own.targetNodes : own.sourceNodes);
            EXPECT_EQ(side.targetLoop.size(), exchanged ? own.sourceNodes : own.targetNodes);
          }
        }
      }
      std::multiset<Ids> expected;
      for (const KnownSide& own : known.sides)
      {
        expected.insert(own.faceIds);
      }
      EXPECT_EQ(found, expected);
      EXPECT_EQ(hexsweep::findTargetFaces(solid, first), last);
    }
  }
}

TEST(SolidReader, TheSolidsAsSoupInSinglePrecision)
{
  for (const KnownSolid& known : knownSolids())
  {
    SCOPED_TRACE(known.name);
    SolidData data = readSolid(test::solidGrid(known.name));
    data.surface.points = data.surface.points.cast<float>().cast<double>().eval();
    const SolidSurface solid = makeSolidSurface(test::soup(data.surface));
    EXPECT_EQ(solid.points.rows(), known.points);
    EXPECT_EQ(findSweepTopology(solid, { known.source }).targetFaceIds, Ids{ known.target });
  }
}

TEST(SolidReader, FacesByAngleLieBetweenTheFeatureEdgesOfVTK)
{
  for (const KnownSolid& known : knownSolids())
  {
    SCOPED_TRACE(known.name);
    const Grid grid = test::solidGrid(known.name);
    SolidData data = readSolid(grid);
    data.surface.faceIds.clear();
    hexsweep::SolidOptions options;
    options.featureAngle = 35.0 * hexsweep::Pi / 180.0;
    const SolidSurface solid = makeSolidSurface(data.surface, options);

    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(grid);
    vtkNew<vtkFeatureEdges> features;
    features->SetInputConnection(surface->GetOutputPort());
    features->SetFeatureAngle(35.0);
    features->BoundaryEdgesOff();
    features->NonManifoldEdgesOff();
    features->FeatureEdgesOn();
    features->Update();
    using Place = std::array<double, 3>;
    std::set<std::pair<Place, Place>> sharp;
    for (vtkIdType c = 0; c < features->GetOutput()->GetNumberOfCells(); ++c)
    {
      vtkNew<vtkIdList> ends;
      features->GetOutput()->GetCellPoints(c, ends);
      Place a;
      Place b;
      features->GetOutput()->GetPoint(ends->GetId(0), a.data());
      features->GetOutput()->GetPoint(ends->GetId(1), b.data());
      sharp.emplace(std::min(a, b), std::max(a, b));
    }
    EXPECT_GT(sharp.size(), 20u);
    // The faces that are left when triangles are joined over all other edges, one seed at a time.
    std::map<std::pair<Place, Place>, std::vector<Index>> triangles;
    const auto edgeOf = [&](Index t, Index c) {
      Place a;
      Place b;
      for (int i = 0; i < 3; ++i)
      {
        a[static_cast<std::size_t>(i)] = solid.points(solid.triangles(t, c), i);
        b[static_cast<std::size_t>(i)] = solid.points(solid.triangles(t, (c + 1) % 3), i);
      }
      return std::make_pair(std::min(a, b), std::max(a, b));
    };
    for (Index t = 0; t < solid.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        triangles[edgeOf(t, c)].push_back(t);
      }
    }
    Ids faces(solid.faceIds.size(), -1);
    Index next = 0;
    for (Index seed = 0; seed < solid.triangles.rows(); ++seed)
    {
      if (faces[static_cast<std::size_t>(seed)] >= 0)
      {
        continue;
      }
      Ids queue = { seed };
      faces[static_cast<std::size_t>(seed)] = next;
      for (std::size_t i = 0; i < queue.size(); ++i)
      {
        for (Index c = 0; c < 3; ++c)
        {
          const auto edge = edgeOf(queue[i], c);
          for (const Index other : triangles[edge])
          {
            if (!sharp.count(edge) && faces[static_cast<std::size_t>(other)] < 0)
            {
              faces[static_cast<std::size_t>(other)] = next;
              queue.push_back(other);
            }
          }
        }
      }
      ++next;
    }
    EXPECT_EQ(solid.faceIds, faces);
    EXPECT_GE(next, 3);
  }
}

TEST(SolidReader, TheVolumeOfVTK)
{
  for (const KnownSolid& known : knownSolids())
  {
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(test::solidGrid(known.name));
    vtkNew<vtkMassProperties> mass;
    mass->SetInputConnection(surface->GetOutputPort());
    mass->Update();
    EXPECT_NEAR(
      volumeOf(makeSolidSurface(readSolid(surface->GetOutput()).surface)) / mass->GetVolume(), 1.0,
      1e-6);
  }
}
}
