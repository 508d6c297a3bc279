// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexKernels.h"

namespace hexsweep
{
extern const HexKernels HexKernelsBaseline;
#if defined(HEXSWEEP_KERNELS_X86)
extern const HexKernels HexKernelsAvx2;
#endif

int availableHexKernels(const HexKernels* kernels[2])
{
  int count = 0;
  kernels[count++] = &HexKernelsBaseline;
#if defined(HEXSWEEP_KERNELS_X86)
  if (__builtin_cpu_supports("avx2"))
  {
    kernels[count++] = &HexKernelsAvx2;
  }
#endif
  return count;
}

const HexKernels& hexKernels()
{
  const HexKernels* kernels[2];
  return *kernels[availableHexKernels(kernels) - 1];
}
}
