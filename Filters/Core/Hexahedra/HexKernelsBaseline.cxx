// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexKernelsBody.h"

namespace hexsweep
{
extern const HexKernels HexKernelsBaseline;
const HexKernels HexKernelsBaseline = makeHexKernels("baseline");
}
