// SPDX-License-Identifier: BSD-3-Clause
// The table of the ways to sweep a solid: its first row against the caps that the solids were made
// with.
#include "FailureSolids.h"

#include <vtkSweepCandidates.h>
#include <vtkTable.h>

#include <sstream>

namespace TestCandidateTable
{
using Ids = std::vector<vtkIdType>;

Ids idsIn(const std::string& text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<vtkIdType>(stream), std::istream_iterator<vtkIdType>() };
}

struct Candidates
{
  vtkNew<vtkSweepCandidates> filter;
  test::Events events;

  explicit Candidates(vtkDataObject* solid, const Ids& source = {})
    : events(filter)
  {
    this->filter->SetInputData(solid);
    for (const vtkIdType id : source)
    {
      this->filter->AddSourceFaceId(id);
    }
    this->filter->Update();
  }

  vtkIdType rows() const { return this->filter->GetOutput()->GetNumberOfRows(); }

  vtkVariant value(vtkIdType row, const char* column) const
  {
    return this->filter->GetOutput()->GetValueByName(row, column);
  }

  Ids ids(vtkIdType row, const char* column) const
  {
    return idsIn(this->value(row, column).ToString());
  }
};

void expectFirst(vtkDataObject* solid, const Ids& source, const Ids& target)
{
  const Candidates all(solid);
  EXPECT_TRUE(all.events.errors.empty());
  ASSERT_GT(all.rows(), 0);
  const std::set<Ids> caps = { all.ids(0, "SourceFaceIds"), all.ids(0, "TargetFaceIds") };
  EXPECT_EQ(caps, (std::set<Ids>{ source, target }));
  EXPECT_EQ(all.value(0, "Verdict").ToString(), "fits");
  EXPECT_EQ(all.value(0, "Rank").ToInt(), 1);
  for (const bool swapped : { false, true })
  {
    const Candidates of(solid, swapped ? target : source);
    ASSERT_GT(of.rows(), 0);
    EXPECT_EQ(of.ids(0, "SourceFaceIds"), swapped ? target : source);
    EXPECT_EQ(of.ids(0, "TargetFaceIds"), swapped ? source : target);
  }
}

TEST(CandidateTable, FirstIsTheSweepThatCadSolidsWereMadeAs)
{
  for (const test::CadSolid& solid : test::cadSolids())
  {
    SCOPED_TRACE(solid.name);
    expectFirst(test::solidGrid(solid.name), solid.source, solid.target);
  }
}

TEST(CandidateTable, CapsOfSeveralFacesAndAmongMany)
{
  for (const test::FailureSolid& solid : test::solidsOfHiddenCaps())
  {
    SCOPED_TRACE(solid.name);
    expectFirst(test::failureGrid(solid.name), solid.source, solid.target);
  }
}

TEST(CandidateTable, IsOrderedAndGivesReasons)
{
  const Candidates all(test::failureGrid("target_ambiguous/g20"));
  ASSERT_GT(all.rows(), 3);
  std::set<std::string> verdicts;
  double last = 1.0;
  for (vtkIdType row = 0; row < all.rows(); ++row)
  {
    EXPECT_FALSE(all.value(row, "Reasons").ToString().empty());
    const std::string verdict = all.value(row, "Verdict").ToString();
    const double score = all.value(row, "Score").ToDouble();
    EXPECT_TRUE(verdicts.insert(verdict).second || score <= last) << row;
    EXPECT_EQ(score == 0.0, verdict == "refused");
    last = score;
  }
  EXPECT_EQ(
    all.filter->GetOutput()->GetFieldData()->GetArray("SweepReportCandidatesCut")->GetTuple1(0),
    0.0);
}

TEST(CandidateTable, WrongInputsAreNamed)
{
  vtkNew<vtkSweepCandidates> ofOpen;
  ofOpen->SetInputData(test::solidQuads("flange"));
  test::expectOneError(ofOpen, "open");
  vtkNew<vtkSweepCandidates> wrong;
  wrong->SetInputData(test::solidGrid("flange"));
  wrong->AddSourceFaceId(999);
  test::expectOneError(wrong, "source face id 999 does not exist");
}
}
