// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Threads that ask now and then whether to go on. Private to the module.
 */
#ifndef HexSweepAsking_h
#define HexSweepAsking_h

#include "Core/Common/ParallelFor.h"

namespace hexsweep
{
/**
 * smpFor() that asks every twentieth of a second, where its pieces allow: Core reports progress
 * between its stages, and a stage of a large mesh may take long.
 *
 * @param progress pipelineProgress() or a part of it. It is called with a number that is none,
 * which leaves the progress as it is.
 * @return throws Aborted when progress returns false.
 */
ParallelFor askingFor(const Progress& progress);
}

#endif
