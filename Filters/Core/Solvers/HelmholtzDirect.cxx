// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/HelmholtzDirect.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <cmath>

namespace hexsweep
{
namespace
{
/// All entries 1. Both triangles are stored, so that rows are columns.
SparseMatrix patternOf(const HelmholtzMesh& mesh)
{
  const Index n = mesh.size();
  SparseMatrix pattern(n, n);
  pattern.reserve(static_cast<Index>(mesh.lower.column.size() + mesh.upper.column.size()) + n);
  for (Index i = 0; i < n; ++i)
  {
    pattern.startVec(i);
    const auto addPart = [&](const MatrixPart& part) {
      for (Index e = part.begin[at(i)]; e < part.begin[at(i + 1)]; ++e)
      {
        pattern.insertBack(part.column[at(e)], i) = 1.0;
      }
    };
    addPart(mesh.lower);
    pattern.insertBack(i, i) = 1.0;
    addPart(mesh.upper);
  }
  pattern.finalize();
  return pattern;
}
}

HelmholtzDirectSolver::HelmholtzDirectSolver(const HelmholtzMesh& mesh)
  : Mesh(&mesh)
  , Matrix(patternOf(mesh))
  , Factor(Matrix, MultifrontalSolver::Kind::Cholesky)
{
}

void HelmholtzDirectSolver::setMatrix(double lambda)
{
  const HelmholtzMesh& mesh = *this->Mesh;
  double* value = this->Matrix.valuePtr();
  for (Index i = 0; i < mesh.size(); ++i)
  {
    const auto addPart = [&](const MatrixPart& part) {
      for (Index e = part.begin[at(i)]; e < part.begin[at(i + 1)]; ++e)
      {
        *value++ = part.inDouble.stiffness[at(e)] + lambda * part.inDouble.mass[at(e)];
      }
    };
    addPart(mesh.lower);
    *value++ = mesh.diagonal.stiffness[at(i)] + lambda * mesh.diagonal.mass[at(i)];
    addPart(mesh.upper);
  }
}

Points HelmholtzDirectSolver::solve(double lambda, const Points& load, double tolerance)
{
  constexpr int RoundsAllowed = 8;
  this->setMatrix(lambda);
  this->Factor.factorize(this->Matrix);
  const Eigen::VectorXd diagonal = this->Matrix.diagonal();
  const double target = tolerance * std::sqrt(diagonal.mean());
  Points x = Points::Zero(load.rows(), 3);
  Points residual = load;
  for (int round = 0; round < RoundsAllowed; ++round)
  {
    x += this->Factor.solve(residual);
    residual = load - this->Matrix * x;
    const double left = std::sqrt(
      (residual.array().square().colwise() / diagonal.array()).colwise().sum().maxCoeff());
    if (left <= target)
    {
      return x;
    }
    if (!std::isfinite(left))
    {
      break;
    }
  }
  throw SolverFailure("the prism's Laplace equation could not be solved: the target quads may be "
                      "collapsed.");
}
}
