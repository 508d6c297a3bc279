// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepAssemblyText.h"

#include "HexSweepHexText.h"

#include "Core/Common/Errors.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
const char* const Advice =
  "set Size to a smaller length, or cut or move the faces there in the CAD "
  "system";

/// @return empty where all are good.
std::string describeHexes(const SweptVolume& volume)
{
  const VolumeHexes& hexes = volume.hexes;
  const HexQualitySummary summary = summarize(hexes.qualities);
  const JudgedHexes judged = { summary, hexes.hexes.rows(),
    [&](Index h) { return hexes.qualities[static_cast<std::size_t>(h)]; },
    [&](Index h) {
      HexCorners places;
      for (int c = 0; c < 8; ++c)
      {
        places.row(c) = hexes.points.row(hexes.hexes(h, c));
      }
      return places;
    } };
  if (summary.inverted + summary.degenerate > 0)
  {
    return describeInverted(judged, Advice);
  }
  return summary.undecided > 0 ? describeUndecided(judged, Advice) : std::string();
}
}

std::vector<std::string> describeVolumes(const AssemblySweep& sweep,
  const std::vector<AssemblyVolume>& volumes, const std::vector<std::string>& names)
{
  std::vector<std::string> sentences;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    const SweptVolume& volume = sweep.volumes[v];
    if (!volume.isMine)
    {
      continue;
    }
    // Of a body in pieces the first one says that it has none.
    if (!volume.problem.empty() && sweep.planned.bodyOf[v] == static_cast<Index>(v))
    {
      const Index whole = volumes[v].whole;
      const std::string& name =
        whole < 0 ? volumes[v].name : names[static_cast<std::size_t>(whole)];
      sentences.push_back(name + " has no hexahedra: " + volume.problem);
    }
    const std::string bad = volume.problem.empty() ? describeHexes(volume) : std::string();
    if (!bad.empty())
    {
      sentences.push_back(volumes[v].name + ": " + bad);
    }
  }
  return sentences;
}

void checkAnyHexes(const AssemblySweep& sweep, const std::vector<Index>& counts,
  const std::vector<std::string>& sentences)
{
  const auto volumes = static_cast<std::ptrdiff_t>(sweep.volumes.size());
  if (std::all_of(counts.end() - volumes, counts.end(), [](Index n) { return n == 0; }))
  {
    throw InvalidInput("no volume of the assembly has hexahedra; what each of them lacks is told "
                       "in a warning. " +
      (sentences.empty() ? std::string() : sentences.front()));
  }
}
}
