// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADFile.h"

#include "Core/Common/Describe.h"
#include "HexSweepCADProducts.h"
#include "HexSweepCADRepair.h"
#include "HexSweepCADRun.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <UnitsMethods.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>

namespace hexsweep
{
namespace
{
struct Unit
{
  const char* name;
  const char* kernelName; ///< of Interface_Static
  UnitsMethods_LengthUnit unit;
};

constexpr std::array<Unit, 8> Units{ {
  { "millimetre", "MM", UnitsMethods_LengthUnit_Millimeter },
  { "centimetre", "CM", UnitsMethods_LengthUnit_Centimeter },
  { "metre", "M", UnitsMethods_LengthUnit_Meter },
  { "kilometre", "KM", UnitsMethods_LengthUnit_Kilometer },
  { "micrometre", "UM", UnitsMethods_LengthUnit_Micron },
  { "inch", "INCH", UnitsMethods_LengthUnit_Inch },
  { "foot", "FT", UnitsMethods_LengthUnit_Foot },
  { "mile", "MI", UnitsMethods_LengthUnit_Mile },
} };

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

const Unit& unitNamed(const std::string& name)
{
  const auto* found =
    std::find_if(Units.begin(), Units.end(), [&](const Unit& unit) { return unit.name == name; });
  if (found == Units.end())
  {
    std::string all;
    for (const Unit& unit : Units)
    {
      all += (all.empty() ? "" : ", ") + std::string(unit.name);
    }
    throw InvalidInput("the length unit \"" + name + "\" is not known. Choose one of " + all + ".");
  }
  return *found;
}

/// A unit as STEP files call it, in small letters; millimetre where that is not known.
const Unit& unitCalled(std::string name)
{
  const std::size_t american = name.rfind("meter");
  if (american != std::string::npos)
  {
    name.replace(american, 5, "metre");
  }
  const auto* found = std::find_if(Units.begin(), Units.end(),
    [&](const Unit& own) { return name == own.name || name == lower(own.kernelName); });
  return found == Units.end() ? Units.front() : *found;
}

/// What the kernel calls a unit in a file; millimetre where that says nothing.
const Unit& unitOfFile(UnitsMethods_LengthUnit unit)
{
  const auto* found =
    std::find_if(Units.begin(), Units.end(), [&](const Unit& own) { return own.unit == unit; });
  return found == Units.end() ? Units.front() : *found;
}

/// A setting of the kernel's readers, which are global, for a while.
class KernelSetting
{
public:
  KernelSetting(const char* name, int value)
    : Name(name)
    , Before(Interface_Static::IVal(name))
  {
    Interface_Static::SetIVal(name, value);
  }
  ~KernelSetting() { Interface_Static::SetIVal(this->Name, this->Before); }
  KernelSetting(const KernelSetting&) = delete;
  KernelSetting& operator=(const KernelSetting&) = delete;

private:
  const char* Name;
  int Before;
};

class KernelUnit
{
public:
  explicit KernelUnit(const char* unit)
    : Before(Interface_Static::CVal("xstep.cascade.unit"))
  {
    Interface_Static::SetCVal("xstep.cascade.unit", unit);
  }
  ~KernelUnit() { Interface_Static::SetCVal("xstep.cascade.unit", this->Before.c_str()); }
  KernelUnit(const KernelUnit&) = delete;
  KernelUnit& operator=(const KernelUnit&) = delete;

private:
  std::string Before;
};

/// A document of the kernel, closed when it is done with.
class Document
{
public:
  Document() { XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", this->Handle); }
  ~Document()
  {
    try
    {
      XCAFApp_Application::GetApplication()->Close(this->Handle);
    }
    catch (const Standard_Failure&)
    {
      // It is not needed any more.
    }
  }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  opencascade::handle<TDocStd_Document> Handle;
};

[[noreturn]] void refuse(const std::string& fileName, const std::string& why)
{
  throw InvalidInput(fileName + ": " + why);
}

std::string beginOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  std::string begin(256, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return begin;
}

/// Files that end before their end mark may still be parsed, with whatever is missing.
void checkIsWhole(const std::string& fileName)
{
  constexpr std::streamoff Tail = 1024;
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(0, size - Tail));
  const std::string end{ std::istreambuf_iterator<char>(file), {} };
  if (end.find("END-ISO-10303-21") == std::string::npos)
  {
    refuse(fileName,
      "the file is cut short: it does not end with END-ISO-10303-21. Export or copy it again.");
  }
}

/// The second half of what the kernel's two readers do alike: shapes in a unit, and their names.
template <typename Reader>
CADModel transfer(
  Reader& reader, const std::string& fileName, const Unit& unit, const Progress& progress)
{
  const KernelUnit kernelUnit(unit.kernelName);
  Document document;
  XCAFDoc_DocumentTool::SetLengthUnit(document.Handle, 1.0, unit.unit);
  opencascade::handle<CADProgress> shown = new CADProgress(progress);
  const bool transferred = reader.Transfer(document.Handle, shown->Start());
  shown->check();
  if (!transferred)
  {
    refuse(fileName, "the file has no shape that can be taken over.");
  }
  CADModel model = readProducts(document.Handle);
  model.lengthUnit = unit.name;
  return model;
}

CADModel readSTEP(
  const std::string& fileName, const CADFileOptions& options, const Progress& progress)
{
  checkIsWhole(fileName);
  STEPCAFControl_Reader reader;
  // The setting is there from the first reader on, and not before.
  const KernelSetting names("read.stepcaf.subshapes.name", 1);
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(false);
  reader.SetPropsMode(false);
  if (reader.ReadFile(fileName.c_str()) != IFSelect_RetDone)
  {
    refuse(fileName, "this is no STEP file that can be read (ISO 10303-21). Export it again.");
  }
  reportProgress(progress, 0.2);
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solidAngles;
  reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
  const Unit unit = !options.lengthUnit.empty() ? unitNamed(options.lengthUnit)
    : lengths.IsEmpty()                         ? Units.front()
                                                : unitCalled(lower(lengths.First().ToCString()));
  return transfer(reader, fileName, unit, progressPart(progress, 0.2, 1.0));
}

CADModel readIGES(
  const std::string& fileName, const CADFileOptions& options, const Progress& progress)
{
  IGESCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  if (reader.ReadFile(fileName.c_str()) != IFSelect_RetDone)
  {
    refuse(fileName, "this is no IGES file that can be read. Export it again, or as STEP.");
  }
  reportProgress(progress, 0.2);
  const auto iges = opencascade::handle<IGESData_IGESModel>::DownCast(reader.Model());
  const Unit& unit = !options.lengthUnit.empty()
    ? unitNamed(options.lengthUnit)
    // The kernel knows these by their factor to millimetres.
    : unitOfFile(UnitsMethods::GetLengthUnitByFactorValue(
        iges->GlobalSection().UnitValue(), UnitsMethods_LengthUnit_Millimeter));
  return transfer(reader, fileName, unit, progressPart(progress, 0.2, 1.0));
}

CADModel readBREP(
  const std::string& fileName, const CADFileOptions& options, const Progress& progress)
{
  TopoDS_Shape shape;
  opencascade::handle<CADProgress> shown = new CADProgress(progress);
  const BRep_Builder builder;
  // The kernel prints to the console where it is given another one's file.
  const std::string begin = beginOf(fileName);
  const bool read = begin.find("CASCADE Topology") == std::string::npos &&
      begin.rfind("DBRep_DrawableShape", 0) != 0
    ? false
    : begin.rfind("Open CASCADE Topology", 0) == 0
    ? BinTools::Read(shape, fileName.c_str(), shown->Start())
    : BRepTools::Read(shape, fileName.c_str(), builder, shown->Start());
  shown->check();
  if (!read || shape.IsNull())
  {
    refuse(fileName, "this is no BREP file of OpenCASCADE that can be read. Export it again.");
  }
  CADModel model = productsOfShape(shape);
  // These files know no unit.
  model.lengthUnit = options.lengthUnit;
  return model;
}
}

std::optional<CADFormat> cadFormatOf(const std::string& fileName)
{
  const std::size_t dot = fileName.rfind('.');
  const std::string extension = dot == std::string::npos ? "" : lower(fileName.substr(dot));
  if (extension == ".step" || extension == ".stp")
  {
    return CADFormat::STEP;
  }
  if (extension == ".iges" || extension == ".igs")
  {
    return CADFormat::IGES;
  }
  if (extension == ".brep" || extension == ".brp")
  {
    return CADFormat::BREP;
  }
  return std::nullopt;
}

const std::vector<std::string>& cadLengthUnits()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Unit& unit : Units)
    {
      all.emplace_back(unit.name);
    }
    return all;
  }();
  return names;
}

CADModel readCADFile(
  const std::string& fileName, const CADFileOptions& options, const Progress& progress)
{
  const std::optional<CADFormat> format = cadFormatOf(fileName);
  if (!format)
  {
    refuse(fileName, "only .step, .stp, .iges, .igs, .brep and .brp files are read.");
  }
  if (!std::ifstream(fileName, std::ios::binary))
  {
    refuse(fileName, "the file cannot be opened.");
  }
  const SilencedCAD silenced;
  const Progress reading = progressPart(progress, 0.0, 0.9);
  CADModel model = callCAD(fileName + ": the CAD kernel failed on this file", [&] {
    return *format == CADFormat::STEP ? readSTEP(fileName, options, reading)
      : *format == CADFormat::IGES    ? readIGES(fileName, options, reading)
                                      : readBREP(fileName, options, reading);
  });
  repairSolids(model, options.heal, progressPart(progress, 0.9, 1.0));
  if (model.solids.empty())
  {
    refuse(fileName,
      "the file has no solid" +
        (model.leftOut.empty() ? std::string(".")
                               : ", but " + listWords(model.leftOut) +
              ". Close surfaces into a solid in the CAD system, then export it again."));
  }
  return model;
}
}
