// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweepInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Common/IdRange.h"
#include "Core/Common/Stopwatch.h"
#include "Core/Hexahedra/HexPolishing.h"
#include "Core/Interior/SweptBoxes.h"
#include "Core/Interior/SweptHexes.h"

#include <algorithm>
#include <optional>

namespace hexsweep
{
namespace
{
struct Candidate
{
  Points points;
  Hexes hexes;
  bool sourceIsBottom = true;
  HexQualitySummary quality;
  std::vector<HexQuality> qualities; ///< where they are to be kept
  /// Not certified although inner nodes could change it.
  Index curable = 0;
  FixedCorners fixed;
  std::string method;

  bool betterThan(const Candidate& other) const
  {
    return quality.notCertified != other.quality.notCertified
      ? quality.notCertified < other.quality.notCertified
      : quality.minScaledJacobian > other.quality.minScaledJacobian;
  }
};

std::vector<bool> fixedNodes(const SweepCage& cage)
{
  const Index n = cage.source.rows();
  const Index layers = cage.boundary.numberOfLayers();
  std::vector<bool> fixed(static_cast<std::size_t>((layers + 1) * n), false);
  std::fill(fixed.begin(), fixed.begin() + n, true);
  std::fill(fixed.end() - n, fixed.end(), true);
  for (Index k = 1; k < layers; ++k)
  {
    for (const Index i : cage.boundary.nodes)
    {
      fixed[static_cast<std::size_t>(k * n + i)] = true;
    }
  }
  return fixed;
}

/// @throw InvalidInput where the parts of a cage do not belong together.
void checkCage(const SweepCage& cage)
{
  const Index n = cage.source.rows();
  const SweepBoundary& boundary = cage.boundary;
  const Index layers = boundary.numberOfLayers();
  const Index nodes = static_cast<Index>(boundary.nodes.size());
  if (cage.target.rows() != n)
  {
    throw InvalidInput("the cage has " + std::to_string(n) + " source points and " +
      std::to_string(cage.target.rows()) + " target points. Give the same points on both caps.");
  }
  checkIds(cage.quads, n, "quad");
  if (layers < 1 || static_cast<Index>(boundary.fractions.size()) != layers + 1)
  {
    throw InvalidInput("the cage has " + std::to_string(boundary.rings.size()) + " rings and " +
      std::to_string(boundary.fractions.size()) +
      " fractions. Give one of each for every layer of nodes, the first on the source cap and the "
      "last on the target cap.");
  }
  for (const Points& ring : boundary.rings)
  {
    if (ring.rows() != nodes)
    {
      throw InvalidInput("a ring of the cage has " + std::to_string(ring.rows()) +
        " points, and there are " + std::to_string(nodes) +
        " loop nodes. Give the place of each loop node on each layer.");
    }
  }
  checkIds(Eigen::Map<const Faces>(boundary.nodes.data(), nodes, 1), n, "loop node");
}

class Cascade
{
public:
  Cascade(const SweepCage& cage, const InteriorOptions& options)
    : Cage(cage)
    , Options(options)
    , Fixed(fixedNodes(cage))
  {
  }

  Candidate start(const InteriorStart& start, const Progress& progress)
  {
    const Stopwatch watch;
    Candidate candidate;
    candidate.points =
      start.method(this->Cage, progressPart(progress, 0.0, 0.8), this->Options.parallelFor);
    candidate.method = start.name;
    candidate.sourceIsBottom = hexsweep::sourceIsBottom(this->Cage.quads, candidate.points,
      this->Cage.boundary.numberOfLayers(), this->Options.parallelFor);
    if (this->Options.ensureValid || this->Options.polishingRounds > 0)
    {
      reportProgress(progress, 0.8);
      candidate.hexes =
        sweptHexes(this->Cage.quads, candidate.points, this->Cage.boundary.numberOfLayers());
      candidate.fixed = fixedCorners(candidate.points, candidate.hexes, this->Fixed);
      reportProgress(progress, 0.85);
      this->measure(candidate, progressPart(progress, 0.85, 1.0));
    }
    this->finish(start.name, candidate.quality.notCertified, 0, watch);
    return candidate;
  }

  void untangle(
    Candidate& candidate, const Progress& progress, Precision precision = Precision::Double)
  {
    const Stopwatch watch;
    UntangledHexes untangled = untangleHexes(candidate.points, candidate.hexes,
      sweptBoxes(candidate.points, this->Cage.quads, this->Cage.boundary), this->Fixed,
      this->Options.parallelFor, progressPart(progress, 0.0, 0.9), precision);
    candidate.points = std::move(untangled.points);
    candidate.method += " + untangling";
    this->measure(candidate, progressPart(progress, 0.9, 1.0));
    this->finish("Untangling", untangled.after, untangled.before - untangled.after, watch);
  }

  void keepBetter(Candidate&& candidate)
  {
    if (!this->Best || candidate.betterThan(*this->Best))
    {
      this->Best = std::move(candidate);
    }
  }

  void polish(const Progress& progress)
  {
    const Stopwatch watch;
    Candidate& best = *this->Best;
    const HexQualitySummary quality = best.quality;
    const Index curable = best.curable;
    std::vector<HexQuality> qualities = std::move(best.qualities);
    PolishedHexes polished = polishHexes(best.points, best.hexes, this->Fixed,
      this->Options.polishingRounds, this->Options.parallelFor, progressPart(progress, 0.0, 0.95));
    std::swap(best.points, polished.points);
    this->measure(best, progressPart(progress, 0.95, 1.0));
    // What the polish lowers is a sum over corners; now and then the mean falls with it.
    if (best.quality.meanScaledJacobian < quality.meanScaledJacobian)
    {
      best.points = std::move(polished.points);
      best.quality = quality;
      best.qualities = std::move(qualities);
      best.curable = curable;
    }
    else
    {
      best.method += " + polish";
    }
    this->finish(
      "Polish", best.quality.notCertified, quality.notCertified - best.quality.notCertified, watch);
  }

  /// The polish moves what the untangling left: another one may get further.
  void tryAgain(int rounds, const Progress& progress)
  {
    for (int round = 0; round < rounds; ++round)
    {
      const Index before = this->Best->curable;
      const double from = static_cast<double>(round) / rounds;
      const double to = static_cast<double>(round + 1) / rounds;
      if (before > 0)
      {
        this->untangle(*this->Best, progressPart(progress, from, 0.5 * (from + to)));
      }
      if (this->Best->curable == before)
      {
        return;
      }
      this->polish(progressPart(progress, 0.5 * (from + to), to));
    }
  }

  void round(const Progress& progress)
  {
    const Stopwatch watch;
    Candidate& best = *this->Best;
    const Index before = best.quality.notCertified;
    best.points = stored(best.points, Precision::Single);
    if (best.hexes.rows() == 0) // nobody looks at them
    {
      return;
    }
    best.fixed = fixedCorners(best.points, best.hexes, this->Fixed);
    this->measure(best, progressPart(progress, 0.0, 0.1));
    this->finish("Rounding", best.quality.notCertified, before - best.quality.notCertified, watch);
    if (this->Options.ensureValid && best.curable > 0 && best.quality.notCertified > before)
    {
      this->untangle(best, progressPart(progress, 0.1, 1.0), Precision::Single);
    }
    this->LostByRounding = std::max<Index>(0, best.quality.notCertified - before);
  }

  SweepInterior result() &&
  {
    SweepInterior result;
    result.fixed = std::move(this->Best->fixed);
    result.points = std::move(this->Best->points);
    result.qualities = std::move(this->Best->qualities);
    result.sourceIsBottom = this->Best->sourceIsBottom;
    result.method = std::move(this->Best->method);
    result.steps = std::move(this->Steps);
    result.lostByRounding = this->LostByRounding;
    return result;
  }

private:
  void measure(Candidate& candidate, const Progress& progress) const
  {
    std::vector<HexQuality> qualities =
      hexQualities(candidate.points, candidate.hexes, true, this->Options.parallelFor, progress);
    candidate.quality = summarize(qualities);
    candidate.curable = 0;
    for (std::size_t h = 0; h < qualities.size(); ++h)
    {
      candidate.curable += qualities[h].validity != Validity::Certified &&
        !candidate.fixed.forbids(static_cast<Index>(h));
    }
    if (this->Options.keepQualities)
    {
      candidate.qualities = std::move(qualities);
    }
  }
  void finish(const std::string& name, Index notCertified, Index mended, const Stopwatch& watch)
  {
    this->Steps.push_back({ name, notCertified, mended, watch.seconds() });
  }

  const SweepCage& Cage;
  const InteriorOptions& Options;
  std::vector<bool> Fixed;
  std::optional<Candidate> Best;
  std::vector<InteriorStep> Steps;
  Index LostByRounding = 0;
};

constexpr double RoundingShare = 0.05;
constexpr double PolishingShare = 0.4;
/// Of that, where untangling and polish are repeated.
constexpr double RepeatedShare = 0.2;
constexpr int Repetitions = 2;
}

SweepInterior sweepInterior(const SweepCage& cage, const std::vector<InteriorStart>& starts,
  const InteriorOptions& options, const Progress& progress)
{
  if (starts.empty())
  {
    throw InvalidInput("there is no method for the interior. Give at least one start.");
  }
  checkCage(cage);
  Cascade cascade(cage, options);
  const double share =
    (1.0 - PolishingShare) / (options.ensureValid ? static_cast<double>(starts.size()) : 1.0);
  bool done = false;
  bool polish = options.polishingRounds > 0;
  for (std::size_t s = 0; s < starts.size() && !done; ++s)
  {
    const double from = static_cast<double>(s) * share;
    try
    {
      Candidate candidate =
        cascade.start(starts[s], progressPart(progress, from, from + 0.5 * share));
      if (options.ensureValid && candidate.curable > 0)
      {
        cascade.untangle(candidate, progressPart(progress, from + 0.5 * share, from + share));
      }
      done = !options.ensureValid || candidate.curable == 0;
      polish = polish && !(starts[s].isBest && candidate.quality.notCertified == 0);
      cascade.keepBetter(std::move(candidate));
    }
    catch (const SolverFailure&)
    {
      if (s == 0)
      {
        throw;
      }
    }
  }
  if (polish)
  {
    const double end = 1.0 - RoundingShare;
    const double again = end - RepeatedShare * PolishingShare;
    cascade.polish(progressPart(progress, 1.0 - PolishingShare, again));
    cascade.tryAgain(options.ensureValid ? Repetitions : 0, progressPart(progress, again, end));
  }
  if (options.precision == Precision::Single)
  {
    cascade.round(progressPart(progress, 1.0 - RoundingShare, 1.0));
  }
  reportProgress(progress, 1.0);
  return std::move(cascade).result();
}
}
