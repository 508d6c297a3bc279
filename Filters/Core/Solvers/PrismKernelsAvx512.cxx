// SPDX-License-Identifier: BSD-3-Clause
// Compiled for AVX-512 (see CMakeLists.txt); empty where the compiler has no such thing.
#if defined(__AVX512F__)
#include "Core/Solvers/PrismKernelsBody.h"

namespace hexsweep
{
extern const PrismKernels prismKernelsAvx512;
const PrismKernels prismKernelsAvx512 = makeKernels("AVX-512");
}
#endif
