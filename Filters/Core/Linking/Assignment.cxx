// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/Assignment.h"

#include <limits>

namespace hexsweep
{
std::vector<Index> leastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost)
{
  const Index n = cost.rows();
  std::vector<Index> rowOf(static_cast<std::size_t>(n), -1);
  Eigen::VectorXd rowPotential = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd columnPotential = Eigen::VectorXd::Zero(n);
  for (Index row = 0; row < n; ++row)
  {
    // A shortest path from the row to a free column, over columns already given away.
    Eigen::VectorXd distance =
      Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
    std::vector<Index> previous(static_cast<std::size_t>(n), -1);
    std::vector<bool> settled(static_cast<std::size_t>(n), false);
    Index from = row;
    Index column = -1;
    double reached = 0.0;
    for (;;)
    {
      Index nearest = -1;
      for (Index j = 0; j < n; ++j)
      {
        if (settled[static_cast<std::size_t>(j)])
        {
          continue;
        }
        const double through = reached + cost(from, j) - rowPotential[from] - columnPotential[j];
        if (through < distance[j])
        {
          distance[j] = through;
          previous[static_cast<std::size_t>(j)] = column;
        }
        if (nearest < 0 || distance[j] < distance[nearest])
        {
          nearest = j;
        }
      }
      column = nearest;
      reached = distance[column];
      if (rowOf[static_cast<std::size_t>(column)] < 0)
      {
        break;
      }
      settled[static_cast<std::size_t>(column)] = true;
      from = rowOf[static_cast<std::size_t>(column)];
    }
    rowPotential[row] += reached;
    for (Index j = 0; j < n; ++j)
    {
      if (settled[static_cast<std::size_t>(j)])
      {
        rowPotential[rowOf[static_cast<std::size_t>(j)]] += reached - distance[j];
        columnPotential[j] -= reached - distance[j];
      }
    }
    while (column >= 0)
    {
      const Index before = previous[static_cast<std::size_t>(column)];
      rowOf[static_cast<std::size_t>(column)] =
        before < 0 ? row : rowOf[static_cast<std::size_t>(before)];
      column = before;
    }
  }
  std::vector<Index> columnOf(static_cast<std::size_t>(n));
  for (Index j = 0; j < n; ++j)
  {
    columnOf[static_cast<std::size_t>(rowOf[static_cast<std::size_t>(j)])] = j;
  }
  return columnOf;
}
}
