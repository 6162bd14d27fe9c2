// SPDX-License-Identifier: BSD-3-Clause
#include "sim/disc_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kBucket = 0.3;  // [m], side of a square
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

double distance_to_border(const Eigen::Vector2d& p, const Polygon& polygon) {
  double least = kInfinity;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    least = std::min(least, distance_to_segment(p, polygon[j], polygon[i]));
  }
  return least;
}

// Along a ray of direction (c, s) from `from` to the disc [m]; infinite where it passes.
double ray_to_disc(const Eigen::Vector2d& from, double c, double s, const Eigen::Vector2d& centre, double radius) {
  const Eigen::Vector2d to = centre - from;
  const double along = to.x() * c + to.y() * s;
  const double across = to.y() * c - to.x() * s;
  if (to.squaredNorm() <= radius * radius) return 0.0;
  const double half2 = radius * radius - across * across;
  if (half2 < 0.0 || along < 0.0) return kInfinity;
  return std::max(0.0, along - std::sqrt(half2));
}

}  // namespace

DiscField::DiscField(std::vector<Eigen::Vector2d> centres, double radius)
    : centres_(std::move(centres)), radius_(radius), low_(Eigen::Vector2d::Zero()) {
  if (!(radius_ > 0.0) || !std::isfinite(radius_)) {
    throw std::invalid_argument("the radius of the discs must be positive");
  }
  if (centres_.empty()) return;
  const bool numbers = std::all_of(centres_.begin(), centres_.end(), [](const Eigen::Vector2d& c) {
    return std::isfinite(c.x()) && std::isfinite(c.y());
  });
  if (!numbers) throw std::invalid_argument("the centre of a disc is not a number");
  const Box box = bounds(centres_);
  low_ = box.low - Eigen::Vector2d(radius_, radius_);
  columns_ = column(box.high.x() + radius_) + 1;
  rows_ = row(box.high.y() + radius_) + 1;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    const Eigen::Vector2d& c = centres_[k];
    for (int j = row(c.y() - radius_); j <= std::min(rows_ - 1, row(c.y() + radius_)); ++j) {
      for (int i = column(c.x() - radius_); i <= std::min(columns_ - 1, column(c.x() + radius_)); ++i) {
        if (i < 0 || j < 0) continue;
        buckets_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)]
            .push_back(static_cast<std::uint32_t>(k));
      }
    }
  }
}

int DiscField::column(double x) const { return static_cast<int>(std::floor((x - low_.x()) / kBucket)); }
int DiscField::row(double y) const { return static_cast<int>(std::floor((y - low_.y()) / kBucket)); }

const std::vector<std::uint32_t>& DiscField::bucket(int column, int row) const {
  static const std::vector<std::uint32_t> none;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return none;
  return buckets_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

template <typename Visit>
void DiscField::visit_near(const Box& box, double reach, Visit&& visit) const {
  const int last_row = std::min(row(box.high.y() + reach), rows_ - 1);
  const int last_column = std::min(column(box.high.x() + reach), columns_ - 1);
  for (int j = std::max(0, row(box.low.y() - reach)); j <= last_row; ++j) {
    for (int i = std::max(0, column(box.low.x() - reach)); i <= last_column; ++i) {
      for (const std::uint32_t k : bucket(i, j)) visit(centres_[k]);
    }
  }
}

double DiscField::gap(const Polygon& polygon, double at_most) const {
  double least = at_most;
  if (polygon.empty()) return least;
  visit_near(bounds(polygon), at_most, [&](const Eigen::Vector2d& centre) {
    if (least <= 0.0) return;
    least = contains(polygon, centre) ? 0.0 : std::min(least, distance_to_border(centre, polygon) - radius_);
  });
  return std::max(0.0, least);
}

double DiscField::distance(const Eigen::Vector2d& point, double at_most) const {
  double least = at_most;
  visit_near({point, point}, at_most,
             [&](const Eigen::Vector2d& centre) { least = std::min(least, (centre - point).norm() - radius_); });
  return least;
}

// From square to square along the ray; what is met in one of them before the ray leaves it is met first.
double DiscField::range(double x, double y, double angle, double range_max) const {
  if (centres_.empty()) return kInfinity;
  const double c = std::cos(angle), s = std::sin(angle);
  const Eigen::Vector2d from(x, y);
  // To where the ray comes in, and along it to where it leaves all squares.
  double enter = 0.0, leave = range_max;
  const auto clip = [&](double start, double direction, double low, double high) {
    if (direction == 0.0) {
      if (start < low || start > high) leave = -1.0;
      return;
    }
    const double a = (low - start) / direction, b = (high - start) / direction;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(x, c, low_.x(), low_.x() + columns_ * kBucket);
  clip(y, s, low_.y(), low_.y() + rows_ * kBucket);
  if (enter > leave) return kInfinity;
  int i = std::clamp(column(x + enter * c), 0, columns_ - 1), j = std::clamp(row(y + enter * s), 0, rows_ - 1);
  while (i >= 0 && j >= 0 && i < columns_ && j < rows_) {
    const double exit_x = c == 0.0 ? kInfinity : (low_.x() + (i + (c > 0.0 ? 1 : 0)) * kBucket - x) / c;
    const double exit_y = s == 0.0 ? kInfinity : (low_.y() + (j + (s > 0.0 ? 1 : 0)) * kBucket - y) / s;
    const double exit = std::min(exit_x, exit_y);
    double nearest = kInfinity;
    for (const std::uint32_t k : bucket(i, j))
      nearest = std::min(nearest, ray_to_disc(from, c, s, centres_[k], radius_));
    if (nearest <= exit) return nearest <= range_max ? nearest : kInfinity;
    if (exit > leave) return kInfinity;
    if (exit_x < exit_y) {
      i += c > 0.0 ? 1 : -1;
    } else {
      j += s > 0.0 ? 1 : -1;
    }
  }
  return kInfinity;
}

}  // namespace sim
}  // namespace hidwa_local_planner
