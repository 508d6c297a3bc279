// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepThreadPool.h"

#include <utility>

namespace hexsweep
{
ThreadPool::ThreadPool(int threads)
{
  for (int t = 0; t < threads; ++t)
  {
    this->Threads.emplace_back([this] { this->work(); });
  }
}

ThreadPool::~ThreadPool()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOver = true;
  }
  this->Begun.notify_all();
  for (std::thread& thread : this->Threads)
  {
    thread.join();
  }
}

void ThreadPool::run(Index count, const std::function<void(Index)>& call)
{
  if (count <= 1 || this->IsBusy.exchange(true))
  {
    for (Index i = 0; i < count; ++i)
    {
      call(i);
    }
    return;
  }
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Call = &call;
  this->Count = count;
  this->Next = 0;
  this->Working = this->Threads.size();
  ++this->Loop;
  this->Begun.notify_all();
  this->Ended.wait(lock, [this] { return this->Working == 0; });
  const std::exception_ptr failure = std::exchange(this->Failure, nullptr);
  lock.unlock();
  this->IsBusy = false;
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

void ThreadPool::work()
{
  Index seen = 0;
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (true)
  {
    this->Begun.wait(lock, [&] { return this->IsOver || this->Loop != seen; });
    if (this->IsOver)
    {
      return;
    }
    seen = this->Loop;
    lock.unlock();
    this->takeAll();
    lock.lock();
    if (--this->Working == 0)
    {
      this->Ended.notify_one();
    }
  }
}

void ThreadPool::takeAll()
{
  for (Index i = this->Next++; i < this->Count; i = this->Next++)
  {
    try
    {
      (*this->Call)(i);
    }
    catch (...)
    {
      // One that leaves a thread would end the process.
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Failure || i < this->FailedCall)
      {
        this->Failure = std::current_exception();
        this->FailedCall = i;
      }
    }
  }
}
}
