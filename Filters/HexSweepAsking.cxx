// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepAsking.h"

#include "HexSweepRun.h"

#include <chrono>
#include <limits>
#include <memory>
#include <thread>

namespace hexsweep
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds Patience{ 50 };

/// Asks on the thread that it was made on, if it is time to.
class Question
{
public:
  explicit Question(const Progress& progress)
    : Asked(progress)
  {
  }
  void askIfDue()
  {
    if (std::this_thread::get_id() != this->Caller)
    {
      return;
    }
    const Clock::time_point now = Clock::now();
    if (now - this->Last > Patience)
    {
      this->Last = now;
      reportProgress(this->Asked, std::numeric_limits<double>::quiet_NaN());
    }
  }

private:
  Progress Asked;
  std::thread::id Caller = std::this_thread::get_id();
  Clock::time_point Last = Clock::now();
};
}

ParallelFor askingFor(const Progress& progress)
{
  ParallelFor threads = smpFor();
  if (!progress)
  {
    return threads;
  }
  const auto question = std::make_shared<Question>(progress);
  return [threads, question](Index count, const std::function<void(Index)>& call) {
    question->askIfDue();
    const auto asking = [&](Index i) {
      question->askIfDue();
      call(i);
    };
    if (threads)
    {
      threads(count, asking);
      return;
    }
    for (Index i = 0; i < count; ++i)
    {
      asking(i);
    }
  };
}
}
