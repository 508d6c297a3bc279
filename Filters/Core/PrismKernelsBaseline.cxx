// SPDX-License-Identifier: BSD-3-Clause
#include "PrismKernelsBody.h"

namespace hexsweep
{
extern const PrismKernels prismKernelsBaseline;
const PrismKernels prismKernelsBaseline = makeKernels("baseline");
}
