// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How a filter fails: with one message. Private to the module.
 */
#ifndef HexSweepFailure_h
#define HexSweepFailure_h

#include <string>

class vtkAlgorithm;

namespace hexsweep
{
/**
 * Raises the filter's one vtkErrorMacro and sets its error code (vtkErrorCode::UserError). The
 * error is left out where an input is empty since a filter before this one failed: that one's error
 * says why.
 *
 * The filter is to return 0 next, so that the executive stops the pipeline. What the executive
 * then says of its own, that the request failed, with a print of the request, goes only to those
 * who observe the executive.
 */
void reportFailure(vtkAlgorithm* self, const std::string& problem);

/// Takes back the error code of an earlier run, without a change of the modification time.
void clearFailure(vtkAlgorithm* self);
}

#endif
