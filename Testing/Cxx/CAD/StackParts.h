// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts with caps at many heights along one direction, made with the CAD kernel.
 */
#ifndef StackParts_h
#define StackParts_h

#include <TopoDS_Shape.hxx>

#include <string>

namespace stackparts
{
/**
 * A base (rectangle, rounded rectangle, disk, L) with two to six bosses, pockets, holes and
 * counterbores, some tangent or nearly so to each other or to the base, some bosses with tilted or
 * domed tops. The same seed gives the same part, one solid, some tens of millimetres large.
 */
TopoDS_Shape randomStack(unsigned int seed);

/// Five steps with a through bore and a keyway that is open to one end of its step.
TopoDS_Shape steppedShaft();

/// A plate with nx times ny counterbored holes (or plain ones), 10 apart.
TopoDS_Shape drilledPlate(int nx, int ny, bool counterbored);

/// A pipe along an arc with a flange at one end and a thick middle.
TopoDS_Shape steppedBend();

/// A plate with a boss and a pocket, round and square, whose walls lean by some degrees.
TopoDS_Shape drafted(double degrees);

/// A block with a bore across it. A block with a rounded edge between cap and side.
TopoDS_Shape crossBored();
TopoDS_Shape filleted();
}

#endif
