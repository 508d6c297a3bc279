// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Seconds of the stages of some work, for reports.
 */
#ifndef hexsweep_Stopwatch_h
#define hexsweep_Stopwatch_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace hexsweep
{
struct Stage
{
  std::string name;
  double seconds;
};

class Stopwatch
{
public:
  /// Wall time since it was made or started again.
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

  void restart() { this->Start = std::chrono::steady_clock::now(); }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// Stages one after the other, each from the end of the last.
class StageClock
{
public:
  void finish(std::string stage)
  {
    this->Stages.push_back({ std::move(stage), this->Watch.seconds() });
    this->Watch.restart();
  }

  /// Work that was timed where it was done.
  void finish(const std::vector<Stage>& stages)
  {
    this->Stages.insert(this->Stages.end(), stages.begin(), stages.end());
    this->Watch.restart();
  }

  const std::vector<Stage>& stages() const { return this->Stages; }

private:
  Stopwatch Watch;
  std::vector<Stage> Stages;
};
}

#endif
