// SPDX-License-Identifier: BSD-3-Clause
#include "contact_watch.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {
namespace {

constexpr double kNear = 0.10;     // [m]
constexpr double kSight = 0.30;    // farther is not measured [m]
constexpr double kFinest = 2e-5;   // between two looks [m]
constexpr double kCoarse = 0.005;  // where it is about to come near [m]

}  // namespace

ContactWatch::ContactWatch(const World& world, const Shape& padded_shape)
    : world_(world), shape_(padded_shape), outermost_(outermost(padded_shape)) {}

void ContactWatch::observe(int now, const Pose2& pose, const Twist2& velocity) {
  moved_ += 1e-3 * (std::abs(velocity.v) + outermost_ * std::abs(velocity.omega));
  const double gap = -depth_;
  const double due = gap > kNear ? std::max(gap - kNear, kCoarse) : std::max(0.9 * gap, kFinest);
  if (moved_ >= due) look(now, pose);
}

void ContactWatch::look(int now, const Pose2& pose) {
  moved_ = 0.0;
  depth_ = deepest(world_, Placed(shape_, pose), kSight);
  if (depth_ > kTouch && touched_at_ < 0) touched_at_ = now;
  deepest_ = std::max(deepest_, depth_);
}

}  // namespace hidwa_attack
