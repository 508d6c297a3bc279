// SPDX-License-Identifier: BSD-3-Clause
// Compiled for AVX2 and FMA (see CMakeLists.txt); empty where the compiler has no such thing.
#if defined(__AVX2__) && defined(__FMA__)
#include "Core/Solvers/PrismKernelsBody.h"

namespace hexsweep
{
extern const PrismKernels prismKernelsAvx2;
const PrismKernels prismKernelsAvx2 = makeKernels("AVX2");
}
#endif
