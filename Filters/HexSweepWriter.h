// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From Core's arrays to points, cells, arrays and reports of VTK. Private to the module.
 */
#ifndef HexSweepWriter_h
#define HexSweepWriter_h

#include "Core/Common/Mesh.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkFieldData;
class vtkPoints;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// New points, for the caller to take (vtkSmartPointer::Take).
/// @param precision a vtkAlgorithm::DesiredOutputPrecision; default precision means double here.
vtkPoints* newPoints(const PointsRef& points, int precision);

/// Fills the grid with one kind of cell (VTK_TRIANGLE, VTK_QUAD or VTK_HEXAHEDRON).
void setCells(vtkUnstructuredGrid* grid, const FacesRef& cells, int cellType);

/// An array of ids, one a tuple; to field data, point data or cell data.
void addIds(vtkFieldData* data, const char* name, const std::vector<Index>& ids);

/**
 * Hands field data on, but for arrays that the filter may write itself: those of its input are
 * about another mesh.
 */
void passFieldData(vtkDataSet* input, vtkFieldData* output, const std::vector<std::string>& own);

/// Field-data entries of the report (SweepReport*).
void addReport(vtkFieldData* fieldData, const char* name, double value);
void addReport(vtkFieldData* fieldData, const char* name, Index value);
void addReport(vtkFieldData* fieldData, const char* name, const std::string& value);
void addReport(vtkFieldData* fieldData, const char* name, const std::vector<std::string>& values);
void addReport(vtkFieldData* fieldData, const char* name, const std::vector<double>& values);

}

#endif
