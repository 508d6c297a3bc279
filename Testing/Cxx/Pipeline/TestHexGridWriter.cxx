// SPDX-License-Identifier: BSD-3-Clause
// The threaded writer against VTK's own.
#include "SolidGrids.h"

#include <vtkFloatArray.h>
#include <vtkHexGridWriter.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <functional>

namespace TestHexGridWriter
{
using namespace test;
using Settings = std::function<void(vtkXMLUnstructuredGridWriter*)>;

/// A swept solid with arrays of many types and lengths.
Grid gridWithArrays()
{
  SolidSweep sweep(solidGrid("flange"), nullptr);
  sweep.filter->SetNumberOfLayers(3);
  sweep.filter->Update();
  Grid grid = Grid::New();
  grid->DeepCopy(sweep.hexes());
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkNew<vtkFloatArray> floats;
  floats->SetName("Floats");
  floats->SetNumberOfComponents(2);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType i = 0; i < points; ++i)
  {
    floats->InsertNextTuple2(0.1 * static_cast<double>(i), -1.0 / static_cast<double>(i + 1));
    ids->InsertNextValue(i % 5 == 0 ? -i : 7 * i);
  }
  grid->GetPointData()->AddArray(floats);
  grid->GetPointData()->AddArray(ids);
  vtkNew<vtkFloatArray> empty;
  empty->SetName("Empty");
  grid->GetFieldData()->AddArray(empty);
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  text->InsertNextValue("flange");
  grid->GetFieldData()->AddArray(text);
  return grid;
}

template <typename Writer>
std::string fileOf(vtkUnstructuredGrid* grid, const Settings& set)
{
  vtkNew<Writer> writer;
  writer->SetInputData(grid);
  writer->WriteToOutputStringOn();
  set(writer);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), 0u);
  return writer->GetOutputString();
}

void expectSameFile(vtkUnstructuredGrid* grid, const Settings& set)
{
  const std::string expected = fileOf<vtkXMLUnstructuredGridWriter>(grid, set);
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&] { EXPECT_TRUE(fileOf<vtkHexGridWriter>(grid, set) == expected) << threads; });
  }
}

TEST(HexGridWriter, WritesWhatVtkWrites)
{
  const Grid grid = gridWithArrays();
  using Writer = vtkXMLUnstructuredGridWriter;
  const std::map<std::string, Settings> cases = {
    { "LZ4, ids of 32 bits",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetCompressorTypeToLZ4();
        writer->SetCompressionLevel(9);
        writer->SetIdTypeToInt32();
      } },
    { "LZ4, ids of 64 bits, sizes of 64 bits",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetCompressorTypeToLZ4();
        writer->SetHeaderTypeToUInt64();
      } },
    { "zlib, small blocks",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetCompressorTypeToZLib();
        writer->SetBlockSize(64);
        writer->SetIdTypeToInt32();
      } },
    { "one block",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetCompressorTypeToLZ4();
        writer->SetBlockSize(1 << 28);
      } },
    { "no compression",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetCompressorTypeToNone();
      } },
    { "other byte order",
      [](Writer* writer) {
        writer->SetDataModeToBinary();
        writer->SetByteOrder(1 - writer->GetByteOrder());
      } },
    { "text", [](Writer* writer) { writer->SetDataModeToAscii(); } },
    { "appended", [](Writer* writer) { writer->SetDataModeToAppended(); } },
  };
  for (const auto& [name, settings] : cases)
  {
    SCOPED_TRACE(name);
    expectSameFile(grid, settings);
  }
}

TEST(HexGridWriter, SaysThatADiskIsFull)
{
  const Grid grid = gridWithArrays();
  vtkNew<vtkHexGridWriter> writer;
  Events events(writer);
  writer->SetInputData(grid);
  writer->SetFileName("/dev/full");
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToLZ4();
  EXPECT_TRUE(writer->Write() != 1 || writer->GetErrorCode() != 0u);
}
}
