// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The curves of a source cap that a border of the target cap became.
 */
#ifndef hexsweep_CurveImages_h
#define hexsweep_CurveImages_h

#include "Core/Assemblies/AssemblyComplex.h"
#include "Core/CapQuads/CapCurves.h"

#include <optional>

namespace hexsweep
{
/// Rows of curves between faces of a cap, whatever else meets there.
std::vector<Index> innerCurves(const AssemblyComplex& complex, const std::vector<Index>& cap);

/// A place on a chain.
struct ChainPlace
{
  Index edge = 0;      ///< from point `edge` to the next one
  double along = 0.0;  ///< fraction of the edge
  double length = 0.0; ///< from the first point
  double distance = 0.0;
};

ChainPlace nearestOnChain(const ArcLengthChain& chain, const Eigen::RowVector3d& place);

/// Finds images of borders among the curves between a cap's faces.
class CurveImages
{
public:
  /// @param tolerance length: no image is farther from its curve.
  CurveImages(const AssemblyComplex& complex, const std::vector<Index>& sources, double tolerance);

  /**
   * @param image  of a border, on or near the source cap.
   * @param closed whether it ends with its first point.
   * @return the curves one after the other in its direction, of a closed one from any of them on;
   *         empty where there are none.
   */
  std::vector<CurveUse> find(const Points& image, bool closed) const;

  /// Whether a point of the complex lies at a place.
  bool isAt(Index point, const Eigen::RowVector3d& place) const
  {
    return (this->Complex.points.row(point) - place).norm() <= this->Tolerance;
  }

private:
  struct Curve
  {
    Index row;
    ArcLengthChain chain;
  };
  struct Part
  {
    double place; ///< of its middle on the image
    CurveUse use;
  };
  std::optional<Part> partOf(const Curve& curve, const ArcLengthChain& image, bool closed) const;

  const AssemblyComplex& Complex;
  double Tolerance;
  std::vector<Curve> Inner;
};
}

#endif
