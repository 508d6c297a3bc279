// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The one place where VTK data become Core arrays and back. Private to the module.
 */
#ifndef HexSweepBridge_h
#define HexSweepBridge_h

#include "Core/Common/Errors.h"
#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
class vtkInformation;
class vtkInformationVector;
class vtkPoints;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// A surface mesh read from a data set. Points are all points of the input, used or not, so that
/// ids are the input's own.
struct SurfaceInput
{
  Points points;
  /// m x 3 or m x 4.
  Faces faces;
  /// Input cell that each face came from.
  std::vector<Index> cellIds;
  /// Vertex and line cells, which are no part of a surface.
  Index ignoredCells = 0;
};

/// Declares that an input port takes unstructured grids and polygonal data. The port is checked by
/// the filter itself, whose message says more than the executive's.
void acceptSurfaces(vtkInformation* portInformation);

/// The data set on a port, or nullptr where nothing is connected (or the object is no point set).
vtkDataSet* inputDataSet(vtkInformationVector** inputs, int port);

/**
 * Whether this is a rank > 0 with nothing on one of its connected ports, as a serial reader leaves
 * it: there is nothing to do and nothing to complain about.
 *
 * @param portNames from port 0 on.
 * @throw InvalidInput when a rank > 0 holds cells: a cap that is split over ranks is not swept.
 */
bool isIdleRank(vtkInformationVector* outputs, vtkInformationVector** inputs,
  const std::vector<std::string>& portNames);

/**
 * Reads triangles; triangle strips, quads and polygons are triangulated.
 *
 * @param data nullptr counts as missing.
 * @param what name for the error text, e.g. "target surface".
 * @throw InvalidInput missing, empty, volume cells, coordinates that are not finite.
 */
SurfaceInput readTriangles(vtkDataSet* data, const std::string& what);

/// Triangles must have angles before a harmonic map is made of them.
/// @throw InvalidInput naming the first cell without area. @param what as readTriangles().
void checkAreas(const SurfaceInput& surface, const std::string& what);

/// Reads quads; any other surface cell is an error. @throw InvalidInput as readTriangles().
SurfaceInput readQuads(vtkDataSet* data, const std::string& what);

/// The quads of an optional input, where one is connected. @throw InvalidInput as readQuads().
std::optional<QuadMesh> readOptionalQuads(vtkDataSet* data, const std::string& what);

/// The cell array that was chosen by SetInputArrayToProcess(0, ...); empty where none was, or where
/// ParaView's entry for none was.
std::string chosenArray(vtkAlgorithm* algorithm);

/// All points of the data set. @throw InvalidInput never: coordinates are not looked at.
Points readPoints(vtkDataSet* data);

/// New points, for the caller to take (vtkSmartPointer::Take).
/// @param precision a vtkAlgorithm::DesiredOutputPrecision; default precision means double here.
vtkPoints* newPoints(const PointsRef& points, int precision);

/// Fills the grid with one kind of cell (VTK_TRIANGLE, VTK_QUAD or VTK_HEXAHEDRON).
void setCells(vtkUnstructuredGrid* grid, const FacesRef& cells, int cellType);

/// An array of ids, one a tuple; to field data, point data or cell data.
void addIds(vtkFieldData* data, const char* name, const std::vector<Index>& ids);

/// Field-data entries of the report (SweepReport*).
void addReport(vtkFieldData* fieldData, const char* name, double value);
void addReport(vtkFieldData* fieldData, const char* name, Index value);
void addReport(vtkFieldData* fieldData, const char* name, const std::string& value);
void addReport(vtkFieldData* fieldData, const char* name, const std::vector<std::string>& values);
void addReport(vtkFieldData* fieldData, const char* name, const std::vector<double>& values);

/// Maps Core's progress in [0, 1] to the filter's progress in [from, to], and asks for aborts.
Progress pipelineProgress(vtkAlgorithm* self, double from = 0.0, double to = 1.0);

/// The threads of vtkSMPTools; empty where there is one only.
ParallelFor smpFor();

/**
 * Runs the body of a RequestData: what Core throws becomes one error on `self` (see
 * reportFailure()) and empty outputs; an abort gives empty outputs silently.
 *
 * @return what RequestData is to return: 1, or 0 after an error.
 */
int runFilter(vtkAlgorithm* self, vtkInformationVector* outputs, const std::function<void()>& body);
}

#endif
