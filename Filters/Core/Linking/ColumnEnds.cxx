// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/ColumnEnds.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the loop: a column that begins at a corner goes this far out of its way to end at one.
constexpr double MostDrift = 0.08;

/// A column that may end at a corner.
struct CornerPair
{
  double offset; ///< from where it would end otherwise
  std::size_t corner;
  std::size_t column;
};

class Anchoring
{
public:
  Anchoring(const std::vector<double>& begins, std::vector<ColumnAnchor> anchors, double turn)
    : Begins(begins)
    , Anchors(std::move(anchors))
    , Turn(turn)
  {
  }

  bool isAnchored(double v) const
  {
    return std::any_of(this->Anchors.begin(), this->Anchors.end(),
      [&](const ColumnAnchor& anchor) { return wrappedV(anchor.end) == wrappedV(v); });
  }

  CornerPair pair(std::size_t corner, double v, std::size_t column) const
  {
    return { std::abs(std::remainder(v - this->freeEnd(column), 1.0)), corner, column };
  }

  /// Lets the column end there unless that would cross another one's way.
  bool anchor(std::size_t column, double v)
  {
    const double end = this->freeEnd(column) + std::remainder(v - this->freeEnd(column), 1.0);
    if (!this->fits(column, end))
    {
      return false;
    }
    this->Anchors.insert(
      std::lower_bound(this->Anchors.begin(), this->Anchors.end(), column,
        [](const ColumnAnchor& anchor, std::size_t c) { return anchor.column < c; }),
      { column, end });
    return true;
  }

  std::vector<double> ends() const
  {
    std::vector<double> ends = this->Begins;
    for (double& end : ends)
    {
      end += this->Turn;
    }
    const std::size_t n = ends.size();
    for (std::size_t a = 0; a < this->Anchors.size(); ++a)
    {
      const bool wraps = a + 1 == this->Anchors.size();
      const ColumnAnchor& from = this->Anchors[a];
      const ColumnAnchor& to = this->Anchors[wraps ? 0 : a + 1];
      const double last = wraps ? to.end + 1.0 : to.end;
      const double lastBegin = this->Begins[to.column] + (wraps ? 1.0 : 0.0);
      for (std::size_t j = from.column; j < (wraps ? to.column + n : to.column); ++j)
      {
        const double begin = this->Begins[j % n] + (j >= n ? 1.0 : 0.0);
        const double along =
          (begin - this->Begins[from.column]) / (lastBegin - this->Begins[from.column]);
        // An anchor itself must come out exactly.
        ends[j % n] = (j == from.column ? from.end : from.end + along * (last - from.end)) -
          (j >= n ? 1.0 : 0.0);
      }
    }
    return ends;
  }

private:
  double freeEnd(std::size_t column) const { return this->Begins[column] + this->Turn; }

  bool fits(std::size_t column, double end) const
  {
    return std::none_of(
      this->Anchors.begin(), this->Anchors.end(), [&](const ColumnAnchor& anchor) {
        if (anchor.column == column)
        {
          return true;
        }
        const double columns =
          std::remainder(this->Begins[column] - this->Begins[anchor.column], 1.0);
        const double ends = std::remainder(end - anchor.end, 1.0);
        return (columns > 0.0) != (ends > 0.0);
      });
  }

  const std::vector<double>& Begins;
  std::vector<ColumnAnchor> Anchors; // by column
  double Turn;
};

void nearestFirst(std::vector<CornerPair>& pairs)
{
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const CornerPair& a, const CornerPair& b) { return a.offset < b.offset; });
}
}

ColumnEnds columnEnds(const std::vector<double>& begins, const std::vector<Index>& cornerColumns,
  std::vector<ColumnAnchor> anchors, double turn, const std::vector<double>& corners)
{
  Anchoring anchoring(begins, std::move(anchors), turn);
  std::vector<char> isOpen;
  std::vector<CornerPair> pairs;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    isOpen.push_back(!anchoring.isAnchored(corners[c]));
    for (const Index column : cornerColumns)
    {
      const CornerPair pair = anchoring.pair(c, corners[c], static_cast<std::size_t>(column));
      if (isOpen[c] && pair.offset < MostDrift)
      {
        pairs.push_back(pair);
      }
    }
  }
  nearestFirst(pairs);
  for (const CornerPair& pair : pairs)
  {
    if (isOpen[pair.corner] && anchoring.anchor(pair.column, corners[pair.corner]))
    {
      isOpen[pair.corner] = 0;
    }
  }
  ColumnEnds result;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    pairs.clear();
    for (std::size_t j = 0; j < begins.size() && isOpen[c]; ++j)
    {
      pairs.push_back(anchoring.pair(c, corners[c], j));
    }
    nearestFirst(pairs);
    const bool found = std::any_of(pairs.begin(), pairs.end(),
      [&](const CornerPair& pair) { return anchoring.anchor(pair.column, corners[c]); });
    if (isOpen[c] && !found)
    {
      result.lostCorners.push_back(c);
    }
  }
  result.ends = anchoring.ends();
  return result;
}
}
