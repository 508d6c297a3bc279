// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How a filter runs: its ports, its progress and threads, its one error. Private to the
 * module.
 */
#ifndef HexSweepRun_h
#define HexSweepRun_h

#include "Core/Common/Errors.h"
#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;
class vtkInformation;
class vtkInformationVector;

namespace hexsweep
{
/// Declares that an input port takes unstructured grids and polygonal data. The port is checked by
/// the filter itself, whose message says more than the executive's: it may have no input, too.
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

/// The same of data sets that have been read from their ports, each with its name.
bool isIdleRank(
  vtkInformationVector* outputs, const std::vector<std::pair<vtkDataSet*, std::string>>& data);

/// The cell array that was chosen by SetInputArrayToProcess(0, ...); empty where none was, or where
/// ParaView's entry for none was.
std::string chosenArray(vtkAlgorithm* algorithm);

/// Maps Core's progress in [0, 1] to the filter's progress in [from, to], and asks for aborts.
Progress pipelineProgress(vtkAlgorithm* self, double from = 0.0, double to = 1.0);

/// As many threads as vtkSMPTools has; empty where there is one only.
ParallelFor smpFor();

/**
 * Runs the body of a RequestData after checkInputs(): what Core throws becomes one error on `self`
 * (see reportFailure()) and empty outputs; an abort gives empty outputs silently.
 *
 * @return what RequestData is to return: 1, or 0 after an error.
 */
int runFilter(vtkAlgorithm* self, vtkInformationVector* outputs, const std::function<void()>& body);
}

#endif
