// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/PrismKernels.h"

namespace hexsweep
{
extern const PrismKernels prismKernelsBaseline;
#if defined(HEXSWEEP_KERNELS_X86)
extern const PrismKernels prismKernelsAvx2;
extern const PrismKernels prismKernelsAvx512;
#endif

int availablePrismKernels(const PrismKernels* kernels[3])
{
  int count = 0;
  kernels[count++] = &prismKernelsBaseline;
#if defined(HEXSWEEP_KERNELS_X86)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    kernels[count++] = &prismKernelsAvx2;
    if (__builtin_cpu_supports("avx512f"))
    {
      kernels[count++] = &prismKernelsAvx512;
    }
  }
#endif
  return count;
}

const PrismKernels& prismKernels()
{
  const PrismKernels* kernels[3];
  return *kernels[availablePrismKernels(kernels) - 1];
}
}
