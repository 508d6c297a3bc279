// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepThreadPool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace TestThreadPool
{
using hexsweep::Index;
using hexsweep::ThreadPool;

TEST(ThreadPool, EveryNumberIsCalledOnce)
{
  ThreadPool pool(3);
  for (const Index count : { 0, 1, 2, 3, 1000 })
  {
    for (int loop = 0; loop < 200; ++loop)
    {
      std::vector<int> calls(static_cast<std::size_t>(count), 0);
      pool.run(count, [&](Index i) { ++calls[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), count);
    }
  }
}

TEST(ThreadPool, WorksOnSeveralThreadsOtherThanTheCallers)
{
  ThreadPool pool(3);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  pool.run(30, [&](Index) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard<std::mutex> lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_GT(threads.size(), 1u);
  EXPECT_EQ(threads.count(std::this_thread::get_id()), 0u);
}

TEST(ThreadPool, TheFirstFailureIsThrownAfterAllCalls)
{
  ThreadPool pool(3);
  for (int loop = 0; loop < 50; ++loop)
  {
    std::atomic<int> calls{ 0 };
    try
    {
      pool.run(100, [&](Index i) {
        ++calls;
        if (i % 10 == 7)
        {
          throw std::runtime_error(std::to_string(i));
        }
      });
      FAIL();
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(error.what(), std::string("7"));
    }
    EXPECT_EQ(calls, 100);
  }
  int after = 0;
  pool.run(1, [&](Index) { ++after; });
  EXPECT_EQ(after, 1);
}

TEST(ThreadPool, ACallWithinACallIsRun)
{
  ThreadPool pool(2);
  std::atomic<int> calls{ 0 };
  pool.run(10, [&](Index) { pool.run(10, [&](Index) { ++calls; }); });
  EXPECT_EQ(calls, 100);
}
}
