// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Runs named functions in turn and compares their CPU times.
 *
 * Google Benchmark interleaves repetitions at random and gives no ratios; here the functions take
 * turns (a b c a b c ...), so that what slows the machine down for a while slows all of them. One
 * comparison is one iteration of a benchmark:
 *
 *     void compare(benchmark::State& state)
 *     {
 *       test::Interleaved runs;
 *       runs.add("ours", [&] { ... });
 *       runs.add("theirs", [&] { ... });
 *       runs.report(state); // counters ours_s, theirs_s, theirs/ours
 *     }
 *     BENCHMARK(compare)->Iterations(1);
 */
#ifndef Interleaved_h
#define Interleaved_h

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test
{
/// CPU seconds of the whole process since it began, all threads together.
inline double cpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Forgets the peak of the resident memory (Linux; elsewhere nothing happens).
inline void resetPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// Peak of the resident memory of the process since the reset, in MB; 0 where it is not known.
inline double peakMegabytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == "VmHWM:")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

class Interleaved
{
public:
  /// The functions are run in the order in which they are added; the first one is compared with.
  void add(const std::string& name, std::function<void()> function)
  {
    this->Runs.push_back({ name, std::move(function), {}, 0.0 });
  }

  /**
   * Runs all of them `rounds` times, as the one iteration of the benchmark.
   *
   * Counters: the median CPU seconds of each (name_s), its ratio to the first (name/first), and
   * the peak of the memory of the process (name_MB), meshes and all.
   */
  void report(benchmark::State& state, int rounds = 5)
  {
    for (auto iteration : state)
    {
      (void)iteration;
      for (int round = 0; round < rounds; ++round)
      {
        for (Run& run : this->Runs)
        {
          resetPeakMemory();
          const double begin = cpuSeconds();
          run.function();
          run.seconds.push_back(cpuSeconds() - begin);
          run.megabytes = std::max(run.megabytes, peakMegabytes());
        }
      }
    }
    for (const Run& run : this->Runs)
    {
      state.counters[run.name + "_s"] = median(run.seconds);
      state.counters[run.name + "_MB"] = run.megabytes;
      if (&run != &this->Runs.front())
      {
        state.counters[run.name + "/" + this->Runs.front().name] =
          median(run.seconds) / median(this->Runs.front().seconds);
      }
    }
  }

private:
  struct Run
  {
    std::string name;
    std::function<void()> function;
    std::vector<double> seconds;
    double megabytes;
  };

  static double median(std::vector<double> values)
  {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::vector<Run> Runs;
};
}

#endif
