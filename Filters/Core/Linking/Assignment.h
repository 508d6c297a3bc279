// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The assignment problem: n things to n places at least total cost.
 */
#ifndef hexsweep_Assignment_h
#define hexsweep_Assignment_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Column of each row in the assignment with the least sum of costs, by shortest augmenting paths
 * with potentials (the Hungarian method \cite Kuhn1955, in the O(n^3) form of N. Tomizawa
 * \cite Tomizawa1971).
 *
 * @param cost n x n, finite.
 */
std::vector<Index> leastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost);
}

#endif
