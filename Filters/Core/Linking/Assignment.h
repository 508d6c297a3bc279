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
 * with potentials (H. W. Kuhn, "The Hungarian method for the assignment problem", Naval Research
 * Logistics Quarterly 2, 1955; the O(n^3) form of N. Tomizawa, Networks 1, 1971).
 *
 * @param cost n x n, finite.
 */
std::vector<Index> leastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost);
}

#endif
