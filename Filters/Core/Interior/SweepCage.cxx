// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweepCage.h"

#include "Core/Common/Errors.h"
#include "Core/Common/IdRange.h"

#include <algorithm>
#include <string>

namespace hexsweep
{
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
}
