// SPDX-License-Identifier: BSD-3-Clause
// A filter that fails says so once, and its pipeline is seen to have failed.
#include "SolidGrids.h"

#include <vtkErrorCode.h>
#include <vtkOutputWindow.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkSweepSets.h>
#include <vtkTable.h>

namespace TestFailure
{
using namespace test;

/// What would be on the screen.
class Screen : public vtkOutputWindow
{
public:
  static Screen* New() { return new Screen; }
  std::vector<std::string> texts;
  void DisplayText(const char* text) override { this->texts.emplace_back(text); }
};

/// Puts a screen in place of that of the process, for a while.
class Shown
{
public:
  Shown() { vtkOutputWindow::SetInstance(this->TestScreen); }
  ~Shown() { vtkOutputWindow::SetInstance(this->Before); }
  Shown(const Shown&) = delete;
  void operator=(const Shown&) = delete;
  std::vector<std::string>& texts() { return this->TestScreen->texts; }

private:
  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  vtkNew<Screen> TestScreen;
};

/// A sweep that fails, for its source face does not exist, and a filter after it.
struct FailingChain
{
  vtkNew<vtkOneToOneSweep> sweep;
  vtkNew<vtkSweepSets> sets;

  FailingChain()
  {
    this->sweep->SetSolidData(solidGrid("wing"));
    this->sweep->AddSourceFaceId(99);
    this->sets->SetHexesConnection(this->sweep->GetOutputPort(0));
    this->sets->SetBoundaryConnection(this->sweep->GetOutputPort(1));
  }

  bool succeeds()
  {
    return vtkStreamingDemandDrivenPipeline::SafeDownCast(this->sets->GetExecutive())->Update() !=
      0;
  }

  void name(vtkIdType source)
  {
    this->sweep->RemoveAllSourceFaceIds();
    this->sweep->AddSourceFaceId(source);
  }
};

TEST(Failure, IsOneMessageHoweverOftenItIsAskedFor)
{
  FailingChain chain;
  Shown shown;
  EXPECT_FALSE(chain.succeeds());
  ASSERT_EQ(shown.texts().size(), 1u);
  EXPECT_NE(shown.texts()[0].find("face id 99 does not exist"), std::string::npos);
  EXPECT_EQ(shown.texts()[0].find("vtkInformation"), std::string::npos);
  chain.sets->Update();
  chain.sweep->Update();
  EXPECT_EQ(shown.texts().size(), 1u) << shown.texts().back();
  EXPECT_EQ(chain.sweep->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_NE(chain.sets->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(chain.sweep->GetOutput()->GetNumberOfCells(), 0);

  chain.name(98);
  EXPECT_FALSE(chain.succeeds());
  ASSERT_EQ(shown.texts().size(), 2u) << shown.texts().back();
  EXPECT_NE(shown.texts()[1].find("face id 98 does not exist"), std::string::npos);
}

TEST(Failure, IsForgottenWhenItIsMended)
{
  FailingChain chain;
  Shown shown;
  EXPECT_FALSE(chain.succeeds());
  chain.name(3);
  chain.sweep->SetNumberOfLayers(2);
  chain.sweep->SetQuadSize(8.0);
  EXPECT_TRUE(chain.succeeds());
  EXPECT_EQ(shown.texts().size(), 1u) << shown.texts().back();
  EXPECT_EQ(chain.sweep->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(chain.sets->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  const vtkMTimeType built = chain.sweep->GetOutput()->GetMTime();
  EXPECT_TRUE(chain.succeeds());
  EXPECT_EQ(chain.sweep->GetOutput()->GetMTime(), built) << "nothing changed, and it ran again";
}

TEST(Failure, AnotherErrorOfTheExecutiveIsStillShown)
{
  FailingChain chain;
  Shown shown;
  EXPECT_FALSE(chain.succeeds());
  vtkNew<vtkTable> table;
  chain.sweep->SetSolidData(table);
  EXPECT_FALSE(chain.succeeds());
  ASSERT_GT(shown.texts().size(), 1u);
  EXPECT_NE(shown.texts()[1].find("is of type vtkTable"), std::string::npos) << shown.texts()[1];
}

TEST(Failure, WithoutWarningsNothingIsShownNorKept)
{
  FailingChain chain;
  Shown shown;
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_FALSE(chain.succeeds());
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_TRUE(shown.texts().empty());
  EXPECT_FALSE(chain.sweep->GetExecutive()->HasObserver(vtkCommand::ErrorEvent));
  chain.name(98);
  EXPECT_FALSE(chain.succeeds());
  EXPECT_EQ(shown.texts().size(), 1u);
  EXPECT_FALSE(chain.sweep->GetExecutive()->HasObserver(vtkCommand::ErrorEvent));
}
}
