// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether data sets hold together, before anything is read from them. Private to the module.
 */
#ifndef HexSweepInputCheck_h
#define HexSweepInputCheck_h

#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace hexsweep
{
/// The name of its class, or "cell of type <number>".
std::string describeCellType(int type);

/**
 * VTK itself reads past the end of arrays that are shorter than a data set says, and of points that
 * its cells name and that are not there. So each data set is asked once: cells have points, corners
 * are points, as many as their type has, and attributes have a tuple for each point or cell.
 *
 * Costs one pass over the connectivity.
 *
 * @param data a data set, a collection of them, anything else, or nullptr.
 * @param what name for the error text, e.g. "input".
 * @throw InvalidInput naming the first cell or array that is wrong.
 */
void checkData(vtkDataObject* data, const std::string& what);

/// checkData() of all that is connected to an algorithm; without the arrays that a
/// vtkDataSetAlgorithm passes by, flags of ghosts aside.
void checkInputs(vtkAlgorithm* algorithm);
}

#endif
