// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Nearest points of one face and one edge of a CAD model. Private to the module.
 */
#ifndef HexSweepCADSurface_h
#define HexSweepCADSurface_h

#include "Core/Geometry/TriangleSearch.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
/// A place on a surface.
struct CADSurfacePlace
{
  Eigen::RowVector3d point;
  double u;
  double v;
};

/**
 * The surface of a face. Elementary surfaces answer in closed form; on others Newton's method runs
 * from the parameters of the nearest triangle, and where it fails the kernel's own search.
 * Does not change; any thread may ask.
 */
class CADSurface
{
public:
  /// @param face with triangles, see divideShape(). @param scale of the model, a length.
  CADSurface(const TopoDS_Face& face, double scale);

  std::optional<CADSurfacePlace> closest(const Eigen::RowVector3d& place) const;

  std::string type() const; ///< see ModelGeometry::surfaceType()

  /// Outward for the solid that the face was taken from.
  std::optional<Eigen::RowVector3d> normal(const CADSurfacePlace& place) const;

private:
  std::optional<CADSurfacePlace> elementary(const gp_Pnt& place) const;
  std::optional<CADSurfacePlace> newton(const gp_Pnt& place, double u, double v) const;
  std::optional<CADSurfacePlace> searched(const gp_Pnt& place) const;

  opencascade::handle<Geom_Surface> Surface;
  bool Reversed;
  double Scale;
  double Bounds[4]; ///< least and greatest u, least and greatest v of the face
  std::optional<TriangleSearch> Facets;
  PlanePoints Parameters; ///< three rows a facet
};

/// The curve of an edge, between its ends. As CADSurface.
class CADCurve
{
public:
  explicit CADCurve(const TopoDS_Edge& edge, double scale);

  std::optional<Eigen::RowVector3d> closest(const Eigen::RowVector3d& place) const;

  /// Two rows, or none where the curve is closed and has no corner there.
  const Points& ends() const { return this->Ends; }

private:
  double nearestSample(const gp_Pnt& place) const;

  opencascade::handle<Geom_Curve> Curve;
  double From = 0.0;
  double To = 0.0;
  double Scale;
  bool Closed = false;
  Points Ends{ 0, 3 };
  std::vector<double> SampleParameters;
  Points Samples;
};
}

#endif
