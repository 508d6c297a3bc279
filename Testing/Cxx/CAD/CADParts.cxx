// SPDX-License-Identifier: BSD-3-Clause
#include "CADParts.h"

#include "Core/Common/Constants.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepFilletAPI_MakeFillet2d.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeOffset.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepOffset_MakeSimpleOffset.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace cadparts
{
namespace
{
using hexsweep::Pi;
const gp_Pnt Origin(0.0, 0.0, 0.0);

gp_Ax2 axesAt(double x, double y, double z)
{
  return gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0.0, 0.0, 1.0));
}

TopoDS_Wire circle(const gp_Ax2& axes, double radius)
{
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)).Edge());
}

TopoDS_Wire square(double half, double z, double turn = 0.0)
{
  BRepBuilderAPI_MakePolygon polygon;
  for (int i = 0; i < 4; ++i)
  {
    const double angle = turn + Pi / 4.0 + i * Pi / 2.0;
    const double radius = half * std::sqrt(2.0);
    polygon.Add(gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  polygon.Close();
  return polygon.Wire();
}

/// A closed spline through points on a circle with lobes.
TopoDS_Wire splineLoop(double radius, double lobe, int lobes, double z)
{
  constexpr int Count = 24;
  opencascade::handle<TColgp_HArray1OfPnt> points = new TColgp_HArray1OfPnt(1, Count);
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * Pi * i / Count;
    const double r = radius + lobe * std::cos(lobes * angle);
    points->SetValue(i + 1, gp_Pnt(r * std::cos(angle), r * std::sin(angle), z));
  }
  GeomAPI_Interpolate spline(points, true, 1e-9);
  spline.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline.Curve()).Edge());
}

TopoDS_Wire splinePath()
{
  TColgp_Array1OfPnt points(1, 5);
  points.SetValue(1, gp_Pnt(0.0, 0.0, 0.0));
  points.SetValue(2, gp_Pnt(0.0, 1.0, 10.0));
  points.SetValue(3, gp_Pnt(2.0, 3.0, 20.0));
  points.SetValue(4, gp_Pnt(6.0, 3.0, 30.0));
  points.SetValue(5, gp_Pnt(9.0, 1.0, 40.0));
  return BRepBuilderAPI_MakeWire(
    BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge());
}

opencascade::handle<Geom_BSplineSurface> waves(double half, double z, double height)
{
  constexpr int Count = 9;
  TColgp_Array2OfPnt points(1, Count, 1, Count);
  for (int i = 0; i < Count; ++i)
  {
    for (int j = 0; j < Count; ++j)
    {
      const double x = half * (2.0 * i / (Count - 1) - 1.0);
      const double y = half * (2.0 * j / (Count - 1) - 1.0);
      points.SetValue(i + 1, j + 1,
        gp_Pnt(x, y, z + height * std::sin(2.5 * x / half) * std::cos(2.0 * y / half)));
    }
  }
  return GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-6).Surface();
}

TopoDS_Shape extruded(const TopoDS_Wire& outer, double height)
{
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outer, true).Face(), gp_Vec(0, 0, height))
    .Shape();
}

TopoDS_Shape bored(const TopoDS_Shape& solid, double x, double y, double radius)
{
  return BRepAlgoAPI_Cut(
    solid, BRepPrimAPI_MakeCylinder(axesAt(x, y, -100.0), radius, 300.0).Shape())
    .Shape();
}

TopoDS_Shape revolved(const TopoDS_Shape& face, double degrees)
{
  return BRepPrimAPI_MakeRevol(face, gp_Ax1(Origin, gp_Dir(0.0, 1.0, 0.0)), degrees * Pi / 180.0)
    .Shape();
}

TopoDS_Shape discAt(double x, double radius)
{
  return BRepBuilderAPI_MakeFace(circle(axesAt(x, 0.0, 0.0), radius), true).Face();
}

TopoDS_Shape loft(const std::vector<TopoDS_Wire>& sections, bool ruled)
{
  BRepOffsetAPI_ThruSections through(true, ruled, 1e-7);
  for (const TopoDS_Wire& section : sections)
  {
    through.AddWire(section);
  }
  through.Build();
  return through.Shape();
}

TopoDS_Wire ellipse(double z, double a, double b)
{
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Elips(axesAt(0, 0, z), a, b)).Edge());
}

TopoDS_Shape barrel()
{
  // The profile of half a barrel with a bore: its outer side is an arc.
  const gp_Pnt low(6.0, 0.0, 0.0);
  const gp_Pnt high(6.0, 12.0, 0.0);
  const TopoDS_Edge arc =
    BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(low, gp_Pnt(8.0, 6.0, 0.0), high).Value());
  const gp_Pnt innerLow(3.0, 0.0, 0.0);
  const gp_Pnt innerHigh(3.0, 12.0, 0.0);
  const TopoDS_Wire wire =
    BRepBuilderAPI_MakeWire(arc, BRepBuilderAPI_MakeEdge(high, innerHigh).Edge(),
      BRepBuilderAPI_MakeEdge(innerHigh, innerLow).Edge(),
      BRepBuilderAPI_MakeEdge(innerLow, low).Edge());
  return revolved(BRepBuilderAPI_MakeFace(wire, true).Face(), 360.0);
}

TopoDS_Shape filletedBlock()
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-10, -6, 0), 20.0, 12.0, 5.0).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
  {
    GProp_GProps line;
    BRepGProp::LinearProperties(edge.Current(), line);
    if (std::abs(line.Mass() - 5.0) < 1e-9)
    {
      fillet.Add(2.0, TopoDS::Edge(edge.Current()));
    }
  }
  return bored(fillet.Shape(), 3.0, 0.0, 2.5);
}

TopoDS_Shape offsetSheet()
{
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(waves(10.0, 0.0, 1.0), 1e-6).Face();
  BRepOffset_MakeSimpleOffset thick(face, 2.0);
  thick.SetBuildSolidFlag(true);
  thick.Perform();
  return thick.GetResultShape();
}

TopoDS_Shape waveTop()
{
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(waves(12.0, 8.0, 1.0), 1e-6).Face();
  const TopoDS_Shape above = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 30.0)).Shape();
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -8, 0), 20.0, 16.0, 20.0).Shape();
  return BRepAlgoAPI_Cut(block, above).Shape();
}

TopoDS_Shape domed()
{
  const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(axesAt(0, 0, 0), 6.0, 20.0).Shape();
  return BRepAlgoAPI_Common(bar, BRepPrimAPI_MakeSphere(gp_Pnt(1.0, 0.0, 0.0), 14.0).Shape())
    .Shape();
}

// The five solids of Data/solids.

TopoDS_Shape flange()
{
  TopoDS_Shape solid = bored(extruded(circle(axesAt(0, 0, 0), 50.0), 14.0), 0.0, 0.0, 16.0);
  for (int i = 0; i < 6; ++i)
  {
    const double angle = (11.46 + 60.0 * i) * Pi / 180.0;
    solid = bored(solid, 35.0 * std::cos(angle), 35.0 * std::sin(angle), 5.0);
  }
  return solid;
}

TopoDS_Shape squareToCircle()
{
  const TopoDS_Shape outer = loft({ square(20.0, 0.0), circle(axesAt(0, 0, 40.0), 17.0) }, false);
  const TopoDS_Shape inner = BRepPrimAPI_MakeCone(axesAt(0, 0, 0), 9.0, 5.0, 40.0).Shape();
  return BRepAlgoAPI_Cut(outer, inner).Shape();
}

/// Upper and lower side of a section of four digits (camber 3 % at 0.4, 18 % thick), as splines
/// that meet in a sharp edge.
TopoDS_Wire wingSection(double chord, double degrees, double z)
{
  constexpr int Count = 15;
  const double turn = -degrees * Pi / 180.0;
  const auto place = [&](double x, int side) {
    const double thickness = 5.0 * 0.18 *
      (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x -
        0.1036 * x * x * x * x);
    const double camber =
      x < 0.4 ? 0.03 / 0.16 * (0.8 * x - x * x) : 0.03 / 0.36 * (0.2 + 0.8 * x - x * x);
    const double u = chord * x;
    const double v = chord * (camber + side * thickness);
    return gp_Pnt(
      std::cos(turn) * u - std::sin(turn) * v, std::sin(turn) * u + std::cos(turn) * v, z);
  };
  const auto curve = [&](int side) {
    TColgp_Array1OfPnt points(1, Count);
    for (int i = 0; i < Count; ++i)
    {
      const double x = 0.5 - 0.5 * std::cos(Pi * i / (Count - 1));
      points.SetValue(i + 1, place(x, i == 0 || i == Count - 1 ? 0 : side));
    }
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points, 3, 5).Curve()).Edge();
  };
  return BRepBuilderAPI_MakeWire(curve(1), curve(-1));
}

TopoDS_Shape wing()
{
  return loft({ wingSection(100.0, 0.0, 0.0), wingSection(55.0, 15.0, 150.0) }, true);
}

/// An L with walls of 20 and fillets, straight for 6, then with a draft of 3 degrees for 24.
TopoDS_Shape bracket()
{
  BRepBuilderAPI_MakePolygon corner;
  const double corners[6][2] = { { 0, 0 }, { 60, 0 }, { 60, 20 }, { 20, 20 }, { 20, 60 },
    { 0, 60 } };
  for (const auto& place : corners)
  {
    corner.Add(gp_Pnt(place[0], place[1], 0.0));
  }
  corner.Close();
  const TopoDS_Face sharp = BRepBuilderAPI_MakeFace(corner.Wire(), true).Face();
  BRepFilletAPI_MakeFillet2d fillet(sharp);
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(sharp, TopAbs_VERTEX, vertices);
  for (int v = 1; v <= vertices.Extent(); ++v)
  {
    const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices.FindKey(v));
    const gp_Pnt place = BRep_Tool::Pnt(vertex);
    const bool isOuter = place.X() + place.Y() < 1.0;
    const bool isInner = std::abs(place.X() - 20.0) + std::abs(place.Y() - 20.0) < 1.0;
    if (isOuter || isInner)
    {
      fillet.AddFillet(vertex, isOuter ? 8.0 : 6.0);
    }
  }
  const TopoDS_Face low = TopoDS::Face(fillet.Shape());
  const TopoDS_Wire outline = BRepTools::OuterWire(low);
  BRepOffsetAPI_MakeOffset inward(outline, GeomAbs_Intersection);
  inward.Perform(-24.0 * std::tan(3.0 * Pi / 180.0));
  gp_Trsf lift;
  lift.SetTranslation(gp_Vec(0, 0, 6.0));
  gp_Trsf top;
  top.SetTranslation(gp_Vec(0, 0, 30.0));
  const TopoDS_Shape draft =
    loft({ TopoDS::Wire(BRepBuilderAPI_Transform(outline, lift, true).Shape()),
           TopoDS::Wire(BRepBuilderAPI_Transform(inward.Shape(), top, true).Shape()) },
      true);
  const TopoDS_Shape straight = BRepPrimAPI_MakePrism(low, gp_Vec(0, 0, 6.0)).Shape();
  TopoDS_Shape solid = BRepAlgoAPI_Fuse(straight, draft).Shape();
  for (const auto& [x, y] : { std::make_pair(46.0, 10.0), std::make_pair(10.0, 46.0) })
  {
    solid = bored(solid, x, y, 5.0);
  }
  return solid;
}

TopoDS_Shape solidOf(const TopoDS_Shape& shape)
{
  const TopExp_Explorer solid(shape, TopAbs_SOLID);
  if (!solid.More())
  {
    throw std::runtime_error("the kernel made no solid");
  }
  return solid.Current();
}
}

const std::vector<Part>& all()
{
  static const std::vector<Part> parts{
    { "bar", [] { return extruded(circle(axesAt(0, 0, 0), 5.0), 20.0); } },
    { "block_with_holes",
      [] {
        const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-10, -6, 0), 20.0, 12.0, 4.0).Shape();
        return bored(bored(box, -5.0, 0.0, 2.0), 4.0, 1.0, 3.0);
      } },
    { "tube", [] { return bored(extruded(circle(axesAt(0, 0, 0), 8.0), 15.0), 0.0, 0.0, 5.0); } },
    { "frustum", [] { return BRepPrimAPI_MakeCone(axesAt(0, 0, 0), 8.0, 4.0, 10.0).Shape(); } },
    { "funnel",
      [] {
        return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCone(axesAt(0, 0, 0), 8.0, 5.0, 10.0).Shape(),
          BRepPrimAPI_MakeCone(axesAt(0, 0, 0), 5.0, 3.0, 10.0).Shape())
          .Shape();
      } },
    { "elbow", [] { return revolved(discAt(15.0, 4.0), 90.0); } },
    { "pipe_elbow",
      [] {
        return BRepAlgoAPI_Cut(
          revolved(discAt(15.0, 5.0), 120.0), revolved(discAt(15.0, 3.0), 120.0))
          .Shape();
      } },
    { "lobes", [] { return extruded(splineLoop(10.0, 1.5, 3, 0.0), 6.0); } },
    { "lobes_with_hole",
      [] { return bored(extruded(splineLoop(10.0, 1.0, 4, 0.0), 6.0), 1.0, 0.5, 4.0); } },
    { "bent_wire",
      [] {
        return BRepOffsetAPI_MakePipe(
          splinePath(), BRepBuilderAPI_MakeFace(circle(axesAt(0, 0, 0), 2.5), true).Face())
          .Shape();
      } },
    { "bent_square",
      [] {
        return BRepOffsetAPI_MakePipe(
          splinePath(), BRepBuilderAPI_MakeFace(square(2.0, 0.0), true).Face())
          .Shape();
      } },
    { "loft",
      [] {
        return loft({ splineLoop(8.0, 0.0, 2, 0.0), splineLoop(7.0, 0.8, 4, 8.0),
                      splineLoop(9.0, 1.0, 2, 16.0) },
          false);
      } },
    { "loft_of_ellipses",
      [] {
        return loft(
          { ellipse(0.0, 8.0, 5.0), ellipse(8.0, 7.0, 6.5), ellipse(18.0, 9.0, 4.0) }, false);
      } },
    { "twist",
      [] {
        return loft({ square(5.0, 0.0), square(5.0, 12.0, 0.6) }, true);
      } },
    { "barrel", [] { return barrel(); } },
    { "ring_sector",
      [] {
        BRepBuilderAPI_MakePolygon section(
          gp_Pnt(8, 0, 0), gp_Pnt(13, 0, 0), gp_Pnt(13, 4, 0), gp_Pnt(8, 4, 0), true);
        return revolved(BRepBuilderAPI_MakeFace(section.Wire(), true).Face(), 100.0);
      } },
    { "domed_bar", [] { return domed(); } },
    { "wave_top", [] { return waveTop(); } },
    { "offset_sheet", [] { return offsetSheet(); } },
    { "filleted_block", [] { return filletedBlock(); } },
    // The solids of Data/solids.
    { "solid_bracket", [] { return bracket(); } },
    { "solid_elbow",
      [] {
        return BRepAlgoAPI_Cut(
          revolved(discAt(60.0, 20.0), 90.0), revolved(discAt(60.0, 13.0), 90.0))
          .Shape();
      } },
    { "solid_flange", [] { return flange(); } },
    { "solid_loft", [] { return squareToCircle(); } },
    { "solid_wing", [] { return wing(); } },
  };
  return parts;
}

TopoDS_Shape part(const std::string& name)
{
  for (const Part& part : all())
  {
    if (part.name == name)
    {
      try
      {
        return solidOf(part.make());
      }
      catch (const Standard_Failure& failure)
      {
        throw std::runtime_error(name + ": " + failure.GetMessageString());
      }
    }
  }
  throw std::out_of_range(name);
}

void writeSTEP(const TopoDS_Shape& shape, const std::string& fileName, const char* unit)
{
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", unit);
  writer.Transfer(shape, STEPControl_AsIs);
  const bool written = writer.Write(fileName.c_str()) == IFSelect_RetDone;
  Interface_Static::SetCVal("write.step.unit", "MM");
  if (!written)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void writeIGES(const TopoDS_Shape& shape, const std::string& fileName)
{
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(shape);
  writer.ComputeModel();
  if (!writer.Write(fileName.c_str()))
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void writeBREP(const TopoDS_Shape& shape, const std::string& fileName)
{
  if (!BRepTools::Write(shape, fileName.c_str()))
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

TopoDS_Shape readSTEP(const std::string& fileName)
{
  STEPControl_Reader reader;
  if (reader.ReadFile(fileName.c_str()) != IFSelect_RetDone)
  {
    throw std::runtime_error("cannot read " + fileName);
  }
  reader.TransferRoots();
  return reader.OneShape();
}

double volumeOf(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  // The kernel's other integrations are off by up to 16 % where a closed spline is a profile.
  BRepGProp::VolumePropertiesGK(shape, properties, 1e-6);
  return std::abs(properties.Mass());
}

double areaOf(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}
}
