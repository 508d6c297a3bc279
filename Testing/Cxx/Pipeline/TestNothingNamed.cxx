// SPDX-License-Identifier: BSD-3-Clause
// A solid alone: caps, layers and sizes are found.
#include "BlockSolids.h"
#include "FailureSolids.h"

namespace TestNothingNamed
{
using test::SolidSweep;
using Ids = std::vector<vtkIdType>;

Ids idsOf(vtkUnstructuredGrid* hexes, const char* name)
{
  vtkDataArray* array = hexes->GetFieldData()->GetArray(name);
  Ids ids;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(array->GetTuple1(i)));
  }
  return ids;
}

Ids sourceOf(vtkUnstructuredGrid* hexes)
{
  return idsOf(hexes, hexsweep::reports::SourceFaceIds);
}

Ids targetOf(vtkUnstructuredGrid* hexes)
{
  return idsOf(hexes, hexsweep::reports::TargetFaceIds);
}

std::set<Ids> capsOf(vtkUnstructuredGrid* hexes)
{
  return { sourceOf(hexes), targetOf(hexes) };
}

double leastOf(vtkUnstructuredGrid* hexes)
{
  return test::report(hexes, hexsweep::reports::MinScaledJacobian);
}

void expectCertified(vtkUnstructuredGrid* hexes)
{
  ASSERT_GT(hexes->GetNumberOfCells(), 0);
  EXPECT_EQ(test::report(hexes, hexsweep::reports::NotCertified), 0.0);
}

/// Mean length of the edges along the sweep over that of the others.
double slenderness(vtkUnstructuredGrid* hexes)
{
  double along = 0.0;
  double across = 0.0;
  for (vtkIdType h = 0; h < hexes->GetNumberOfCells(); ++h)
  {
    const test::Corners c = test::cornersOf(hexes, h);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto length = [&](std::size_t a, std::size_t b) {
        return test::distance(test::pointOf(hexes, c[a]), test::pointOf(hexes, c[b]));
      };
      along += 2.0 * length(i, i + 4);
      across += length(i, (i + 1) % 4) + length(i + 4, (i + 1) % 4 + 4);
    }
  }
  return along / across;
}

TEST(NothingNamed, CadSolidsAreCertifiedAndAsGoodAsIntended)
{
  for (const test::CadSolid& solid : test::cadSolids())
  {
    SCOPED_TRACE(solid.name);
    const test::Grid surface = test::solidGrid(solid.name);
    SolidSweep found(surface);
    found.filter->Update();
    EXPECT_EQ(found.messages(), "");
    expectCertified(found.hexes());
    EXPECT_EQ(capsOf(found.hexes()), (std::set<Ids>{ solid.source, solid.target }));
    SolidSweep intended(surface);
    intended.name(solid.source, solid.target);
    intended.filter->Update();
    EXPECT_GE(leastOf(found.hexes()), 0.9 * leastOf(intended.hexes()));
    EXPECT_NEAR(slenderness(found.hexes()), 1.0, 0.2);
    EXPECT_GT(found.hexes()
                ->GetFieldData()
                ->GetAbstractArray(hexsweep::reports::Candidates)
                ->GetNumberOfTuples(),
      0);
  }
}

TEST(NothingNamed, HiddenCaps)
{
  for (const test::FailureSolid& solid : test::solidsOfHiddenCaps())
  {
    if (std::string(solid.name) == "part_of_split_target_taken/f8")
    {
      continue; // caps are found, see CandidateTable; its sides are another matter
    }
    SCOPED_TRACE(solid.name);
    const test::Grid surface = test::failureGrid(solid.name);
    SolidSweep found(surface);
    found.filter->SetNumberOfLayers(solid.layers);
    found.filter->Update();
    expectCertified(found.hexes());
    EXPECT_EQ(capsOf(found.hexes()), (std::set<Ids>{ solid.source, solid.target }));
    SolidSweep fromSource(surface);
    fromSource.name(solid.source, {});
    fromSource.filter->SetNumberOfLayers(solid.layers);
    fromSource.filter->Update();
    expectCertified(fromSource.hexes());
    EXPECT_EQ(targetOf(fromSource.hexes()), solid.target);
  }
}

TEST(NothingNamed, SourceQuadsTellTheSource)
{
  for (const char* name : { "flange", "loft" })
  {
    const test::Grid surface = test::solidGrid(name);
    SolidSweep sweep(surface, test::solidQuads(name));
    sweep.filter->SetNumberOfLayers(2);
    sweep.filter->Update();
    const auto& solids = test::cadSolids();
    const auto solid = std::find_if(
      solids.begin(), solids.end(), [&](const auto& s) { return std::string(s.name) == name; });
    EXPECT_EQ(sourceOf(sweep.hexes()), solid->source);
    EXPECT_EQ(targetOf(sweep.hexes()), solid->target);
  }
}

TEST(NothingNamed, ATargetAloneIsTheTarget)
{
  SolidSweep sweep(test::solidGrid("flange"));
  sweep.name({}, { 3 });
  sweep.filter->SetNumberOfLayers(2);
  sweep.filter->Update();
  EXPECT_EQ(sourceOf(sweep.hexes()), Ids{ 2 });
  EXPECT_EQ(targetOf(sweep.hexes()), Ids{ 3 });
}

/// 8 x 6 x 2.
test::SolidBlock plate()
{
  return test::blockOf({ 8, 6, 2 }, [](double x, double y, double z) {
    return test::Point{ 8.0 * x, 6.0 * y, 2.0 * z };
  });
}

TEST(NothingNamed, TheNextBestSweepIsTriedAndSaid)
{
  // Left is meshed with 2 rows between top and bottom, 6 between front and back: with 3 layers it
  // can only be a cap.
  SolidSweep sweep(test::blockFaces(plate(), test::allFaces(), { test::Left }));
  sweep.filter->SetNumberOfLayers(3);
  sweep.filter->Update();
  expectCertified(sweep.hexes());
  EXPECT_EQ(capsOf(sweep.hexes()), (std::set<Ids>{ { test::Left }, { test::Right } }));
  EXPECT_TRUE(sweep.events.errors.empty());
  ASSERT_EQ(sweep.events.warnings.size(), 1u);
  EXPECT_NE(sweep.events.warnings[0].find("did not work"), std::string::npos);
  EXPECT_NE(sweep.events.warnings[0].find("has 2 layers, and 3 are asked for"), std::string::npos)
    << sweep.events.warnings[0];
  // Where none works there is one error.
  SolidSweep none(
    test::blockFaces(plate(), test::allFaces(), { test::Left, test::Front, test::Top }));
  none.filter->SetNumberOfLayers(3);
  test::expectOneError(none.filter, "of the sweeps that look best none works");
}

TEST(NothingNamed, SizeSetsWhatIsNotSet)
{
  const auto cells = [](const std::function<void(vtkOneToOneSweep*)>& set) {
    SolidSweep sweep(test::blockFaces(plate(), test::allFaces()));
    sweep.name({ test::Bottom }, {});
    set(sweep.filter);
    sweep.filter->Update();
    EXPECT_EQ(sweep.messages(), "");
    const auto layers = static_cast<vtkIdType>(test::report(sweep.hexes(), "SweepReportLayers"));
    return std::make_pair(layers, sweep.hexes()->GetNumberOfCells() / layers);
  };
  const auto bySize = cells([](vtkOneToOneSweep* f) { f->SetSize(0.5); });
  EXPECT_EQ(bySize.first, 4);
  EXPECT_NEAR(static_cast<double>(bySize.second), 48.0 / 0.25, 0.15 * 48.0 / 0.25);
  const auto byNumber = cells([](vtkOneToOneSweep* f) {
    f->SetSize(0.5);
    f->SetNumberOfLayers(7);
  });
  EXPECT_EQ(byNumber, std::make_pair(vtkIdType(7), bySize.second));
  const auto byLayerSize = cells([](vtkOneToOneSweep* f) {
    f->SetSize(0.5);
    f->SetLayerSize(1.0);
  });
  EXPECT_EQ(byLayerSize, std::make_pair(vtkIdType(2), bySize.second));
  const auto byPositions = cells([](vtkOneToOneSweep* f) {
    f->SetSize(0.5);
    f->AddLayerPosition(0.1);
  });
  EXPECT_EQ(byPositions, std::make_pair(vtkIdType(2), bySize.second));
  const auto byQuads = cells([](vtkOneToOneSweep* f) {
    f->SetSize(0.5);
    f->SetQuadSize(1.0);
  });
  EXPECT_EQ(byQuads.first, 4);
  EXPECT_NEAR(static_cast<double>(byQuads.second), 48.0, 0.3 * 48.0);
  // Layers that are there already count more than a size.
  SolidSweep meshed(test::blockFaces(plate(), test::allFaces(), { test::Left }));
  meshed.name({ test::Bottom }, { test::Top });
  meshed.filter->Update();
  EXPECT_EQ(test::report(meshed.hexes(), "SweepReportLayers"), 2.0);

  SolidSweep wrong(test::solidGrid("flange"));
  wrong.filter->SetSize(-1.0);
  test::expectOneError(wrong.filter, "Set Size to a positive length");
}

TEST(NothingNamed, AQuarterOfAMillionHexahedraAtMost)
{
  const test::SolidBlock bar = test::blockOf({ 1, 1, 40 }, [](double x, double y, double z) {
    return test::Point{ x, y, 150.0 * z };
  });
  SolidSweep sweep(test::blockFaces(bar, test::allFaces()));
  sweep.name({ test::Bottom }, { test::Top });
  sweep.filter->SetCertify(false);
  sweep.filter->SetImproveQuality(false);
  sweep.filter->SetEnsureValid(false);
  sweep.filter->Update();
  EXPECT_TRUE(sweep.events.errors.empty());
  EXPECT_LE(sweep.hexes()->GetNumberOfCells(), 250000);
  EXPECT_GT(sweep.hexes()->GetNumberOfCells(), 125000);
  ASSERT_EQ(sweep.events.warnings.size(), 1u);
  EXPECT_NE(sweep.events.warnings[0].find("would be more than 250000"), std::string::npos)
    << sweep.events.warnings[0];
  EXPECT_NEAR(slenderness(sweep.hexes()), 1.0, 0.1);
}

TEST(NothingNamed, SolidsThatCannotBeSweptAreRefusedWithReasons)
{
  // A tunnel through a side.
  const test::Grid cross = test::blockFaces(plate(), test::allFaces());
  vtkDataArray* ids = cross->GetCellData()->GetArray("FaceId");
  for (vtkIdType c = 0; c < cross->GetNumberOfCells(); ++c)
  {
    ids->SetTuple1(c, ids->GetTuple1(c) < 3 ? 1 : 2); // a belt, and two lids that are one face
  }
  SolidSweep sweep(cross);
  test::expectOneError(sweep.filter, "no way to sweep the solid fits");
}
}
