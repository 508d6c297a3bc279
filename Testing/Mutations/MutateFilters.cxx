// SPDX-License-Identifier: BSD-3-Clause
// HexSweepMutateFilters FIRST COUNT [SECONDS] (of one run the filter and what it says are printed):
// runs the filters on mutated inputs number FIRST, FIRST + 1, ..., no longer than some seconds, and
// ends with 1 where one of them crashed, hung, lied or lost its way:
// - the process lives, and no run takes longer than a minute of a processor;
// - a filter either has an output or says in one error why it has none;
// - a hexahedron that is certified is proved valid in exact numbers, and the report counts the
// others;
// - hexahedra that are not certified are told;
// - an aborted filter has no output, and a filter works on good inputs after any of that.
#include "MutatedInputs.h"

#include "Support/ExactHexes.h"

#include <vtkOutputWindow.h>

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
using namespace test;
using Clock = std::chrono::steady_clock;

constexpr double LongestSeconds = 60.0;
constexpr std::uint64_t RunsPerProcess = 40;
constexpr vtkIdType HexesProved = 60;

class Silence : public vtkOutputWindow
{
public:
  static Silence* New() { return new Silence; }
  void DisplayText(const char*) override {}
};

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

hexsweep::HexCorners cornersOfHex(vtkDataSet* hexes, vtkIdType cell)
{
  hexsweep::HexCorners corners;
  const Corners ids = cornersOf(hexes, cell);
  for (int i = 0; i < 8; ++i)
  {
    const std::array<double, 3> place = pointOf(hexes, ids[static_cast<std::size_t>(i)]);
    corners.row(i) << place[0], place[1], place[2];
  }
  return corners;
}

/// What is wrong with the verdicts on hexahedra; empty: nothing.
std::string wrongVerdict(vtkDataSet* hexes, const Events& events)
{
  vtkDataArray* validity = hexes->GetCellData()->GetArray("Validity");
  vtkDataArray* counted = hexes->GetFieldData()->GetArray("SweepReportNotCertified");
  if (!validity || !counted || validity->GetNumberOfTuples() != hexes->GetNumberOfCells())
  {
    return {};
  }
  vtkIdType notCertified = 0;
  vtkIdType hexahedra = 0;
  const vtkIdType step = std::max<vtkIdType>(1, hexes->GetNumberOfCells() / HexesProved);
  for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
  {
    const double verdict = validity->GetTuple1(c);
    hexahedra += verdict != 5.0;
    notCertified += verdict != 0.0 && verdict != 5.0;
    if (verdict == 0.0 && c % step == 0 &&
      truthEverywhere(cornersOfHex(hexes, c)) == Truth::NotPositive)
    {
      return "hexahedron " + std::to_string(c) + " is certified and not valid";
    }
  }
  double reported = 0.0;
  for (vtkIdType i = 0; i < counted->GetNumberOfTuples(); ++i)
  {
    reported += counted->GetTuple1(i);
  }
  const bool hasGhosts = hexes->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName());
  if (!hasGhosts && reported != static_cast<double>(notCertified))
  {
    return "not certified: " + std::to_string(notCertified) + ", reported " +
      std::to_string(reported);
  }
  return notCertified > 0 && !hasGhosts && events.warnings.empty()
    ? std::to_string(notCertified) + " hexahedra are not certified, and nobody was told"
    : std::string();
}

/// What is wrong with a run; empty: nothing.
std::string problemOf(vtkAlgorithm* filter, const Events& events, bool aborted)
{
  const bool hasAny = hasOutput(filter);
  if (aborted)
  {
    return hasAny ? "aborted, and there is an output" : "";
  }
  const std::size_t errors = events.errors.size() + events.executiveErrors.size();
  if (events.errors.size() > 1)
  {
    return "several errors: " + events.errors[0] + " and " + events.errors[1];
  }
  if (!hasAny && errors == 0)
  {
    return "neither an output nor an error";
  }
  if (hasAny && errors > 0)
  {
    return "an output and an error";
  }
  for (const std::string& text : events.errors)
  {
    if (text.find("-nan") != std::string::npos)
    {
      return text;
    }
  }
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    if (auto* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port)))
    {
      const std::string wrong = wrongVerdict(data, events);
      if (!wrong.empty())
      {
        return wrong;
      }
    }
  }
  return {};
}

/// @return what is wrong.
std::string run(std::uint64_t number, bool isAlone)
{
  Chance chance(number);
  const FilterUse& use = everyFilter()[number % everyFilter().size()];
  const vtkSmartPointer<vtkAlgorithm> filter = mutatedFilter(use, chance);
  if (isAlone)
  {
    filter->Print(std::cout);
    std::cout.flush();
  }
  Events events(filter);
  vtkNew<AbortAt> abort; // what is aborted when all is done has its output
  abort->Fraction = chance.real(0.0, 0.99);
  const bool aborts = chance.oneIn(12);
  const unsigned long tag = aborts ? filter->AddObserver(vtkCommand::ProgressEvent, abort) : 0;
  filter->Update();
  for (const std::vector<std::string>* texts : { &events.errors, &events.warnings })
  {
    for (std::size_t i = 0; i < texts->size() && isAlone; ++i)
    {
      std::cout << (*texts)[i] << '\n';
    }
  }
  const bool aborted = filter->GetAbortExecute() != 0 && !hasOutput(filter);
  std::string problem = problemOf(filter, events, aborted);
  if (problem.empty() && (aborted || chance.oneIn(8)))
  {
    // The same kind of filter, and where its settings are its own this one, on good inputs.
    const vtkSmartPointer<vtkAlgorithm> again = use.on();
    again->Update();
    problem = hasOutput(again) ? "" : "good inputs fail afterwards";
  }
  if (tag != 0)
  {
    filter->RemoveObserver(tag);
  }
  return problem.empty() ? problem : use.name + ": " + problem;
}

/// So that what asks for millions of hexahedra is refused, and does not just take long.
void limitMemory()
{
  constexpr rlim_t More = rlim_t{ 300 } << 20;
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  if (file >> pages)
  {
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + More;
    const rlimit limit = { bytes, bytes };
    setrlimit(RLIMIT_AS, &limit);
  }
}

/// Ends this process where it takes so many seconds of processor time from now on, or waits for
/// ever: on a busy machine the clock tells nothing.
void endIn(double seconds)
{
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  setitimer(ITIMER_PROF, &timer, nullptr);
  alarm(40 * static_cast<unsigned int>(seconds));
}

/// Runs some in a process of their own. @return how many were wrong.
int runProcess(std::uint64_t first, std::uint64_t end, int pipe)
{
  limitMemory();
  int wrong = 0;
  for (std::uint64_t number = first; number < end; ++number)
  {
    if (write(pipe, &number, sizeof number) != sizeof number)
    {
      return 1;
    }
    endIn(LongestSeconds);
    const std::string problem = run(number, end == first + 1);
    if (!problem.empty())
    {
      ++wrong;
      std::cout << "run " << number << ": " << problem << std::endl;
    }
  }
  return wrong;
}

/// @return how many runs were wrong; `end` is set to the run after the last one.
int runGroup(std::uint64_t first, std::uint64_t& end)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    std::perror("pipe");
    std::exit(1);
  }
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    const int wrong = runProcess(first, end, ends[1]);
    std::cout.flush();
    _exit(std::min(wrong, 100));
  }
  close(ends[1]);
  std::uint64_t last = first;
  std::uint64_t number = 0;
  while (read(ends[0], &number, sizeof number) == sizeof number)
  {
    last = number;
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
  {
    std::cout << "run " << last << ": ended by signal " << WTERMSIG(status)
              << (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM ? " (it hung)" : "")
              << std::endl;
    end = last + 1;
    return 1;
  }
  return WEXITSTATUS(status);
}
}

int main(int count, char** words)
{
  if (count < 3)
  {
    std::cerr << "HexSweepMutateFilters FIRST COUNT [SECONDS]\n";
    return 1;
  }
  const std::uint64_t first = std::strtoull(words[1], nullptr, 10);
  const std::uint64_t runs = std::strtoull(words[2], nullptr, 10);
  const double seconds = count > 3 ? std::strtod(words[3], nullptr) : HUGE_VAL;
  vtkNew<Silence> silence; // errors are looked at, not shown
  vtkOutputWindow::SetInstance(silence);
  everyFilter(); // made once, before the processes part
  const auto begin = Clock::now();
  std::uint64_t done = 0;
  int wrong = 0;
  while (done < runs && secondsSince(begin) < seconds)
  {
    std::uint64_t end = first + std::min(done + RunsPerProcess, runs);
    wrong += runGroup(first + done, end);
    done = end - first;
  }
  std::cout << done << " runs from " << first << " on in " << secondsSince(begin) << " s, " << wrong
            << " of them wrong" << std::endl;
  return wrong == 0 && done > 0 ? 0 : 1;
}
