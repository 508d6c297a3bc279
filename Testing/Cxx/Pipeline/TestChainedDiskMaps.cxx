// SPDX-License-Identifier: BSD-3-Clause
// Disk maps made one by one and chained to the hexes give what the projector makes by itself.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkCageHexInterior.h>
#include <vtkHarmonicDiskMap.h>
#include <vtkHexValidity.h>
#include <vtkSweepQuadProjector.h>

#include <vtkMeshQuality.h>
#include <vtkTrivialProducer.h>

namespace TestChainedDiskMaps
{
using test::Grid;
using test::report;
using test::SweepGrids;

/// disk map (source, partner target) + disk map (target, partner source) -> projector -> interior
/// -> validity; or without the maps.
struct Chain
{
  vtkNew<vtkTrivialProducer> SourceQuads;
  vtkNew<vtkTrivialProducer> SourceSurface;
  vtkNew<vtkTrivialProducer> TargetSurface;
  vtkNew<vtkTrivialProducer> LinkingSides;
  vtkNew<vtkHarmonicDiskMap> SourceMap;
  vtkNew<vtkHarmonicDiskMap> TargetMap;
  vtkNew<vtkSweepQuadProjector> Projector;
  vtkNew<vtkCageHexInterior> Interior;
  vtkNew<vtkHexValidity> Validity;

  Chain(const SweepGrids& sweep, bool chained, bool polyData = false)
  {
    const auto set = [&](vtkTrivialProducer* producer, vtkUnstructuredGrid* grid) {
      producer->SetOutput(polyData ? static_cast<vtkDataObject*>(test::polyData(grid)) : grid);
    };
    set(this->SourceQuads, sweep.sourceQuads);
    set(this->SourceSurface, sweep.sourceSurface);
    set(this->TargetSurface, sweep.targetSurface);
    set(this->LinkingSides, sweep.linkingSides);

    this->SourceMap->SetInputConnection(this->SourceSurface->GetOutputPort());
    this->SourceMap->SetPartnerConnection(this->TargetSurface->GetOutputPort());
    this->SourceMap->SetLinkingSidesConnection(this->LinkingSides->GetOutputPort());
    this->TargetMap->SetInputConnection(this->TargetSurface->GetOutputPort());
    this->TargetMap->SetPartnerConnection(this->SourceSurface->GetOutputPort());
    this->TargetMap->SetLinkingSidesConnection(this->LinkingSides->GetOutputPort());

    this->Projector->SetSourceQuadsConnection(this->SourceQuads->GetOutputPort());
    this->Projector->SetLinkingSidesConnection(this->LinkingSides->GetOutputPort());
    if (chained)
    {
      this->Projector->SetDiskMapsToFromInput();
      this->Projector->SetTargetSurfaceConnection(this->TargetMap->GetOutputPort());
      this->Projector->SetSourceSurfaceConnection(this->SourceMap->GetOutputPort());
    }
    else
    {
      this->Projector->SetTargetSurfaceConnection(this->TargetSurface->GetOutputPort());
      this->Projector->SetSourceSurfaceConnection(this->SourceSurface->GetOutputPort());
    }
    this->Interior->SetSourceQuadsConnection(this->SourceQuads->GetOutputPort());
    this->Interior->SetTargetQuadsConnection(this->Projector->GetOutputPort());
    this->Interior->SetLinkingSidesConnection(this->LinkingSides->GetOutputPort());
    this->Validity->SetInputConnection(this->Interior->GetOutputPort());
  }

  vtkUnstructuredGrid* run()
  {
    test::Events maps(this->SourceMap);
    test::Events targetMaps(this->TargetMap);
    test::Events projector(this->Projector);
    test::Events interior(this->Interior);
    test::Events validity(this->Validity);
    this->Validity->Update();
    for (const test::Events* events : { &maps, &targetMaps, &projector, &interior, &validity })
    {
      EXPECT_TRUE(events->errors.empty()) << events->errors[0];
      EXPECT_TRUE(events->warnings.empty()) << events->warnings[0];
    }
    auto* output = vtkUnstructuredGrid::SafeDownCast(this->Validity->GetOutput());
    EXPECT_NE(output, nullptr);
    return output;
  }
};

void expectRightHanded(vtkUnstructuredGrid* hexes)
{
  EXPECT_EQ(report(hexes, hexsweep::reports::Inverted), 0);
  for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(hexes->GetCellType(c), VTK_HEXAHEDRON);
    ASSERT_GT(vtkMeshQuality::HexScaledJacobian(hexes->GetCell(c)), 0.0) << "cell " << c;
  }
}

std::vector<std::pair<std::string, SweepGrids>> sweeps()
{
  return { { "ubend", test::readCase("ubend") }, { "taper10", test::readCase("taper10") },
    { "plate with three holes", test::plateSweep(3) } };
}

TEST(ChainedDiskMaps, GiveTheSameMeshAsTheProjectorAlone)
{
  const char* domains[3] = { "Disk", "Annulus", "Circles" };
  std::size_t number = 0;
  for (const auto& [name, sweep] : sweeps())
  {
    SCOPED_TRACE(name);
    Chain chained(sweep, true);
    Chain alone(sweep, false);
    vtkUnstructuredGrid* hexes = chained.run();
    EXPECT_EQ(test::textReport(chained.SourceMap->GetOutput(), hexsweep::arrays::DiskMapDomain),
      domains[number++]);
    ASSERT_GT(hexes->GetNumberOfCells(), 0);
    vtkUnstructuredGrid* expected = alone.run();
    ASSERT_EQ(hexes->GetNumberOfCells(), expected->GetNumberOfCells());
    EXPECT_EQ(test::greatestDistance(hexes, expected), 0.0);
    for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
    {
      ASSERT_EQ(test::cornersOf(hexes, c), test::cornersOf(expected, c));
    }
    expectRightHanded(hexes);
  }
}

TEST(ChainedDiskMaps, OneFilterMapsBothCaps)
{
  for (const auto& [name, sweep] : sweeps())
  {
    SCOPED_TRACE(name);
    Chain one(sweep, true);
    one.Projector->SetTargetSurfaceConnection(one.SourceMap->GetOutputPort(1));
    Chain alone(sweep, false);
    vtkUnstructuredGrid* hexes = one.run();
    ASSERT_GT(hexes->GetNumberOfCells(), 0);
    EXPECT_EQ(one.TargetMap->GetOutput()->GetNumberOfCells(), 0);
    vtkUnstructuredGrid* expected = alone.run();
    ASSERT_EQ(hexes->GetNumberOfCells(), expected->GetNumberOfCells());
    EXPECT_EQ(test::greatestDistance(hexes, expected), 0.0);
  }
}

TEST(ChainedDiskMaps, PolyDataAllTheWay)
{
  const SweepGrids sweep = test::readCase("taper10");
  Chain grids(sweep, true);
  Chain polyData(sweep, true, true);
  EXPECT_EQ(test::greatestDistance(grids.run(), polyData.run()), 0.0);
}

TEST(ChainedDiskMaps, EitherOrientationGivesRightHandedHexes)
{
  for (const auto& [name, sweep] : sweeps())
  {
    SCOPED_TRACE(name);
    Chain plain(sweep, true);
    SweepGrids turnedSweep = sweep;
    turnedSweep.sourceQuads = test::turnedOver(sweep.sourceQuads);
    Chain turned(turnedSweep, true);
    vtkUnstructuredGrid* hexes = turned.run();
    expectRightHanded(hexes);
    // The projection alone: untangling and polishing blow rounding up.
    for (Chain* chain : { &plain, &turned })
    {
      chain->Projector->EnsureValidOff();
      chain->Projector->ImproveQualityOff();
    }
    hexes = turned.run();
    EXPECT_LT(test::greatestDistance(plain.run(), hexes), 1e-11 * test::sizeOf(hexes));
  }
}

TEST(ChainedDiskMaps, AlsoFromTheDiskItself)
{
  // OutputDisk puts the points into the disk: the projector finds the surface in SurfacePoints.
  const SweepGrids sweep = test::readCase("taper10");
  Chain plain(sweep, true);
  Chain disk(sweep, true);
  disk.SourceMap->OutputDiskOn();
  disk.TargetMap->OutputDiskOn();
  EXPECT_EQ(test::greatestDistance(plain.run(), disk.run()), 0.0);
}

TEST(ChainedDiskMaps, ChangesUpstreamComeThrough)
{
  const SweepGrids sweep = test::readCase("taper10");
  Chain chain(sweep, true);
  vtkNew<vtkUnstructuredGrid> first;
  first->DeepCopy(chain.run());
  chain.SourceMap->SetWeightsToMeanValue();
  chain.TargetMap->SetWeightsToMeanValue();
  EXPECT_GT(test::greatestDistance(first, chain.run()), 1e-9);
  chain.SourceMap->SetWeightsToCotangent();
  chain.TargetMap->SetWeightsToCotangent();
  test::expectSameBits(first, chain.run());
}
}
