// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/DelaunayCells.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/Predicates.h"
#include "Core/Geometry/HilbertOrder.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace hexsweep
{
namespace
{
constexpr double FrameSize = 10.0; // of the extent: the square that holds all points

int nextCorner(int c)
{
  return (c + 1) % 3;
}

/// Whether d is inside the circle through a, b, c. Its sign decides about beauty only.
bool inCircle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c,
  const Eigen::RowVector2d& d)
{
  const Eigen::RowVector2d p = a - d;
  const Eigen::RowVector2d q = b - d;
  const Eigen::RowVector2d r = c - d;
  const auto cross = [](const Eigen::RowVector2d& u, const Eigen::RowVector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double value =
    p.squaredNorm() * cross(q, r) + q.squaredNorm() * cross(r, p) + r.squaredNorm() * cross(p, q);
  const double size =
    p.squaredNorm() * (q.squaredNorm() + r.squaredNorm()) + q.squaredNorm() * r.squaredNorm();
  return value > 1e-12 * size;
}

class Triangulator
{
public:
  explicit Triangulator(const PlaneGraph& graph)
  {
    const Index n = graph.points.rows();
    for (Index i = 0; i < n; ++i)
    {
      this->Places.push_back(graph.points.row(i));
    }
    const Eigen::RowVector2d low = graph.points.colwise().minCoeff();
    const Eigen::RowVector2d high = graph.points.colwise().maxCoeff();
    const double size = FrameSize * (high - low).maxCoeff();
    const Eigen::RowVector2d middle = 0.5 * (low + high);
    for (const auto& [x, y] :
      { std::pair{ -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } })
    {
      this->Places.push_back(middle + size * Eigen::RowVector2d(x, y));
    }
    this->Cells.push_back({ { n, n + 1, n + 2 }, { -1, -1, 1 } });
    this->Cells.push_back({ { n, n + 2, n + 3 }, { 0, -1, -1 } });
    this->CellAt.assign(this->Places.size(), 0);
    this->CellAt[static_cast<std::size_t>(n + 3)] = 1;
    for (const CurvePlace& place : hilbertOrder(HilbertCurve(graph.points), graph.points))
    {
      this->insert(static_cast<Index>(place.id));
    }
    for (const auto& [a, b] : graph.edges)
    {
      this->force(a, b);
    }
    this->makeDelaunay();
  }

  const std::vector<DelaunayCell>& cells() const { return this->Cells; }

private:
  const Eigen::RowVector2d& place(Index i) const
  {
    return this->Places[static_cast<std::size_t>(i)];
  }
  DelaunayCell& cell(Index t) { return this->Cells[static_cast<std::size_t>(t)]; }
  int side(Index a, Index b, Index c) const
  {
    return orientation(this->place(a), this->place(b), this->place(c));
  }

  int cornerOf(Index t, Index point)
  {
    const std::array<Index, 3>& corner = this->cell(t).corner;
    return corner[0] == point ? 0 : corner[1] == point ? 1 : corner[2] == point ? 2 : -1;
  }

  void relink(Index t, Index before, Index now)
  {
    if (t >= 0)
    {
      for (Index& across : this->cell(t).across)
      {
        across = across == before ? now : across;
      }
    }
  }

  void touch(Index t)
  {
    for (const Index i : this->cell(t).corner)
    {
      this->CellAt[static_cast<std::size_t>(i)] = t;
    }
  }

  /// The cell that holds a point, by a walk from the last one.
  Index locate(Index point)
  {
    Index t = this->Last;
    for (std::size_t step = 0; step < 4 * this->Cells.size() + 16; ++step)
    {
      Index next = -1;
      for (int k = 0; k < 3 && next < 0; ++k)
      {
        const int c = static_cast<int>((step + static_cast<std::size_t>(k)) % 3);
        const DelaunayCell& here = this->cell(t);
        if (this->side(here.corner[static_cast<std::size_t>(c)],
              here.corner[static_cast<std::size_t>(nextCorner(c))], point) < 0)
        {
          next = here.across[static_cast<std::size_t>(c)];
        }
      }
      if (next < 0)
      {
        return t;
      }
      t = next;
    }
    throw InvalidInput("the curves of the caps cannot be triangulated.");
  }

  void insert(Index point)
  {
    const Index t = this->locate(point);
    const DelaunayCell here = this->cell(t);
    int zero = -1;
    int zeros = 0;
    for (int c = 0; c < 3; ++c)
    {
      if (this->side(here.corner[static_cast<std::size_t>(c)],
            here.corner[static_cast<std::size_t>(nextCorner(c))], point) == 0)
      {
        zero = c;
        ++zeros;
      }
    }
    if (zeros > 1)
    {
      throw InvalidInput("points of the caps' curves coincide.");
    }
    std::deque<std::pair<Index, int>> open;
    if (zeros == 0)
    {
      this->splitCell(t, point, open);
    }
    else
    {
      this->splitEdge(t, zero, point, open);
    }
    this->Last = t;
    this->legalize(open);
  }

  void splitCell(Index t, Index point, std::deque<std::pair<Index, int>>& open)
  {
    const DelaunayCell old = this->cell(t);
    const Index first = static_cast<Index>(this->Cells.size());
    const Index second = first + 1;
    this->Cells.push_back({});
    this->Cells.push_back({});
    const auto& [a, b, c] = old.corner;
    this->cell(t) = { { a, b, point }, { old.across[0], first, second } };
    this->cell(first) = { { b, c, point }, { old.across[1], second, t } };
    this->cell(second) = { { c, a, point }, { old.across[2], t, first } };
    this->relink(old.across[1], t, first);
    this->relink(old.across[2], t, second);
    for (const Index i : { t, first, second })
    {
      this->touch(i);
      open.emplace_back(i, 0);
    }
  }

  /// The edge from corner `c` of cell `t` is cut; no edge of the graph is there yet.
  void splitEdge(Index t, int c, Index point, std::deque<std::pair<Index, int>>& open)
  {
    const auto at = [](int i) { return static_cast<std::size_t>(i % 3); };
    const DelaunayCell old = this->cell(t);
    const Index a = old.corner[at(c)];
    const Index b = old.corner[at(c + 1)];
    const Index apex = old.corner[at(c + 2)];
    const Index u = old.across[at(c)];
    if (u < 0)
    {
      throw InvalidInput("the curves of the caps cannot be triangulated.");
    }
    const DelaunayCell other = this->cell(u);
    const int d = this->cornerOf(u, b);
    const Index below = other.corner[at(d + 2)];
    const Index first = static_cast<Index>(this->Cells.size());
    const Index second = first + 1;
    this->Cells.push_back({});
    this->Cells.push_back({});
    this->cell(t) = { { a, point, apex }, { second, first, old.across[at(c + 2)] } };
    this->cell(first) = { { point, b, apex }, { u, old.across[at(c + 1)], t } };
    this->cell(u) = { { b, point, below }, { first, second, other.across[at(d + 2)] } };
    this->cell(second) = { { point, a, below }, { t, other.across[at(d + 1)], u } };
    this->relink(old.across[at(c + 1)], t, first);
    this->relink(other.across[at(d + 1)], u, second);
    for (const Index i : { t, first, u, second })
    {
      this->touch(i);
    }
    open.emplace_back(t, 2);
    open.emplace_back(first, 1);
    open.emplace_back(u, 2);
    open.emplace_back(second, 1);
  }

  /// Whether the four corners round an edge are a convex quadrilateral.
  bool isConvex(Index t, int c)
  {
    const auto at = [](int i) { return static_cast<std::size_t>(i % 3); };
    const DelaunayCell& here = this->cell(t);
    const Index u = here.across[at(c)];
    const Index a = here.corner[at(c)];
    const Index b = here.corner[at(c + 1)];
    const Index apex = here.corner[at(c + 2)];
    const Index below = this->cell(u).corner[at(this->cornerOf(u, b) + 2)];
    return this->side(apex, below, b) > 0 && this->side(below, apex, a) > 0;
  }

  /// Edge a b of cell t (from corner c) becomes the edge between the two other corners.
  void flip(Index t, int c)
  {
    const auto at = [](int i) { return static_cast<std::size_t>(i % 3); };
    const DelaunayCell here = this->cell(t);
    const Index u = here.across[at(c)];
    const DelaunayCell other = this->cell(u);
    const Index a = here.corner[at(c)];
    const Index b = here.corner[at(c + 1)];
    const Index apex = here.corner[at(c + 2)];
    const int d = this->cornerOf(u, b);
    const Index below = other.corner[at(d + 2)];
    DelaunayCell left{ { a, below, apex }, { other.across[at(d + 1)], u, here.across[at(c + 2)] } };
    left.isEdge = { other.isEdge[at(d + 1)], false, here.isEdge[at(c + 2)] };
    DelaunayCell right{ { below, b, apex },
      { other.across[at(d + 2)], here.across[at(c + 1)], t } };
    right.isEdge = { other.isEdge[at(d + 2)], here.isEdge[at(c + 1)], false };
    this->cell(t) = left;
    this->cell(u) = right;
    this->relink(other.across[at(d + 1)], u, t);
    this->relink(here.across[at(c + 1)], t, u);
    this->touch(t);
    this->touch(u);
  }

  bool wantsFlip(Index t, int c)
  {
    const auto at = [](int i) { return static_cast<std::size_t>(i % 3); };
    const DelaunayCell& here = this->cell(t);
    const Index u = here.across[at(c)];
    if (u < 0 || here.isEdge[at(c)])
    {
      return false;
    }
    const Index below = this->cell(u).corner[at(this->cornerOf(u, here.corner[at(c + 1)]) + 2)];
    return inCircle(this->place(here.corner[0]), this->place(here.corner[1]),
             this->place(here.corner[2]), this->place(below)) &&
      this->isConvex(t, c);
  }

  void legalize(std::deque<std::pair<Index, int>>& open)
  {
    std::size_t left = 1000 + 10 * this->Cells.size();
    while (!open.empty() && left-- > 0)
    {
      const auto [t, c] = open.front();
      open.pop_front();
      if (!this->wantsFlip(t, c))
      {
        continue;
      }
      const Index u = this->cell(t).across[static_cast<std::size_t>(c)];
      this->flip(t, c);
      open.emplace_back(t, 0);
      open.emplace_back(t, 2);
      open.emplace_back(u, 0);
      open.emplace_back(u, 1);
    }
  }

  /// Cells round a point: counter-clockwise, and at a corner of the frame on from the first one the
  /// other way.
  std::vector<Index> around(Index point)
  {
    std::vector<Index> result;
    const Index start = this->CellAt[static_cast<std::size_t>(point)];
    for (const int turn : { 2, 0 })
    {
      Index t = start;
      do
      {
        result.push_back(t);
        const int c = this->cornerOf(t, point);
        t = this->cell(t).across[static_cast<std::size_t>((c + turn) % 3)];
      } while (t >= 0 && t != start);
      if (t == start)
      {
        break;
      }
    }
    return result;
  }

  /// @return whether there is such an edge, which then is one of the graph.
  bool mark(Index a, Index b)
  {
    for (const Index t : this->around(a))
    {
      const int c = this->cornerOf(t, a);
      if (this->cell(t).corner[static_cast<std::size_t>(nextCorner(c))] == b)
      {
        this->cell(t).isEdge[static_cast<std::size_t>(c)] = true;
        const Index u = this->cell(t).across[static_cast<std::size_t>(c)];
        this->cell(u).isEdge[static_cast<std::size_t>(this->cornerOf(u, b))] = true;
        return true;
      }
    }
    return false;
  }

  /// The cell left of the edge between two points and the corner where it begins; -1: there is
  /// none.
  std::pair<Index, int> find(Index from, Index to)
  {
    for (const Index t : this->around(from))
    {
      const int c = this->cornerOf(t, from);
      if (this->cell(t).corner[static_cast<std::size_t>(nextCorner(c))] == to)
      {
        return { t, c };
      }
    }
    return { -1, 0 };
  }

  [[noreturn]] void failAt(Index a) const
  {
    throw InvalidInput("the curves of the caps cannot be told apart near (" +
      describe(this->place(a).x()) + ", " + describe(this->place(a).y()) +
      ") across the sweep. Set ImprintTolerance to another value.");
  }

  /**
   * The edges that the way from a to b crosses, each from right to left.
   *
   * @return where the way ends: b, or the first point that it meets before.
   */
  Index crossedEdges(Index a, Index b, std::deque<std::pair<Index, Index>>& crossed)
  {
    const Eigen::RowVector2d way = this->place(b) - this->place(a);
    Index t = -1;
    int c = 0;
    for (const Index s : this->around(a))
    {
      const int own = this->cornerOf(s, a);
      const Index p = this->cell(s).corner[static_cast<std::size_t>((own + 1) % 3)];
      const Index q = this->cell(s).corner[static_cast<std::size_t>((own + 2) % 3)];
      if (p == b || (this->side(a, b, p) == 0 && way.dot(this->place(p) - this->place(a)) > 0.0))
      {
        return p;
      }
      if (this->side(a, b, p) < 0 && this->side(a, b, q) > 0)
      {
        t = s;
        c = (own + 1) % 3;
      }
    }
    while (t >= 0)
    {
      if (this->cell(t).isEdge[static_cast<std::size_t>(c)])
      {
        this->failAt(a);
      }
      const Index p = this->cell(t).corner[static_cast<std::size_t>(c)];
      crossed.emplace_back(p, this->cell(t).corner[static_cast<std::size_t>(nextCorner(c))]);
      const Index u = this->cell(t).across[static_cast<std::size_t>(c)];
      const int d = this->cornerOf(u, p);
      const Index far = this->cell(u).corner[static_cast<std::size_t>(nextCorner(d))];
      const int side = far == b ? 0 : this->side(a, b, far);
      if (side == 0)
      {
        return far;
      }
      c = side > 0 ? d : nextCorner(d);
      t = u;
    }
    this->failAt(a);
  }

  /// Makes the way from a to b one or more edges of the graph, by flips \cite Sloan1993.
  void force(Index a, Index b)
  {
    while (a != b)
    {
      std::deque<std::pair<Index, Index>> crossed;
      const Index end = this->crossedEdges(a, b, crossed);
      std::size_t left = 100 + 20 * crossed.size() * crossed.size();
      while (!crossed.empty())
      {
        const auto [p, q] = crossed.front();
        crossed.pop_front();
        const auto [t, c] = this->find(p, q);
        if (t < 0 || left-- == 0)
        {
          this->failAt(a);
        }
        if (!this->isConvex(t, c))
        {
          crossed.emplace_back(p, q);
          continue;
        }
        this->flip(t, c);
        // The new edge is the one from corner 1 of cell t to corner 2.
        const Index below = this->cell(t).corner[1];
        const Index apex = this->cell(t).corner[2];
        if (below == a || below == end || apex == a || apex == end)
        {
          continue;
        }
        const int sideBelow = this->side(a, end, below);
        const int sideApex = this->side(a, end, apex);
        if (sideBelow * sideApex < 0)
        {
          crossed.emplace_back(sideBelow < 0 ? below : apex, sideBelow < 0 ? apex : below);
        }
      }
      if (!this->mark(a, end))
      {
        this->failAt(a);
      }
      a = end;
    }
  }

  void makeDelaunay()
  {
    std::deque<std::pair<Index, int>> open;
    for (std::size_t t = 0; t < this->Cells.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        open.emplace_back(static_cast<Index>(t), c);
      }
    }
    this->legalize(open);
  }

  std::vector<Eigen::RowVector2d> Places;
  std::vector<DelaunayCell> Cells;
  std::vector<Index> CellAt;
  Index Last = 0;
};
}

std::vector<DelaunayCell> delaunayCells(const PlaneGraph& graph)
{
  return Triangulator(graph).cells();
}
}
