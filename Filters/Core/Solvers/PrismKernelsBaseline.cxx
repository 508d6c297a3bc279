// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/PrismKernelsBody.h"

namespace hexsweep
{
extern const PrismKernels prismKernelsBaseline;
const PrismKernels prismKernelsBaseline = makeKernels("baseline");
}
