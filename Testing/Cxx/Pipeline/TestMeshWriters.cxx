// SPDX-License-Identifier: BSD-3-Clause
// How writers of swept meshes fail. That files come back is tested with those who read them, in
// Testing/Python/Module.
#include "SolidGrids.h"

#include <vtkErrorCode.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSweepAbaqusWriter.h>
#include <vtkSweepGmshWriter.h>
#include <vtkSweepSets.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace TestMeshWriters
{
using namespace test;

struct SweptElbow
{
  SolidSweep sweep{ solidGrid("elbow") };
  vtkNew<vtkSweepSets> sets;

  SweptElbow()
  {
    this->sweep.filter->SetNumberOfLayers(2);
    this->sweep.filter->SetQuadSize(8.0);
    this->sets->SetHexesConnection(this->sweep.filter->GetOutputPort(0));
    this->sets->SetBoundaryConnection(this->sweep.filter->GetOutputPort(1));
    this->sets->Update();
  }
};

bool exists(const std::string& name)
{
  return std::ifstream(name).good();
}

std::vector<vtkSmartPointer<vtkSweepMeshWriter>> writers()
{
  return { vtkSmartPointer<vtkSweepAbaqusWriter>::New(),
    vtkSmartPointer<vtkSweepGmshWriter>::New() };
}

/// The one error of a writer.
std::string failure(vtkSweepMeshWriter* writer, vtkDataObject* input, const std::string& name)
{
  const Events events(writer);
  writer->SetInputData(input);
  writer->SetFileName(name.c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(events.errors.size(), 1u);
  return events.errors.empty() ? std::string() : events.errors.front();
}

TEST(MeshWriters, WhatIsWrongIsSaidAndNoFileIsLeft)
{
  SweptElbow elbow;
  const std::string name = std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/failing_writer.out";
  vtkNew<vtkMultiBlockDataSet> empty;
  for (const auto& writer : writers())
  {
    EXPECT_NE(
      failure(writer, empty, name).find("Connect the output of SweepSets"), std::string::npos);
    EXPECT_FALSE(exists(name));
    EXPECT_NE(failure(writer, elbow.sets->GetOutput(), "/nowhere/mesh.out").find("No such file"),
      std::string::npos);
    EXPECT_NE(
      failure(writer, elbow.sets->GetOutput(), "").find("no file is named"), std::string::npos);
  }
  vtkNew<vtkSweepGmshWriter> gmsh;
  gmsh->SetFileVersion(40);
  EXPECT_NE(failure(gmsh, elbow.sets->GetOutput(), name).find("22 (2.2) or 41"), std::string::npos);
  EXPECT_FALSE(exists(name));
}

TEST(MeshWriters, AFullDiskIsNoticed)
{
  if (!exists("/dev/full"))
  {
    GTEST_SKIP() << "no /dev/full";
  }
  SweptElbow elbow;
  // A link, as what could not be written as a whole is removed.
  const std::string name = std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/full.out";
  for (const auto& writer : writers())
  {
    std::remove(name.c_str());
    ASSERT_EQ(symlink("/dev/full", name.c_str()), 0);
    EXPECT_NE(
      failure(writer, elbow.sets->GetOutput(), name).find("No space left"), std::string::npos);
    EXPECT_FALSE(exists(name));
  }
}

TEST(MeshWriters, AbortLeavesNoFileAndSaysNothing)
{
  SweptElbow elbow;
  const std::string name = std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/aborted.out";
  for (const auto& writer : writers())
  {
    const Events events(writer);
    writer->AddObserver(
      vtkCommand::ProgressEvent, writer.Get(), &vtkSweepMeshWriter::AbortExecuteOn);
    writer->SetInputData(elbow.sets->GetOutput());
    writer->SetFileName(name.c_str());
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_TRUE(events.errors.empty());
    EXPECT_FALSE(exists(name));
  }
}

TEST(MeshWriters, AnOldFileIsReplaced)
{
  SweptElbow elbow;
  const std::string name = std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/replaced.out";
  for (const auto& writer : writers())
  {
    std::ofstream(name) << std::string(1 << 22, '~');
    writer->SetInputData(elbow.sets->GetOutput());
    writer->SetFileName(name.c_str());
    EXPECT_EQ(writer->Write(), 1);
    std::ifstream file(name);
    const std::string content{ std::istreambuf_iterator<char>(file), {} };
    EXPECT_GT(content.size(), 1000u);
    EXPECT_EQ(content.find('~'), std::string::npos);
    std::remove(name.c_str());
  }
}
}
