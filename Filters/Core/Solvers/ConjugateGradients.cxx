// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/ConjugateGradients.h"

#include <Eigen/Cholesky>

#include <numeric>

namespace hexsweep
{
namespace
{
/// For products with the matrix, and for sums of vectors, which are cheaper than a thread.
constexpr Index NodesAtOnce = 2048;
constexpr Index NodesOfVectors = 16384;

/// Of a positive definite block, however near to singular it is: Eigen's closed form of small
/// inverses has a determinant of any sign there, and with it a direction that does not descend. Of
/// another block what scales alike.
template <typename Block>
Block inverseOfBlock(const Block& block)
{
  const Eigen::LLT<Block> factor(block);
  if (factor.info() == Eigen::Success)
  {
    return factor.solve(Block::Identity());
  }
  const double size = block.cwiseAbs().maxCoeff();
  return size > 0.0 ? Block(Block::Identity() / size) : Block(Block::Identity());
}

/// The matrix and what is wanted of it, the unknowns of a node at a time.
template <int Width>
class BlockSystem
{
public:
  using Block = Eigen::Matrix<double, Width, Width>;
  using Unknowns = Eigen::Matrix<double, Width, 1>;

  BlockSystem(const SparseMatrix& matrix, const ParallelFor& parallelFor)
    : Matrix(matrix)
    , Threads(parallelFor)
    , Inverse(static_cast<std::size_t>(matrix.rows() / Width))
    , Partial(static_cast<std::size_t>((this->nodes() + NodesAtOnce - 1) / NodesAtOnce), 0.0)
  {
    this->forNodes(NodesAtOnce, [&](Index j) {
      Block block = Block::Zero();
      for (int c = 0; c < Width; ++c)
      {
        for (SparseMatrix::InnerIterator it(this->Matrix, Width * j + c); it; ++it)
        {
          if (it.row() / Width == j)
          {
            block(it.row() % Width, c) = it.value();
          }
        }
      }
      this->Inverse[static_cast<std::size_t>(j)] = inverseOfBlock(block);
      return 0.0;
    });
  }

  Index nodes() const { return this->Matrix.rows() / Width; }

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

  /// A node's rows of the product; the matrix is symmetric, so that its columns will do.
  Unknowns product(Index j, const Eigen::VectorXd& x) const
  {
    const int* outer = this->Matrix.outerIndexPtr() + Width * j;
    const int size = outer[1] - outer[0];
    const int* rows = this->Matrix.innerIndexPtr() + outer[0];
    const double* columns[Width];
    for (int c = 0; c < Width; ++c)
    {
      columns[c] = this->Matrix.valuePtr() + outer[c];
    }
    Unknowns sum = Unknowns::Zero();
    for (int k = 0; k < size; k += Width)
    {
      const double* const values = x.data() + rows[k];
      for (int c = 0; c < Width; ++c)
      {
        double part = columns[c][k] * values[0];
        for (int r = 1; r < Width; ++r)
        {
          part += columns[c][k + r] * values[r];
        }
        sum[c] += part;
      }
    }
    return sum;
  }

  Unknowns precondition(Index j, const Unknowns& residual) const
  {
    return this->Inverse[static_cast<std::size_t>(j)] * residual;
  }

private:
  const SparseMatrix& Matrix;
  const ParallelFor& Threads;
  std::vector<Block> Inverse;  // of the diagonal's blocks
  std::vector<double> Partial; // sums
};

template <int Width>
Eigen::VectorXd iterate(const SparseMatrix& matrix, const Eigen::VectorXd& b, int steps,
  double tolerance, const ParallelFor& parallelFor)
{
  BlockSystem<Width> system(matrix, parallelFor);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  Eigen::VectorXd residual = b;
  Eigen::VectorXd direction(b.size());
  Eigen::VectorXd image(b.size());
  const auto at = [](auto& vector, Index j) { return vector.template segment<Width>(Width * j); };
  double square = system.forNodes(NodesOfVectors, [&](Index j) {
    at(direction, j) = system.precondition(j, at(residual, j));
    return at(direction, j).dot(at(residual, j));
  });
  const double enough = tolerance * tolerance * square;
  for (int step = 0; step < steps && square > enough; ++step)
  {
    const double curvature = system.forNodes(NodesAtOnce, [&](Index j) {
      at(image, j) = system.product(j, direction);
      return at(image, j).dot(at(direction, j));
    });
    if (!(curvature > 0.0))
    {
      break;
    }
    const double length = square / curvature;
    const double next = system.forNodes(NodesOfVectors, [&](Index j) {
      at(x, j) += length * at(direction, j);
      at(residual, j) -= length * at(image, j);
      // The image is no longer needed.
      at(image, j) = system.precondition(j, at(residual, j));
      return at(image, j).dot(at(residual, j));
    });
    const double turn = next / square;
    square = next;
    system.forNodes(NodesOfVectors, [&](Index j) {
      at(direction, j) = at(image, j) + turn * at(direction, j);
      return 0.0;
    });
  }
  return x;
}
}

Eigen::VectorXd conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& b,
  NodeUnknowns unknowns, int steps, double tolerance, const ParallelFor& parallelFor)
{
  return unknowns == NodeUnknowns::Two ? iterate<2>(matrix, b, steps, tolerance, parallelFor)
                                       : iterate<3>(matrix, b, steps, tolerance, parallelFor);
}
}
