// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/MultifrontalSolver.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
using Matrix = Eigen::MatrixXd;

/// Parts of the elimination tree that know nothing of each other.
constexpr double Branches = 16.0;
/// Below it threads cost more than they bring; multiplications and additions.
constexpr double LittleWork = 4e6;
/// Updates of no more values are kept for the next factorisation: most of the time of a small one
/// went into memory that the system took back and gave anew.
constexpr Index MostKeptValues = 1000000;

/// An elimination tree in parts: fronts first ... last of each branch, and those above them all.
struct BranchedTree
{
  std::vector<std::pair<std::size_t, std::size_t>> branches;
  std::vector<std::size_t> top; ///< rising
};

/**
 * Branches of no more than an even share of the work.
 *
 * @param parents of fronts whose descendants stand right before them.
 */
BranchedTree branchesOf(const std::vector<Index>& parents, const std::vector<double>& ownWork)
{
  std::vector<double> work = ownWork; // with that of the descendants
  std::vector<std::size_t> first(parents.size());
  std::iota(first.begin(), first.end(), std::size_t{ 0 });
  double whole = 0.0;
  for (std::size_t f = 0; f < parents.size(); ++f)
  {
    whole += ownWork[f];
    if (parents[f] >= 0)
    {
      work[at(parents[f])] += work[f];
      first[at(parents[f])] = std::min(first[at(parents[f])], first[f]);
    }
  }
  BranchedTree tree;
  if (whole < LittleWork)
  {
    tree.branches.emplace_back(0, parents.size() - 1);
    return tree;
  }
  const double share = whole / Branches;
  double workOfLast = 0.0;
  for (std::size_t f = parents.size(); f-- > 0;)
  {
    if (work[f] > share)
    {
      tree.top.push_back(f);
      continue;
    }
    // Small ones side by side, as separate parts of a mesh are, are one.
    const bool isNext = !tree.branches.empty() && tree.branches.back().first == f + 1 &&
      workOfLast + work[f] <= share;
    workOfLast = isNext ? workOfLast + work[f] : work[f];
    if (isNext)
    {
      tree.branches.back().first = first[f];
    }
    else
    {
      tree.branches.emplace_back(first[f], f);
    }
    f = first[f];
  }
  std::reverse(tree.top.begin(), tree.top.end());
  return tree;
}
}

/// What factorize() knows of the fronts.
struct MultifrontalSolver::Work
{
  const SparseMatrix& matrix;
  std::vector<Update>& updates; ///< of the fronts' borders
  bool keepsUpdates;            ///< not only until the parents have taken them
  std::vector<std::vector<std::size_t>> children;
};

MultifrontalSolver::MultifrontalSolver(
  const SparseMatrix& pattern, Kind kind, const PointsRef& places, int width)
  : Factorization(kind)
{
  Dissection dissection = dissectBlocks(pattern, width, places);
  this->Order = std::move(dissection.order);
  const Index n = pattern.rows();
  this->Place.resize(at(n));
  for (Index k = 0; k < n; ++k)
  {
    this->Place[at(this->Order[at(k)])] = k;
  }

  std::vector<std::vector<Index>> children(dissection.parts.size());
  std::vector<Index> seen(at(n), -1); // the last front that a place was put into
  for (std::size_t f = 0; f < dissection.parts.size(); ++f)
  {
    const Dissection::Part& part = dissection.parts[f];
    const Index border = static_cast<Index>(this->Borders.size());
    const auto add = [&](Index place) {
      if (place >= part.end && seen[at(place)] != static_cast<Index>(f))
      {
        seen[at(place)] = static_cast<Index>(f);
        this->Borders.push_back(place);
      }
    };
    for (Index k = part.begin; k < part.end; ++k)
    {
      for (SparseMatrix::InnerIterator it(pattern, this->Order[at(k)]); it; ++it)
      {
        add(this->Place[at(it.row())]);
      }
    }
    for (const Index c : children[f])
    {
      const Front& child = this->Fronts[at(c)];
      for (Index k = 0; k < child.borderSize; ++k)
      {
        add(this->Borders[at(child.border + k)]);
      }
    }
    std::sort(this->Borders.begin() + border, this->Borders.end());
    const Index borderSize = static_cast<Index>(this->Borders.size()) - border;
    const Index pivots = part.end - part.begin;
    const Index lower = this->ValuesNeeded;
    const Index upper = lower + pivots * (pivots + borderSize);
    this->ValuesNeeded = kind == Kind::LU ? upper + pivots * borderSize : upper;
    this->UpdateValues += borderSize * borderSize;
    this->Fronts.push_back({ part.begin, pivots, part.parent, border, borderSize, lower, upper });
    if (part.parent >= 0)
    {
      children[at(part.parent)].push_back(static_cast<Index>(f));
    }
  }
  if (kind == Kind::LU)
  {
    this->Pivoting.resize(at(n));
  }
}

void MultifrontalSolver::assemble(
  const Front& front, const SparseMatrix& matrix, const std::vector<Index>& local)
{
  const Index size = front.pivots + front.borderSize;
  Eigen::Map<Matrix> lower(this->Values.data() + front.lower, size, front.pivots);
  lower.setZero();
  for (Index k = 0; k < front.pivots; ++k)
  {
    for (SparseMatrix::InnerIterator it(matrix, this->Order[at(front.begin + k)]); it; ++it)
    {
      const Index place = this->Place[at(it.row())];
      if (place >= front.begin)
      {
        lower(local[at(place)], k) = it.value();
      }
    }
  }
  if (this->Factorization == Kind::LU)
  {
    Eigen::Map<Matrix> upper(this->Values.data() + front.upper, front.pivots, front.borderSize);
    upper.setZero();
    for (Index k = 0; k < front.borderSize; ++k)
    {
      const int column = this->Order[at(this->Borders[at(front.border + k)])];
      for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
      {
        const Index pivot = this->Place[at(it.row())] - front.begin;
        if (pivot >= 0 && pivot < front.pivots)
        {
          upper(pivot, k) = it.value();
        }
      }
    }
  }
}

void MultifrontalSolver::extendAdd(const Front& front, Update& update, const Front& child,
  const Update& childUpdate, const std::vector<Index>& local)
{
  const bool full = this->Factorization == Kind::LU;
  const Index size = front.pivots + front.borderSize;
  const Index* places = this->Borders.data() + child.border;
  for (Index j = 0; j < child.borderSize; ++j)
  {
    const Index column = local[at(places[j])];
    const bool isPivot = column < front.pivots;
    // Column of the front, indexed by the rows of the whole front; its upper part lies apart.
    double* below = isPivot ? this->Values.data() + front.lower + column * size
                            : update.data() + (column - front.pivots) * front.borderSize;
    double* above =
      isPivot ? below : this->Values.data() + front.upper + (column - front.pivots) * front.pivots;
    for (Index i = full ? 0 : j; i < child.borderSize; ++i)
    {
      const Index row = local[at(places[i])];
      if (isPivot || row < front.pivots)
      {
        above[row] += childUpdate(i, j);
      }
      else
      {
        below[row - front.pivots] += childUpdate(i, j);
      }
    }
  }
}

bool MultifrontalSolver::eliminate(const Front& front, Update& update)
{
  if (front.pivots == 0) // two parts that need no separator; Eigen divides by the number of pivots
  {
    return true;
  }
  Eigen::Map<Matrix> panel(
    this->Values.data() + front.lower, front.pivots + front.borderSize, front.pivots);
  auto diagonal = panel.topRows(front.pivots);
  auto lower = panel.bottomRows(front.borderSize);
  using InPlace = Eigen::Ref<Matrix, 0, Eigen::OuterStride<>>;
  if (this->Factorization == Kind::Cholesky)
  {
    const Eigen::LLT<InPlace> cholesky(diagonal);
    if (cholesky.info() != Eigen::Success || !diagonal.diagonal().allFinite())
    {
      return false;
    }
    if (front.borderSize > 0)
    {
      diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(lower);
      update.selfadjointView<Eigen::Lower>().rankUpdate(lower, -1.0);
    }
    return true;
  }
  const Eigen::PartialPivLU<InPlace> lu(diagonal);
  if (!((diagonal.diagonal().array().abs() > 0.0).all() && diagonal.allFinite()))
  {
    return false;
  }
  Eigen::Map<Eigen::VectorXi>(this->Pivoting.data() + front.begin, front.pivots) =
    lu.permutationP().indices();
  Eigen::Map<Matrix> upper(this->Values.data() + front.upper, front.pivots, front.borderSize);
  if (front.borderSize > 0)
  {
    upper = (lu.permutationP() * upper).eval();
    diagonal.triangularView<Eigen::UnitLower>().solveInPlace(upper);
    diagonal.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(lower);
    update.noalias() -= lower * upper;
  }
  return true;
}

/// @param local scratch: one entry a row of the matrix.
void MultifrontalSolver::factorizeFront(std::size_t f, std::vector<Index>& local, Work& work)
{
  const Front& front = this->Fronts[f];
  for (Index k = 0; k < front.pivots; ++k)
  {
    local[at(front.begin + k)] = k;
  }
  for (Index k = 0; k < front.borderSize; ++k)
  {
    local[at(this->Borders[at(front.border + k)])] = front.pivots + k;
  }
  this->assemble(front, work.matrix, local);
  Update& update = work.updates[f];
  update.setZero(front.borderSize, front.borderSize);
  for (const std::size_t c : work.children[f])
  {
    this->extendAdd(front, update, this->Fronts[c], work.updates[c], local);
    if (!work.keepsUpdates)
    {
      work.updates[c].resize(0, 0);
    }
  }
  if (!this->eliminate(front, update))
  {
    throw SolverFailure("the harmonic map's linear system is singular: part of the surface has "
                        "no boundary, or triangles are degenerate.");
  }
}

void MultifrontalSolver::factorize(const SparseMatrix& matrix, const ParallelFor& parallelFor)
{
  const std::size_t count = this->Fronts.size();
  if (count == 0)
  {
    return;
  }
  this->Values.resize(at(this->ValuesNeeded));
  const bool keeps = this->UpdateValues <= MostKeptValues;
  std::vector<Update> updates(keeps ? 0 : count);
  if (keeps)
  {
    this->Updates.resize(count);
  }
  Work work{ matrix, keeps ? this->Updates : updates, keeps,
    std::vector<std::vector<std::size_t>>(count) };
  std::vector<Index> parents;
  std::vector<double> costs;
  for (std::size_t f = 0; f < count; ++f)
  {
    const Front& front = this->Fronts[f];
    const auto size = static_cast<double>(front.pivots + front.borderSize);
    parents.push_back(front.parent);
    costs.push_back(static_cast<double>(front.pivots) * size * size);
    if (front.parent >= 0)
    {
      work.children[at(front.parent)].push_back(f);
    }
  }
  const BranchedTree tree = branchesOf(parents, costs);
  forPieces(parallelFor, static_cast<Index>(tree.branches.size()), 1, [&](Index branch, Index) {
    std::vector<Index> local(this->Order.size());
    for (std::size_t f = tree.branches[at(branch)].first; f <= tree.branches[at(branch)].second;
         ++f)
    {
      this->factorizeFront(f, local, work);
    }
  });
  std::vector<Index> local(this->Order.size());
  for (const std::size_t f : tree.top)
  {
    this->factorizeFront(f, local, work);
  }
}

Eigen::MatrixXd MultifrontalSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const
{
  std::vector<Index> fronts(this->Fronts.size());
  std::iota(fronts.begin(), fronts.end(), Index{ 0 });
  return this->solve({ this->Place, std::move(fronts) }, b);
}

MultifrontalSolver::Selection MultifrontalSolver::select(const std::vector<Index>& rows) const
{
  Selection selection;
  std::vector<bool> isSelected(this->Order.size(), false);
  for (const Index row : rows)
  {
    selection.places.push_back(this->Place[at(row)]);
    isSelected[at(selection.places.back())] = true;
  }
  // What is eliminated at a front is felt by those above it.
  std::vector<bool> isFelt(this->Fronts.size(), false);
  for (std::size_t f = 0; f < this->Fronts.size(); ++f)
  {
    const Front& front = this->Fronts[f];
    const auto begin = isSelected.begin() + front.begin;
    isFelt[f] = isFelt[f] || std::find(begin, begin + front.pivots, true) != begin + front.pivots;
    if (isFelt[f])
    {
      selection.fronts.push_back(static_cast<Index>(f));
      if (front.parent >= 0)
      {
        isFelt[at(front.parent)] = true;
      }
    }
  }
  return selection;
}

Eigen::MatrixXd MultifrontalSolver::solve(
  const Selection& selection, const Eigen::Ref<const Eigen::MatrixXd>& b) const
{
  Matrix result(b.rows(), b.cols());
  std::vector<RowPair> x(this->Order.size()); // in the elimination order
  for (Index c = 0; c < b.cols(); c += 2)
  {
    const Index second = std::min(c + 1, b.cols() - 1);
    for (const Index f : selection.fronts)
    {
      const Front& front = this->Fronts[at(f)];
      std::fill_n(x.begin() + front.begin, front.pivots, RowPair(0.0, 0.0));
    }
    for (Index k = 0; k < b.rows(); ++k)
    {
      x[at(selection.places[at(k)])] = { b(k, c), b(k, second) };
    }
    this->substitute(x, selection.fronts);
    for (Index k = 0; k < b.rows(); ++k)
    {
      const RowPair& row = x[at(selection.places[at(k)])];
      result(k, c) = row[0];
      result(k, second) = row[second - c];
    }
  }
  return result;
}

/// Forwards and backwards, at the given fronts only; a front's border lies within those above it.
void MultifrontalSolver::substitute(std::vector<RowPair>& x, const std::vector<Index>& fronts) const
{
  const bool cholesky = this->Factorization == Kind::Cholesky;
  std::vector<RowPair> y; // the rows of a front
  for (const Index f : fronts)
  {
    const Front& front = this->Fronts[at(f)];
    const Index size = front.pivots + front.borderSize;
    const Index* border = this->Borders.data() + front.border;
    y.resize(std::max(y.size(), at(size)));
    for (Index k = 0; k < front.pivots; ++k)
    {
      const Index row = cholesky ? k : Index{ this->Pivoting[at(front.begin + k)] };
      y[at(row)] = x[at(front.begin + k)];
    }
    for (Index k = 0; k < front.borderSize; ++k)
    {
      y[at(front.pivots + k)] = x[at(border[k])];
    }
    substituteForward(this->Values.data() + front.lower, size, front.pivots, !cholesky, y.data());
    std::copy_n(y.begin(), front.pivots, x.begin() + front.begin);
    for (Index k = 0; k < front.borderSize; ++k)
    {
      x[at(border[k])] = y[at(front.pivots + k)];
    }
  }
  for (auto f = fronts.rbegin(); f != fronts.rend(); ++f)
  {
    const Front& front = this->Fronts[at(*f)];
    const Index size = front.pivots + front.borderSize;
    const Index* border = this->Borders.data() + front.border;
    std::copy_n(x.begin() + front.begin, front.pivots, y.begin());
    for (Index k = 0; k < front.borderSize; ++k)
    {
      y[at(front.pivots + k)] = x[at(border[k])];
    }
    const double* panel = this->Values.data() + front.lower;
    if (cholesky)
    {
      substituteTransposed(panel, size, front.pivots, y.data());
    }
    else
    {
      subtractProduct(this->Values.data() + front.upper, front.pivots, front.pivots,
        front.borderSize, y.data() + front.pivots, y.data());
      substituteBackward(panel, size, front.pivots, y.data());
    }
    std::copy_n(y.begin(), front.pivots, x.begin() + front.begin);
  }
}
}
