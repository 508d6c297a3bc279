// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What filters tell the user about bad hexahedra, in the same words. Private to the module.
 */
#ifndef HexSweepHexText_h
#define HexSweepHexText_h

#include "Core/Hexahedra/HexQuality.h"

#include <functional>
#include <string>

namespace hexsweep
{
/// Hexahedra with their verdicts, wherever they are stored.
struct JudgedHexes
{
  HexQualitySummary summary;
  /// Their numbers are [0, count).
  Index count;
  /// NotJudged for what is not to be named.
  std::function<HexQuality(Index)> quality;
  std::function<HexCorners(Index)> corners;
};

/**
 * How many hexahedra are inverted or degenerate and where the first ten are, or that all of them
 * are inside out.
 *
 * @param advice what to do, after a verb: "move their points".
 */
std::string describeInverted(const JudgedHexes& hexes, const std::string& advice);

/// The same of those that are Undecided.
std::string describeUndecided(const JudgedHexes& hexes, const std::string& advice);
}

#endif
