// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sheets of nodes between the layers of a stack, in an order that all its regions share.
 */
#ifndef hexsweep_StackLevels_h
#define hexsweep_StackLevels_h

#include "Core/Stacks/StackArrangement.h"

namespace hexsweep
{
/**
 * A level is a sheet that one or more caps lie on; in regions where it is no cap it runs on through
 * the material. Levels have their ranks for numbers: of two in one region the lower one is below.
 */
struct StackLevels
{
  Index count = 0;
  /// One a region: the levels of its caps, as StackArrangement::stacks.
  std::vector<std::vector<Index>> ofCaps;
  /// One a region and interval of material: its levels, rising, those of its two caps included.
  std::vector<std::vector<std::vector<Index>>> intervals;
};

/**
 * Orders the caps of all regions, and leads each level through all material that it meets.
 *
 * Caps on both sides of a border between regions are one level where they have the same height
 * all along it. Flat caps of one height are one level, and so are those that are nearer than `join`
 * and share no point.
 *
 * Afterwards two regions that touch have the same levels wherever both have material: a mesh of
 * columns between them conforms.
 *
 * @param slack height up to which caps count as equal where their borders were moved, over the
 *              caps' slope.
 * @throw InvalidInput where two caps change their order along a border, or run out into each other.
 */
StackLevels orderLevels(const StackArrangement& arrangement, const CapLikeFaces& faces,
  const CapHeights& heights, double slack, double join);
}

#endif
