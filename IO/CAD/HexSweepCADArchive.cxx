// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADArchive.h"

#include "Core/Common/Errors.h"
#include "HexSweepArrays.h"
#include "HexSweepCADLoad.h"
#include "HexSweepCADRun.h"

#include <BinTools.hxx>

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <sstream>

namespace hexsweep
{
namespace
{
void addIds(const char* name, const std::vector<Index>& ids, vtkFieldData* to)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const Index id : ids)
  {
    array->InsertNextValue(id);
  }
  to->AddArray(array);
}

void addText(const char* name, const std::string& text, vtkFieldData* to)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  to->AddArray(array);
}

std::vector<Index> idsIn(vtkFieldData* fields, const char* name)
{
  std::vector<Index> ids;
  if (vtkDataArray* array = fields->GetArray(name))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      ids.push_back(static_cast<Index>(array->GetComponent(i, 0)));
    }
  }
  return ids;
}

std::string textIn(vtkFieldData* fields, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

TopoDS_Shape shapeOf(vtkUnsignedCharArray* bytes)
{
  const unsigned char* first = bytes->GetPointer(0);
  std::istringstream stream(std::string(first, first + bytes->GetNumberOfValues()));
  TopoDS_Shape shape;
  BinTools::Read(shape, stream);
  return shape;
}

TopoDS_Shape shapeFromFile(vtkFieldData* fields)
{
  const std::string file = textIn(fields, arrays::CADFile);
  if (checksumOf(file) != textIn(fields, arrays::CADChecksum))
  {
    throw InvalidInput("the CAD file " + file + " has changed since the solid was read");
  }
  const CADModel model = loadCADModel(file, settingsFrom(textIn(fields, arrays::CADSettings)));
  const std::vector<Index> number = idsIn(fields, arrays::CADSolid);
  if (number.empty() || number.front() < 0 ||
    static_cast<std::size_t>(number.front()) >= model.solids.size())
  {
    throw InvalidInput("the CAD file " + file + " has no such solid");
  }
  return model.solids[static_cast<std::size_t>(number.front())].shape;
}

/// The library that is loaded can restore geometries.
[[maybe_unused]] const bool IsRegistered = (vtkModelGeometry::SetRestorer(&restoreGeometry), true);
}

std::string binaryOf(const NumberedSolid& solid)
{
  std::ostringstream stream;
  BinTools::Write(solid.shape, stream, false, false, BinTools_FormatVersion_CURRENT);
  return stream.str();
}

void writeGeometry(
  const NumberedSolid& solid, const std::string& binary, const CADOrigin& origin, vtkFieldData* to)
{
  addIds(arrays::CADFaceIds, solid.faceIds, to);
  addIds(arrays::CADEdgeIds, solid.edgeIds, to);
  if (!binary.empty())
  {
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName(arrays::CADGeometry);
    bytes->SetNumberOfValues(static_cast<vtkIdType>(binary.size()));
    std::memcpy(bytes->GetPointer(0), binary.data(), binary.size());
    to->AddArray(bytes);
    return;
  }
  addText(arrays::CADFile, origin.file, to);
  addText(arrays::CADChecksum, origin.checksum, to);
  addText(arrays::CADSettings, origin.settings, to);
  addIds(arrays::CADSolid, { origin.solid }, to);
}

vtkModelGeometry::Geometry restoreGeometry(vtkDataObject* data, std::string& problem)
{
  vtkFieldData* fields = data->GetFieldData();
  try
  {
    const SilencedCAD silenced;
    auto* bytes = vtkUnsignedCharArray::SafeDownCast(fields->GetArray(arrays::CADGeometry));
    NumberedSolid solid;
    solid.shape = callCAD("the CAD geometry of the solid cannot be read",
      [&] { return bytes ? shapeOf(bytes) : shapeFromFile(fields); });
    solid.faceIds = idsIn(fields, arrays::CADFaceIds);
    solid.edgeIds = idsIn(fields, arrays::CADEdgeIds);
    if (solid.shape.IsNull())
    {
      throw InvalidInput("the CAD geometry of the solid cannot be read");
    }
    return callCAD("the CAD geometry of the solid cannot be used",
      [&] { return std::make_shared<const CADGeometry>(std::move(solid)); });
  }
  catch (const InvalidInput& error)
  {
    problem = error.what();
  }
  catch (const std::exception& error)
  {
    problem = std::string("the CAD geometry of the solid cannot be read: ") + error.what();
  }
  return nullptr;
}
}
