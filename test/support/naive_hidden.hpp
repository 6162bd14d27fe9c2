// SPDX-License-Identifier: BSD-3-Clause
// Where somebody may stand unseen, and what the critic Occlusion says of one rollout: the slow, plain way.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

/// The length of sight from each sensor in each direction, and the places that it hides.
class NaiveHidden {
 public:
  NaiveHidden(const GridView& grid, const Pose2& robot, const SensorSectors& sectors, double reach) : grid_(grid) {
    for (int j = 0; j < grid.size_y; ++j) {
      for (int i = 0; i < grid.size_x; ++i) {
        if (grid.at({i, j}) == cost::kLethal) lethal_.push_back(grid.centre({i, j}));
      }
    }
    double farthest = 0.0;
    for (const SensorSector& sector : sectors) {
      const double x = sector.pose.x, y = sector.pose.y, c = std::cos(robot.theta), s = std::sin(robot.theta);
      Sensor sensor;
      const double across = std::hypot(grid.size_x, grid.size_y) * grid.resolution;
      sensor.at = Point(robot.x + c * x - s * y, robot.y + s * x + c * y);
      sensor.direction = robot.theta + sector.pose.theta;
      sensor.width = sector.width;
      sensor.reach = std::min(reach, across) + std::hypot(x, y);
      sensor.range = std::min(sector.range, sensor.reach + 0.35);
      farthest = std::max(farthest, sensor.range);
      sensors_.push_back(sensor);
    }
    bins_ = std::min(720, std::max(90, static_cast<int>(std::ceil(2.0 * M_PI * farthest / grid.resolution))));
    for (Sensor& sensor : sensors_) {
      for (int k = 0; k < bins_; ++k) sensor.sights.push_back(sight(sensor, k));
    }
  }

  /// Of a direction that is told apart [rad].
  double bin() const { return 2.0 * M_PI / bins_; }

  std::vector<Point> places() const {
    std::vector<Point> found;
    for (const Sensor& sensor : sensors_) {
      for (int k = 0; k < bins_; ++k) {
        const double right = sensor.sights[static_cast<std::size_t>(k)];
        const double left = sensor.sights[static_cast<std::size_t>(k + 1 < bins_ ? k + 1 : 0)];
        const double border = (k + 1) * bin();
        if (std::abs(left - right) < 0.3 || !in_view(sensor, border)) continue;
        const Point ahead(std::cos(border), std::sin(border)), to_left(-std::sin(border), std::cos(border));
        const Point shadow = left < right ? to_left : Point(-to_left);
        const double edge = std::min(left, right);
        if (is_slit(sensor, border, edge, left > right)) continue;
        // All places that count; of them the first, what is 0.3 m farther, and so on; and the last one before a gap,
        // where that is more than 0.15 m farther.
        std::vector<double> chosen, counting;
        const auto close = [&] {
          if (!chosen.empty() && !counting.empty() && counting.back() - chosen.back() > 0.15) {
            chosen.push_back(counting.back());
          }
        };
        for (double along = edge; along < std::min(sensor.reach, std::max(left, right)); along += 0.05) {
          const Point line = sensor.at + along * ahead, place = line + 0.2 * shadow, deeper = line + 0.35 * shadow;
          if (has_room(line) && has_room(place) && unseen(place) && unseen(deeper)) {
            counting.push_back(along);
            if (chosen.empty() || along - chosen.back() >= 0.3 - 1e-9) chosen.push_back(along);
          } else {
            close();
          }
        }
        close();
        for (const double along : chosen) found.push_back(sensor.at + along * ahead + 0.2 * shadow);
      }
    }
    return found;
  }

  /// Whether from every sensor that looks there a lethal cell nearer than the place is no farther from the straight
  /// line to it than half of its diagonal and one bin; or the place is beyond its range.
  bool is_behind_something(const Point& place) const {
    for (const Sensor& sensor : sensors_) {
      const Point way = place - sensor.at;
      if (!in_view(sensor, std::atan2(way.y(), way.x())) || way.norm() > sensor.range) continue;
      bool covered = false;
      for (const Point& cell : lethal_) {
        const Point to = cell - sensor.at;
        const double beside = std::abs(way.x() * to.y() - way.y() * to.x()) / way.norm();
        if (to.norm() < way.norm() && way.dot(to) > 0.0 && beside <= 0.71 * grid_.resolution + to.norm() * bin()) {
          covered = true;
        }
      }
      if (!covered) return false;
    }
    return true;
  }

 private:
  struct Sensor {
    Point at{0.0, 0.0};
    double direction = 0.0, width = 0.0, range = 0.0, reach = 0.0;
    std::vector<double> sights;
  };

  static double turn(double from, double to) { return std::remainder(to - from, 2.0 * M_PI); }
  static bool in_view(const Sensor& sensor, double bearing) {
    return sensor.width >= 2.0 * M_PI || std::abs(turn(sensor.direction, bearing)) <= 0.5 * sensor.width;
  }

  /// To the nearest cell whose disc reaches into the bin.
  double sight(const Sensor& sensor, int k) const {
    double least = sensor.range;
    const double middle = (k + 0.5) * bin(), disc = std::sqrt(0.5) * grid_.resolution;
    for (const Point& cell : lethal_) {
      const Point to = cell - sensor.at;
      const double length = to.norm();
      if (length <= disc) continue;  // the sensor is in it
      const double off = std::abs(turn(middle, std::atan2(to.y(), to.x())));
      if (off <= std::asin(disc / length) + 0.5 * bin()) least = std::min(least, length);
    }
    return least;
  }

  /// Something that is seen on the open side of an edge is less than 0.3 m away from it.
  bool is_slit(const Sensor& sensor, double border, double edge, bool open_to_left) const {
    const Point corner(edge * std::cos(border), edge * std::sin(border));
    for (int k = 0; k < bins_; ++k) {
      const double middle = (k + 0.5) * bin(), length = sensor.sights[static_cast<std::size_t>(k)];
      const double off = open_to_left ? turn(border, middle) : turn(middle, border);
      if (off < 0.0 || length >= sensor.range) continue;
      const double turned = std::max(0.0, off - 0.5 * bin());
      if (edge * std::sin(turned) >= 0.3 || turned >= 0.5 * M_PI) continue;
      if ((length * Point(std::cos(middle), std::sin(middle)) - corner).norm() < 0.3) return true;
    }
    return false;
  }

  bool has_room(const Point& middle) const {
    const double x = middle.x() - grid_.origin_x, y = middle.y() - grid_.origin_y;
    if (x < 0.15 || y < 0.15 || x + 0.15 >= grid_.size_x * grid_.resolution) return false;
    if (y + 0.15 >= grid_.size_y * grid_.resolution) return false;
    return std::none_of(lethal_.begin(), lethal_.end(), [&](const Point& c) { return (c - middle).norm() <= 0.15; });
  }

  bool unseen(const Point& point) const {
    for (const Sensor& sensor : sensors_) {
      const Point to = point - sensor.at;
      double bearing = std::atan2(to.y(), to.x());
      if (!in_view(sensor, bearing)) continue;
      if (bearing < 0.0) bearing += 2.0 * M_PI;
      const int k = std::min(bins_ - 1, static_cast<int>(bearing / bin()));
      if (to.norm() <= sensor.sights[static_cast<std::size_t>(k)]) return false;
    }
    return true;
  }

  GridView grid_;
  std::vector<Point> lethal_;
  std::vector<Sensor> sensors_;
  int bins_ = 0;
};

/// [m] What Occlusion says of a rollout of this sample [m/s]. `poses`: start pose first, `step` [s] apart. `inscribed`:
/// radius of the robot's inscribed circle, `disc`: of a place [m]. `apart`: time between two poses that count [s].
inline double naive_occlusion(const std::vector<Pose2>& poses, double step, double sample, double inscribed,
                              const std::vector<Point>& places, double disc, const Parameters& p, double apart = 0.25) {
  const double v = std::abs(sample), a = p.decel_lim_x == 0.0 ? p.acc_lim_x : std::abs(p.decel_lim_x);
  if (v <= p.blind_speed) return 0.0;
  const double reaction = p.control_latency + 0.1, until_rest = reaction + v / a;
  const double needed = p.occlusion_speed * until_rest + v * reaction + v * v / (2.0 * a);
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(apart / step)));
  double sum = 0.0;
  for (std::size_t k = stride; k < poses.size(); k += stride) {
    double risk = 0.0;
    for (const Point& place : places) {
      const double away = std::hypot(place.x() - poses[k].x, place.y() - poses[k].y);
      risk = std::max(risk, 1.0 - std::max(0.0, away - disc - inscribed) / needed);
    }
    sum += risk * (v - p.blind_speed) * static_cast<double>(stride) * step;
  }
  return sum;
}

}  // namespace hidwa_local_planner::test
