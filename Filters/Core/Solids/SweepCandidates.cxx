// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepCandidates.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SweepCap.h"
#include "Core/Solids/SweepFit.h"
#include "Core/Solids/SweepRanking.h"
#include "Core/Solids/SweepTopology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using CapPair = std::pair<std::size_t, std::size_t>;

/// The likeliest caps of which all pairs are tried.
constexpr std::size_t MostCaps = 64;
constexpr std::size_t MostDirections = 64;
constexpr std::size_t MostRefused = 3;

/// Directions along which sides may lie: normals of plane faces, axes of bent ones; those of larger
/// faces first.
std::vector<Eigen::RowVector3d> sideDirections(const FaceGraph& graph)
{
  constexpr double Plane = 0.99;
  constexpr double Same = 0.998; // 3.6 degrees
  std::vector<std::pair<double, Eigen::RowVector3d>> directions;
  for (const FaceShape& face : graph.faces)
  {
    Eigen::RowVector3d direction = face.normal;
    if (face.normal.norm() < Plane)
    {
      direction = principalAxes(face.spread()).axes.col(0).transpose();
    }
    direction.normalize();
    const auto known = std::find_if(directions.begin(), directions.end(),
      [&](const auto& other) { return std::abs(other.second.dot(direction)) > Same; });
    if (known != directions.end())
    {
      known->first += face.area;
    }
    else
    {
      directions.emplace_back(face.area, direction);
    }
  }
  std::stable_sort(directions.begin(), directions.end(),
    [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Eigen::RowVector3d> result;
  for (const auto& direction : directions)
  {
    result.push_back(direction.second);
  }
  return result;
}

/// Finds caps and pairs of them, each once, and ranks the pairs.
class CandidateSearch
{
public:
  explicit CandidateSearch(const SolidSurface& solid)
    : Graph(makeFaceGraph(solid))
    , Ways(this->Graph)
  {
  }

  SweepCandidates findAll()
  {
    this->addSets(smoothFaceSets(this->Graph, std::vector<char>(this->Graph.faces.size(), 1)));
    const std::vector<std::size_t> likely = this->likeliestCaps();
    for (std::size_t i = 0; i < likely.size(); ++i)
    {
      for (std::size_t j = i + 1; j < likely.size(); ++j)
      {
        this->addPair(likely[i], likely[j]);
      }
      this->addFarthest(likely[i]);
    }
    this->addEnds();
    return this->ranked(false);
  }

  SweepCandidates findTargets(const std::vector<Index>& sourceIds)
  {
    const std::size_t source = this->sourceOf(sourceIds);
    this->addSets(smoothFaceSets(this->Graph, this->facesOff(source)));
    for (std::size_t i = 0; i < this->Caps.size(); ++i)
    {
      this->addPair(source, i);
    }
    this->addFarthest(source);
    this->addOtherEnd(source);
    return this->ranked(true);
  }

private:
  /// The number of a cap; -1 where the faces are none.
  Index capOf(const FaceSet& faces)
  {
    const auto known = this->Numbers.emplace(faces, -1);
    if (known.second)
    {
      if (std::optional<CapCandidate> cap = makeCapCandidate(this->Graph, faces))
      {
        known.first->second = static_cast<Index>(this->Caps.size());
        this->Caps.push_back(std::move(*cap));
        this->Distances.emplace_back();
        this->Steps.emplace_back();
      }
    }
    return known.first->second;
  }

  void addSets(const std::vector<FaceSet>& sets)
  {
    for (const FaceSet& set : sets)
    {
      this->capOf(set);
    }
  }

  std::size_t sourceOf(const std::vector<Index>& ids)
  {
    const std::vector<Index> checked = checkedFaceIds(this->Graph.solid, ids, "source");
    const Index cap = this->capOf(facesWithIds(this->Graph, checked));
    if (cap < 0)
    {
      // Says what is wrong with it.
      makeSweepCap(this->Graph.solid, this->Graph.halfEdges, checked,
        trianglesOfFaces(this->Graph.solid, ids), "source cap");
    }
    return static_cast<std::size_t>(cap);
  }

  /// Marks faces that have no point in common with a cap.
  std::vector<char> facesOff(std::size_t cap) const
  {
    const SolidSurface& solid = this->Graph.solid;
    std::vector<char> onCap(static_cast<std::size_t>(solid.points.rows()), 0);
    std::vector<char> isOff(this->Graph.faces.size(), 1);
    for (const std::size_t face : this->Caps[cap].faces)
    {
      isOff[face] = 0;
    }
    for (const Index p : this->Caps[cap].rimPoints)
    {
      onCap[static_cast<std::size_t>(p)] = 1;
    }
    for (Index i = 0; i < solid.triangles.size(); ++i)
    {
      if (onCap[static_cast<std::size_t>(solid.triangles.data()[i])])
      {
        isOff[this->Graph.patches.faceOfTriangle[static_cast<std::size_t>(i / 3)]] = 0;
      }
    }
    return isOff;
  }

  /// Caps with the right number of loops, likeliest first.
  std::vector<std::size_t> likeliestCaps()
  {
    std::vector<std::size_t> caps;
    for (std::size_t i = 0; i < this->Caps.size(); ++i)
    {
      if (hasLoopsOfSweep(this->Graph, this->Caps[i]))
      {
        caps.push_back(i);
      }
    }
    this->sortByLikelihood(caps);
    if (caps.size() > MostCaps)
    {
      caps.resize(MostCaps);
      this->Cut = true;
    }
    return caps;
  }

  void sortByLikelihood(std::vector<std::size_t>& caps) const
  {
    std::stable_sort(caps.begin(), caps.end(), [&](std::size_t a, std::size_t b) {
      return likelihoodOf(this->Caps[a]) > likelihoodOf(this->Caps[b]);
    });
  }

  void addPair(std::size_t first, std::size_t second)
  {
    const CapPair pair(std::min(first, second), std::max(first, second));
    if (first != second && this->Tried.insert(pair).second &&
      capsFit(this->Graph, this->Caps[first], this->Caps[second]))
    {
      this->Pairs.emplace_back(first, second);
    }
  }

  const std::vector<Index>& stepsFromCap(std::size_t cap)
  {
    if (this->Steps[cap].empty())
    {
      this->Steps[cap] = stepsFrom(this->Graph, this->Caps[cap].faces);
    }
    return this->Steps[cap];
  }

  /// Pairs a cap with the faces that are farthest from it, where these are several.
  void addFarthest(std::size_t cap)
  {
    const std::vector<Index> steps = this->stepsFromCap(cap);
    const Index most = *std::max_element(steps.begin(), steps.end());
    std::vector<char> isFarthest;
    for (const Index s : steps)
    {
      isFarthest.push_back(s == most);
    }
    for (const FaceSet& set :
      connectedFaces(this->Graph, isFarthest, [](const FaceContact&) { return true; }))
    {
      const Index partner = this->capOf(set);
      if (partner >= 0)
      {
        this->addPair(cap, static_cast<std::size_t>(partner));
      }
    }
  }

  void addEnds()
  {
    std::vector<Eigen::RowVector3d> directions = sideDirections(this->Graph);
    if (directions.size() > MostDirections)
    {
      directions.resize(MostDirections);
      this->Cut = true;
    }
    for (const Eigen::RowVector3d& direction : directions)
    {
      if (const auto ends = endsAlong(this->Graph, direction))
      {
        const Index first = this->capOf(ends->first);
        const Index second = this->capOf(ends->second);
        if (first >= 0 && second >= 0)
        {
          this->addPair(static_cast<std::size_t>(first), static_cast<std::size_t>(second));
        }
      }
    }
  }

  /// What lies across from a source cap along its normal.
  void addOtherEnd(std::size_t source)
  {
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    for (const std::size_t face : this->Caps[source].faces)
    {
      normal += this->Graph.faces[face].area * this->Graph.faces[face].normal;
    }
    const auto ends = endsAlong(this->Graph, normal.normalized());
    const Index cap = ends ? this->capOf(ends->second) : -1;
    if (cap >= 0)
    {
      this->addPair(source, static_cast<std::size_t>(cap));
    }
  }

  /// Pairs of caps, those with the better caps first; so few that measuring them takes no longer
  /// than the rest.
  void keepBestPairs()
  {
    std::stable_sort(this->Pairs.begin(), this->Pairs.end(), [&](CapPair a, CapPair b) {
      return scoreOfCaps(this->Caps[a.first], this->Caps[a.second]) >
        scoreOfCaps(this->Caps[b.first], this->Caps[b.second]);
    });
    constexpr Index PointsMeasured = 600000;
    const auto most = static_cast<std::size_t>(
      std::clamp<Index>(PointsMeasured / this->Graph.solid.points.rows(), 6, 60));
    if (this->Pairs.size() > most)
    {
      this->Pairs.resize(most);
      this->Cut = true;
    }
  }

  const std::vector<double>& distancesFromCap(std::size_t cap)
  {
    if (this->Distances[cap].empty())
    {
      this->Distances[cap] = this->Ways.from(this->Caps[cap]);
    }
    return this->Distances[cap];
  }

  /// Steps to the nearest face of the target over those to the farthest face of all.
  double remoteness(std::size_t source, std::size_t target)
  {
    const std::vector<Index>& steps = this->stepsFromCap(source);
    const Index most = *std::max_element(steps.begin(), steps.end());
    Index least = most;
    for (const std::size_t face : this->Caps[target].faces)
    {
      least = std::min(least, steps[face]);
    }
    return static_cast<double>(least) / static_cast<double>(most);
  }

  SweepCandidate judge(CapPair pair, bool sourceIsGiven)
  {
    if (!sourceIsGiven && isBetterSource(this->Caps[pair.second], this->Caps[pair.first]))
    {
      std::swap(pair.first, pair.second);
    }
    const CapCandidate& source = this->Caps[pair.first];
    const CapCandidate& target = this->Caps[pair.second];
    const SweepMeasure measure = measureSweep(this->Graph, source, target,
      this->distancesFromCap(pair.first), this->distancesFromCap(pair.second));
    SweepCandidate candidate;
    candidate.sourceFaceIds = source.faceIds;
    candidate.targetFaceIds = target.faceIds;
    candidate.score =
      scoreOfSweep(source, target, measure, this->remoteness(pair.first, pair.second));
    candidate.fits = sourceIsGiven || !measure.hasWideShoulder();
    candidate.reasons = describeSweep(source, target, measure);
    return candidate;
  }

  SweepCandidates ranked(bool sourceIsGiven)
  {
    this->keepBestPairs();
    SweepCandidates result;
    for (const CapPair& pair : this->Pairs)
    {
      result.list.push_back(this->judge(pair, sourceIsGiven));
    }
    std::stable_sort(
      result.list.begin(), result.list.end(), [](const SweepCandidate& a, const SweepCandidate& b) {
        return a.fits != b.fits ? a.fits : a.score > b.score;
      });
    if (!sourceIsGiven)
    {
      this->addRefused(result.list);
    }
    result.cut = this->Cut;
    return result;
  }

  /// The likeliest pairs of caps that do not fit, with the reason.
  void addRefused(std::vector<SweepCandidate>& list)
  {
    constexpr std::size_t Looked = 12;
    std::vector<std::size_t> caps(this->Caps.size());
    for (std::size_t i = 0; i < caps.size(); ++i)
    {
      caps[i] = i;
    }
    this->sortByLikelihood(caps);
    caps.resize(std::min(caps.size(), Looked));
    std::vector<CapPair> refused;
    for (std::size_t i = 0; i < caps.size(); ++i)
    {
      for (std::size_t j = i + 1; j < caps.size(); ++j)
      {
        const CapCandidate& first = this->Caps[caps[i]];
        const CapCandidate& second = this->Caps[caps[j]];
        if (areApart(first, second) && !capsFit(this->Graph, first, second))
        {
          refused.emplace_back(caps[i], caps[j]);
        }
      }
    }
    const auto weight = [&](const CapPair& pair) {
      return scoreOfCaps(this->Caps[pair.first], this->Caps[pair.second]) *
        std::sqrt(this->Caps[pair.first].area + this->Caps[pair.second].area);
    };
    std::stable_sort(refused.begin(), refused.end(),
      [&](const CapPair& a, const CapPair& b) { return weight(a) > weight(b); });
    refused.resize(std::min(refused.size(), MostRefused));
    for (const CapPair& pair : refused)
    {
      SweepCandidate candidate;
      candidate.sourceFaceIds = this->Caps[pair.first].faceIds;
      candidate.targetFaceIds = this->Caps[pair.second].faceIds;
      try
      {
        sweepBetween(this->Graph.solid, candidate.sourceFaceIds, candidate.targetFaceIds);
      }
      catch (const InvalidInput& error)
      {
        candidate.reasons = error.what();
        list.push_back(std::move(candidate));
      }
    }
  }

  FaceGraph Graph;
  RimDistances Ways;
  std::vector<CapCandidate> Caps;
  std::map<FaceSet, Index> Numbers;
  std::vector<std::vector<double>> Distances; // of each cap, empty: not asked for yet
  std::vector<std::vector<Index>> Steps;
  std::set<CapPair> Tried;
  std::vector<CapPair> Pairs; // that fit
  bool Cut = false;
};
}

std::string verdictOn(const SweepCandidate& candidate)
{
  return candidate.fits ? "fits" : candidate.score > 0.0 ? "poor" : "refused";
}

SweepCandidates findSweepCandidates(const SolidSurface& solid)
{
  return CandidateSearch(solid).findAll();
}

SweepCandidates findTargetCandidates(
  const SolidSurface& solid, const std::vector<Index>& sourceFaceIds)
{
  return CandidateSearch(solid).findTargets(sourceFaceIds);
}
}
