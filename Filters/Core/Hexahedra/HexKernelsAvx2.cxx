// SPDX-License-Identifier: BSD-3-Clause
// Compiled for AVX2 (see CMakeLists.txt); empty where the compiler has no such thing.
#if defined(__AVX2__)
#include "Core/Hexahedra/HexKernelsBody.h"

namespace hexsweep
{
extern const HexKernels HexKernelsAvx2;
const HexKernels HexKernelsAvx2 = makeHexKernels("AVX2");
}
#endif
