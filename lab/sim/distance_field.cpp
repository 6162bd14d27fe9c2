// SPDX-License-Identifier: BSD-3-Clause
#include "sim/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kFar = 1e12;  // [cells^2], of a row or column without a marked cell

/// Lower envelope of the parabolas f[q] + (p - q)^2 at every p, in linear time
/// (Felzenszwalb and Huttenlocher 2012, "Distance transforms of sampled functions").
class Envelope {
 public:
  explicit Envelope(std::size_t longest) : vertex_(longest), border_(longest + 1) {}

  void transform(const std::vector<double>& f, std::size_t n, std::vector<double>& result) {
    std::size_t k = 0;
    vertex_[0] = 0;
    border_[0] = -std::numeric_limits<double>::infinity();
    for (std::size_t q = 1; q < n; ++q) {
      double s = intersection(f, q, vertex_[k]);
      while (s <= border_[k]) s = intersection(f, q, vertex_[--k]);
      vertex_[++k] = q;
      border_[k] = s;
    }
    std::size_t i = 0;
    for (std::size_t p = 0; p < n; ++p) {
      while (i < k && border_[i + 1] < static_cast<double>(p)) ++i;
      const double d = static_cast<double>(p) - static_cast<double>(vertex_[i]);
      result[p] = d * d + f[vertex_[i]];
    }
  }

 private:
  static double intersection(const std::vector<double>& f, std::size_t q, std::size_t r) {
    const auto a = static_cast<double>(q);
    const auto b = static_cast<double>(r);
    return ((f[q] + a * a) - (f[r] + b * b)) / (2.0 * (a - b));
  }

  std::vector<std::size_t> vertex_;
  std::vector<double> border_;
};

}  // namespace

DistanceField::DistanceField(const OccupancyMap& map, const std::vector<std::uint8_t>& marked)
    : map_(map), distance_(marked.size()) {
  const auto width = static_cast<std::size_t>(map.width);
  const auto height = static_cast<std::size_t>(map.height);
  std::vector<double> line(std::max(width, height));
  std::vector<double> result(line.size());
  std::vector<double> squared(marked.size());
  Envelope envelope(line.size());
  for (std::size_t column = 0; column < width; ++column) {
    for (std::size_t row = 0; row < height; ++row) line[row] = marked[row * width + column] ? 0.0 : kFar;
    envelope.transform(line, height, result);
    for (std::size_t row = 0; row < height; ++row) squared[row * width + column] = result[row];
  }
  for (std::size_t row = 0; row < height; ++row) {
    std::copy_n(squared.begin() + static_cast<std::ptrdiff_t>(row * width), width, line.begin());
    envelope.transform(line, width, result);
    for (std::size_t column = 0; column < width; ++column) {
      distance_[row * width + column] = static_cast<float>(std::sqrt(result[column]) * map.resolution);
    }
  }
}

DistanceField DistanceField::to_obstacles(const OccupancyMap& map) {
  std::vector<std::uint8_t> marked(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), marked.begin(),
                 [](Cell cell) { return static_cast<std::uint8_t>(cell == Cell::kOccupied); });
  return DistanceField(map, marked);
}

DistanceField DistanceField::to_regions(const OccupancyMap& map, const std::vector<Region>& regions) {
  std::vector<std::uint8_t> marked(map.cells.size(), 0);
  for (const Region& region : regions) {
    const Box box = bounds(region.polygon);
    for (int row = std::max(0, map.row(box.low.y())); row <= std::min(map.height - 1, map.row(box.high.y())); ++row) {
      for (int column = std::max(0, map.column(box.low.x()));
           column <= std::min(map.width - 1, map.column(box.high.x())); ++column) {
        if (contains(region.polygon, {map.center_x(column), map.center_y(row)})) marked[map.index(column, row)] = 1;
      }
    }
  }
  return DistanceField(map, marked);
}

double DistanceField::at(double x, double y) const {
  const int column = std::clamp(map_.column(x), 0, map_.width - 1);
  const int row = std::clamp(map_.row(y), 0, map_.height - 1);
  return at_cell(column, row);
}

}  // namespace sim
}  // namespace hidwa_local_planner
