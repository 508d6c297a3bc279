// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Threads to lend to Core, in orders that a single one never has.
 */
#ifndef LentThreads_h
#define LentThreads_h

#include "Core/Common/ParallelFor.h"

#include <thread>
#include <vector>

namespace test
{
/// The largest numbers first, one after the other.
inline void backwards(hexsweep::Index count, const std::function<void(hexsweep::Index)>& call)
{
  for (hexsweep::Index i = count; i-- > 0;)
  {
    call(i);
  }
}

/// Three threads at once. What a call throws ends the program.
inline void sideBySide(hexsweep::Index count, const std::function<void(hexsweep::Index)>& call)
{
  constexpr hexsweep::Index Threads = 3;
  std::vector<std::thread> threads;
  for (hexsweep::Index t = 0; t < Threads; ++t)
  {
    threads.emplace_back([&call, count, t] {
      for (hexsweep::Index i = t; i < count; i += Threads)
      {
        call(i);
      }
    });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}

#endif
