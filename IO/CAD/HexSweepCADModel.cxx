// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADModel.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>

namespace hexsweep
{
void numberFacesAndEdges(CADModel& model)
{
  model.faces.Clear();
  model.edges.Clear();
  Bnd_Box box;
  for (const CADSolid& solid : model.solids)
  {
    TopExp::MapShapes(solid.shape, TopAbs_FACE, model.faces);
    for (TopExp_Explorer edge(solid.shape, TopAbs_EDGE); edge.More(); edge.Next())
    {
      if (!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
      {
        model.edges.Add(edge.Current());
      }
    }
    BRepBndLib::AddOptimal(solid.shape, box, false, false);
  }
  model.size = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

std::vector<std::string> faceNames(const CADModel& model)
{
  std::vector<std::string> names(static_cast<std::size_t>(model.faces.Extent()));
  for (const CADFaceLabel& label : model.labels)
  {
    if (const int id = model.faces.FindIndex(label.face))
    {
      names[static_cast<std::size_t>(id - 1)] = label.name;
    }
  }
  return names;
}

std::vector<std::optional<CADColor>> faceColors(const CADModel& model)
{
  std::vector<std::optional<CADColor>> colors(static_cast<std::size_t>(model.faces.Extent()));
  for (const CADSolid& solid : model.solids)
  {
    for (TopExp_Explorer face(solid.shape, TopAbs_FACE); face.More(); face.Next())
    {
      std::optional<CADColor>& color =
        colors[static_cast<std::size_t>(model.faces.FindIndex(face.Current()) - 1)];
      color = color ? color : solid.color;
    }
  }
  for (const CADFaceLabel& label : model.labels)
  {
    const int id = model.faces.FindIndex(label.face);
    if (id > 0 && label.color)
    {
      colors[static_cast<std::size_t>(id - 1)] = label.color;
    }
  }
  return colors;
}
}
