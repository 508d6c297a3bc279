// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexDescent.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/FoldoverFreeEnergy.h"
#include "Core/Solvers/ConjugateGradients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int MaximumBacktracks = 25;
constexpr double SufficientDecrease = 1e-4;
/// Added to the diagonal, relative to its mean: directions that no term sees stay put.
constexpr double Damping = 1e-6;
/// Shape counts, size hardly, as for the quads.
constexpr double VolumeWeight = 1.0 / 128.0;
constexpr double StepTolerance = 1e-2; // see conjugateGradients()
constexpr int MostIterations = 300;

/// The trilinear shape functions' derivatives at one place, for the nodes that count there.
struct Sample
{
  int count = 0;
  int node[8];
  Eigen::Vector3d slope[8];
};

constexpr int CornerPlace[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

/// @param place in [0, 1]^3.
Sample sampleAt(const Eigen::Vector3d& place)
{
  Sample sample;
  for (int i = 0; i < 8; ++i)
  {
    Eigen::Vector3d value;
    Eigen::Vector3d sign;
    for (int a = 0; a < 3; ++a)
    {
      value[a] = CornerPlace[i][a] ? place[a] : 1.0 - place[a];
      sign[a] = CornerPlace[i][a] ? 1.0 : -1.0;
    }
    const Eigen::Vector3d slope(
      sign[0] * value[1] * value[2], sign[1] * value[0] * value[2], sign[2] * value[0] * value[1]);
    if (!slope.isZero(0.0))
    {
      sample.node[sample.count] = i;
      sample.slope[sample.count++] = slope;
    }
  }
  return sample;
}

std::vector<Sample> samplesOf(HexSamples where)
{
  std::vector<Sample> samples;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        const bool corner = i != 1 && j != 1 && k != 1;
        if (corner || where == HexSamples::Lattice)
        {
          samples.push_back(sampleAt(0.5 * Eigen::Vector3d(i, j, k)));
        }
      }
    }
  }
  return samples;
}

using Corners = Eigen::Matrix<double, 8, 3>;
}

/// Where each hexahedron's blocks go in the Hessian of the free nodes, three unknowns a node.
struct HexDescent::System
{
  Hexes Cells;
  HexBoxes InverseBoxes;
  std::vector<Index> FreeNodes;
  Eigen::Matrix<int, Eigen::Dynamic, 8, Eigen::RowMajor> Variables; // free node or -1
  SparseMatrix Hessian;
  /// 64 a hexahedron: value index of the first entry of each block, or -1. The three columns of a
  /// block are ColumnLength of its variable apart.
  std::vector<int> Slots;
  std::vector<int> ColumnLength;

  System(const HexesRef& hexes, const HexBoxes& boxes, const std::vector<bool>& free)
    : Cells(hexes)
    , InverseBoxes(boxes.cwiseInverse())
  {
    this->numberVariables(free);
    const NeighborLists neighbors = this->neighborVariables();
    this->setPattern(neighbors);
    this->findSlots(neighbors);
  }

  Corners corners(const Points& points, Index h) const
  {
    Corners x;
    for (int i = 0; i < 8; ++i)
    {
      x.row(i) = points.row(this->Cells(h, i));
    }
    return x;
  }

  Eigen::Matrix3d jacobian(const Corners& x, const Sample& sample, Index h) const
  {
    Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
    for (int i = 0; i < sample.count; ++i)
    {
      j += x.row(sample.node[i]).transpose() * sample.slope[i].transpose();
    }
    return j * this->InverseBoxes.row(h).asDiagonal();
  }

  double value(const Points& points, const std::vector<Sample>& samples, double epsilon) const
  {
    double sum = 0.0;
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      const Corners x = this->corners(points, h);
      for (const Sample& sample : samples)
      {
        sum += distortionValue<3>(this->jacobian(x, sample, h), epsilon, VolumeWeight);
      }
    }
    return sum;
  }

  double leastDeterminant(const Points& points, const std::vector<Sample>& samples) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      const Corners x = this->corners(points, h);
      for (const Sample& sample : samples)
      {
        bool movable = false;
        for (int i = 0; i < sample.count; ++i)
        {
          movable = movable || this->Variables(h, sample.node[i]) >= 0;
        }
        if (movable)
        {
          least = std::min(least, this->jacobian(x, sample, h).determinant());
        }
      }
    }
    return least;
  }

  /// Fills the Hessian; returns the value and the gradient.
  std::pair<double, Eigen::VectorXd> assemble(
    const Points& points, const std::vector<Sample>& samples, double epsilon)
  {
    double sum = 0.0;
    Eigen::VectorXd gradient =
      Eigen::VectorXd::Zero(3 * static_cast<Index>(this->FreeNodes.size()));
    double* values = this->Hessian.valuePtr();
    std::fill(values, values + this->Hessian.nonZeros(), 0.0);
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      const Corners x = this->corners(points, h);
      for (const Sample& sample : samples)
      {
        const Distortion<3> d = distortion<3>(this->jacobian(x, sample, h), epsilon, VolumeWeight);
        sum += d.value;
        Eigen::Vector3d slope[8];
        for (int i = 0; i < sample.count; ++i)
        {
          slope[i] = sample.slope[i].cwiseProduct(this->InverseBoxes.row(h).transpose());
        }
        for (int j = 0; j < sample.count; ++j)
        {
          const int variable = this->Variables(h, sample.node[j]);
          if (variable < 0)
          {
            continue;
          }
          gradient.segment<3>(3 * variable) += d.gradient * slope[j];
          Eigen::Matrix<double, 9, 3> half;
          half.noalias() = slope[j][0] * d.curvature.middleCols<3>(0);
          half.noalias() += slope[j][1] * d.curvature.middleCols<3>(3);
          half.noalias() += slope[j][2] * d.curvature.middleCols<3>(6);
          for (int i = 0; i < sample.count; ++i)
          {
            const int slot =
              this->Slots[static_cast<std::size_t>(64 * h + 8 * sample.node[i] + sample.node[j])];
            if (slot < 0)
            {
              continue;
            }
            const Eigen::Matrix3d block = slope[i][0] * half.middleRows<3>(0) +
              slope[i][1] * half.middleRows<3>(3) + slope[i][2] * half.middleRows<3>(6);
            const int stride = this->ColumnLength[static_cast<std::size_t>(variable)];
            for (int c = 0; c < 3; ++c)
            {
              for (int r = 0; r < 3; ++r)
              {
                values[slot + c * stride + r] += block(r, c);
              }
            }
          }
        }
      }
    }
    const Eigen::VectorXd diagonal = this->Hessian.diagonal();
    const double shift = Damping * diagonal.mean();
    for (Index i = 0; i < diagonal.size(); ++i)
    {
      this->Hessian.coeffRef(i, i) += shift;
    }
    return { sum, gradient };
  }

  /// Newton's step.
  Eigen::VectorXd step(const Eigen::VectorXd& gradient) const
  {
    return conjugateGradients(
      this->Hessian, -gradient, NodeUnknowns::Three, MostIterations, StepTolerance);
  }

  Points moved(const Points& points, const Eigen::VectorXd& move, double length) const
  {
    Points next = points;
    for (std::size_t k = 0; k < this->FreeNodes.size(); ++k)
    {
      next.row(this->FreeNodes[k]) +=
        length * move.segment<3>(3 * static_cast<Index>(k)).transpose();
    }
    return next;
  }

private:
  using NeighborLists = std::vector<std::vector<int>>; // rising

  void numberVariables(const std::vector<bool>& free)
  {
    std::vector<Index>& nodes = this->FreeNodes;
    for (Index i = 0; i < this->Cells.size(); ++i)
    {
      if (free[static_cast<std::size_t>(this->Cells.data()[i])])
      {
        nodes.push_back(this->Cells.data()[i]);
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    this->Variables.resize(this->Cells.rows(), 8);
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      for (int i = 0; i < 8; ++i)
      {
        const auto found = std::lower_bound(nodes.begin(), nodes.end(), this->Cells(h, i));
        this->Variables(h, i) = found != nodes.end() && *found == this->Cells(h, i)
          ? static_cast<int>(found - nodes.begin())
          : -1;
      }
    }
  }

  /// For each free node those that share a hexahedron with it, itself among them.
  NeighborLists neighborVariables() const
  {
    NeighborLists neighbors(this->FreeNodes.size());
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      for (int j = 0; j < 8; ++j)
      {
        for (int i = 0; i < 8 && this->Variables(h, j) >= 0; ++i)
        {
          if (this->Variables(h, i) >= 0)
          {
            neighbors[static_cast<std::size_t>(this->Variables(h, j))].push_back(
              this->Variables(h, i));
          }
        }
      }
    }
    for (std::vector<int>& list : neighbors)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return neighbors;
  }

  void setPattern(const NeighborLists& neighbors)
  {
    const int n = static_cast<int>(neighbors.size());
    Eigen::VectorXi lengths(3 * n);
    for (int j = 0; j < n; ++j)
    {
      const int length = 3 * static_cast<int>(neighbors[static_cast<std::size_t>(j)].size());
      lengths.segment<3>(3 * j).setConstant(length);
      this->ColumnLength.push_back(length);
    }
    this->Hessian.resize(3 * n, 3 * n);
    this->Hessian.reserve(lengths);
    for (int j = 0; j < 3 * n; ++j)
    {
      for (const int i : neighbors[static_cast<std::size_t>(j / 3)])
      {
        for (int r = 0; r < 3; ++r)
        {
          this->Hessian.insert(3 * i + r, j) = 0.0;
        }
      }
    }
    if (n > 0) // of a matrix without columns Eigen 3.4 reads the length of the first
    {
      this->Hessian.makeCompressed();
    }
  }

  void findSlots(const NeighborLists& neighbors)
  {
    this->Slots.assign(static_cast<std::size_t>(64 * this->Cells.rows()), -1);
    for (Index h = 0; h < this->Cells.rows(); ++h)
    {
      for (int i = 0; i < 8; ++i)
      {
        for (int j = 0; j < 8; ++j)
        {
          const int row = this->Variables(h, i);
          const int column = this->Variables(h, j);
          if (row >= 0 && column >= 0)
          {
            const std::vector<int>& list = neighbors[static_cast<std::size_t>(column)];
            this->Slots[static_cast<std::size_t>(64 * h + 8 * i + j)] =
              this->Hessian.outerIndexPtr()[3 * column] +
              3 * static_cast<int>(std::lower_bound(list.begin(), list.end(), row) - list.begin());
          }
        }
      }
    }
  }
};

HexDescent::HexDescent(const HexesRef& hexes, const HexBoxes& boxes, const std::vector<bool>& free)
  : Equations(std::make_unique<System>(hexes, boxes, free))
{
}

HexDescent::~HexDescent() = default;

bool HexDescent::hasFreeNodes() const
{
  return !this->Equations->FreeNodes.empty();
}

HexDescent::Result HexDescent::descend(const Points& points, HexSamples where, double epsilon,
  int steps, double relativeDecrease, const Progress& progress) const
{
  System& system = *this->Equations;
  const std::vector<Sample> samples = samplesOf(where);
  auto [value, gradient] = system.assemble(points, samples, epsilon);
  Result result{ points, value, value, 0.0, 0 };
  for (int step = 0; step < steps && gradient.squaredNorm() > 0.0; ++step)
  {
    reportProgress(progress, static_cast<double>(step) / static_cast<double>(steps));
    const Eigen::VectorXd move = system.step(gradient);
    ++result.steps;
    const double slope = move.dot(gradient);
    if (!move.allFinite() || !(slope < 0.0))
    {
      break;
    }
    double length = 1.0;
    std::optional<Points> next;
    double nextValue = value;
    for (int backtrack = 0; backtrack < MaximumBacktracks && !next; ++backtrack, length *= 0.5)
    {
      Points candidate = system.moved(result.points, move, length);
      nextValue = system.value(candidate, samples, epsilon);
      if (std::isfinite(nextValue) && nextValue <= value + SufficientDecrease * length * slope)
      {
        next = std::move(candidate);
      }
    }
    if (!next)
    {
      break;
    }
    const bool settled = value - nextValue <= relativeDecrease * std::abs(value);
    result.points = *std::move(next);
    value = nextValue;
    if (settled || step + 1 == steps)
    {
      break;
    }
    gradient = system.assemble(result.points, samples, epsilon).second;
  }
  result.after = value;
  result.leastDeterminant = system.leastDeterminant(result.points, samples);
  return result;
}
}
