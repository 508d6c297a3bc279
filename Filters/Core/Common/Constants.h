// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_Constants_h
#define hexsweep_Constants_h

#include <limits>

namespace hexsweep
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

#endif
