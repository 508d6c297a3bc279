// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes of one linking side by ring and column.
 */
#ifndef hexsweep_RingTable_h
#define hexsweep_RingTable_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Row k, column j: linking point id of the node of ring k on the column of node j of the loop.
using RingTable = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
}

#endif
