// SPDX-License-Identifier: BSD-3-Clause
#include "enclosed_obstacle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hidwa_local_planner::control {
namespace {

// Where the line crosses a row of cells, and which way.
struct Crossing {
  double x = 0.0;  // [m]
  int turn = 0;    // 1 upwards, -1 downwards
};

// A line that crosses a row more often is a scribble: what lies beyond is not looked at.
constexpr std::size_t kMostCrossings = 64;
struct Crossings {
  std::array<Crossing, kMostCrossings> all;
  std::size_t count = 0;
  Crossing* begin() { return all.data(); }
  Crossing* end() { return all.data() + count; }
};

void find_crossings(const std::vector<Point>& line, double y, Crossings& crossings) {
  crossings.count = 0;
  for (std::size_t k = 0; k < line.size() && crossings.count < kMostCrossings; ++k) {
    const Point& a = line[k];
    const Point& b = line[(k + 1) % line.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    crossings.all[crossings.count++] = {x, b.y() > a.y() ? 1 : -1};
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
}

// Of the cells in row j whose centres lie in [from, to).
bool has_lethal(const GridView& grid, int j, double from, double to) {
  const double first = std::ceil((from - grid.origin_x) / grid.resolution - 0.5);
  const double last = std::ceil((to - grid.origin_x) / grid.resolution - 0.5);
  const int begin = static_cast<int>(std::clamp(first, 0.0, static_cast<double>(grid.size_x)));
  const int end = static_cast<int>(std::clamp(last, 0.0, static_cast<double>(grid.size_x)));
  for (int i = begin; i < end; ++i) {
    if (grid.at({i, j}) == cost::kLethal) return true;
  }
  return false;
}

bool row_encloses(const std::vector<Point>& line, const GridView& grid, int j) {
  Crossings crossings;
  find_crossings(line, grid.centre({0, j}).y(), crossings);
  int winding = 0;
  for (std::size_t k = 0; k + 1 < crossings.count; ++k) {
    winding += crossings.all[k].turn;
    if (winding != 0 && has_lethal(grid, j, crossings.all[k].x, crossings.all[k + 1].x)) return true;
  }
  return false;
}

}  // namespace

bool encloses_obstacle(const std::vector<Point>& line, const GridView& costmap) {
  if (line.size() < 3 || !costmap.valid()) return false;
  const auto [low, high] =
      std::minmax_element(line.begin(), line.end(), [](const Point& a, const Point& b) { return a.y() < b.y(); });
  const int first = std::max(0, costmap.cell_at(costmap.origin_x, low->y()).j);
  const int last = std::min(costmap.size_y - 1, costmap.cell_at(costmap.origin_x, high->y()).j);
  for (int j = first; j <= last; ++j) {
    if (row_encloses(line, costmap, j)) return true;
  }
  return false;
}

}  // namespace hidwa_local_planner::control
