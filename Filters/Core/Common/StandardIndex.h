// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_StandardIndex_h
#define hexsweep_StandardIndex_h

#include "Core/Common/Mesh.h"

#include <cstddef>

namespace hexsweep
{
/// An id as the containers of the standard library take it.
inline std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}
}

#endif
