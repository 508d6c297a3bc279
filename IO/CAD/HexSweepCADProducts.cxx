// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADProducts.h"

#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <utility>

namespace hexsweep
{
namespace
{
constexpr int GreatestDepth = 64; ///< of assemblies in assemblies

std::string nameOf(const TDF_Label& label)
{
  opencascade::handle<TDataStd_Name> name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name))
  {
    return {};
  }
  const TCollection_ExtendedString& text = name->Get();
  std::string result(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter target = result.data();
  text.ToUTF8CString(target);
  result.resize(static_cast<std::size_t>(text.LengthOfCString()));
  return result;
}

/// Names that systems give to what has none.
bool saysNothing(const std::string& name)
{
  return name.empty() || name == "NONE" || name == "none" || name == "SOLID" ||
    name.rfind("Open CASCADE STEP translator", 0) == 0 || name == "COMPOUND" || name == "FACE" ||
    name == "SHELL" || name == "''" || name == " ";
}

/// Instances are often numbered instead of named: "18", "NAUO18".
bool isNumber(std::string name)
{
  if (name.rfind("NAUO", 0) == 0)
  {
    name.erase(0, 4);
  }
  return name.find_first_not_of("0123456789") == std::string::npos;
}

std::optional<CADColor> colorOf(XCAFDoc_ColorTool& colors, const TDF_Label& label)
{
  for (const XCAFDoc_ColorType type : { XCAFDoc_ColorSurf, XCAFDoc_ColorGen })
  {
    Quantity_Color color;
    if (colors.GetColor(label, type, color))
    {
      double red = 0.0;
      double green = 0.0;
      double blue = 0.0;
      color.Values(red, green, blue, Quantity_TOC_sRGB);
      return CADColor{ red, green, blue };
    }
  }
  return std::nullopt;
}

/// Walks down the products of a document.
class Walk
{
public:
  /// @param colors nullptr: only shapes are added, which have none.
  explicit Walk(opencascade::handle<XCAFDoc_ColorTool> colors = nullptr)
    : Colors(std::move(colors))
  {
  }

  void visit(const TDF_Label& label, const TopLoc_Location& place, const std::string& instance,
    std::ptrdiff_t parent, int depth)
  {
    if (depth > GreatestDepth)
    {
      this->Model.complaints.emplace_back(
        "assemblies that contain each other more than 64 deep are left out.");
      return;
    }
    TDF_Label referred;
    if (XCAFDoc_ShapeTool::IsReference(label) &&
      XCAFDoc_ShapeTool::GetReferredShape(label, referred))
    {
      const std::optional<CADColor> own = colorOf(*this->Colors, label);
      const std::optional<CADColor> before = this->Color;
      this->Color = own ? own : this->Color;
      this->visit(
        referred, place * XCAFDoc_ShapeTool::GetLocation(label), nameOf(label), parent, depth + 1);
      this->Color = before;
      return;
    }
    const std::string product = nameOf(label);
    this->Model.products.push_back({ !saysNothing(product) ? product
        : saysNothing(instance) || isNumber(instance)      ? std::string()
                                                           : instance,
      parent });
    const auto row = static_cast<std::ptrdiff_t>(this->Model.products.size()) - 1;
    if (XCAFDoc_ShapeTool::IsAssembly(label))
    {
      TDF_LabelSequence parts;
      XCAFDoc_ShapeTool::GetComponents(label, parts);
      for (const TDF_Label& part : parts)
      {
        this->visit(part, place, "", row, depth + 1);
      }
      return;
    }
    this->addPart(label, place, row);
  }

  void addShape(const TopoDS_Shape& shape, std::ptrdiff_t product)
  {
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    {
      CADSolid found;
      found.shape = solid.Current();
      for (std::ptrdiff_t row = product; row >= 0; row = this->Model.products[at(row)].parent)
      {
        found.products.insert(found.products.begin(), at(row));
      }
      found.color = this->Color;
      this->Model.solids.push_back(std::move(found));
    }
    this->count(shape, TopAbs_SHELL, TopAbs_SOLID, this->Sheets);
    this->count(shape, TopAbs_FACE, TopAbs_SHELL, this->Sheets);
    this->count(shape, TopAbs_WIRE, TopAbs_FACE, this->Wires);
    this->count(shape, TopAbs_EDGE, TopAbs_WIRE, this->Wires);
    this->count(shape, TopAbs_VERTEX, TopAbs_EDGE, this->Vertices);
  }

  CADModel finish()
  {
    const auto tell = [&](std::size_t count, const char* one, const char* several) {
      if (count > 0)
      {
        this->Model.leftOut.push_back(std::to_string(count) + " " + (count == 1 ? one : several));
      }
    };
    tell(this->Sheets.size(), "sheet body without volume", "sheet bodies without volume");
    tell(this->Wires.size(), "wire", "wires");
    tell(this->Vertices.size(), "free vertex", "free vertices");
    this->Model.sheets = std::move(this->Sheets);
    return std::move(this->Model);
  }

private:
  static std::size_t at(std::ptrdiff_t row) { return static_cast<std::size_t>(row); }

  static void count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum without,
    std::vector<TopoDS_Shape>& found)
  {
    for (TopExp_Explorer some(shape, kind, without); some.More(); some.Next())
    {
      found.push_back(some.Current());
    }
  }

  void addPart(const TDF_Label& label, const TopLoc_Location& place, std::ptrdiff_t product)
  {
    const std::optional<CADColor> before = this->Color;
    if (const std::optional<CADColor> own = colorOf(*this->Colors, label))
    {
      this->Color = this->Color ? this->Color : own;
    }
    const std::size_t first = this->Model.solids.size();
    this->addShape(XCAFDoc_ShapeTool::GetShape(label).Moved(place), product);
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(label, subs);
    for (const TDF_Label& sub : subs)
    {
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(sub).Moved(place);
      const std::string name = nameOf(sub);
      const std::optional<CADColor> color = colorOf(*this->Colors, sub);
      if (shape.ShapeType() == TopAbs_FACE && (!saysNothing(name) || color))
      {
        this->Model.labels.push_back({ shape, saysNothing(name) ? "" : name, color });
      }
      for (std::size_t s = first; s < this->Model.solids.size(); ++s)
      {
        CADSolid& solid = this->Model.solids[s];
        if (solid.shape.IsSame(shape))
        {
          solid.name = saysNothing(name) ? solid.name : name;
          solid.color = color ? color : solid.color;
        }
      }
    }
    this->Color = before;
  }

  CADModel Model;
  opencascade::handle<XCAFDoc_ColorTool> Colors;
  std::optional<CADColor> Color; ///< of the instances above
  std::vector<TopoDS_Shape> Sheets;
  std::vector<TopoDS_Shape> Wires;
  std::vector<TopoDS_Shape> Vertices;
};

/// Each solid has a name: its own, else that of its part, with a number where that is not enough.
void nameSolids(CADModel& model)
{
  std::vector<int> solidsOf(model.products.size(), 0);
  for (const CADSolid& solid : model.solids)
  {
    if (!solid.products.empty())
    {
      ++solidsOf[solid.products.back()];
    }
  }
  std::vector<int> seen(model.products.size(), 0);
  for (std::size_t s = 0; s < model.solids.size(); ++s)
  {
    CADSolid& solid = model.solids[s];
    if (!solid.name.empty())
    {
      continue;
    }
    if (solid.products.empty() || model.products[solid.products.back()].name.empty())
    {
      solid.name = "Solid " + std::to_string(s + 1);
      continue;
    }
    const std::size_t product = solid.products.back();
    solid.name = model.products[product].name;
    if (solidsOf[product] > 1)
    {
      solid.name += " " + std::to_string(++seen[product]);
    }
  }
}
}

CADModel readProducts(const opencascade::handle<TDocStd_Document>& document)
{
  const opencascade::handle<XCAFDoc_ShapeTool> shapes =
    XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence free;
  shapes->GetFreeShapes(free);
  Walk walk(XCAFDoc_DocumentTool::ColorTool(document->Main()));
  for (const TDF_Label& label : free)
  {
    walk.visit(label, TopLoc_Location(), "", -1, 0);
  }
  CADModel model = walk.finish();
  nameSolids(model);
  return model;
}

CADModel productsOfShape(const TopoDS_Shape& shape)
{
  Walk walk;
  walk.addShape(shape, -1);
  CADModel model = walk.finish();
  nameSolids(model);
  return model;
}
}
