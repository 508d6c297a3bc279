// SPDX-License-Identifier: BSD-3-Clause
#include "StackParts.h"

#include "Core/Common/Constants.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace stackparts
{
namespace
{
using hexsweep::Pi;

/// The same numbers with every standard library.
class Dice
{
public:
  explicit Dice(unsigned int seed)
    : Engine(seed)
  {
  }
  double between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine()) / 4294967296.0;
  }
  bool chance(double share) { return this->between(0.0, 1.0) < share; }
  int upTo(int count) { return std::min(count - 1, static_cast<int>(this->between(0.0, count))); }

private:
  std::mt19937 Engine;
};

struct Round
{
  double x;
  double y;
  double radius;
};

TopoDS_Shape cylinder(const Round& round, double low, double high)
{
  return BRepPrimAPI_MakeCylinder(
    gp_Ax2(gp_Pnt(round.x, round.y, low), gp_Dir(0.0, 0.0, 1.0)), round.radius, high - low)
    .Shape();
}

TopoDS_Shape box(double x, double y, double a, double b, double low, double high)
{
  return BRepPrimAPI_MakeBox(gp_Pnt(x - a, y - b, low), gp_Pnt(x + a, y + b, high)).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b)
{
  return BRepAlgoAPI_Fuse(a, b).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b)
{
  return BRepAlgoAPI_Cut(a, b).Shape();
}

/// Without borders between faces of one surface; the one solid.
TopoDS_Shape oneSolid(const TopoDS_Shape& shape)
{
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  TopExp_Explorer solids(unify.Shape(), TopAbs_SOLID);
  return solids.More() ? solids.Current() : unify.Shape();
}

/// Whether the kernel made what it was asked for: with tangent faces it does not always.
bool isOneSolid(const TopoDS_Shape& shape)
{
  if (shape.IsNull())
  {
    return false;
  }
  int solids = 0;
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next())
  {
    ++solids;
  }
  return solids == 1 && BRepCheck_Analyzer(shape).IsValid();
}

struct Base
{
  TopoDS_Shape shape;
  double a; ///< half of what is free for features
  double b;
  double height;
};

Base makeBase(Dice& dice)
{
  Base base{ {}, dice.between(22.0, 40.0), dice.between(18.0, 30.0), dice.between(5.0, 16.0) };
  switch (dice.upTo(4))
  {
    case 0:
      base.shape = box(0.0, 0.0, base.a, base.b, 0.0, base.height);
      break;
    case 1:
    {
      const TopoDS_Shape block = box(0.0, 0.0, base.a, base.b, 0.0, base.height);
      BRepFilletAPI_MakeFillet fillet(block);
      for (TopExp_Explorer edges(block, TopAbs_EDGE); edges.More(); edges.Next())
      {
        // Upright edges, each met once from either side: adding twice does no harm.
        TopExp_Explorer ends(edges.Current(), TopAbs_VERTEX);
        const gp_Pnt first = BRep_Tool::Pnt(TopoDS::Vertex(ends.Current()));
        ends.Next();
        const gp_Pnt last = BRep_Tool::Pnt(TopoDS::Vertex(ends.Current()));
        if (std::abs(first.Z() - last.Z()) > 1.0)
        {
          fillet.Add(0.25 * base.b, TopoDS::Edge(edges.Current()));
        }
      }
      base.shape = fillet.Shape();
      break;
    }
    case 2:
      base.a = base.b = std::max(base.a, base.b);
      base.shape = cylinder({ 0.0, 0.0, base.a }, 0.0, base.height);
      base.a = base.b = 0.7 * base.a;
      break;
    default:
      base.shape = cut(box(0.0, 0.0, base.a, base.b, 0.0, base.height),
        box(base.a, base.b, 0.7 * base.a, 0.8 * base.b, -1.0, base.height + 1.0));
  }
  return base;
}

double nearlyNothing(Dice& dice)
{
  const double choices[] = { 0.0, 0.0, 1e-4, 0.01, -0.01, 0.2 };
  return choices[dice.upTo(6)];
}

/// A circle somewhere, or tangent to one that is there or to the border of the base.
Round place(Dice& dice, const Base& base, const std::vector<Round>& others)
{
  Round round{ dice.between(-0.8, 0.8) * base.a, dice.between(-0.8, 0.8) * base.b,
    dice.between(2.0, 7.0) };
  if (!others.empty() && dice.chance(0.25))
  {
    const Round& other =
      others[static_cast<std::size_t>(dice.upTo(static_cast<int>(others.size())))];
    const double angle = dice.between(0.0, 2.0 * Pi);
    const double outside = other.radius + round.radius;
    const double inside = std::abs(other.radius - round.radius);
    const double apart = (dice.chance(0.5) ? outside : inside) + nearlyNothing(dice);
    round.x = other.x + apart * std::cos(angle);
    round.y = other.y + apart * std::sin(angle);
  }
  else if (dice.chance(0.15))
  {
    round.x = -base.a + round.radius + nearlyNothing(dice);
  }
  return round;
}

TopoDS_Shape boss(Dice& dice, const Base& base, const Round& round)
{
  const double top = base.height + dice.between(2.0, 14.0);
  const double low = 0.5 * base.height;
  if (dice.chance(0.3))
  {
    return box(round.x, round.y, round.radius, dice.between(0.5, 1.5) * round.radius, low, top);
  }
  const TopoDS_Shape straight = cylinder(round, low, top);
  const double kind = dice.between(0.0, 1.0);
  if (kind < 0.15)
  {
    const double tilt = dice.between(0.1, 0.35);
    const double way = dice.between(0.0, 2.0 * Pi);
    const double lift = 1.2 * round.radius * std::tan(tilt);
    const gp_Dir normal(
      std::sin(tilt) * std::cos(way), std::sin(tilt) * std::sin(way), std::cos(tilt));
    const gp_Pnt middle(round.x, round.y, base.height + 1.0 + lift);
    const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Pln(middle, normal), -200.0, 200.0, -200.0, 200.0);
    const TopoDS_Shape slab = BRepPrimAPI_MakePrism(face, gp_Vec(normal) * -100.0).Shape();
    return BRepAlgoAPI_Common(cylinder(round, low, base.height + 40.0), slab).Shape();
  }
  if (kind < 0.25)
  {
    // Large enough for its lower half to stay below the foot.
    const double radius = top - low + 2.0 * round.radius;
    return BRepAlgoAPI_Common(
      straight, BRepPrimAPI_MakeSphere(gp_Pnt(round.x, round.y, top - radius), radius).Shape())
      .Shape();
  }
  return straight;
}

TopoDS_Shape hollow(Dice& dice, const Base& base, const Round& round)
{
  const double far = base.height + 50.0;
  const double depth = dice.between(0.25, 0.75) * base.height;
  switch (dice.upTo(5))
  {
    case 0:
      return cylinder({ round.x, round.y, 0.6 * round.radius }, -1.0, far);
    case 1:
      return fused(cylinder({ round.x, round.y, 0.5 * round.radius }, -1.0, far),
        cylinder(round, base.height - depth, far));
    case 2:
      return box(round.x, round.y, round.radius, dice.between(0.5, 1.5) * round.radius,
        base.height - depth, far);
    case 3:
      return cylinder(round, -1.0, depth);
    default:
      return cylinder(round, base.height - depth, far);
  }
}
}

TopoDS_Shape randomStack(unsigned int seed)
{
  Dice dice(seed);
  const Base base = makeBase(dice);
  TopoDS_Shape shape = base.shape;
  const int features = 2 + dice.upTo(5);
  const int bosses = dice.upTo(features + 1);
  std::vector<Round> rounds;
  for (int f = 0; f < features; ++f)
  {
    const Round round = place(dice, base, rounds);
    rounds.push_back(round);
    const TopoDS_Shape next =
      f < bosses ? fused(shape, boss(dice, base, round)) : cut(shape, hollow(dice, base, round));
    const TopoDS_Shape solid = next.IsNull() ? next : oneSolid(next);
    if (isOneSolid(next) && isOneSolid(solid))
    {
      shape = solid;
    }
  }
  return shape;
}

TopoDS_Shape steppedShaft()
{
  const double radii[] = { 8.0, 12.0, 18.0, 14.0, 10.0 };
  const double lengths[] = { 12.0, 20.0, 8.0, 18.0, 15.0 };
  TopoDS_Shape shape;
  double at = 0.0;
  double keyEnd = 0.0;
  for (int i = 0; i < 5; ++i)
  {
    const TopoDS_Shape step = cylinder({ 0.0, 0.0, radii[i] }, at, at + lengths[i]);
    shape = i == 0 ? step : fused(shape, step);
    at += lengths[i];
    keyEnd = i == 3 ? at : keyEnd;
  }
  shape = cut(shape, cylinder({ 0.0, 0.0, 4.0 }, -1.0, at + 1.0));
  return oneSolid(cut(shape, box(13.0, 0.0, 2.5, 2.0, keyEnd - 11.0, keyEnd)));
}

TopoDS_Shape drilledPlate(int nx, int ny, bool counterbored)
{
  TopoDS_Shape shape =
    BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(10.0 * nx, 10.0 * ny, 8.0)).Shape();
  TopTools_ListOfShape parts;
  TopTools_ListOfShape tools;
  parts.Append(shape);
  for (int i = 0; i < nx; ++i)
  {
    for (int j = 0; j < ny; ++j)
    {
      const double x = 10.0 * i + 5.0;
      const double y = 10.0 * j + 5.0;
      const TopoDS_Shape bore = cylinder({ x, y, 1.5 }, -1.0, 9.0);
      tools.Append(counterbored ? fused(bore, cylinder({ x, y, 3.0 }, 5.0, 9.0)) : bore);
    }
  }
  BRepAlgoAPI_Cut drilled;
  drilled.SetArguments(parts);
  drilled.SetTools(tools);
  drilled.Build();
  return oneSolid(drilled.Shape());
}

TopoDS_Shape steppedBend()
{
  const auto arc = [](double radius, double from, double degrees) {
    const gp_Ax2 across(gp_Pnt(30.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0));
    const TopoDS_Face disk = BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(across, radius)).Edge()).Wire());
    const gp_Ax1 axis(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0));
    gp_Trsf turn;
    turn.SetRotation(axis, from * Pi / 180.0);
    const TopoDS_Shape turned = BRepBuilderAPI_Transform(disk, turn).Shape();
    return BRepPrimAPI_MakeRevol(turned, axis, degrees * Pi / 180.0).Shape();
  };
  TopoDS_Shape shape = fused(arc(6.0, 0.0, 100.0), arc(10.0, 0.0, 12.0));
  shape = fused(shape, arc(8.0, 40.0, 25.0));
  return oneSolid(cut(shape, arc(3.5, 0.0, 100.0)));
}

TopoDS_Shape drafted(double degrees)
{
  const double lean = std::tan(degrees * Pi / 180.0);
  const auto loft = [](double x, double y, double low, double high, double a, double b) {
    BRepOffsetAPI_ThruSections sections(true, true);
    for (const auto& [z, half] : { std::pair{ low, a }, std::pair{ high, b } })
    {
      BRepBuilderAPI_MakePolygon square;
      square.Add(gp_Pnt(x - half, y - half, z));
      square.Add(gp_Pnt(x + half, y - half, z));
      square.Add(gp_Pnt(x + half, y + half, z));
      square.Add(gp_Pnt(x - half, y + half, z));
      square.Close();
      sections.AddWire(square.Wire());
    }
    return sections.Shape();
  };
  const auto cone = [](double x, double y, double low, double high, double a, double b) {
    return BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, y, low), gp_Dir(0.0, 0.0, 1.0)), a, b, high - low)
      .Shape();
  };
  TopoDS_Shape shape = box(0.0, 0.0, 30.0, 20.0, 0.0, 10.0);
  shape = fused(shape, loft(-15.0, 5.0, 10.0, 20.0, 8.0, 8.0 - 10.0 * lean));
  shape = fused(shape, cone(15.0, 8.0, 10.0, 18.0, 7.0, 7.0 - 8.0 * lean));
  shape = cut(shape, loft(15.0, -10.0, 5.0, 10.0, 6.0 - 5.0 * lean, 6.0));
  shape = cut(shape, cone(-5.0, -10.0, 4.0, 10.0, 5.0 - 6.0 * lean, 5.0));
  return oneSolid(shape);
}

TopoDS_Shape crossBored()
{
  const TopoDS_Shape stepped =
    fused(box(0.0, 0.0, 20.0, 15.0, 0.0, 12.0), cylinder({ 0.0, 0.0, 8.0 }, 0.0, 30.0));
  return oneSolid(cut(stepped,
    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-40.0, 0.0, 22.0), gp_Dir(1.0, 0.0, 0.0)), 3.0, 80.0)
      .Shape()));
}

TopoDS_Shape filleted()
{
  const TopoDS_Shape stepped =
    oneSolid(fused(box(0.0, 0.0, 20.0, 15.0, 0.0, 12.0), cylinder({ 0.0, 0.0, 8.0 }, 0.0, 30.0)));
  BRepFilletAPI_MakeFillet fillet(stepped);
  for (TopExp_Explorer edges(stepped, TopAbs_EDGE); edges.More(); edges.Next())
  {
    TopExp_Explorer ends(edges.Current(), TopAbs_VERTEX);
    const gp_Pnt first = BRep_Tool::Pnt(TopoDS::Vertex(ends.Current()));
    if (std::abs(first.Z() - 12.0) < 1e-6 && std::hypot(first.X(), first.Y()) < 9.0)
    {
      fillet.Add(2.0, TopoDS::Edge(edges.Current()));
      break;
    }
  }
  return fillet.Shape();
}
}
