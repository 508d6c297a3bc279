// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADRepair.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"
#include "HexSweepCADRun.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr std::size_t MostWords = 6;
/// Of the size of all sheets: IGES files have each edge twice, once a face.
constexpr double SewingTolerance = 1e-5;

/// Closed shells among the sheets, each a solid.
void sewSheets(CADModel& model)
{
  Bnd_Box box;
  for (const TopoDS_Shape& sheet : model.sheets)
  {
    BRepBndLib::Add(sheet, box, false);
  }
  BRepBuilderAPI_Sewing sewing(SewingTolerance * std::sqrt(box.SquareExtent()));
  for (const TopoDS_Shape& sheet : model.sheets)
  {
    sewing.Add(sheet);
  }
  sewing.Perform();
  std::size_t made = 0;
  for (TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL); shell.More(); shell.Next())
  {
    if (!BRep_Tool::IsClosed(shell.Current()))
    {
      continue;
    }
    TopoDS_Solid solid;
    const BRep_Builder builder;
    builder.MakeSolid(solid);
    builder.Add(solid, shell.Current());
    BRepLib::OrientClosedSolid(solid);
    CADSolid found;
    found.shape = solid;
    found.name = "Solid " + std::to_string(++made);
    model.solids.push_back(std::move(found));
  }
  if (made > 0)
  {
    model.leftOut.clear();
    model.complaints.push_back(
      "the file has surfaces only: " + countOf(model.sheets.size(), "sheet") +
      (made == 1 ? " were sewn into a solid." : " were sewn into " + countOf(made, "solid") + "."));
  }
}
}

std::string listWords(const std::vector<std::string>& words)
{
  std::string text;
  const std::size_t shown = std::min(MostWords, words.size());
  for (std::size_t i = 0; i < shown; ++i)
  {
    text += (i == 0 ? "" : i + 1 == shown && shown == words.size() ? " and " : ", ") + words[i];
  }
  return text + (shown < words.size() ? ", ..." : "");
}

void repairSolids(CADModel& model, bool heal, const Progress& progress)
{
  if (model.solids.empty() && !model.sheets.empty())
  {
    sewSheets(model);
  }
  std::vector<std::string> unsound;
  std::vector<std::string> healed;
  for (std::size_t s = 0; s < model.solids.size(); ++s)
  {
    CADSolid& solid = model.solids[s];
    if (heal)
    {
      ShapeFix_Shape fix(solid.shape);
      if (fix.Perform() && fix.Shape().ShapeType() == TopAbs_SOLID)
      {
        const opencascade::handle<ShapeBuild_ReShape> changes = fix.Context();
        for (CADFaceLabel& label : model.labels)
        {
          label.face = changes->Apply(label.face);
        }
        solid.shape = fix.Shape();
        healed.push_back("\"" + solid.name + "\"");
      }
    }
    BRepLib::BuildCurves3d(solid.shape);
    if (!BRepCheck_Analyzer(solid.shape).IsValid())
    {
      unsound.push_back("\"" + solid.name + "\"");
    }
    reportProgress(progress, static_cast<double>(s + 1) / static_cast<double>(model.solids.size()));
  }
  if (!healed.empty())
  {
    model.complaints.push_back("repaired: " + listWords(healed) + ".");
  }
  if (!unsound.empty())
  {
    model.complaints.push_back("not sound by the CAD kernel's own check (faces or edges that do "
                               "not fit, or cross): " +
      listWords(unsound) + "." +
      (heal ? " Mend it in the CAD system." : " Switch HealGeometry on to repair what can be."));
  }
}
}
