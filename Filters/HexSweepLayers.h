// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The layers that a vtkLayeredSweepAlgorithm is asked for. Private to the module.
 */
#ifndef HexSweepLayers_h
#define HexSweepLayers_h

#include "Core/Linking/LinkingSides.h"

class vtkLayeredSweepAlgorithm;

namespace hexsweep
{
/// @param mayBeFree whether no layers at all may be asked for: the caller chooses them then.
/// @throw InvalidInput naming the property that is out of range.
LayerRequest requestedLayers(vtkLayeredSweepAlgorithm* filter, bool mayBeFree = false);
}

#endif
