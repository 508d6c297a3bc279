// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The solids of a CAD file with their faces and edges numbered. Private to the module.
 */
#ifndef HexSweepCADModel_h
#define HexSweepCADModel_h

#include "Core/Common/Mesh.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
using CADColor = std::array<double, 3>; ///< red, green, blue in [0, 1]

/// A shape of the file before anything is numbered.
struct CADSolid
{
  TopoDS_Shape shape; ///< a TopoDS_Solid, where it is in the assembly
  std::string name;
  std::vector<std::size_t> products; ///< rows of CADModel::products, from the root on
  std::optional<CADColor> color;
};

/// An assembly, or a part, of the product structure.
struct CADProduct
{
  std::string name;
  std::ptrdiff_t parent = -1; ///< row, -1: it is at the top
};

struct CADFaceLabel
{
  TopoDS_Shape face;
  std::string name; ///< may be empty
  std::optional<CADColor> color;
};

struct CADModel
{
  std::vector<CADProduct> products;
  std::vector<CADSolid> solids;
  std::vector<CADFaceLabel> labels; ///< of faces that the file names or colours
  std::vector<TopoDS_Shape> sheets; ///< shells and faces that belong to no solid
  /// Face id i and edge id i are the ones numbered i here, from 1 on. Faces and edges that solids
  /// share have one number.
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  std::string lengthUnit;              ///< of the coordinates, "millimetre"
  double size = 0.0;                   ///< diagonal of the box around all solids
  std::vector<std::string> leftOut;    ///< what the file has besides solids, in words
  std::vector<std::string> complaints; ///< what to tell the user
};

/// Numbers faces and edges of all solids, in the order of the solids.
void numberFacesAndEdges(CADModel& model);

/// By face id - 1: the name that the file gives a face, or nothing.
std::vector<std::string> faceNames(const CADModel& model);

/// By face id - 1: the colour of a face, else that of its solid, else nothing.
std::vector<std::optional<CADColor>> faceColors(const CADModel& model);
}

#endif
