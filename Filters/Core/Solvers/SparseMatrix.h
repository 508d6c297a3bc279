// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sparse matrix type of all solvers.
 */
#ifndef hexsweep_SparseMatrix_h
#define hexsweep_SparseMatrix_h

#include <Eigen/SparseCore>

namespace hexsweep
{
using SparseMatrix = Eigen::SparseMatrix<double>;
}

#endif
