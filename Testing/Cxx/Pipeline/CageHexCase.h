// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Analytic sweeps as inputs of vtkCageHexInterior, and the filter with its messages.
 */
#ifndef CageHexCase_h
#define CageHexCase_h

#include "CapGrids.h"
#include "Support/SweepMeshes.h"

#include <vtkCageHexInterior.h>

namespace test
{
vtkSmartPointer<vtkPoints> pointsOf(const Points& points);

/// Quads.
template <typename Data = vtkUnstructuredGrid>
vtkSmartPointer<Data> gridOf(const Points& points, const Quads& quads)
{
  auto grid = vtkSmartPointer<Data>::New();
  grid->SetPoints(pointsOf(points));
  grid->Allocate(quads.rows());
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const vtkIdType ids[4] = { quads(q, 0), quads(q, 1), quads(q, 2), quads(q, 3) };
    grid->InsertNextCell(VTK_QUAD, 4, ids);
  }
  return grid;
}

/// The three inputs; a test changes them before run().
struct CageHexCase
{
  vtkSmartPointer<vtkPointSet> source;
  vtkSmartPointer<vtkPointSet> target;
  vtkSmartPointer<vtkPointSet> linking;
  vtkNew<vtkCageHexInterior> filter;
  Events events;

  explicit CageHexCase(const Sweep& sweep);

  vtkUnstructuredGrid* run();

  /// A number of the report, by its name without the prefix.
  double report(const std::string& name);

  /// One error that contains the text, nothing in the output.
  void expectError(const std::string& part);
};

/// An affine one of five layers, with a hole.
Sweep someSweep();

vtkIdType countInverted(vtkUnstructuredGrid* grid);
}

#endif
