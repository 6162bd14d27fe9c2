// SPDX-License-Identifier: BSD-3-Clause
#include "route.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {
namespace {

constexpr double kSpacing = 0.05;  // of its points [m]
constexpr int kAtGoal = 1500;      // how long the robot is left at the goal [ms]

double apart(const Pose2& a, const Pose2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

bool Route::renew(int now, const Pose2& robot) {
  if (!points_.empty() && !latched_ && apart(robot, goal()) <= 0.25) {
    latched_ = true;
    until_ = std::min(until_, now + kAtGoal);
  }
  if (now < until_) return false;
  until_ = now + random_.whole(3000, 9000);
  lay(robot);
  return true;
}

void Route::lay(const Pose2& robot) {
  points_.assign(1, robot);
  latched_ = false;
  for (int bends = random_.whole(1, 3); bends > 0; --bends) {
    const double angle = random_.in(-M_PI, M_PI), by = random_.in(1.0, 4.0);
    const double x = points_.back().x + by * std::cos(angle), y = points_.back().y + by * std::sin(angle);
    lead_to({std::clamp(x, 0.5, world_.width() - 0.5), std::clamp(y, 0.5, world_.height() - 0.5)});
  }
}

void Route::lead_to(const Spot& next) {
  const Pose2 from = points_.back();
  const double dx = next.x - from.x, dy = next.y - from.y, length = std::hypot(dx, dy);
  const int parts = std::max(1, static_cast<int>(length / kSpacing));
  for (int k = 1; k <= parts; ++k) {
    const double t = static_cast<double>(k) / parts;
    points_.push_back({from.x + t * dx, from.y + t * dy, std::atan2(dy, dx)});
  }
}

}  // namespace hidwa_attack
