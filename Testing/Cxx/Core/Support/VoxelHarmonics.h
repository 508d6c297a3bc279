// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic coordinates on a voxel grid, as section 4.3 of Cai and Tautges (2013) computes
 * them (after Joshi, Meyer, DeRose, Green, Sanocki, "Harmonic Coordinates for Character
 * Articulation", 2007): the reference that the prism solver is compared with.
 */
#ifndef VoxelHarmonics_h
#define VoxelHarmonics_h

#include "Core/Common/Mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace test
{
/// Steps 1 to 6 of section 4.3, one function each. A cell's value belongs to its centre.
class VoxelHarmonics
{
public:
  using Index = hexsweep::Index;
  /// Values of three harmonic functions.
  using Values = Eigen::RowVector3d;

  enum class Tag : unsigned char
  {
    Untyped,
    Boundary,
    Interior,
    Exterior
  };

  /// @param cells number of cells along the longest side of the cage's box.
  /// @param onVertices values at the cage vertices, linear in between.
  /// @param start values to begin with in the interior; zero if empty.
  VoxelHarmonics(const hexsweep::PointsRef& cage, const hexsweep::TrianglesRef& triangles,
    Index cells, const hexsweep::PointsRef& onVertices,
    const std::function<Values(const Eigen::RowVector3d&)>& start)
  {
    this->allocate(cage, cells);
    this->scanConvert(cage, triangles, onVertices);
    this->floodExterior();
    this->fillInterior(start);
    this->smooth();
  }

  /// Trilinear between the centres of the cells; the point must be well inside the grid.
  Values at(const Eigen::RowVector3d& point) const
  {
    const Eigen::RowVector3d place = (point - this->Origin) / this->Step;
    const Eigen::RowVector3d corner = (place.array() - 0.5).floor();
    const Eigen::RowVector3d t = place.array() - 0.5 - corner.array();
    Values sum = Values::Zero();
    for (int c = 0; c < 8; ++c)
    {
      double weight = 1.0;
      Eigen::Matrix<Index, 1, 3> cell;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int bit = c >> axis & 1;
        cell[axis] = static_cast<Index>(corner[axis]) + bit;
        weight *= bit ? t[axis] : 1.0 - t[axis];
      }
      sum += weight * this->CellValues[this->idOf(cell)];
    }
    return sum;
  }

  Index count(Tag tag) const { return std::count(this->Tags.begin(), this->Tags.end(), tag); }
  double step() const { return this->Step; }

private:
  std::size_t idOf(const Eigen::Matrix<Index, 1, 3>& cell) const
  {
    return static_cast<std::size_t>((cell[2] * this->Size[1] + cell[1]) * this->Size[0] + cell[0]);
  }

  Eigen::RowVector3d centerOf(const Eigen::Matrix<Index, 1, 3>& cell) const
  {
    return this->Origin + this->Step * (cell.cast<double>().array() + 0.5).matrix();
  }

  /// Steps 1 and 2: a grid that encloses the cage with two cells to spare, all of it untyped.
  void allocate(const hexsweep::PointsRef& cage, Index cells)
  {
    const Eigen::RowVector3d low = cage.colwise().minCoeff();
    const Eigen::RowVector3d extent = cage.colwise().maxCoeff() - low;
    this->Step = extent.maxCoeff() / static_cast<double>(cells);
    this->Origin = low.array() - 2 * this->Step;
    this->Size = (extent / this->Step).array().ceil().cast<Index>() + 4;
    const auto total = static_cast<std::size_t>(this->Size.prod());
    this->Tags.assign(total, Tag::Untyped);
    this->CellValues.assign(total, Values::Zero());
  }

  /// Step 3: the cells that a triangle passes take its values at the place next to their centre.
  void scanConvert(const hexsweep::PointsRef& cage, const hexsweep::TrianglesRef& triangles,
    const hexsweep::PointsRef& onVertices)
  {
    std::vector<double> nearest(this->Tags.size(), std::numeric_limits<double>::max());
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      Eigen::Matrix3d corners;
      Eigen::Matrix3d values;
      double longest = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        corners.row(c) = cage.row(triangles(t, c));
        values.row(c) = onVertices.row(triangles(t, c));
        longest = std::max(
          longest, (cage.row(triangles(t, c)) - cage.row(triangles(t, (c + 1) % 3))).norm());
      }
      // Close enough to leave no gap through which the exterior could pass from cell to cell.
      const Index samples = static_cast<Index>(std::ceil(6 * longest / this->Step));
      for (Index i = 0; i <= samples; ++i)
      {
        for (Index j = 0; i + j <= samples; ++j)
        {
          const Eigen::RowVector3d weights =
            Eigen::RowVector3d(static_cast<double>(i), static_cast<double>(j),
              static_cast<double>(samples - i - j)) /
            static_cast<double>(samples);
          const Eigen::RowVector3d place = weights * corners;
          const Eigen::Matrix<Index, 1, 3> cell =
            ((place - this->Origin) / this->Step).array().floor().cast<Index>();
          const std::size_t id = this->idOf(cell);
          const double distance = (place - this->centerOf(cell)).squaredNorm();
          this->Tags[id] = Tag::Boundary;
          if (distance < nearest[id])
          {
            nearest[id] = distance;
            this->CellValues[id] = weights * values;
          }
        }
      }
    }
  }

  /// Step 4: from a corner cell, across the faces of cells.
  void floodExterior()
  {
    std::vector<Eigen::Matrix<Index, 1, 3>> open = { { 0, 0, 0 } };
    this->Tags[0] = Tag::Exterior;
    while (!open.empty())
    {
      const Eigen::Matrix<Index, 1, 3> cell = open.back();
      open.pop_back();
      for (int face = 0; face < 6; ++face)
      {
        Eigen::Matrix<Index, 1, 3> next = cell;
        next[face / 2] += face % 2 ? 1 : -1;
        const bool outside = next.minCoeff() < 0 || (next.array() >= this->Size.array()).any();
        if (!outside && this->Tags[this->idOf(next)] == Tag::Untyped)
        {
          this->Tags[this->idOf(next)] = Tag::Exterior;
          open.push_back(next);
        }
      }
    }
  }

  /// Step 5: what is left is the interior.
  void fillInterior(const std::function<Values(const Eigen::RowVector3d&)>& start)
  {
    for (Index z = 0; z < this->Size[2]; ++z)
    {
      for (Index y = 0; y < this->Size[1]; ++y)
      {
        for (Index x = 0; x < this->Size[0]; ++x)
        {
          const Eigen::Matrix<Index, 1, 3> cell(x, y, z);
          const std::size_t id = this->idOf(cell);
          if (this->Tags[id] == Tag::Untyped)
          {
            this->Tags[id] = Tag::Interior;
            this->CellValues[id] = start ? start(this->centerOf(cell)) : Values::Zero();
          }
        }
      }
    }
  }

  /// Step 6: each interior cell takes the mean of its six neighbours, until nothing changes.
  /// Over-relaxed: going past the mean takes hundreds of rounds to the same end, not ten thousands.
  void smooth()
  {
    std::vector<std::size_t> interior;
    for (std::size_t id = 0; id < this->Tags.size(); ++id)
    {
      if (this->Tags[id] == Tag::Interior)
      {
        interior.push_back(id);
      }
    }
    const std::size_t row = static_cast<std::size_t>(this->Size[0]);
    const std::size_t slice = row * static_cast<std::size_t>(this->Size[1]);
    const double past = 2.0 / (1.0 + std::sin(std::acos(-1.0) / static_cast<double>(row)));
    double change = 1.0;
    while (change > 1e-8)
    {
      change = 0.0;
      for (const std::size_t id : interior)
      {
        const auto& v = this->CellValues;
        const Values mean =
          (v[id - 1] + v[id + 1] + v[id - row] + v[id + row] + v[id - slice] + v[id + slice]) / 6;
        const Values step = past * (mean - v[id]);
        change = std::max(change, step.cwiseAbs().maxCoeff());
        this->CellValues[id] += step;
      }
    }
  }

  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Step = 1.0;
  Eigen::Matrix<Index, 1, 3> Size = Eigen::Matrix<Index, 1, 3>::Zero();
  std::vector<Tag> Tags;
  std::vector<Values> CellValues;
};
}

#endif
