// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The harmonic map of a disk that fills a hole (paper section 3.1.2, steps 3 and 4).
 */
#ifndef hexsweep_DiskFill_h
#define hexsweep_DiskFill_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * The energy of the harmonic function that fills a round disk, as a form of its boundary values.
 *
 * The boundary values are linear in the angle between the nodes. Their harmonic extension into the
 * disk, or to the outside of it, has the Dirichlet integral
 *   -1/pi  integral integral g'(s) g'(t) log |2 sin((s - t) / 2)| ds dt
 * (J. Douglas \cite Douglas1931, integrated by parts), which is summed in closed form. No node
 * inside the disk is needed.
 *
 * @param angles m >= 3 angles of the nodes in radians, strictly monotone, less than one turn.
 * @return m x m, symmetric, positive semidefinite, rows sum to zero; g^T A g is the energy of
 *         equation (2): twice the Dirichlet integral.
 */
Eigen::MatrixXd diskFillEnergy(const std::vector<double>& angles);
}

#endif
