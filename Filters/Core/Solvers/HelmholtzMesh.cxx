// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/HelmholtzMesh.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
using Sparse = Eigen::SparseMatrix<double>;

/// Breadth-first from the given nodes; the Cuthill-McKee order of every level keeps rows short.
void numberByDistance(const Sparse& K, const std::vector<char>& isGiven, HelmholtzMesh& mesh)
{
  const Index n = K.rows();
  std::vector<char> reached(isGiven);
  std::vector<Index> front;
  const auto addNeighbours = [&](Index id) {
    for (Sparse::InnerIterator entry(K, id); entry; ++entry)
    {
      const Index other = entry.row();
      if (!reached[at(other)])
      {
        reached[at(other)] = 1;
        mesh.ids.push_back(other);
      }
    }
  };
  mesh.levels.push_back(0);
  for (Index i = 0; i < n; ++i)
  {
    if (isGiven[at(i)])
    {
      addNeighbours(i);
    }
  }
  while (mesh.levels.back() < mesh.size())
  {
    const Index begin = mesh.levels.back();
    const Index end = mesh.size();
    mesh.levels.push_back(end);
    for (Index i = begin; i < end; ++i)
    {
      addNeighbours(mesh.ids[at(i)]);
    }
  }
  for (Index i = 0; i < n; ++i)
  {
    if (!reached[at(i)])
    {
      mesh.ids.push_back(i);
    }
  }
  if (mesh.levels.back() < mesh.size())
  {
    mesh.levels.push_back(mesh.size());
  }
}

void add(double stiffness, double mass, MatrixPart& part)
{
  part.inDouble.stiffness.push_back(stiffness);
  part.inDouble.mass.push_back(mass);
  part.inSingle.stiffness.push_back(static_cast<float>(stiffness));
  part.inSingle.mass.push_back(static_cast<float>(mass));
}

MatrixPair<float> single(const MatrixPair<double>& pair)
{
  return { { pair.stiffness.begin(), pair.stiffness.end() },
    { pair.mass.begin(), pair.mass.end() } };
}

/// See HelmholtzMesh::decay.
void setDecay(const QuadLaplacian& laplacian, const std::vector<Index>& place, HelmholtzMesh& mesh)
{
  for (std::size_t l = 0; l + 1 < mesh.levels.size(); ++l)
  {
    const Index begin = mesh.levels[l];
    double mass = 0.0;
    double stiffness = 0.0;
    for (Index i = begin; i < mesh.levels[l + 1]; ++i)
    {
      const Index id = mesh.ids[at(i)];
      for (Sparse::InnerIterator entry(laplacian.mass, id); entry; ++entry)
      {
        mass += entry.value();
      }
      for (Sparse::InnerIterator entry(laplacian.stiffness, id); entry; ++entry)
      {
        stiffness -= place[at(entry.row())] < begin ? entry.value() : 0.0;
      }
    }
    mesh.decay.push_back(stiffness > 0.0 ? mass / stiffness : 0.0);
  }
}

template <typename Real>
HelmholtzSystem<Real> makeSystem(const HelmholtzMesh& mesh, const MatrixPair<Real>& lower,
  const MatrixPair<Real>& upper, const MatrixPair<Real>& diagonal, const MatrixPair<Real>& sums,
  Index n, const double* lambda)
{
  HelmholtzSystem<Real> system{ n, mesh.lower.begin.data(), mesh.lower.column.data(),
    lower.stiffness.data(), lower.mass.data(), mesh.upper.begin.data(), mesh.upper.column.data(),
    upper.stiffness.data(), upper.mass.data(), diagonal.stiffness.data(), diagonal.mass.data(),
    sums.stiffness.data(), sums.mass.data(), {} };
  for (int l = 0; l < LanesPerBatch; ++l)
  {
    system.lambda[l] = static_cast<Real>(lambda[l]);
  }
  return system;
}
}

HelmholtzSystem<double> HelmholtzMesh::system(Index n, const double* lambda) const
{
  return makeSystem(
    *this, this->lower.inDouble, this->upper.inDouble, this->diagonal, this->upperSums, n, lambda);
}

HelmholtzSystem<float> HelmholtzMesh::systemInSingle(Index n, const double* lambda) const
{
  return makeSystem(*this, this->lower.inSingle, this->upper.inSingle, this->diagonalInSingle,
    this->upperSumsInSingle, n, lambda);
}

HelmholtzMesh helmholtzMesh(const QuadLaplacian& laplacian, const std::vector<char>& isGiven)
{
  const Sparse& K = laplacian.stiffness;
  const Sparse& M = laplacian.mass;
  HelmholtzMesh mesh;
  numberByDistance(K, isGiven, mesh);
  // Free nodes by their number, given ones by -1 - their number; so given ones are below all.
  constexpr Index Unknown = -1;
  std::vector<Index> place(at(K.rows()), Unknown);
  for (Index i = 0; i < mesh.size(); ++i)
  {
    place[at(mesh.ids[at(i)])] = i;
  }
  setDecay(laplacian, place, mesh);

  std::vector<Index> numberOfGiven(at(K.rows()), Unknown);
  struct Entry
  {
    Index column;
    double stiffness;
    double mass;
  };
  std::vector<Entry> row;
  for (MatrixPart* part : { &mesh.lower, &mesh.upper, &mesh.coupling })
  {
    part->begin.assign(1, 0);
  }
  for (const Index id : mesh.ids)
  {
    row.clear();
    Sparse::InnerIterator mass(M, id);
    for (Sparse::InnerIterator entry(K, id); entry; ++entry, ++mass)
    {
      const Index other = entry.row();
      if (place[at(other)] >= 0)
      {
        row.push_back({ place[at(other)], entry.value(), mass.value() });
        continue;
      }
      Index& number = numberOfGiven[at(other)];
      if (number == Unknown)
      {
        number = static_cast<Index>(mesh.given.size());
        mesh.given.push_back(other);
      }
      mesh.coupling.column.push_back(static_cast<int>(number));
      add(entry.value(), mass.value(), mesh.coupling);
    }
    std::sort(
      row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.column < b.column; });
    double stiffnessSum = 0.0;
    double massSum = 0.0;
    for (const Entry& entry : row)
    {
      if (entry.column == place[at(id)])
      {
        mesh.diagonal.stiffness.push_back(entry.stiffness);
        mesh.diagonal.mass.push_back(entry.mass);
        continue;
      }
      const bool isLower = entry.column < place[at(id)];
      MatrixPart& part = isLower ? mesh.lower : mesh.upper;
      part.column.push_back(static_cast<int>(entry.column));
      add(entry.stiffness, entry.mass, part);
      stiffnessSum += isLower ? 0.0 : entry.stiffness;
      massSum += isLower ? 0.0 : entry.mass;
    }
    mesh.upperSums.stiffness.push_back(stiffnessSum);
    mesh.upperSums.mass.push_back(massSum);
    for (MatrixPart* part : { &mesh.lower, &mesh.upper, &mesh.coupling })
    {
      part->begin.push_back(static_cast<Index>(part->column.size()));
    }
  }
  mesh.diagonalInSingle = single(mesh.diagonal);
  mesh.upperSumsInSingle = single(mesh.upperSums);
  return mesh;
}
}
