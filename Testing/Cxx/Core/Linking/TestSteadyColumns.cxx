// SPDX-License-Identifier: BSD-3-Clause
// Which CAD edges become columns, by their courses in a strip.
#include "Core/Linking/SteadyColumns.h"

#include <gtest/gtest.h>

namespace TestSteadyColumns
{
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::steadyColumns;
using hexsweep::StripColumn;

using Way = std::vector<std::pair<double, double>>; // (v, u)

/// Edges through these places, and how many of them are left.
class Edges
{
public:
  Edges& add(const Way& way)
  {
    StripColumn column;
    for (const auto& [v, u] : way)
    {
      column.points.push_back(static_cast<Index>(this->Places.size()));
      this->Places.emplace_back(v, u);
    }
    this->Columns.push_back(column);
    return *this;
  }

  /// Numbers of those that are left.
  std::vector<std::size_t> steady() const
  {
    PlanePoints free(static_cast<Index>(this->Places.size()), 2);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      free.row(static_cast<Index>(i)) << this->Places[i].first, this->Places[i].second;
    }
    std::vector<std::size_t> left;
    for (const StripColumn& column : steadyColumns(this->Columns, free))
    {
      for (std::size_t c = 0; c < this->Columns.size(); ++c)
      {
        if (this->Columns[c].points == column.points)
        {
          left.push_back(c);
        }
      }
    }
    return left;
  }

private:
  std::vector<std::pair<double, double>> Places;
  std::vector<StripColumn> Columns;
};

using Numbers = std::vector<std::size_t>;

TEST(SteadyColumns, StraightOnesStayHoweverTheyAreDivided)
{
  Edges edges;
  edges.add({ { 0.0, 0.0 }, { 0.0, 1.0 } });
  edges.add({ { 0.25, 0.0 }, { 0.25, 0.1 }, { 0.25, 0.9 }, { 0.25, 1.0 } });
  edges.add({ { 0.99, 0.0 }, { 0.02, 0.6 }, { 0.03, 1.0 } }); // over the seam
  EXPECT_EQ(edges.steady(), (Numbers{ 0, 1, 2 }));
}

TEST(SteadyColumns, ThoseOfATwistStayTogether)
{
  Edges edges;
  for (const double v : { 0.1, 0.4, 0.7 })
  {
    edges.add({ { v, 0.0 }, { v + 0.15, 0.5 }, { v + 0.3, 1.0 } });
  }
  EXPECT_EQ(edges.steady(), (Numbers{ 0, 1, 2 }));
}

TEST(SteadyColumns, OneThatRunsRoundALedgeIsLeftOut)
{
  Edges edges;
  edges.add({ { 0.0, 0.0 }, { 0.0, 1.0 } });
  edges.add({ { 0.3, 0.0 }, { 0.3, 0.4 }, { 0.5, 0.41 }, { 0.5, 1.0 } });
  edges.add({ { 0.6, 0.0 }, { 0.6, 0.4 }, { 0.8, 0.41 }, { 0.6, 0.42 }, { 0.6, 1.0 } }); // and back
  EXPECT_EQ(edges.steady(), (Numbers{ 0 }));
}

TEST(SteadyColumns, OneThatIsAloneHasToBeSteadyItself)
{
  EXPECT_EQ(Edges().add({ { 0.0, 0.0 }, { 0.25, 0.5 }, { 0.5, 1.0 } }).steady(), (Numbers{ 0 }));
  EXPECT_EQ(Edges().add({ { 0.0, 0.0 }, { 0.5, 0.02 }, { 0.5, 1.0 } }).steady(), (Numbers{}));
}

TEST(SteadyColumns, AGrooveIsFollowed)
{
  Edges edges;
  edges.add({ { 0.0, 0.0 }, { 0.0, 1.0 } });
  edges.add(
    { { 0.3, 0.0 }, { 0.3, 0.4 }, { 0.36, 0.4 }, { 0.36, 0.6 }, { 0.3, 0.6 }, { 0.3, 1.0 } });
  EXPECT_EQ(edges.steady(), (Numbers{ 0, 1 }));
}

TEST(SteadyColumns, OneThatFallsBackIsLeftOut)
{
  Edges edges;
  edges.add({ { 0.0, 0.0 }, { 0.0, 1.0 } });
  edges.add({ { 0.5, 0.0 }, { 0.5, 0.7 }, { 0.501, 0.4 }, { 0.502, 1.0 } });
  EXPECT_EQ(edges.steady(), (Numbers{ 0 }));
}

TEST(SteadyColumns, OneThatDriftsAlongDiagonallyIsLeftOut)
{
  Edges edges;
  edges.add({ { 0.0, 0.0 }, { 0.0, 1.0 } });
  edges.add({ { 0.3, 0.0 }, { 0.3, 1.0 } });
  edges.add({ { 0.4, 0.0 }, { 0.63, 0.5 }, { 0.86, 1.0 } });
  EXPECT_EQ(edges.steady(), (Numbers{ 0, 1 }));
}

TEST(SteadyColumns, NoneGiveNone)
{
  EXPECT_TRUE(steadyColumns({}, PlanePoints(0, 2)).empty());
}
}
