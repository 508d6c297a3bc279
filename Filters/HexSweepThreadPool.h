// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Threads that wait for work. Private to the module.
 */
#ifndef HexSweepThreadPool_h
#define HexSweepThreadPool_h

#include "Core/Common/Mesh.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace hexsweep
{
/**
 * The STDThread backend of vtkSMPTools makes new threads for every loop: a tenth of a millisecond,
 * which is as long as many of the loops over the nodes of a cap take. These stay.
 */
class ThreadPool
{
public:
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  void operator=(const ThreadPool&) = delete;

  /**
   * See ParallelFor; the caller waits. A single call, and those within a call, run on the thread
   * that asks for them.
   *
   * @throw what a call has thrown, of several the one with the smallest number.
   */
  void run(Index count, const std::function<void(Index)>& call);

private:
  void work();
  void takeAll();

  std::vector<std::thread> Threads;
  std::mutex Mutex;
  std::condition_variable Begun;
  std::condition_variable Ended;
  bool IsOver = false;
  Index Loop = 0;          // how many there were
  std::size_t Working = 0; // threads that have not ended the loop
  std::atomic<bool> IsBusy{ false };

  const std::function<void(Index)>* Call = nullptr;
  Index Count = 0;
  std::atomic<Index> Next{ 0 };
  Index FailedCall = 0;
  std::exception_ptr Failure;
};
}

#endif
