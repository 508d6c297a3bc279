// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What Core throws. The messages are written for the user: what, where, how to mend.
 */
#ifndef hexsweep_Errors_h
#define hexsweep_Errors_h

#include "Core/Common/Mesh.h"

#include <stdexcept>

namespace hexsweep
{
/// The input cannot be used: the message says what is wrong, where, and how to mend it.
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A linear system could not be solved to working accuracy.
class SolverFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The progress callback asked to stop.
class Aborted : public std::runtime_error
{
public:
  Aborted()
    : std::runtime_error("aborted")
  {
  }
};

/// The progress of a part of some work, which spans [from, to] of the whole.
inline Progress progressPart(const Progress& progress, double from, double to)
{
  return [=](double fraction) { return !progress || progress(from + (to - from) * fraction); };
}

/// Reports the fraction done; throws Aborted when the callback returns false.
inline void reportProgress(const Progress& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Aborted();
  }
}
}

#endif
