// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CGAL's discrete conformal map with a circular border, as the peer of our disk map.
 *
 * CGAL's Surface_mesh_parameterization is GPL: a program that includes this may not be passed on
 * under the licence of this project.
 */
#ifndef CgalDiskMap_h
#define CgalDiskMap_h

#include "Core/Common/Mesh.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <Eigen/SparseCholesky>

#include <memory>
#include <stdexcept>
#include <vector>

namespace test
{
/**
 * Solver traits for CGAL: Eigen's SimplicialLDLT.
 *
 * CGAL keeps the nodes of the border in the system, as rows of the unit matrix, which makes it
 * unsymmetric; SimplicialLDLT would read half of it and give a wrong map without a word. Here the
 * border goes to the right-hand side first.
 *
 * @tparam KeepFactor keep the factor for the second right-hand side; CGAL's own traits factorise
 *         again.
 */
template <bool KeepFactor>
class BorderLdlt
{
public:
  using NT = double;
  using Vector = CGAL::Eigen_vector<double>;
  using Matrix = CGAL::Eigen_sparse_matrix<double>;

  bool linear_solver(const Matrix& matrix, const Vector& right, Vector& unknowns, double& divisor)
  {
    divisor = 1.0;
    const auto& full = matrix.eigen_object();
    if (!KeepFactor || &matrix != this->Factorised)
    {
      this->factorise(full);
      this->Factorised = &matrix;
    }
    if (this->Solver->info() != Eigen::Success)
    {
      return false;
    }
    Eigen::VectorXd known = Eigen::VectorXd::Zero(full.rows());
    for (Eigen::Index i = 0; i < full.rows(); ++i)
    {
      known[i] = this->Inner[static_cast<std::size_t>(i)] < 0 ? right[i] : 0.0;
    }
    const Eigen::VectorXd pull = full * known;
    Eigen::VectorXd reduced(this->Solver->rows());
    for (Eigen::Index i = 0; i < full.rows(); ++i)
    {
      if (this->Inner[static_cast<std::size_t>(i)] >= 0)
      {
        reduced[this->Inner[static_cast<std::size_t>(i)]] = right[i] - pull[i];
      }
    }
    const Eigen::VectorXd solved = this->Solver->solve(reduced);
    for (Eigen::Index i = 0; i < full.rows(); ++i)
    {
      const Eigen::Index inner = this->Inner[static_cast<std::size_t>(i)];
      unknowns[i] = inner < 0 ? right[i] : solved[inner];
    }
    return true;
  }

private:
  template <typename SparseMatrix>
  void factorise(const SparseMatrix& full)
  {
    // Both ways of storing the matrix have one entry where a row of the unit matrix is.
    std::vector<Eigen::Index> entries(static_cast<std::size_t>(full.rows()), 0);
    const auto forEach = [&full](auto visit) {
      for (Eigen::Index outer = 0; outer < full.outerSize(); ++outer)
      {
        for (typename SparseMatrix::InnerIterator entry(full, outer); entry; ++entry)
        {
          visit(entry);
        }
      }
    };
    forEach([&](const auto& entry) { ++entries[static_cast<std::size_t>(entry.row())]; });
    this->Inner.assign(entries.size(), -1);
    Eigen::Index inner = 0;
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      if (entries[i] > 1)
      {
        this->Inner[i] = inner++;
      }
    }
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(static_cast<std::size_t>(full.nonZeros()));
    forEach([&](const auto& entry) {
      const Eigen::Index row = this->Inner[static_cast<std::size_t>(entry.row())];
      const Eigen::Index column = this->Inner[static_cast<std::size_t>(entry.col())];
      if (row >= 0 && column >= 0 && row >= column)
      {
        triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), entry.value());
      }
    });
    Eigen::SparseMatrix<double> reduced(inner, inner);
    reduced.setFromTriplets(triplets.begin(), triplets.end());
    this->Solver->compute(reduced);
  }

  const Matrix* Factorised = nullptr;
  std::vector<Eigen::Index> Inner; // number among the inner nodes, or -1
  // Shared: CGAL copies its traits.
  std::shared_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> Solver =
    std::make_shared<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>();
};

/// The mesh in CGAL's own structure, built beforehand; parameterize() is what is to be timed.
class CgalDiskMap
{
public:
  explicit CgalDiskMap(const hexsweep::TriangleMesh& mesh)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for (hexsweep::Index i = 0; i < mesh.points.rows(); ++i)
    {
      vertices.push_back(this->Surface.add_vertex(
        Kernel::Point_3(mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2))));
    }
    const auto vertex = [&](hexsweep::Index t, hexsweep::Index c) {
      return vertices[static_cast<std::size_t>(mesh.triangles(t, c))];
    };
    for (hexsweep::Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      this->Surface.add_face(vertex(t, 0), vertex(t, 1), vertex(t, 2));
    }
    this->Border = CGAL::Polygon_mesh_processing::longest_border(this->Surface).first;
    this->Places =
      this->Surface.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  }

  /// @tparam SolverTraits CGAL::Default: what CGAL uses by itself.
  template <typename SolverTraits>
  void parameterize()
  {
    namespace Maps = CGAL::Surface_mesh_parameterization;
    using BorderMap = Maps::Circular_border_arc_length_parameterizer_3<Mesh>;
    using Map = Maps::Discrete_conformal_map_parameterizer_3<Mesh, BorderMap, SolverTraits>;
    if (Maps::parameterize(this->Surface, Map(), this->Border, this->Places) != Maps::OK)
    {
      throw std::runtime_error("CGAL's parameterization failed");
    }
  }

  hexsweep::PlanePoints coordinates() const
  {
    hexsweep::PlanePoints result(
      static_cast<hexsweep::Index>(this->Surface.number_of_vertices()), 2);
    for (const Mesh::Vertex_index v : this->Surface.vertices())
    {
      const Kernel::Point_2 place = this->Places[v];
      // CGAL's disk has the radius 1/2 about (1/2, 1/2).
      result.row(static_cast<hexsweep::Index>(static_cast<std::size_t>(v)))
        << 2.0 * place.x() - 1.0,
        2.0 * place.y() - 1.0;
    }
    return result;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

  Mesh Surface;
  Mesh::Halfedge_index Border;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> Places;
};
}

#endif
