// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_Constants_h
#define hexsweep_Constants_h

namespace hexsweep
{
constexpr double Pi = 3.14159265358979323846;
}

#endif
