// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyPlan.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Solids/SweepCandidates.h"
#include "Core/Solids/SweepTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Combinations that are tried, besides one for each volume.
constexpr std::size_t MostCombinations = 2000;
/// Starts of a stack of volumes that are compared.
constexpr std::size_t MostRoots = 64;

std::string nameOfVolume(Index volume)
{
  return "volume " + std::to_string(volume + 1);
}

enum class FaceRole
{
  Cap,
  Side
};

/// One option a volume.
using Choice = std::vector<std::size_t>;

/// What a choice makes of the shared faces, and whether that works.
class ChoiceCheck
{
public:
  ChoiceCheck(const AssemblyComplex& complex, const std::vector<VolumeOptions>& volumes,
    const Choice& choice, const CanCarry& canCarry)
    : Complex(complex)
    , Carries(canCarry)
  {
    for (std::size_t v = 0; v < volumes.size(); ++v)
    {
      const bool isThere = !volumes[v].options.empty();
      this->Layouts.push_back(isThere ? &volumes[v].options[choice[v]].layout : &this->None);
      this->IsFixed.push_back(isThere && volumes[v].options[choice[v]].fixed);
      this->IsThere.push_back(isThere);
    }
  }

  /// @return a plan, or nothing, with why.
  std::optional<AssemblyPlan> plan(std::string& why)
  {
    AssemblyPlan result;
    const std::size_t count = this->Layouts.size();
    this->IsTurned.assign(count, false);
    this->IsDone.assign(count, false);
    result.stackOf.assign(count, -1);
    for (std::size_t v = 0; v < count; ++v)
    {
      if (this->IsDone[v] || !this->IsThere[v])
      {
        continue;
      }
      const std::vector<Index> stack = this->stackOf(static_cast<Index>(v));
      for (const Index volume : stack)
      {
        result.stackOf[at(volume)] = static_cast<Index>(v);
      }
      if (!this->orderStack(stack, result.order, why))
      {
        return std::nullopt;
      }
    }
    for (std::size_t v = 0; v < count; ++v)
    {
      result.sweeps.push_back(this->layoutOf(static_cast<Index>(v)));
    }
    return result;
  }

  /// Volumes of which another way may help; empty: any.
  const std::set<Index>& culprits() const { return this->Culprits; }

private:
  const std::vector<Index>& cap(Index volume, bool second) const
  {
    const SweepLayout& own = *this->Layouts[at(volume)];
    return second ? own.targets : own.sources;
  }

  FaceRole roleIn(Index volume, Index face) const
  {
    const bool isCap =
      std::binary_search(this->cap(volume, false).begin(), this->cap(volume, false).end(), face) ||
      std::binary_search(this->cap(volume, true).begin(), this->cap(volume, true).end(), face);
    return isCap ? FaceRole::Cap : FaceRole::Side;
  }

  /// The other volume of a face, or -1 where there is none that is swept.
  Index beyond(Index volume, Index face) const
  {
    const std::vector<Index>& volumes = this->Complex.faces[at(face)].volumes;
    if (volumes.size() < 2)
    {
      return -1;
    }
    const Index other = volumes[volumes[0] == volume ? 1 : 0];
    return this->IsThere[at(other)] ? other : -1;
  }

  /// Volumes that are joined cap to cap, directly or by others, rising.
  std::vector<Index> stackOf(Index start)
  {
    std::vector<Index> stack(1, start);
    std::set<Index> known{ start };
    for (std::size_t i = 0; i < stack.size(); ++i)
    {
      for (const bool second : { false, true })
      {
        for (const Index face : this->cap(stack[i], second))
        {
          const Index other = this->beyond(stack[i], face);
          if (other >= 0 && this->roleIn(other, face) == FaceRole::Cap &&
            known.insert(other).second)
          {
            stack.push_back(other);
          }
        }
      }
    }
    for (const Index volume : stack)
    {
      this->IsDone[at(volume)] = true;
    }
    std::sort(stack.begin(), stack.end());
    return stack;
  }

  /// Whether a cap has a face that is a side of another volume: its quads are known before.
  bool isPinned(Index volume, bool second) const
  {
    const std::vector<Index>& faces = this->cap(volume, second);
    return std::any_of(faces.begin(), faces.end(), [&](Index face) {
      const Index other = this->beyond(volume, face);
      return other >= 0 && this->roleIn(other, face) == FaceRole::Side;
    });
  }

  /// A cap that a stack can begin with.
  struct Root
  {
    Index volume;
    bool second;
  };

  /// Quads that are known at two places of a stack are the same where each cap is one face alone.
  bool canBePinned(
    const std::vector<Index>& stack, const std::vector<Root>& pinned, std::string& why)
  {
    const bool areWhole = std::all_of(pinned.begin(), pinned.end(),
      [&](const Root& root) { return this->cap(root.volume, root.second).size() == 1; });
    if (pinned.size() < 2 || areWhole)
    {
      return true;
    }
    why = "two caps of " + nameOfVolume(pinned[0].volume) +
      (pinned[1].volume == pinned[0].volume ? "" : " and " + nameOfVolume(pinned[1].volume)) +
      ", which are stacked, have sides of other volumes in them";
    // Another way for one of these, or for a volume whose side is in a cap, may do.
    this->Culprits.insert(stack.begin(), stack.end());
    for (const Root& root : pinned)
    {
      for (const Index face : this->cap(root.volume, root.second))
      {
        const Index other = this->beyond(root.volume, face);
        if (other >= 0)
        {
          this->Culprits.insert(other);
        }
      }
    }
    return false;
  }

  bool orderStack(const std::vector<Index>& stack, std::vector<Index>& order, std::string& why)
  {
    std::vector<Root> pinned;
    std::vector<Root> roots;
    for (const Index volume : stack)
    {
      for (const bool second : { false, true })
      {
        if (second && this->IsFixed[at(volume)])
        {
          continue;
        }
        roots.push_back({ volume, second });
        if (this->isPinned(volume, second))
        {
          pinned.push_back(roots.back());
        }
      }
    }
    if (!pinned.empty())
    {
      roots = pinned;
    }
    if (!this->canBePinned(stack, pinned, why))
    {
      return false;
    }
    std::stable_sort(roots.begin(), roots.end(), [&](const Root& a, const Root& b) {
      return this->cap(a.volume, a.second).size() > this->cap(b.volume, b.second).size();
    });
    std::string first;
    std::optional<Root> best;
    std::size_t fewest = 0;
    std::vector<Index> found;
    for (std::size_t r = 0; r < std::min(MostRoots, roots.size()); ++r)
    {
      std::string problem;
      const std::optional<std::size_t> imprints =
        this->walk(roots[r], stack.size(), found, problem);
      if (imprints && (!best || *imprints < fewest))
      {
        best = roots[r];
        fewest = *imprints;
      }
      if (best && fewest == 0)
      {
        break;
      }
      first = first.empty() ? problem : first;
    }
    if (!best)
    {
      why = first;
      return false;
    }
    this->walk(*best, stack.size(), found, first);
    order.insert(order.end(), found.begin(), found.end());
    return true;
  }

  /// From volume to volume over common caps; each begins with the cap that it is reached by.
  /// @param count volumes of the stack.
  /// @return how many targets have borders that are to be carried back, or nothing, with why.
  std::optional<std::size_t> walk(
    const Root& root, std::size_t count, std::vector<Index>& found, std::string& problem)
  {
    std::size_t imprints = 0;
    std::set<Index> known{ root.volume };
    found.assign(1, root.volume);
    this->IsTurned[at(root.volume)] = root.second;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const Index volume = found[i];
      const bool turned = this->IsTurned[at(volume)];
      const std::vector<Index>& targets = this->cap(volume, !turned);
      if (needsImprint(this->Complex, targets))
      {
        ++imprints;
        if (!this->Carries(volume, this->layoutOf(volume)))
        {
          problem = nameOfVolume(volume) + " ends at several faces, of which face " +
            std::to_string(this->Complex.faces[at(targets.front())].id) +
            " is one; some of them go on to other volumes, and the borders between them have no "
            "image on its other cap";
          return std::nullopt;
        }
      }
      for (const bool second : { false, true })
      {
        for (const Index face : this->cap(volume, second))
        {
          const Index other = this->beyond(volume, face);
          if (other < 0 || this->roleIn(other, face) == FaceRole::Side || known.count(other) > 0)
          {
            continue;
          }
          const std::vector<Index>& first = this->cap(other, false);
          const bool turnsOther = !std::binary_search(first.begin(), first.end(), face);
          if (turnsOther && this->IsFixed[at(other)])
          {
            // It may be reached by its source from elsewhere.
            problem = nameOfVolume(other) + " is reached by its named target (face " +
              std::to_string(this->Complex.faces[at(face)].id) + ") from " + nameOfVolume(volume);
            continue;
          }
          known.insert(other);
          this->IsTurned[at(other)] = turnsOther;
          found.push_back(other);
        }
      }
    }
    if (found.size() < count)
    {
      return std::nullopt;
    }
    return imprints;
  }

  SweepLayout layoutOf(Index volume) const
  {
    const SweepLayout& own = *this->Layouts[at(volume)];
    return this->IsTurned[at(volume)] ? layOutSides(this->Complex, volume, own.targets, own.sources)
                                      : own;
  }

  const AssemblyComplex& Complex;
  const CanCarry& Carries;
  std::vector<const SweepLayout*> Layouts;
  std::vector<bool> IsFixed;
  std::vector<bool> IsThere;
  std::set<Index> Culprits;
  SweepLayout None;
  std::vector<bool> IsTurned;
  std::vector<bool> IsDone;
};

double costOf(const std::vector<VolumeOptions>& volumes, const Choice& choice)
{
  double cost = 0.0;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    cost -= volumes[v].options.empty()
      ? 0.0
      : std::log(std::max(1e-6, volumes[v].options[choice[v]].score));
  }
  return cost;
}
}

VolumeOptions sweepOptions(
  const AssemblyComplex& complex, Index volume, const SolidSurface& solid, const NamedSweep& named)
{
  std::vector<SweepCandidate> candidates;
  if (!named.sourceFaceIds.empty() && !named.targetFaceIds.empty())
  {
    SweepCandidate only;
    only.sourceFaceIds = named.sourceFaceIds;
    only.targetFaceIds = named.targetFaceIds;
    only.score = 1.0;
    only.fits = true;
    candidates.push_back(only);
    sweepBetween(solid, only.sourceFaceIds, only.targetFaceIds);
  }
  else
  {
    candidates = named.sourceFaceIds.empty()
      ? findSweepCandidates(solid).list
      : findTargetCandidates(solid, named.sourceFaceIds).list;
  }
  VolumeOptions result;
  for (const SweepCandidate& candidate : candidates)
  {
    if (!candidate.fits)
    {
      result.refused.push_back(candidate.reasons);
      continue;
    }
    try
    {
      result.options.push_back(
        { layOutSides(complex, volume, rowsOfFaces(complex, volume, candidate.sourceFaceIds),
            rowsOfFaces(complex, volume, candidate.targetFaceIds)),
          candidate.score, !named.sourceFaceIds.empty() && !named.eitherWay });
    }
    catch (const InvalidInput& error)
    {
      result.refused.emplace_back(error.what());
    }
  }
  if (result.options.empty())
  {
    throw InvalidInput("it cannot be swept as part of an assembly" +
      (result.refused.empty() ? std::string(": no two of its faces are caps.")
                              : ": " + result.refused.front()));
  }
  return result;
}

bool needsImprint(const AssemblyComplex& complex, const std::vector<Index>& targets)
{
  return targets.size() > 1 && std::any_of(targets.begin(), targets.end(), [&](Index face) {
    return complex.faces[at(face)].volumes.size() > 1;
  });
}

AssemblyPlan planAssembly(const AssemblyComplex& complex, const std::vector<VolumeOptions>& volumes,
  const CanCarry& canCarry)
{
  // Best first over all combinations: the next ones take another option of one volume.
  using Costed = std::pair<double, Choice>;
  const auto dearer = [](const Costed& a, const Costed& b) { return a > b; };
  std::priority_queue<Costed, std::vector<Costed>, decltype(dearer)> open(dearer);
  std::set<Choice> seen;
  const Choice best(volumes.size(), 0);
  open.emplace(costOf(volumes, best), best);
  seen.insert(best);
  std::string first;
  const std::size_t most = MostCombinations + volumes.size();
  for (std::size_t tried = 0; tried < most && !open.empty(); ++tried)
  {
    const Choice choice = open.top().second;
    open.pop();
    std::string why;
    ChoiceCheck check(complex, volumes, choice, canCarry);
    if (std::optional<AssemblyPlan> plan = check.plan(why))
    {
      return *std::move(plan);
    }
    first = first.empty() ? why : first;
    for (std::size_t v = 0; v < volumes.size() && seen.size() < 20 * most; ++v)
    {
      const bool mayHelp =
        check.culprits().empty() || check.culprits().count(static_cast<Index>(v)) > 0;
      if (mayHelp && choice[v] + 1 < volumes[v].options.size())
      {
        Choice next = choice;
        ++next[v];
        if (seen.insert(next).second)
        {
          const double cost = costOf(volumes, next);
          open.emplace(cost, std::move(next));
        }
      }
    }
  }
  throw InvalidInput("no sweeps of the volumes fit together: " + first +
    ". Name other source and target faces, or cut a volume there.");
}
}
