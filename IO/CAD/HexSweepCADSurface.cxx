// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADSurface.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <ElSLib.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr int MostSteps = 40;
/// Of the model's size: a step that is shorter does not change the place.
constexpr double Converged = 1e-15;
/// Of the model's size: a place that is found to this is found.
constexpr double Enough = 1e-11;

gp_Pnt pointOf(const Eigen::RowVector3d& place)
{
  return { place[0], place[1], place[2] };
}

Eigen::RowVector3d placeOf(const gp_Pnt& point)
{
  return { point.X(), point.Y(), point.Z() };
}

opencascade::handle<Geom_Surface> basisOf(opencascade::handle<Geom_Surface> surface)
{
  while (
    const auto trimmed = opencascade::handle<Geom_RectangularTrimmedSurface>::DownCast(surface))
  {
    surface = trimmed->BasisSurface();
  }
  return surface;
}

opencascade::handle<Geom_Curve> basisOf(opencascade::handle<Geom_Curve> curve)
{
  while (const auto trimmed = opencascade::handle<Geom_TrimmedCurve>::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}
}

//------------------------------------------------------------------------------
CADSurface::CADSurface(const TopoDS_Face& face, double scale)
  : Surface(basisOf(BRep_Tool::Surface(face)))
  , Reversed(face.Orientation() == TopAbs_REVERSED)
  , Scale(scale)
{
  BRepTools::UVBounds(face, this->Bounds[0], this->Bounds[1], this->Bounds[2], this->Bounds[3]);
  TopLoc_Location location;
  const opencascade::handle<Poly_Triangulation>& mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || !mesh->HasUVNodes() || mesh->NbTriangles() == 0)
  {
    return;
  }
  Points corners(3 * mesh->NbTriangles(), 3);
  this->Parameters.resize(corners.rows(), 2);
  for (int t = 1; t <= mesh->NbTriangles(); ++t)
  {
    for (int c = 1; c <= 3; ++c)
    {
      const int node = mesh->Triangle(t).Value(c);
      const Index row = 3 * (Index{ t } - 1) + c - 1;
      corners.row(row) = placeOf(mesh->Node(node).Transformed(location.Transformation()));
      this->Parameters.row(row) << mesh->UVNode(node).X(), mesh->UVNode(node).Y();
    }
  }
  this->Facets.emplace(std::move(corners));
}

//------------------------------------------------------------------------------
std::string CADSurface::type() const
{
  switch (GeomAdaptor_Surface(this->Surface).GetType())
  {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BezierSurface:
    case GeomAbs_BSplineSurface:
      return "spline";
    case GeomAbs_SurfaceOfExtrusion:
      return "extrusion";
    case GeomAbs_SurfaceOfRevolution:
      return "revolution";
    case GeomAbs_OffsetSurface:
      return "offset";
    default:
      return "other";
  }
}

//------------------------------------------------------------------------------
std::optional<CADSurfacePlace> CADSurface::elementary(const gp_Pnt& place) const
{
  double u = 0.0;
  double v = 0.0;
  if (const auto plane = opencascade::handle<Geom_Plane>::DownCast(this->Surface))
  {
    ElSLib::Parameters(plane->Pln(), place, u, v);
  }
  else if (const auto cylinder =
             opencascade::handle<Geom_CylindricalSurface>::DownCast(this->Surface))
  {
    ElSLib::Parameters(cylinder->Cylinder(), place, u, v);
  }
  else if (const auto cone = opencascade::handle<Geom_ConicalSurface>::DownCast(this->Surface))
  {
    ElSLib::Parameters(cone->Cone(), place, u, v);
  }
  else if (const auto sphere = opencascade::handle<Geom_SphericalSurface>::DownCast(this->Surface))
  {
    ElSLib::Parameters(sphere->Sphere(), place, u, v);
  }
  else if (const auto torus = opencascade::handle<Geom_ToroidalSurface>::DownCast(this->Surface))
  {
    // A torus that crosses itself is left to the search that begins at the facets.
    if (torus->MajorRadius() <= torus->MinorRadius())
    {
      return std::nullopt;
    }
    ElSLib::Parameters(torus->Torus(), place, u, v);
  }
  else
  {
    return std::nullopt;
  }
  return CADSurfacePlace{ placeOf(this->Surface->Value(u, v)), u, v };
}

//------------------------------------------------------------------------------
std::optional<CADSurfacePlace> CADSurface::newton(const gp_Pnt& place, double u, double v) const
{
  double least[2] = { this->Bounds[0], this->Bounds[2] };
  double greatest[2] = { this->Bounds[1], this->Bounds[3] };
  // A little beyond the face, as far as the surface goes: its nodes are near, not on it.
  double low[2];
  double high[2];
  this->Surface->Bounds(low[0], high[0], low[1], high[1]);
  const bool periodic[2] = { this->Surface->IsUPeriodic(), this->Surface->IsVPeriodic() };
  for (int i = 0; i < 2; ++i)
  {
    constexpr double Beyond = 0.05;
    const double more = Beyond * (greatest[i] - least[i]);
    least[i] = periodic[i] ? least[i] - more : std::max(low[i], least[i] - more);
    greatest[i] = periodic[i] ? greatest[i] + more : std::min(high[i], greatest[i] + more);
  }
  gp_Pnt at;
  gp_Vec du;
  gp_Vec dv;
  gp_Vec duu;
  gp_Vec dvv;
  gp_Vec duv;
  double distance = -1.0;
  for (int step = 0; step < MostSteps; ++step)
  {
    this->Surface->D2(u, v, at, du, dv, duu, dvv, duv);
    const gp_Vec off(place, at);
    distance = off.SquareMagnitude();
    const double gu = off.Dot(du);
    const double gv = off.Dot(dv);
    double a = du.Dot(du) + off.Dot(duu);
    double b = du.Dot(dv) + off.Dot(duv);
    double c = dv.Dot(dv) + off.Dot(dvv);
    if (!(a > 0.0 && a * c - b * b > 1e-12 * a * c))
    {
      // Far from the surface, or at a pole: the step of Gauss and Newton goes down all the same.
      a = du.Dot(du);
      b = du.Dot(dv);
      c = dv.Dot(dv);
    }
    const double determinant = a * c - b * b;
    if (!(determinant > 0.0))
    {
      return std::nullopt;
    }
    double stepU = -(c * gu - b * gv) / determinant;
    double stepV = -(a * gv - b * gu) / determinant;
    bool moved = false;
    for (int halving = 0; halving < 30; ++halving)
    {
      const double nextU = std::clamp(u + stepU, least[0], greatest[0]);
      const double nextV = std::clamp(v + stepV, least[1], greatest[1]);
      const double next = gp_Vec(place, this->Surface->Value(nextU, nextV)).SquareMagnitude();
      if (next <= distance)
      {
        moved = std::abs(nextU - u) * du.Magnitude() + std::abs(nextV - v) * dv.Magnitude() >
          Converged * this->Scale;
        u = nextU;
        v = nextV;
        distance = next;
        break;
      }
      stepU *= 0.5;
      stepV *= 0.5;
    }
    if (!moved)
    {
      break;
    }
  }
  this->Surface->D1(u, v, at, du, dv);
  const gp_Vec off(place, at);
  const auto slope = [&](const gp_Vec& d, double x, double lowest, double highest) {
    const double along = off.Dot(d) / std::max(d.Magnitude(), 1e-300);
    const bool atEnd = (x <= lowest && along > 0.0) || (x >= highest && along < 0.0);
    return atEnd ? 0.0 : std::abs(along);
  };
  // The nearest point is where nothing is left of the way along the surface.
  if (slope(du, u, least[0], greatest[0]) > Enough * this->Scale ||
    slope(dv, v, least[1], greatest[1]) > Enough * this->Scale)
  {
    return std::nullopt;
  }
  return CADSurfacePlace{ placeOf(at), u, v };
}

//------------------------------------------------------------------------------
std::optional<CADSurfacePlace> CADSurface::searched(const gp_Pnt& place) const
{
  try
  {
    GeomAPI_ProjectPointOnSurf search(
      place, this->Surface, this->Bounds[0], this->Bounds[1], this->Bounds[2], this->Bounds[3]);
    if (search.NbPoints() == 0)
    {
      return std::nullopt;
    }
    double u = 0.0;
    double v = 0.0;
    search.LowerDistanceParameters(u, v);
    if (std::optional<CADSurfacePlace> better = this->newton(place, u, v))
    {
      return better;
    }
    return CADSurfacePlace{ placeOf(search.NearestPoint()), u, v };
  }
  catch (const Standard_Failure&)
  {
    return std::nullopt;
  }
}

//------------------------------------------------------------------------------
std::optional<CADSurfacePlace> CADSurface::closest(const Eigen::RowVector3d& place) const
{
  const gp_Pnt point = pointOf(place);
  if (std::optional<CADSurfacePlace> found = this->elementary(point))
  {
    return found;
  }
  if (!this->Facets)
  {
    return this->searched(point);
  }
  const TrianglePoint nearest = this->Facets->closest(place);
  const Index row = 3 * nearest.triangle;
  const Eigen::RowVector2d start = nearest.coordinates * this->Parameters.middleRows<3>(row);
  std::optional<CADSurfacePlace> found = this->newton(point, start[0], start[1]);
  return found ? found : this->searched(point);
}

//------------------------------------------------------------------------------
std::optional<Eigen::RowVector3d> CADSurface::normal(const CADSurfacePlace& place) const
{
  gp_Pnt at;
  gp_Vec du;
  gp_Vec dv;
  this->Surface->D1(place.u, place.v, at, du, dv);
  gp_Vec normal = du.Crossed(dv);
  const double size = normal.Magnitude();
  if (!(size > 1e-12 * du.Magnitude() * dv.Magnitude()))
  {
    return std::nullopt;
  }
  normal *= (this->Reversed ? -1.0 : 1.0) / size;
  return Eigen::RowVector3d(normal.X(), normal.Y(), normal.Z());
}

//------------------------------------------------------------------------------
CADCurve::CADCurve(const TopoDS_Edge& edge, double scale)
  : Scale(scale)
{
  const TopoDS_Vertex first = TopExp::FirstVertex(edge);
  const TopoDS_Vertex last = TopExp::LastVertex(edge);
  this->Closed = first.IsSame(last);
  if (!this->Closed && !first.IsNull() && !last.IsNull())
  {
    this->Ends.resize(2, 3);
    this->Ends << placeOf(BRep_Tool::Pnt(first)), placeOf(BRep_Tool::Pnt(last));
  }
  this->Curve = BRep_Tool::Curve(edge, this->From, this->To);
  if (this->Curve.IsNull())
  {
    return;
  }
  if (this->Closed)
  {
    gp_Pnt at;
    gp_Vec begin;
    gp_Vec end;
    this->Curve->D1(this->From, at, begin);
    this->Curve->D1(this->To, at, end);
    constexpr double Smooth = 0.01; // radians
    if (begin.Magnitude() > 0.0 && end.Magnitude() > 0.0 && begin.Angle(end) > Smooth)
    {
      this->Ends.resize(1, 3);
      this->Ends << placeOf(BRep_Tool::Pnt(first));
    }
  }
  constexpr double Angle = 0.1;
  constexpr double Deflection = 1e-3;
  const GCPnts_TangentialDeflection samples(
    GeomAdaptor_Curve(this->Curve, this->From, this->To), Angle, Deflection * scale, 3);
  this->Samples.resize(samples.NbPoints(), 3);
  for (int i = 1; i <= samples.NbPoints(); ++i)
  {
    this->SampleParameters.push_back(samples.Parameter(i));
    this->Samples.row(i - 1) = placeOf(samples.Value(i));
  }
  this->Curve = basisOf(this->Curve);
}

//------------------------------------------------------------------------------
double CADCurve::nearestSample(const gp_Pnt& place) const
{
  const Eigen::RowVector3d p = placeOf(place);
  double best = -1.0;
  double parameter = this->From;
  for (Index i = 0; i + 1 < this->Samples.rows(); ++i)
  {
    const Eigen::RowVector3d along = this->Samples.row(i + 1) - this->Samples.row(i);
    const double length = along.squaredNorm();
    const double t =
      length > 0.0 ? std::clamp((p - this->Samples.row(i)).dot(along) / length, 0.0, 1.0) : 0.0;
    const double distance = (this->Samples.row(i) + t * along - p).squaredNorm();
    if (best < 0.0 || distance < best)
    {
      best = distance;
      const auto k = static_cast<std::size_t>(i);
      parameter = (1.0 - t) * this->SampleParameters[k] + t * this->SampleParameters[k + 1];
    }
  }
  return parameter;
}

//------------------------------------------------------------------------------
std::optional<Eigen::RowVector3d> CADCurve::closest(const Eigen::RowVector3d& place) const
{
  if (this->Curve.IsNull() || this->Samples.rows() < 2)
  {
    return std::nullopt;
  }
  const gp_Pnt point = pointOf(place);
  double t = this->nearestSample(point);
  const double least = this->From;
  const double greatest = this->To;
  gp_Pnt at;
  gp_Vec d;
  gp_Vec dd;
  for (int step = 0; step < MostSteps; ++step)
  {
    this->Curve->D2(t, at, d, dd);
    const gp_Vec off(point, at);
    const double slope = off.Dot(d);
    double bend = d.Dot(d) + off.Dot(dd);
    bend = bend > 0.1 * d.Dot(d) ? bend : d.Dot(d);
    if (!(bend > 0.0))
    {
      break;
    }
    const double distance = off.SquareMagnitude();
    double change = -slope / bend;
    bool moved = false;
    for (int halving = 0; halving < 30; ++halving)
    {
      // A closed curve goes on over its own begin.
      const double next = this->Closed && this->Curve->IsPeriodic()
        ? t + change
        : std::clamp(t + change, least, greatest);
      if (gp_Vec(point, this->Curve->Value(next)).SquareMagnitude() <= distance)
      {
        moved = std::abs(next - t) * d.Magnitude() > Converged * this->Scale;
        t = next;
        break;
      }
      change *= 0.5;
    }
    if (!moved)
    {
      break;
    }
  }
  return placeOf(this->Curve->Value(t));
}
}
