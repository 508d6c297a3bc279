// SPDX-License-Identifier: BSD-3-Clause
#include "CADMeshes.h"
#include "CADParts.h"
#include "CapGrids.h"
#include "TestEvents.h"
#include "vtkCADReader.h"
#include "vtkOneToOneSweep.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Pln.hxx>

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace TestCADReader
{
using cadmeshes::solidOf;
using cadmeshes::temporaryFile;

TopoDS_Compound together(const std::vector<TopoDS_Shape>& shapes)
{
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(compound, shape);
  }
  return compound;
}

TopoDS_Shape block(double x, double y, double z, double dx, double dy, double dz)
{
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

std::set<int> faceIds(vtkPolyData* solid)
{
  std::set<int> ids;
  vtkDataArray* array = solid->GetCellData()->GetArray("FaceId");
  for (vtkIdType t = 0; t < solid->GetNumberOfCells(); ++t)
  {
    ids.insert(static_cast<int>(array->GetTuple1(t)));
  }
  return ids;
}

std::vector<int> facesOfBoth(vtkCADReader* reader, unsigned int solid, unsigned int other)
{
  const std::set<int> first = faceIds(solidOf(reader, solid));
  const std::set<int> second = faceIds(solidOf(reader, other));
  std::vector<int> both;
  std::set_intersection(
    first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(both));
  return both;
}

int openEdges(vtkPolyData* solid)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(solid);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfCells());
}

std::string unitOf(vtkPolyData* solid)
{
  return vtkStringArray::SafeDownCast(solid->GetFieldData()->GetAbstractArray("LengthUnit"))
    ->GetValue(0);
}

void keepLines(const std::string& fileName, double share)
{
  std::ifstream in(fileName, std::ios::binary);
  const std::string all{ std::istreambuf_iterator<char>(in), {} };
  in.close();
  std::ofstream(fileName, std::ios::binary)
    << all.substr(0, static_cast<std::size_t>(share * static_cast<double>(all.size())));
}

//------------------------------------------------------------------------------
class CADReaderOfParts : public testing::TestWithParam<std::string>
{
};

TEST_P(CADReaderOfParts, GivesClosedTrianglesWithTheKernelsVolume)
{
  const TopoDS_Shape shape = cadparts::part(GetParam());
  const std::string file = temporaryFile("part.step");
  cadparts::writeSTEP(shape, file);
  vtkNew<vtkCADReader> reader;
  const test::Events messages(reader);
  reader->SetFileName(file);
  reader->SetAngularDeflection(6.0);
  reader->Update();
  EXPECT_TRUE(messages.errors.empty());
  EXPECT_TRUE(messages.warnings.empty()) << messages.warnings.front();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
  vtkPolyData* solid = solidOf(reader);
  EXPECT_EQ(openEdges(solid), 0);
  const double volume = cadparts::volumeOf(shape);
  // Facets that turn by 6 degrees cut off 0.2 % of a circle; small bores and bends add theirs.
  EXPECT_NEAR(cadmeshes::volumeOf(solid), volume, 1e-2 * volume);
}

INSTANTIATE_TEST_SUITE_P(Parts, CADReaderOfParts, testing::ValuesIn([] {
  std::vector<std::string> names;
  for (const cadparts::Part& part : cadparts::all())
  {
    names.emplace_back(part.name);
  }
  return names;
}()),
  [](const testing::TestParamInfo<std::string>& given) { return given.param; });

//------------------------------------------------------------------------------
TEST(CADReader, SolidsThatTouchShareFaces)
{
  const std::string file = temporaryFile("touching.step");
  // The small block stands on a part of the large one's top.
  cadparts::writeSTEP(together({ block(0, 0, 0, 10, 10, 2), block(3, 3, 2, 4, 4, 5) }), file);
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(file);
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 2U);
  const std::set<int> first = faceIds(solidOf(reader, 0));
  const std::set<int> second = faceIds(solidOf(reader, 1));
  EXPECT_EQ(first.size(), 7U); // its top in two
  EXPECT_EQ(second.size(), 6U);
  EXPECT_EQ(facesOfBoth(reader, 0, 1).size(), 1U);
  EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader, 0)), 200.0, 1e-9);
  EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader, 1)), 80.0, 1e-9);

  reader->ImprintAndMergeOff();
  reader->Update();
  EXPECT_EQ(faceIds(solidOf(reader, 0)).size(), 6U);
  EXPECT_EQ(*faceIds(solidOf(reader, 1)).begin(), 7);
}

TEST(CADReader, SolidsThatOverlapStayAsTheyAreWithAWarning)
{
  const std::string file = temporaryFile("overlapping.step");
  cadparts::writeSTEP(together({ block(0, 0, 0, 10, 10, 2), block(3, 3, 1, 4, 4, 5) }), file);
  vtkNew<vtkCADReader> reader;
  const test::Events messages(reader);
  reader->SetFileName(file);
  reader->Update();
  EXPECT_TRUE(messages.errors.empty());
  ASSERT_EQ(messages.warnings.size(), 1U);
  EXPECT_NE(messages.warnings.front().find("overlap"), std::string::npos);
  EXPECT_EQ(faceIds(solidOf(reader, 0)).size(), 6U);
}

TEST(CADReader, SolidsThatOverlapDoNotKeepOthersFromSharingFaces)
{
  const std::string file = temporaryFile("overlapping_elsewhere.step");
  cadparts::writeSTEP(together({ block(0, 0, 0, 10, 10, 2), block(50, 0, 0, 10, 10, 2),
                        block(3, 3, 1, 4, 4, 5), block(53, 3, 2, 4, 4, 5) }),
    file);
  vtkNew<vtkCADReader> reader;
  const test::Events messages(reader);
  reader->SetFileName(file);
  reader->Update();
  ASSERT_EQ(messages.warnings.size(), 1U);
  EXPECT_NE(messages.warnings.front().find("overlap"), std::string::npos);
  EXPECT_EQ(facesOfBoth(reader, 0, 2).size(), 0U);
  EXPECT_EQ(facesOfBoth(reader, 1, 3).size(), 1U);
  EXPECT_EQ(faceIds(solidOf(reader, 0)).size(), 6U);
  EXPECT_EQ(faceIds(solidOf(reader, 1)).size(), 7U);
}

TEST(CADReader, EdgesKnowTheirFaces)
{
  const std::string file = temporaryFile("cylinder.step");
  cadparts::writeSTEP(BRepPrimAPI_MakeCylinder(3.0, 5.0).Shape(), file);
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(file);
  reader->Update();
  auto* edges = vtkPolyData::SafeDownCast(
    vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(1))
      ->GetPartition(0, 0));
  ASSERT_EQ(edges->GetNumberOfCells(), 3); // two circles and the seam
  int seams = 0;
  vtkDataArray* beside = edges->GetCellData()->GetArray("EdgeFaceIds");
  for (vtkIdType e = 0; e < 3; ++e)
  {
    seams += beside->GetComponent(e, 0) == beside->GetComponent(e, 1) ? 1 : 0;
  }
  EXPECT_EQ(seams, 1);
}

TEST(CADReader, LengthsComeInTheUnitOfTheFileOrTheOneAskedFor)
{
  const std::string file = temporaryFile("inch.step");
  cadparts::writeSTEP(block(0, 0, 0, 1, 2, 1), file, "INCH");
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(file);
  reader->Update();
  EXPECT_EQ(unitOf(solidOf(reader)), "inch");
  EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader)), 2.0, 1e-9);
  reader->SetLengthUnit(vtkCADReader::MILLIMETRE);
  reader->Update();
  EXPECT_EQ(unitOf(solidOf(reader)), "millimetre");
  EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader)), 2.0 * 25.4 * 25.4 * 25.4, 1e-5);
  reader->SetLengthUnit(vtkCADReader::METRE);
  reader->Update();
  EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader)), 2.0 * 0.0254 * 0.0254 * 0.0254, 1e-14);
}

TEST(CADReader, IgesAndBrepFilesGiveTheSameSolid)
{
  const TopoDS_Shape shape = cadparts::part("block_with_holes");
  const std::string iges = temporaryFile("part.igs");
  const std::string brep = temporaryFile("part.brep");
  cadparts::writeIGES(shape, iges);
  cadparts::writeBREP(shape, brep);
  for (const std::string& file : { iges, brep })
  {
    vtkNew<vtkCADReader> reader;
    const test::Events messages(reader);
    reader->SetFileName(file);
    reader->SetLinearDeflection(1e-4);
    reader->SetAngularDeflection(3.0);
    reader->Update();
    ASSERT_TRUE(messages.errors.empty()) << messages.errors.front();
    ASSERT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U) << file;
    EXPECT_EQ(openEdges(solidOf(reader)), 0);
    EXPECT_NEAR(cadmeshes::volumeOf(solidOf(reader)), cadparts::volumeOf(shape),
      2e-3 * cadparts::volumeOf(shape));
  }
}

TEST(CADReader, WhatIsNoSolidIsLeftOutWithAWarning)
{
  const std::string file = temporaryFile("sheet.step");
  const TopoDS_Shape sheet =
    BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1)), 0, 5, 0, 5).Shape();
  cadparts::writeSTEP(together({ block(0, 0, 0, 10, 10, 2), sheet }), file);
  vtkNew<vtkCADReader> reader;
  const test::Events messages(reader);
  reader->SetFileName(file);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
  ASSERT_EQ(messages.warnings.size(), 1U);
  EXPECT_NE(messages.warnings.front().find("1 sheet body"), std::string::npos)
    << messages.warnings.front();
}

TEST(CADReader, BadFilesGiveOneErrorAndNoOutput)
{
  const std::string whole = temporaryFile("whole.step");
  cadparts::writeSTEP(block(0, 0, 0, 1, 1, 1), whole);
  const std::string cut = temporaryFile("cut.step");
  cadparts::writeSTEP(block(0, 0, 0, 1, 1, 1), cut);
  keepLines(cut, 0.6);
  const std::string noise = temporaryFile("noise.step");
  std::ofstream(noise) << "nothing of the kind\n";
  const std::string noSolid = temporaryFile("no_solid.step");
  cadparts::writeSTEP(
    BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 5, 0, 5).Shape(), noSolid);
  const std::string empty = temporaryFile("empty.brep");
  std::ofstream(empty).flush();
  const std::pair<std::string, std::string> cases[] = {
    { cut, "cut short" },
    { noise, "cut short" },
    { noSolid, "has no solid, but 1 sheet body" },
    { empty, "no BREP file" },
    { temporaryFile("missing.step"), "cannot be opened" },
    { "part.stl", "only .step" },
    { "", "no file is named" },
  };
  for (const auto& [file, words] : cases)
  {
    vtkNew<vtkCADReader> reader;
    const test::Events messages(reader);
    reader->SetFileName(file);
    reader->Update();
    ASSERT_EQ(messages.errors.size(), 1U) << file;
    EXPECT_NE(messages.errors.front().find(words), std::string::npos) << messages.errors.front();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0U);
    // It can be used again.
    reader->SetFileName(whole);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
  }
}

TEST(CADReader, StopsWhereItIsAborted)
{
  const std::string file = std::string(HEXSWEEP_DATA_DIR) + "/cad/bolted_joint.step";
  for (const double fraction : { 0.0, 0.2, 0.5, 0.75, 0.9 })
  {
    vtkNew<vtkCADReader> reader;
    reader->SetFileName(file);
    vtkNew<test::AbortAt> abort;
    abort->Fraction = fraction;
    const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, abort);
    const test::Events messages(reader);
    reader->Update();
    EXPECT_TRUE(messages.errors.empty());
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0U) << fraction;
    reader->RemoveObserver(tag);
    reader->SetAbortExecute(0);
    reader->Modified();
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 6U) << fraction;
  }
}

TEST(CADReader, FacesThatCrossThemselvesAreReported)
{
  // A prism over a polygon that crosses itself.
  BRepBuilderAPI_MakePolygon bow;
  for (const auto& [x, y] : { std::make_pair(0.0, 0.0), std::make_pair(4.0, 3.0),
         std::make_pair(4.0, 0.0), std::make_pair(0.0, 3.0) })
  {
    bow.Add(gp_Pnt(x, y, 0.0));
  }
  bow.Close();
  const TopoDS_Shape crossed = BRepPrimAPI_MakePrism(
    BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), bow.Wire()).Face(),
    gp_Vec(0, 0, 2))
                                 .Shape();
  const std::string file = temporaryFile("bow.step");
  cadparts::writeSTEP(crossed, file);
  vtkNew<vtkCADReader> reader;
  const test::Events messages(reader);
  reader->SetFileName(file);
  reader->Update();
  const auto& said = messages.errors.empty() ? messages.warnings : messages.errors;
  ASSERT_FALSE(said.empty());
  EXPECT_NE(said.front().find("HealGeometry"), std::string::npos) << said.front();
}

TEST(CADReader, OtherRanksGetTheStructure)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(std::string(HEXSWEEP_DATA_DIR) + "/cad/three_blocks.step");
  reader->UpdatePiece(1, 2, 0);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 3U);
  for (unsigned int s = 0; s < 3; ++s)
  {
    vtkPolyData* solid = solidOf(reader, s);
    EXPECT_TRUE(!solid || solid->GetNumberOfCells() == 0);
  }
  vtkNew<vtkOneToOneSweep> sweep;
  const test::Events messages(sweep);
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->UpdatePiece(1, 2, 0);
  EXPECT_TRUE(messages.errors.empty());
  EXPECT_EQ(sweep->GetOutput()->GetNumberOfCells(), 0);
}

TEST(CADReader, NamesAndColoursOfTheFileArrive)
{
  const TopoDS_Shape shape = block(0, 0, 0, 1, 2, 3);
  opencascade::handle<TDocStd_Document> document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TDF_Label part = shapes->AddShape(shape, false);
  TDataStd_Name::Set(part, "Bracket");
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
  {
    GProp_GProps surface;
    BRepGProp::SurfaceProperties(face.Current(), surface);
    if (surface.CentreOfMass().Z() > 2.9) // the upper one
    {
      const TDF_Label label = shapes->AddSubShape(part, face.Current());
      TDataStd_Name::Set(label, "Inlet");
      colors->SetColor(label, Quantity_Color(1.0, 0.0, 0.0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    }
  }
  const std::string file = temporaryFile("names.step");
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.Transfer(document, STEPControl_AsIs);
  ASSERT_EQ(writer.Write(file.c_str()), IFSelect_RetDone);

  vtkNew<vtkCADReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkPolyData* solid = solidOf(reader);
  vtkFieldData* fields = solid->GetFieldData();
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(fields->GetAbstractArray("VolumeName"))->GetValue(0), "Bracket");
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("FaceNames"));
  vtkDataArray* ids = solid->GetCellData()->GetArray("FaceId");
  int named = 0;
  for (vtkIdType t = 0; t < solid->GetNumberOfCells(); ++t)
  {
    double bounds[6];
    solid->GetCellBounds(t, bounds);
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(t));
    const bool isUpper = bounds[4] > 2.9;
    EXPECT_EQ(names->GetValue(id), isUpper ? "Inlet" : "");
    // Single precision in the kernel.
    EXPECT_NEAR(fields->GetArray("FaceColors")->GetComponent(id, 0), isUpper ? 1.0 : -1.0, 1e-6);
    named += isUpper ? 1 : 0;
  }
  EXPECT_EQ(named, 2);
}
}
