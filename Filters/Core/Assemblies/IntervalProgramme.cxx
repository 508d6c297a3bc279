// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/IntervalProgramme.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#ifdef HEXSWEEP_HAS_CBC
#include <coin/Cbc_C_Interface.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace hexsweep
{
namespace
{
/// More could not be meshed.
constexpr double MostEdges = 1e9;
/// Smaller wishes weigh as much as this one: solvers refuse weights without measure.
constexpr double LeastWish = 1e-6;

/// Numbers that are equal, as one.
struct IntervalClass
{
  std::vector<std::pair<double, double>> wishes; ///< number, weight
  Index least = 1;
  Index most = std::numeric_limits<Index>::max();
  Index step = 1; ///< 2: even numbers only
};

/// An equation between classes: the sum of factor times number is zero.
struct ClassEquation
{
  std::map<Index, double> factors;
  const std::string* words;
};

struct Contracted
{
  std::vector<Index> classOf; ///< one a wish
  std::vector<IntervalClass> classes;
  std::vector<ClassEquation> equations;
};

Contracted contract(const IntervalProgramme& programme)
{
  const Index count = static_cast<Index>(programme.wishes.size());
  DisjointSets equal(count);
  for (const IntervalEquation& equation : programme.equations)
  {
    if (equation.left.size() == 1 && equation.right.size() == 1)
    {
      equal.join(equation.left.front(), equation.right.front());
    }
  }
  Contracted result;
  std::map<Index, Index> rows;
  for (Index i = 0; i < count; ++i)
  {
    const Index row =
      rows.try_emplace(equal.find(i), static_cast<Index>(rows.size())).first->second;
    result.classOf.push_back(row);
    result.classes.resize(rows.size());
    const IntervalWish& wish = programme.wishes[at(i)];
    IntervalClass& own = result.classes[at(row)];
    own.least = std::max(own.least, wish.least);
    own.most = wish.most > 0 ? std::min(own.most, wish.most) : own.most;
    own.step = wish.even ? 2 : own.step;
    if (!(wish.number <= MostEdges))
    {
      throw InvalidInput("a curve or a volume would have " + describe(wish.number) +
        " edges or layers. Set Size to a larger length.");
    }
    if (!wish.free)
    {
      const double number = std::max(wish.number, LeastWish);
      own.wishes.emplace_back(number, 1.0 / number);
    }
  }
  for (IntervalClass& own : result.classes)
  {
    own.least += own.least % own.step;
    own.most -= own.most % own.step;
    std::sort(own.wishes.begin(), own.wishes.end());
  }
  for (const IntervalEquation& equation : programme.equations)
  {
    ClassEquation between;
    between.words = &equation.words;
    for (const Index i : equation.left)
    {
      between.factors[result.classOf[at(i)]] += 1.0;
    }
    for (const Index i : equation.right)
    {
      between.factors[result.classOf[at(i)]] -= 1.0;
    }
    const bool holds = std::all_of(between.factors.begin(), between.factors.end(),
      [](const auto& term) { return term.second == 0.0; });
    if (!holds)
    {
      result.equations.push_back(std::move(between));
    }
  }
  return result;
}

double costOf(const IntervalClass& own, double number)
{
  double cost = 0.0;
  for (const auto& [wish, weight] : own.wishes)
  {
    cost += weight * std::abs(number - wish);
  }
  return cost;
}

/// The best number by itself: the cost is convex, so it is next to the weighted median.
Index medianOf(const IntervalClass& own)
{
  double half = 0.0;
  for (const auto& wish : own.wishes)
  {
    half += 0.5 * wish.second;
  }
  double median = static_cast<double>(own.least);
  double passed = 0.0;
  for (const auto& [wish, weight] : own.wishes)
  {
    passed += weight;
    if (passed >= half)
    {
      median = wish;
      break;
    }
  }
  const double step = static_cast<double>(own.step);
  const Index below = own.step * static_cast<Index>(std::floor(median / step));
  const Index above = below + own.step;
  const Index best =
    costOf(own, static_cast<double>(above)) < costOf(own, static_cast<double>(below)) ? above
                                                                                      : below;
  return std::clamp(best, own.least, std::max(own.least, own.most));
}

#ifdef HEXSWEEP_HAS_CBC
constexpr double Unlimited = std::numeric_limits<double>::max();

/// A sparse matrix by columns, as Cbc takes it.
struct Columns
{
  std::vector<CoinBigIndex> starts{ 0 };
  std::vector<int> rows;
  std::vector<double> values;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<double> cost;

  void add(
    const std::vector<std::pair<int, double>>& entries, double least, double most, double price)
  {
    for (const auto& [row, value] : entries)
    {
      this->rows.push_back(row);
      this->values.push_back(value);
    }
    this->starts.push_back(static_cast<CoinBigIndex>(this->rows.size()));
    this->lower.push_back(least);
    this->upper.push_back(most);
    this->cost.push_back(price);
  }
};

/// @return one number a class that is in an equation, or nothing where there is none.
std::optional<std::map<Index, Index>> branchAndCut(
  const Contracted& problem, const std::vector<const ClassEquation*>& equations)
{
  std::map<Index, std::vector<std::pair<int, double>>> entries; // by class
  for (std::size_t e = 0; e < equations.size(); ++e)
  {
    for (const auto& [row, factor] : equations[e]->factors)
    {
      if (factor != 0.0)
      {
        entries[row].emplace_back(
          static_cast<int>(e), factor * static_cast<double>(problem.classes[at(row)].step));
      }
    }
  }
  // A wish is a row: step x number - above + below = wish.
  std::vector<double> right(equations.size(), 0.0);
  Columns columns;
  struct Deviation
  {
    int row;
    double weight;
  };
  std::vector<Deviation> deviations;
  for (auto& [row, own] : entries)
  {
    const IntervalClass& numbers = problem.classes[at(row)];
    for (const auto& [wish, weight] : numbers.wishes)
    {
      const int deviation = static_cast<int>(right.size());
      own.emplace_back(deviation, static_cast<double>(numbers.step));
      right.push_back(wish);
      deviations.push_back({ deviation, weight });
    }
    columns.add(own, static_cast<double>(numbers.least) / static_cast<double>(numbers.step),
      numbers.most == std::numeric_limits<Index>::max()
        ? Unlimited
        : static_cast<double>(numbers.most) / static_cast<double>(numbers.step),
      0.0);
  }
  const int integers = static_cast<int>(entries.size());
  for (const Deviation& deviation : deviations)
  {
    columns.add({ { deviation.row, 1.0 } }, 0.0, Unlimited, deviation.weight);
    columns.add({ { deviation.row, -1.0 } }, 0.0, Unlimited, deviation.weight);
  }
  const std::unique_ptr<Cbc_Model, void (*)(Cbc_Model*)> model(Cbc_newModel(), &Cbc_deleteModel);
  Cbc_loadProblem(model.get(), static_cast<int>(columns.cost.size()),
    static_cast<int>(right.size()), columns.starts.data(), columns.rows.data(),
    columns.values.data(), columns.lower.data(), columns.upper.data(), columns.cost.data(),
    right.data(), right.data());
  for (int i = 0; i < integers; ++i)
  {
    Cbc_setInteger(model.get(), i);
  }
  Cbc_setLogLevel(model.get(), 0);
  constexpr int NodesANumber = 100;
  Cbc_setMaximumNodes(model.get(), 1000 + NodesANumber * integers);
  Cbc_solve(model.get());
  if (Cbc_numberSavedSolutions(model.get()) == 0 && Cbc_isProvenOptimal(model.get()) == 0)
  {
    return std::nullopt;
  }
  const double* const solution = Cbc_getColSolution(model.get());
  std::map<Index, Index> numbers;
  int column = 0;
  for (const auto& [row, own] : entries)
  {
    numbers[row] =
      problem.classes[at(row)].step * static_cast<Index>(std::lround(solution[column]));
    ++column;
  }
  return numbers;
}
#else
std::optional<std::map<Index, Index>> branchAndCut(
  const Contracted&, const std::vector<const ClassEquation*>&)
{
  throw InvalidInput("the numbers of edges on the curves of this model need an integer programme, "
                     "and HexSweep was built without COIN-OR Cbc. Build it with Cbc (Debian: "
                     "coinor-libcbc-dev).");
}
#endif

/// Numbers that are equal must have a common range.
void checkLimits(const IntervalProgramme& programme, const Contracted& problem)
{
  for (std::size_t row = 0; row < problem.classes.size(); ++row)
  {
    const IntervalClass& own = problem.classes[row];
    if (own.least <= own.most)
    {
      continue;
    }
    std::string words;
    for (const IntervalEquation& equation : programme.equations)
    {
      const bool joins = equation.left.size() == 1 && equation.right.size() == 1 &&
        problem.classOf[at(equation.left.front())] == static_cast<Index>(row);
      words += joins ? (words.empty() ? "" : "; ") + equation.words : "";
    }
    throw InvalidInput(
      "numbers of edges or layers that were asked for contradict each other, or are "
      "too small (" +
      std::to_string(own.most) + " at most, " + std::to_string(own.least) + " at least): " + words +
      ".");
  }
}

/// Leaves out equation after equation as long as the rest has no solution either.
[[noreturn]] void refuse(const Contracted& problem)
{
  std::vector<const ClassEquation*> left;
  for (const ClassEquation& equation : problem.equations)
  {
    left.push_back(&equation);
  }
  constexpr std::size_t MostTried = 2000;
  for (std::size_t e = 0; e < left.size() && left.size() < MostTried;)
  {
    std::vector<const ClassEquation*> fewer = left;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(e));
    if (branchAndCut(problem, fewer))
    {
      ++e;
    }
    else
    {
      left = std::move(fewer);
    }
  }
  std::string words;
  std::set<std::string> told;
  for (const ClassEquation* equation : left)
  {
    if (told.insert(*equation->words).second)
    {
      words += (words.empty() ? "" : "; ") + *equation->words;
    }
  }
  throw InvalidInput("no numbers of edges fit all volumes. These contradict each other: " + words +
    ". Sweep one of these volumes between other caps, or cut it.");
}
}

std::vector<Index> solveIntervals(const IntervalProgramme& programme)
{
  const Contracted problem = contract(programme);
  std::map<Index, Index> bound;
  checkLimits(programme, problem);
  if (!problem.equations.empty())
  {
    std::vector<const ClassEquation*> all;
    for (const ClassEquation& equation : problem.equations)
    {
      all.push_back(&equation);
    }
    std::optional<std::map<Index, Index>> solved = branchAndCut(problem, all);
    if (!solved)
    {
      refuse(problem);
    }
    bound = *std::move(solved);
  }
  std::vector<Index> numbers;
  for (const Index row : problem.classOf)
  {
    const auto solved = bound.find(row);
    numbers.push_back(solved != bound.end() ? solved->second : medianOf(problem.classes[at(row)]));
  }
  return numbers;
}
}
