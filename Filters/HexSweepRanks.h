// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What ranks tell each other. Private to the module.
 */
#ifndef HexSweepRanks_h
#define HexSweepRanks_h

#include "Core/Common/Mesh.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;
class vtkMultiProcessController;

namespace hexsweep
{
/// The ranks of the global controller; one where there is none.
class Ranks
{
public:
  Ranks();

  int rank() const { return this->Rank; }
  int count() const { return this->Count; }

  /// What the first rank has of data, with cells, by blocks where it is a collection; elsewhere
  /// than there the argument does not matter. nullptr where it has none. Every rank must call it.
  vtkSmartPointer<vtkDataObject> ofFirst(vtkDataObject* data) const;

  /// The greatest value of all ranks, number by number. Every rank must call it.
  std::vector<Index> greatest(std::vector<Index> values) const;

private:
  vtkSmartPointer<vtkDataObject> broadcast(vtkDataObject* data) const;

  vtkMultiProcessController* Controller;
  int Rank = 0;
  int Count = 1;
};
}

#endif
