// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweepInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Common/Stopwatch.h"
#include "Core/Hexahedra/HexMinimum.h"
#include "Core/Hexahedra/HexPolishing.h"
#include "Core/Hexahedra/LowHexes.h"
#include "Core/Interior/SweptBoxes.h"
#include "Core/Interior/SweptHexes.h"

#include <algorithm>
#include <optional>

namespace hexsweep
{
namespace
{
/// Of scaled Jacobians that are computed in different ways.
constexpr double Rounding = 1e-12;
/// A hundredth of bad hexahedra is as bad as a mean scaled Jacobian that is a tenth lower.
constexpr double WeightOfBad = 10.0;
/// Part of the hexahedra up to which bad ones are cured node by node before patches are untangled.
constexpr double FewBad = 0.01;
/// Part of the hexahedra, and their number, above which untangling takes longer than to make the
/// next start as well.
constexpr double ManyBad = 0.0002;
constexpr double LeastManyBad = 50.0;
/// Scaled Jacobian up to which whole patches are moved: more is seldom worth their time.
constexpr double Enough = 0.4;
/// Scaled Jacobian below which a mesh is no reason to leave its rivals untried.
constexpr double Poor = 0.1;
/// Of patches and of single nodes, at the most.
constexpr int Turns = 2;
constexpr const char* RaisedName = " + raised minimum";

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
  bool isBest = false; ///< InteriorStart::isBest

  /// Whether it is as good as the boundary allows.
  bool wantsNothing() const
  {
    return this->curable == 0 &&
      this->quality.minScaledJacobian >= (1.0 - Rounding) * this->fixed.floor;
  }
  /// Whether it is so far from what the boundary allows that a rival may well be better.
  bool isPoor() const
  {
    return this->fixed.floor > 0.0 &&
      this->quality.minScaledJacobian < std::min(Poor, 0.5 * this->fixed.floor);
  }
  /// As a start: the minimum can be raised later and few bad hexahedra cured, the mean grows
  /// hardly.
  double promise() const
  {
    const double bad = static_cast<double>(this->curable) /
      static_cast<double>(std::max<Index>(1, this->hexes.rows()));
    return this->quality.meanScaledJacobian + std::max(0.0, this->quality.minScaledJacobian) -
      WeightOfBad * bad;
  }
  bool betterThan(const Candidate& other) const
  {
    return quality.notCertified != other.quality.notCertified
      ? quality.notCertified < other.quality.notCertified
      : this->merit() > other.merit();
  }

private:
  /// Of the least scaled Jacobian the part of what the boundary allows, and the mean.
  double merit() const
  {
    const double floor = this->fixed.floor;
    const double least = this->quality.minScaledJacobian;
    return (floor > 0.0 ? std::min(1.0, least / floor) : least) + this->quality.meanScaledJacobian;
  }
};

class Cascade
{
public:
  Cascade(const SweepCage& cage, const InteriorOptions& options)
    : Cage(cage)
    , Options(options)
    , Fixed(fixedNodes(cage))
  {
  }

  /**
   * Makes a start and its rivals and betters them, the most promising first, until one has all that
   * the boundary allows. Where much is to be untangled in all of them those that would be next are
   * rivals, too. Of the others only those are looked at that are certified as they are, once there
   * is one without a hexahedron that can be cured and it is not poor.
   *
   * @param first moves on to the start that is next.
   * @param mustSucceed whether a failure of the first is the caller's to know.
   * @return whether there is such a one, or none is asked for.
   */
  bool tryRivals(const InteriorStart*& first, const InteriorStart* end, bool mustSucceed,
    const Progress& progress)
  {
    std::vector<Candidate> candidates =
      this->rivals(first, end, mustSucceed, progressPart(progress, 0.0, 0.5));
    const double width = 0.5 / static_cast<double>(std::max<std::size_t>(1, candidates.size()));
    double from = 0.5;
    bool done = false;
    for (Candidate& candidate : candidates)
    {
      const Progress part = progressPart(progress, from, from + width);
      from += width;
      if (done && candidate.curable > 0 && !this->Best->isPoor())
      {
        continue;
      }
      this->better(candidate, part);
      done = done || !this->Options.ensureValid || candidate.curable == 0;
      const bool isEnough = done && (candidate.isBest || candidate.wantsNothing());
      this->keepBetter(std::move(candidate));
      if (isEnough || !this->Options.ensureValid || !this->Options.persists)
      {
        return true;
      }
    }
    return done;
  }

  bool canBePolished() const
  {
    return !(this->Best->isBest && this->Best->quality.notCertified == 0);
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
    best.qualities = std::vector<HexQuality>(); // measured again in any case, and large
    PolishedHexes polished = polishHexes(best.points, best.hexes, this->Fixed,
      this->Options.polishingRounds, this->Options.parallelFor, progressPart(progress, 0.0, 0.95));
    std::swap(best.points, polished.points);
    this->measure(best, progressPart(progress, 0.95, 1.0));
    // What the polish lowers is a sum over corners; now and then the mean falls with it.
    if (best.quality.meanScaledJacobian < quality.meanScaledJacobian)
    {
      best.points = std::move(polished.points);
      this->measure(best, {});
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
    best.fixed = fixedCorners(best.points, best.hexes, this->Fixed, this->Options.parallelFor);
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
  /// Cures what can be cured, and raises the minimum where that is asked for.
  void better(Candidate& candidate, const Progress& progress)
  {
    if (this->Options.ensureValid && candidate.curable > 0)
    {
      this->cure(candidate, progressPart(progress, 0.0, 0.8));
    }
    if (this->Options.polishingRounds > 0 && candidate.curable == 0 && !candidate.isBest)
    {
      this->raiseMinimumOf(candidate, progressPart(progress, 0.8, 1.0));
    }
  }

  /// Up to what the boundary allows. Where not all are certified some may lose that on the way.
  void raiseMinimumOf(Candidate& candidate, const Progress& progress)
  {
    if (candidate.wantsNothing() || !(candidate.fixed.floor > 0.0))
    {
      return;
    }
    const Stopwatch watch;
    const Index before = candidate.quality.notCertified;
    candidate.qualities = std::vector<HexQuality>();
    const double wanted = (1.0 - Rounding) * candidate.fixed.floor;
    const Certificates certificates =
      candidate.curable > 0 ? Certificates::MayGo : Certificates::Stay;
    Points raised = raiseMinimum(candidate.points, candidate.hexes, this->Fixed, wanted,
      certificates, this->Options.parallelFor, progressPart(progress, 0.0, 0.3))
                      .points;
    if (certificates == Certificates::Stay)
    {
      raised = this->raiseByPatches(
        std::move(raised), candidate.hexes, wanted, progressPart(progress, 0.3, 0.8));
    }
    std::swap(candidate.points, raised);
    this->measure(candidate, progressPart(progress, 0.8, 0.9));
    if (candidate.quality.notCertified > before)
    {
      std::swap(candidate.points, raised);
      this->measure(candidate, progressPart(progress, 0.9, 1.0));
    }
    else if (candidate.method.find(RaisedName) == std::string::npos)
    {
      candidate.method += RaisedName;
    }
    this->finish(
      "Minimum", candidate.quality.notCertified, before - candidate.quality.notCertified, watch);
  }

  /// Patches and single nodes by turns, as the ones leave to the others what these are good at.
  Points raiseByPatches(
    Points&& start, const Hexes& hexes, double wanted, const Progress& progress) const
  {
    Points points = std::move(start);
    for (int turn = 0; turn < Turns; ++turn)
    {
      const double from = static_cast<double>(turn) / Turns;
      const double to = static_cast<double>(turn + 1) / Turns;
      const RaisedLowHexes low = raiseLowHexes(points, hexes, this->Fixed, std::min(wanted, Enough),
        this->Options.parallelFor, progressPart(progress, from, 0.5 * (from + to)));
      if (!(low.after > low.before))
      {
        break;
      }
      points = raiseMinimum(low.points, hexes, this->Fixed, wanted, Certificates::Stay,
        this->Options.parallelFor, progressPart(progress, 0.5 * (from + to), to))
                 .points;
    }
    return points;
  }

  void cure(Candidate& candidate, const Progress& progress)
  {
    if (static_cast<double>(candidate.curable) <=
      FewBad * static_cast<double>(candidate.hexes.rows()))
    {
      this->raiseMinimumOf(candidate, progressPart(progress, 0.0, 0.3));
    }
    if (candidate.curable > 0)
    {
      this->untangle(candidate, progressPart(progress, 0.3, 1.0));
    }
  }

  /// @param first moves on to the start that is next.
  std::vector<Candidate> rivals(const InteriorStart*& first, const InteriorStart* end,
    bool mustSucceed, const Progress& progress)
  {
    std::vector<Candidate> candidates;
    const auto isTangled = [](const Candidate& candidate) {
      return static_cast<double>(candidate.curable) >
        std::max(LeastManyBad, ManyBad * static_cast<double>(candidate.hexes.rows()));
    };
    const InteriorStart* const begin = first;
    const double width = 1.0 / static_cast<double>(end - begin);
    do
    {
      const double from = static_cast<double>(first - begin) * width;
      try
      {
        if (first == begin || !first->rivals || first->rivals(this->Cage))
        {
          candidates.push_back(this->start(*first, progressPart(progress, from, from + width)));
        }
      }
      catch (const SolverFailure&)
      {
        if (mustSucceed && first == begin)
        {
          throw;
        }
      }
      ++first;
    } while (first != end &&
      (first->rivals || std::all_of(candidates.begin(), candidates.end(), isTangled)));
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.promise() > b.promise(); });
    return candidates;
  }

  Candidate start(const InteriorStart& start, const Progress& progress)
  {
    const Stopwatch watch;
    Candidate candidate;
    candidate.points =
      start.method(this->Cage, progressPart(progress, 0.0, 0.8), this->Options.parallelFor);
    candidate.method = start.name;
    candidate.isBest = start.isBest;
    candidate.sourceIsBottom = hexsweep::sourceIsBottom(this->Cage.quads, candidate.points,
      this->Cage.boundary.numberOfLayers(), this->Options.parallelFor);
    if (this->Options.ensureValid || this->Options.polishingRounds > 0)
    {
      reportProgress(progress, 0.8);
      candidate.hexes = sweptHexes(this->Cage.quads, candidate.points,
        this->Cage.boundary.numberOfLayers(), this->Options.parallelFor);
      candidate.fixed =
        fixedCorners(candidate.points, candidate.hexes, this->Fixed, this->Options.parallelFor);
      reportProgress(progress, 0.85);
      this->measure(candidate, progressPart(progress, 0.85, 1.0));
    }
    this->finish(start.name, candidate.quality.notCertified, 0, watch);
    return candidate;
  }

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
constexpr double PolishingShare = 0.35;
/// Of that, where untangling and polish are repeated.
constexpr double RepeatedShare = 0.2;
constexpr int Repetitions = 2;
}

InteriorStart startAt(const std::string& name, const Points& points)
{
  return { name,
    [&points](const SweepCage&, const Progress&, const ParallelFor&) { return points; } };
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
  const InteriorStart* const begin = starts.data();
  const InteriorStart* const end = options.ensureValid ? begin + starts.size() : begin + 1;
  const double share = (1.0 - PolishingShare) / static_cast<double>(end - begin);
  bool done = false;
  for (const InteriorStart* next = begin; next != end && !done;)
  {
    done = cascade.tryRivals(next, end, next == begin,
      progressPart(progress, static_cast<double>(next - begin) * share, 1.0 - PolishingShare));
  }
  if (options.polishingRounds > 0 && cascade.canBePolished())
  {
    const double polishing = 1.0 - RoundingShare - PolishingShare;
    const double again = 1.0 - RoundingShare - RepeatedShare * PolishingShare;
    cascade.polish(progressPart(progress, polishing, again));
    cascade.tryAgain(options.ensureValid && options.persists ? Repetitions : 0,
      progressPart(progress, again, 1.0 - RoundingShare));
  }
  if (options.precision == Precision::Single)
  {
    cascade.round(progressPart(progress, 1.0 - RoundingShare, 1.0));
  }
  reportProgress(progress, 1.0);
  return std::move(cascade).result();
}
}
