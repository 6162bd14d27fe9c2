// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_2d.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <utility>

namespace costmap_2d {
namespace {

// Whole cells in `cells`, towards zero; what falls short of a whole cell by rounding only counts as whole.
int wholeCells(double cells) { return static_cast<int>(cells + std::copysign(1e-6, cells)); }

}  // namespace

Costmap2D::Costmap2D(unsigned int cells_size_x, unsigned int cells_size_y, double resolution, double origin_x,
                     double origin_y, unsigned char default_value)
    : default_value_(default_value) {
  resizeMap(cells_size_x, cells_size_y, resolution, origin_x, origin_y);
}

Costmap2D::Costmap2D(const Costmap2D& map)
    : size_x_(map.size_x_),
      size_y_(map.size_y_),
      resolution_(map.resolution_),
      origin_x_(map.origin_x_),
      origin_y_(map.origin_y_),
      default_value_(map.default_value_),
      cells_(map.cells_) {}

Costmap2D& Costmap2D::operator=(const Costmap2D& map) {
  if (this != &map) {
    size_x_ = map.size_x_;
    size_y_ = map.size_y_;
    resolution_ = map.resolution_;
    origin_x_ = map.origin_x_;
    origin_y_ = map.origin_y_;
    default_value_ = map.default_value_;
    cells_ = map.cells_;
  }
  return *this;
}

bool Costmap2D::copyCostmapWindow(const Costmap2D& map, double win_origin_x, double win_origin_y, double win_size_x,
                                  double win_size_y) {
  unsigned int x0, y0, x1, y1;
  if (this == &map || !map.worldToMap(win_origin_x, win_origin_y, x0, y0) ||
      !map.worldToMap(win_origin_x + win_size_x, win_origin_y + win_size_y, x1, y1)) {
    return false;
  }
  resizeMap(x1 - x0, y1 - y0, map.resolution_, win_origin_x, win_origin_y);
  for (unsigned int y = 0; y < size_y_; ++y) {
    std::memcpy(getCharMap() + getIndex(0, y), map.getCharMap() + map.getIndex(x0, y0 + y), size_x_);
  }
  return true;
}

void Costmap2D::mapToWorld(unsigned int mx, unsigned int my, double& wx, double& wy) const {
  wx = origin_x_ + (mx + 0.5) * resolution_;
  wy = origin_y_ + (my + 0.5) * resolution_;
}

bool Costmap2D::worldToMap(double wx, double wy, unsigned int& mx, unsigned int& my) const {
  const double x = (wx - origin_x_) / resolution_;
  const double y = (wy - origin_y_) / resolution_;
  if (!(x >= 0.0 && y >= 0.0 && x < size_x_ && y < size_y_)) return false;
  mx = static_cast<unsigned int>(x);
  my = static_cast<unsigned int>(y);
  return true;
}

void Costmap2D::worldToMapNoBounds(double wx, double wy, int& mx, int& my) const {
  mx = static_cast<int>((wx - origin_x_) / resolution_);
  my = static_cast<int>((wy - origin_y_) / resolution_);
}

void Costmap2D::worldToMapEnforceBounds(double wx, double wy, int& mx, int& my) const {
  const auto cell = [this](double offset, unsigned int size) {
    return static_cast<int>(std::clamp(offset / resolution_, 0.0, std::max(1.0, double(size)) - 1.0));
  };
  mx = cell(wx - origin_x_, size_x_);
  my = cell(wy - origin_y_, size_y_);
}

void Costmap2D::updateOrigin(double new_origin_x, double new_origin_y) {
  const int dx = wholeCells((new_origin_x - origin_x_) / resolution_);
  const int dy = wholeCells((new_origin_y - origin_y_) / resolution_);
  if (dx == 0 && dy == 0) return;
  const int width = static_cast<int>(size_x_);
  const int height = static_cast<int>(size_y_);
  std::vector<unsigned char> moved(cells_.size(), default_value_);
  const int kept = width - std::abs(dx);
  if (kept > 0) {
    for (int y = std::max(0, -dy); y < std::min(height, height - dy); ++y) {
      const unsigned char* from = cells_.data() + (y + dy) * width + std::max(0, dx);
      std::memcpy(moved.data() + y * width + std::max(0, -dx), from, static_cast<std::size_t>(kept));
    }
  }
  // In place: whoever holds the pointer of getCharMap() keeps seeing this map.
  std::copy(moved.begin(), moved.end(), cells_.begin());
  origin_x_ += dx * resolution_;
  origin_y_ += dy * resolution_;
}

bool Costmap2D::saveMap(const std::string& file_name) const {
  std::ofstream file(file_name, std::ios::binary);
  file << "P5\n" << size_x_ << " " << size_y_ << "\n255\n";
  for (unsigned int row = 0; row < size_y_; ++row) {  // the picture's first row is the map's last
    file.write(reinterpret_cast<const char*>(cells_.data() + getIndex(0, size_y_ - 1 - row)), size_x_);
  }
  return file.good();
}

void Costmap2D::resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                          double origin_y) {
  size_x_ = size_x;
  size_y_ = size_y;
  resolution_ = resolution;
  origin_x_ = origin_x;
  origin_y_ = origin_y;
  cells_.assign(std::size_t(size_x) * size_y, default_value_);
}

void Costmap2D::resetMap(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn) {
  for (unsigned int y = y0; y < yn; ++y) {
    std::memset(cells_.data() + getIndex(x0, y), default_value_, xn - x0);
  }
}

unsigned int Costmap2D::cellDistance(double world_dist) const {
  return static_cast<unsigned int>(std::max(0.0, std::ceil(world_dist / resolution_)));
}

}  // namespace costmap_2d
