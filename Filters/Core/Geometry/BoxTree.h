// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Bounding boxes over things that lie in the order of a space-filling curve.
 */
#ifndef hexsweep_BoxTree_h
#define hexsweep_BoxTree_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace hexsweep
{
/// An axis-parallel rectangle of the plane; empty as it is made.
struct PlaneBox
{
  double low[2] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  double high[2] = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };

  void extend(double x, double y)
  {
    this->low[0] = std::min(this->low[0], x);
    this->low[1] = std::min(this->low[1], y);
    this->high[0] = std::max(this->high[0], x);
    this->high[1] = std::max(this->high[1], y);
  }
  void extend(const PlaneBox& other)
  {
    this->extend(other.low[0], other.low[1]);
    this->extend(other.high[0], other.high[1]);
  }
  /// 0 inside and on the edge.
  double squaredDistance(double x, double y) const
  {
    const double dx = std::max({ this->low[0] - x, x - this->high[0], 0.0 });
    const double dy = std::max({ this->low[1] - y, y - this->high[1], 0.0 });
    return dx * dx + dy * dy;
  }
};

/**
 * A packed tree (\cite KamelFaloutsos1994): each box holds the next eight of the level below.
 * Building is one pass over the items.
 */
class BoxTree
{
public:
  BoxTree() = default;

  /// @param boxOf boxOf(i) is the PlaneBox of item i, 0 <= i < count.
  template <typename BoxOf>
  BoxTree(std::size_t count, const BoxOf& boxOf)
    : Count(count)
  {
    this->addLevel(count, boxOf);
    while (!this->Levels.empty() && this->Levels.back().size() > 1)
    {
      const std::size_t last = this->Levels.size() - 1;
      this->addLevel(this->Levels[last].size(),
        [&](std::size_t i) -> const PlaneBox& { return this->Levels[last][i]; });
    }
  }

  /**
   * Calls visit(i) for all items in boxes that are no farther from (x, y) than the square root of
   * what visit() returned last, nearer boxes first.
   *
   * @param limit squared distance to begin with; 0 finds what lies at the point.
   * @param visit returns the squared distance within which to look further.
   */
  template <typename Visit>
  void visitNear(double x, double y, double limit, const Visit& visit) const
  {
    if (this->Count == 0)
    {
      return;
    }
    struct Task
    {
      double distance;
      std::size_t level;
      std::size_t box;
    };
    const std::size_t top = this->Levels.size() - 1;
    std::array<Task, Fan * MaximumLevels> tasks;
    std::size_t open = 0;
    tasks[open++] = { this->Levels[top][0].squaredDistance(x, y), top, 0 };
    while (open > 0)
    {
      const Task task = tasks[--open];
      // False for a point that is not finite: it visits everything.
      if (task.distance > limit)
      {
        continue;
      }
      const std::size_t begin = task.box * Fan;
      if (task.level == 0)
      {
        const std::size_t end = std::min(begin + Fan, this->Count);
        for (std::size_t i = begin; i < end; ++i)
        {
          limit = visit(i);
        }
        continue;
      }
      const std::vector<PlaneBox>& below = this->Levels[task.level - 1];
      const std::size_t end = std::min(begin + Fan, below.size());
      const std::size_t old = open;
      for (std::size_t i = begin; i < end; ++i)
      {
        const double distance = below[i].squaredDistance(x, y);
        if (!(distance > limit))
        {
          // The nearest one last: it is the next.
          std::size_t place = open++;
          for (; place > old && tasks[place - 1].distance < distance; --place)
          {
            tasks[place] = tasks[place - 1];
          }
          tasks[place] = { distance, task.level - 1, i };
        }
      }
    }
  }

private:
  static constexpr std::size_t Fan = 8;
  static constexpr std::size_t MaximumLevels = 22; // enough for 2^64 items

  template <typename BoxOf>
  void addLevel(std::size_t count, const BoxOf& boxOf)
  {
    std::vector<PlaneBox> level((count + Fan - 1) / Fan);
    for (std::size_t i = 0; i < count; ++i)
    {
      level[i / Fan].extend(boxOf(i));
    }
    this->Levels.push_back(std::move(level));
  }

  std::size_t Count = 0;
  std::vector<std::vector<PlaneBox>> Levels; // leaves first
};
}

#endif
