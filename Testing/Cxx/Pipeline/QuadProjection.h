// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkSweepQuadProjector with its messages, and what is known of its results.
 */
#ifndef QuadProjection_h
#define QuadProjection_h

#include "CapGrids.h"

#include <vtkSweepQuadProjector.h>

namespace test
{
struct QuadProjection
{
  vtkNew<vtkSweepQuadProjector> filter;
  Events events;

  /// Inputs that are nullptr are not connected.
  explicit QuadProjection(const SweepGrids& sweep);

  /// The projection alone: untangling and polishing blow rounding up.
  QuadProjection& raw();

  /// The quads; no error is expected.
  vtkUnstructuredGrid* run();
};

/// The end of each linking column, by the place of its beginning: walked over edges here.
std::map<std::array<double, 3>, std::array<double, 3>> columnEnds(const SweepGrids& sweep);

/// Both surfaces with the disk maps that vtkHarmonicDiskMap makes of them.
SweepGrids withMaps(const SweepGrids& sweep);
}

#endif
