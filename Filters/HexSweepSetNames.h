// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Names and ids of side sets and node sets. Private to the module.
 */
#ifndef HexSweepSetNames_h
#define HexSweepSetNames_h

#include <vtkType.h>

#include <string>
#include <utility>
#include <vector>

class vtkStringArray;

namespace hexsweep
{
/// What a side set and the node set with the same nodes are called.
struct SetName
{
  std::string name;       ///< the set itself: of the face, or its part in the sweep
  vtkIdType id = 0;       ///< of the side set, from 1 on
  vtkIdType nodesId = 0;  ///< of the node set
  std::string sidesBlock; ///< of the side set as a block, see below
  std::string nodesBlock; ///< of the node set as a block
};

/// Ids that the user has chosen, by name.
using ChosenIds = std::vector<std::pair<std::string, vtkIdType>>;

/**
 * Names for a set a face, in their order, then for the parts.
 *
 * A face has its name in `faceNames` (nullptr: none has one), or "Face" and its id; faces of one
 * name have their ids behind it. Ids are chosen, else those of the faces, else (where one of these
 * does not fit) counted from 1 on; parts follow on from the greatest. vtkExodusIIWriter takes the
 * id of a set from the name of its block: that of a named face is its name and " ID:" with the id.
 *
 * @throw InvalidInput where a chosen name is none of a set, or an id is out of range or taken
 * twice.
 */
std::vector<SetName> nameSets(const std::vector<vtkIdType>& faces, vtkStringArray* faceNames,
  const std::vector<std::string>& parts, const ChosenIds& chosen);
}

#endif
