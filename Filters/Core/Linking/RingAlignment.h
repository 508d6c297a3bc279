// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rings of all linking sides that make sections of the sweep which are like the source.
 */
#ifndef hexsweep_RingAlignment_h
#define hexsweep_RingAlignment_h

#include "Core/Linking/LinkingSideColumns.h"

#include <deque>

namespace hexsweep
{
/**
 * Has rings lie across the sweep where that makes the sides' quads far squarer.
 *
 * Where a pipe is bent here and straight there, columns on the inside of the bend are shorter than
 * others: at equal fractions of their lengths rings lean, behind the bend as well. Heights of the
 * strip do not. The heights of the other sides are such that their rings lie in the planes of those
 * of the side with the longest loop, as they do at the caps. Taken for all sides or none, and only
 * where sections are no less like the source for it.
 */
void levelRingsWhereBetter(std::deque<LinkingSideColumns>& sides);

/**
 * Has columns share rings by length where that makes sections more like the source: where the
 * least-squares affine maps of the source's rings to those of the sections leave far less of a
 * misfit, of all sides together.
 */
void shareRingsWhereBetter(std::deque<LinkingSideColumns>& sides);
}

#endif
