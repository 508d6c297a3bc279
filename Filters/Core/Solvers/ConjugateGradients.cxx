// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/ConjugateGradients.h"

#include <Eigen/LU>

#include <numeric>

namespace hexsweep
{
namespace
{
/// For products with the matrix, and for sums of vectors, which are cheaper than a thread.
constexpr Index NodesAtOnce = 2048;
constexpr Index NodesOfVectors = 16384;

/// The matrix and what is wanted of it, two unknowns at a time.
class BlockSystem
{
public:
  BlockSystem(const SparseMatrix& matrix, const ParallelFor& parallelFor)
    : Matrix(matrix)
    , Threads(parallelFor)
    , Inverse(static_cast<std::size_t>(matrix.rows() / 2))
    , Partial(static_cast<std::size_t>((this->nodes() + NodesAtOnce - 1) / NodesAtOnce), 0.0)
  {
    this->forNodes(NodesAtOnce, [&](Index j) {
      Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
      for (int c = 0; c < 2; ++c)
      {
        for (SparseMatrix::InnerIterator it(this->Matrix, 2 * j + c); it; ++it)
        {
          if (it.row() / 2 == j)
          {
            block(it.row() % 2, c) = it.value();
          }
        }
      }
      this->Inverse[static_cast<std::size_t>(j)] = block.inverse();
      return 0.0;
    });
  }

  Index nodes() const { return this->Matrix.rows() / 2; }

  /// The sum of what the body returns for each node.
  template <typename Body>
  double forNodes(Index grain, const Body& body)
  {
    forPieces(this->Threads, this->nodes(), grain, [&](Index begin, Index end) {
      double sum = 0.0;
      for (Index j = begin; j < end; ++j)
      {
        sum += body(j);
      }
      this->Partial[static_cast<std::size_t>(begin / grain)] = sum;
    });
    const auto pieces = static_cast<std::ptrdiff_t>((this->nodes() + grain - 1) / grain);
    return std::accumulate(this->Partial.begin(), this->Partial.begin() + pieces, 0.0);
  }

  /// Two rows of the product; the matrix is symmetric, so that its columns will do.
  Eigen::Vector2d product(Index j, const Eigen::VectorXd& x) const
  {
    const int* outer = this->Matrix.outerIndexPtr();
    const int begin = outer[2 * j];
    const int size = outer[2 * j + 1] - begin;
    const int* rows = this->Matrix.innerIndexPtr() + begin;
    const double* first = this->Matrix.valuePtr() + begin;
    const double* second = this->Matrix.valuePtr() + outer[2 * j + 1];
    Eigen::Vector2d sum(0.0, 0.0);
    for (int k = 0; k < size; k += 2)
    {
      const double a = x[rows[k]];
      const double b = x[rows[k] + 1];
      sum[0] += first[k] * a + first[k + 1] * b;
      sum[1] += second[k] * a + second[k + 1] * b;
    }
    return sum;
  }

  Eigen::Vector2d precondition(Index j, const Eigen::Vector2d& residual) const
  {
    return this->Inverse[static_cast<std::size_t>(j)] * residual;
  }

private:
  const SparseMatrix& Matrix;
  const ParallelFor& Threads;
  std::vector<Eigen::Matrix2d> Inverse; // of the diagonal's blocks
  std::vector<double> Partial;          // sums
};
}

Eigen::VectorXd conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& b, int steps,
  double tolerance, const ParallelFor& parallelFor)
{
  BlockSystem system(matrix, parallelFor);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  Eigen::VectorXd residual = b;
  Eigen::VectorXd direction(b.size());
  Eigen::VectorXd image(b.size());
  const auto two = [](auto& vector, Index j) { return vector.template segment<2>(2 * j); };
  double square = system.forNodes(NodesOfVectors, [&](Index j) {
    two(direction, j) = system.precondition(j, two(residual, j));
    return two(direction, j).dot(two(residual, j));
  });
  const double enough = tolerance * tolerance * square;
  for (int step = 0; step < steps && square > enough; ++step)
  {
    const double curvature = system.forNodes(NodesAtOnce, [&](Index j) {
      two(image, j) = system.product(j, direction);
      return two(image, j).dot(two(direction, j));
    });
    if (!(curvature > 0.0))
    {
      break;
    }
    const double length = square / curvature;
    const double next = system.forNodes(NodesOfVectors, [&](Index j) {
      two(x, j) += length * two(direction, j);
      two(residual, j) -= length * two(image, j);
      // The image is no longer needed.
      two(image, j) = system.precondition(j, two(residual, j));
      return two(image, j).dot(two(residual, j));
    });
    const double turn = next / square;
    square = next;
    system.forNodes(NodesOfVectors, [&](Index j) {
      two(direction, j) = two(image, j) + turn * two(direction, j);
      return 0.0;
    });
  }
  return x;
}
}
