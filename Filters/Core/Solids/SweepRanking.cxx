// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepRanking.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Solids/SolidMessages.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hexsweep
{
namespace
{
constexpr double Straight = 1e-3;

double ratio(double a, double b)
{
  return std::min(a, b) / std::max(a, b);
}

double compactness(const CapCandidate& cap)
{
  return cap.area / (cap.perimeter * cap.perimeter);
}

double likeness(const CapCandidate& a, const CapCandidate& b)
{
  constexpr double Gentle = 0.25; // caps of 16 times the area count half
  return std::pow(ratio(a.area, b.area) * ratio(compactness(a), compactness(b)), Gentle) *
    (1.0 - 0.5 * std::abs(a.flatness - b.flatness));
}

/// Height over the width of the caps.
double slenderness(
  const CapCandidate& source, const CapCandidate& target, const SweepMeasure& measure)
{
  return measure.height / std::sqrt(0.5 * (source.area + target.area));
}

double lengthFactor(double slenderness)
{
  return 1.0 / (1.0 + 0.05 * std::log1p(slenderness));
}

double turningFactor(double turning)
{
  return 1.0 / (1.0 + 0.5 * turning);
}

double leaningFactor(double leaning)
{
  return 0.7 + 0.3 * std::exp(-10.0 * leaning);
}

double shoulderFactor(const SweepMeasure& measure)
{
  return 1.0 / (1.0 + 2.0 * measure.shoulderShare);
}

double degrees(double sine)
{
  return std::round(std::asin(std::min(1.0, sine)) * 180.0 / Pi);
}
}

double scoreOfCaps(const CapCandidate& first, const CapCandidate& second)
{
  const auto suits = [](const CapCandidate& cap) {
    return cap.upright * cap.smooth * 0.5 * (1.0 + cap.flatness);
  };
  return suits(first) * suits(second) * likeness(first, second);
}

double scoreOfSweep(const CapCandidate& source, const CapCandidate& target,
  const SweepMeasure& measure, double remoteness)
{
  return scoreOfCaps(source, target) * turningFactor(measure.turning) *
    leaningFactor(measure.leaning) * lengthFactor(slenderness(source, target, measure)) *
    std::pow(std::max(1e-3, measure.leastShare), 0.25) * (0.8 + 0.2 * remoteness) *
    shoulderFactor(measure);
}

std::string describeSweep(
  const CapCandidate& source, const CapCandidate& target, const SweepMeasure& measure)
{
  constexpr double Notable = 0.9;
  std::vector<std::pair<double, std::string>> words;
  const auto add = [&](double factor, const std::string& text) {
    if (factor < Notable)
    {
      words.emplace_back(factor, text);
    }
  };
  if (!measure.shoulders.empty())
  {
    add(0.0,
      listFaces(measure.shoulders) + (measure.shoulders.size() == 1 ? " runs" : " run") +
        " across the sweep all round (a shoulder of " +
        describe(std::round(100.0 * measure.shoulderShare)) + " % of the cap)");
  }
  for (const CapCandidate* cap : { &source, &target })
  {
    const bool one = cap->faces.size() == 1;
    add(cap->upright,
      listFaces(cap->faceIds) + (one ? " meets its" : " meet their") + " sides at about " +
        describe(degrees(cap->upright)) + " degrees on average");
    add(cap->smooth, listFaces(cap->faceIds) + (one ? " is" : " are") + " bent within");
  }
  add(turningFactor(measure.turning),
    "sharp edges run across the layers" +
      (measure.turningFaces.empty() ? std::string() : ", at " + listFaces(measure.turningFaces)));
  add(likeness(source, target),
    "the caps differ in area (" + describe(std::round(100.0 * ratio(source.area, target.area))) +
      " %), shape or flatness");
  add(leaningFactor(measure.leaning), "the sides do not lie along one direction");
  const double slender = slenderness(source, target, measure);
  add(lengthFactor(slender),
    "the way is " + describe(std::round(10.0 * slender) / 10.0) +
      " times as long as the caps are wide");
  add(std::pow(measure.leastShare, 0.25),
    "columns differ in length (the shortest has " +
      describe(std::round(100.0 * measure.leastShare)) + " % of the longest)");
  if (words.empty())
  {
    return measure.leaning < Straight && measure.turning < Straight && !measure.isTurned
      ? "straight prism"
      : "good caps and sides";
  }
  std::stable_sort(
    words.begin(), words.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& word : words)
  {
    text += (text.empty() ? "" : "; ") + word.second;
  }
  return text;
}

bool isBetterSource(const CapCandidate& first, const CapCandidate& second)
{
  if (first.corners != second.corners)
  {
    return first.corners < second.corners;
  }
  if (first.faces.size() != second.faces.size())
  {
    return first.faces.size() > second.faces.size();
  }
  constexpr double Alike = 1.0 + 1e-6;
  if (ratio(first.area, second.area) * Alike < 1.0)
  {
    return first.area > second.area;
  }
  return first.faces < second.faces;
}
}
