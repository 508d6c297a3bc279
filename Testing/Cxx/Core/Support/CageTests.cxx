// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CageTests.h"

namespace test
{
CageModels modelsOf(const Sweep& sweep)
{
  CageModels models;
  models.boundary = boundaryOf(sweep);
  models.physical =
    hexsweep::physicalModel(sweep.source, sweep.target, sweep.quads, models.boundary);
  models.cageQuads = hexsweep::cageQuads(sweep.quads, models.physical, sweep.numberOfLayers);
  models.model = hexsweep::topologicalModel(sweep.target, models.cageQuads, models.boundary);
  models.cage = hexsweep::triangulateCage(models.cageQuads, models.physical, models.model);
  return models;
}

Sweep turnedOver(Sweep sweep)
{
  sweep.quads = sweep.quads.rowwise().reverse().eval();
  return sweep;
}

std::vector<Index> insideRows(const Sweep& sweep)
{
  const auto boundary = boundaryOf(sweep);
  const Index n = sweep.source.rows();
  std::vector<Index> rows;
  for (Index row = n; row < sweep.numberOfLayers * n; ++row)
  {
    if (std::find(boundary.nodes.begin(), boundary.nodes.end(), row % n) == boundary.nodes.end())
    {
      rows.push_back(row);
    }
  }
  return rows;
}

Points rowsOf(const Points& points, const std::vector<Index>& rows)
{
  Points picked(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    picked.row(static_cast<Index>(i)) = points.row(rows[i]);
  }
  return picked;
}

Eigen::RowVector3d straightAffineMotion(double x, double y, double t)
{
  Eigen::Matrix3d shape;
  shape << 1.3, 0.4, 0.7, -0.2, 0.8, -0.3, 0.1, 0.2, 2.1;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.3, 1, 0.2).normalized()).toRotationMatrix();
  return (turn * shape * Eigen::Vector3d(x, y, t)).transpose() + Eigen::RowVector3d(3, -1, 2);
}

}
