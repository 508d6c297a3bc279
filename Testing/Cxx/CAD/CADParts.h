// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts made with the CAD kernel, and files of them.
 */
#ifndef CADParts_h
#define CADParts_h

#include <TopoDS_Shape.hxx>

#include <functional>
#include <string>
#include <vector>

namespace cadparts
{
struct Part
{
  const char* name;
  std::function<TopoDS_Shape()> make; ///< a solid that can be swept, some millimetres large
};

/// Twenty parts with plane, cylindrical, conical, spherical, toroidal, spline, extruded, revolved
/// and offset faces, and five like those of Data/solids ("solid_...").
const std::vector<Part>& all();

/// One of them. @throw std::out_of_range.
TopoDS_Shape part(const std::string& name);

/// Writes a shape. @param unit "MM", "INCH", ...: that of the shape.
void writeSTEP(const TopoDS_Shape& shape, const std::string& fileName, const char* unit = "MM");
void writeIGES(const TopoDS_Shape& shape, const std::string& fileName);
void writeBREP(const TopoDS_Shape& shape, const std::string& fileName);

/// Read by the kernel's plain reader, in millimetres.
TopoDS_Shape readSTEP(const std::string& fileName);

/// By the kernel's integration, to a millionth.
double volumeOf(const TopoDS_Shape& shape);
double areaOf(const TopoDS_Shape& shape);
}

#endif
