// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/inflator.h>

#include <algorithm>
#include <cmath>

namespace costmap_2d {

void Inflator::configure(const Settings& settings) {
  settings_ = settings;
  radius_ = std::max(0, static_cast<int>(std::ceil(settings.inflation_radius / settings.resolution)));
  cost_.assign(std::size_t(radius_) * std::size_t(radius_) + 2,
               0);  // the last one is for all beyond the radius
  for (std::size_t squared = 0; squared + 1 < cost_.size(); ++squared) {
    cost_[squared] = costAt(std::sqrt(double(squared)) * settings.resolution);
  }
}

unsigned char Inflator::costAt(double distance) const {
  if (distance == 0.0) return LETHAL_OBSTACLE;
  if (distance <= settings_.inscribed_radius) return INSCRIBED_INFLATED_OBSTACLE;
  const double factor = std::exp(-settings_.cost_scaling_factor * (distance - settings_.inscribed_radius));
  return static_cast<unsigned char>((INSCRIBED_INFLATED_OBSTACLE - 1) * factor);
}

void Inflator::columnDistances(const Costmap2D& grid, const Window& seen) {
  const int width = seen.xn - seen.x0;
  const int height = seen.yn - seen.y0;
  const int far = radius_ + 1;
  column_.resize(std::size_t(width) * std::size_t(height));
  row_has_any_.assign(std::size_t(height), 0);

  const auto sweep = [&](int y, const int* before) {
    int* row = column_.data() + y * width;
    const unsigned char* costs = grid.getCharMap() + (seen.y0 + y) * static_cast<int>(grid.getSizeInCellsX()) + seen.x0;
    for (int x = 0; x < width; ++x) {
      row[x] = costs[x] == LETHAL_OBSTACLE ? 0 : std::min(far, before ? before[x] + 1 : far);
    }
  };
  for (int y = 0; y < height; ++y) sweep(y, y > 0 ? column_.data() + (y - 1) * width : nullptr);
  for (int y = height - 1; y >= 0; --y) {
    int* row = column_.data() + y * width;
    const int* below = y + 1 < height ? row + width : row;
    int least = far;
    for (int x = 0; x < width; ++x) {
      row[x] = std::min(row[x], below[x] + 1);
      least = std::min(least, row[x]);
    }
    row_has_any_[std::size_t(y)] = least < far;
  }
}

unsigned char Inflator::combined(unsigned char old_cost, unsigned char cost) const {
  if (old_cost != NO_INFORMATION) return std::max(old_cost, cost);
  const bool known_now = settings_.inflate_unknown ? cost > FREE_SPACE : cost >= INSCRIBED_INFLATED_OBSTACLE;
  return known_now ? cost : old_cost;
}

void Inflator::inflateRow(Costmap2D& grid, int y, int min_i, int max_i, const Window& seen) {
  if (!row_has_any_[std::size_t(y - seen.y0)]) return;
  const int width = seen.xn - seen.x0;
  const int count = max_i - min_i;
  const int beyond = radius_ * radius_ + 1;
  // padded_[radius_ + k] belongs to the cell k right of min_i; room for the radius on both sides.
  padded_.assign(std::size_t(count + 2 * radius_), beyond);
  const int* column = column_.data() + (y - seen.y0) * width;
  const int shift = radius_ - (min_i - seen.x0);
  for (int x = 0; x < width; ++x) padded_[std::size_t(x + shift)] = column[x] * column[x];

  nearest_.assign(padded_.begin() + radius_, padded_.begin() + radius_ + count);
  int* nearest = nearest_.data();
  for (int dx = 1; dx <= radius_; ++dx) {
    const int* left = padded_.data() + radius_ - dx;
    const int* right = padded_.data() + radius_ + dx;
    const int squared = dx * dx;
    for (int k = 0; k < count; ++k) nearest[k] = std::min(nearest[k], std::min(left[k], right[k]) + squared);
  }
  unsigned char* costs = grid.getCharMap() + y * static_cast<int>(grid.getSizeInCellsX()) + min_i;
  for (int k = 0; k < count; ++k) {
    costs[k] = combined(costs[k], cost_[std::size_t(std::min(nearest[k], beyond))]);
  }
}

void Inflator::inflate(Costmap2D& grid, int min_i, int min_j, int max_i, int max_j) {
  if (min_i >= max_i || min_j >= max_j) return;
  const Window seen{std::max(0, min_i - radius_), std::min(int(grid.getSizeInCellsX()), max_i + radius_),
                    std::max(0, min_j - radius_), std::min(int(grid.getSizeInCellsY()), max_j + radius_)};
  columnDistances(grid, seen);
  for (int y = min_j; y < max_j; ++y) inflateRow(grid, y, min_i, max_i, seen);
}

}  // namespace costmap_2d
