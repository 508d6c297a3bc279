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

Motion cubesMotion(int nx, int layers)
{
  return [=](double x, double y, double t) {
    // The cap's bumps are smaller than half a step.
    const double step = 2.0 / nx;
    return Eigen::RowVector3d(
      step * std::round(x / step), step * std::round(y / step), step * layers * t);
  };
}

void expectCageMethod(Interior interior)
{
  Sweep sweep = makeSweep(12, 9, true, evenLayers(6), bendingMotion);
  const Index n = sweep.source.rows();
  const auto boundary = boundaryOf(sweep);
  const auto run = [&](
                     const hexsweep::ParallelFor& parallelFor, const hexsweep::Progress& progress) {
    return interior({ sweep.source, sweep.target, sweep.quads, boundary }, progress, parallelFor);
  };
  const Points swept = run({}, {});
  EXPECT_TRUE(swept.allFinite());
  EXPECT_EQ(swept.topRows(n), sweep.source);
  EXPECT_EQ(swept.bottomRows(n), sweep.target);
  for (Index k = 0; k <= 6; ++k)
  {
    for (const Index id : boundary.nodes)
    {
      EXPECT_EQ(swept.row(k * n + id), sweep.layers.row(k * n + id));
    }
  }

  const hexsweep::ParallelFor backwards = [](Index count, const std::function<void(Index)>& call) {
    for (Index i = count; i-- > 0;)
    {
      call(i);
    }
  };
  EXPECT_EQ(run(backwards, {}), swept);

  double last = -1.0;
  int reports = 0;
  run({}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++reports > 0;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_THROW(run({}, [](double fraction) { return fraction == 0.0; }), hexsweep::Aborted);

  sweep.source.conservativeResize(n + 1, 3);
  sweep.target.conservativeResize(n + 1, 3);
  sweep.source.row(n) << 10, 20, 30;
  sweep.target.row(n) << 14, 20, 34;
  const Points withUnused = run({}, {});
  for (Index k = 0; k <= 6; ++k)
  {
    const double t = boundary.fractions[static_cast<std::size_t>(k)];
    const Eigen::RowVector3d expected(10 + 4 * t, 20, 30 + 4 * t);
    EXPECT_LT((withUnused.row(k * (n + 1) + n) - expected).norm(), 1e-12);
    EXPECT_EQ(withUnused.middleRows(k * (n + 1), n), swept.middleRows(k * n, n));
  }

  // An upright step across both caps: the model slides along itself there, and points inside lie
  // on its faces.
  const Sweep stair = makeSweep(12, 6, false, evenLayers(4), [](double x, double y, double t) {
    const Eigen::RowVector3d grid = cubesMotion(12, 4)(x, y, t);
    const double side = grid.x() < 0.6 ? 0.0 : 1.0;
    return Eigen::RowVector3d(grid + side * Eigen::RowVector3d(-1.0 / 6, 0, 0.5));
  });
  EXPECT_TRUE(interior(cageOf(stair), {}, {}).allFinite());

  const Sweep oneLayer = makeSweep(6, 5, false, evenLayers(1), bendingMotion);
  EXPECT_EQ(interior(cageOf(oneLayer), {}, {}), oneLayer.layers);
}
}
