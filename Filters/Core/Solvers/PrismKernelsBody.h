// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The bodies of PrismKernels.h; one file for each instruction set includes them.
 *
 * Everything here and in what is included is in an unnamed namespace, so that no two files share a
 * function.
 */
#ifndef hexsweep_PrismKernelsBody_h
#define hexsweep_PrismKernelsBody_h

#include "Core/Solvers/PrismKernelsIteration.h"
#include "Core/Solvers/PrismKernelsProduct.h"

namespace hexsweep
{
namespace
{
constexpr PrismKernels makeKernels(const char* name)
{
  return { name, { factorize<float>, start<float>, backward<float>, forward<float>, update<float> },
    residual, multiply };
}
}
}

#endif
