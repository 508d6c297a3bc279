// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Properties of filters that are lists, and their part of PrintSelf(). Private to the
 * module.
 */
#ifndef HexSweepLists_h
#define HexSweepLists_h

#include <vtkIndent.h>
#include <vtkObject.h>

#include <vector>

namespace hexsweep
{
template <typename Value>
void addToList(vtkObject* owner, std::vector<Value>& list, Value value)
{
  list.push_back(value);
  owner->Modified();
}

/// Leaves the modification time of an empty list as it is: ParaView clears lists before it fills
/// them.
template <typename Value>
void clearList(vtkObject* owner, std::vector<Value>& list)
{
  if (!list.empty())
  {
    list.clear();
    owner->Modified();
  }
}

template <typename Value>
void printList(ostream& os, vtkIndent indent, const char* name, const std::vector<Value>& list)
{
  os << indent << name << ":";
  for (const Value value : list)
  {
    os << " " << value;
  }
  os << "\n";
}
}

#endif
