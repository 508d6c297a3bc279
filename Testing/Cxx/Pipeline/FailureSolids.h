// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solids of Data/failures whose caps were not found once, and what is right.
 */
#ifndef FailureSolids_h
#define FailureSolids_h

#include "SolidGrids.h"

namespace test
{
struct FailureSolid
{
  const char* name; ///< folder in Data/failures
  std::vector<vtkIdType> source;
  std::vector<vtkIdType> target;
  vtkIdType layers;
};

inline void PrintTo(const FailureSolid& solid, std::ostream* os)
{
  *os << solid.name;
}

/// Prisms, pipes and shells whose caps are split, filleted or one of many faces that fit.
inline const std::vector<FailureSolid>& solidsOfHiddenCaps()
{
  static const std::vector<FailureSolid> solids = {
    { "part_of_split_target_taken/f13", { 135, 136, 137 }, { 138, 139 }, 4 },
    { "part_of_split_target_taken/f8", { 38, 39 }, { 81, 82 }, 4 },
    { "part_of_split_target_taken/g18", { 2, 6 }, { 4, 9 }, 4 },
    { "target_ambiguous/c1", { 2 }, { 21 }, 20 },
    { "target_ambiguous/f9", { 61, 62, 63 }, { 38 }, 11 },
    { "target_ambiguous/g20", { 2, 6 }, { 4, 8 }, 2 },
    { "split_target_with_filleted_cap_not_found/f10", { 17, 18 }, { 24, 25 }, 6 },
  };
  return solids;
}

inline Grid failureGrid(const std::string& name)
{
  return readGrid("../failures/" + name + "/solid");
}
}

#endif
