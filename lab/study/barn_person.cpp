// SPDX-License-Identifier: BSD-3-Clause
#include "study/barn_person.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kLookAhead = 1.0;  // [s], along an arc
constexpr double kArcStep = 0.05;   // [s]
constexpr double kFar = 2.0;        // [m], beyond it an obstacle does not matter

// Free space between the centre of the robot and the nearest obstacle, the smallest along an arc [m].
double room_along(const Room& room, const sim::Pose& pose, double v, double omega) {
  double least = kFar;
  for (double t = kArcStep; t < kLookAhead + 0.5 * kArcStep; t += kArcStep) {
    const sim::Pose at = sim::moved(pose, {v * t, omega * t});
    least = room({at.x, at.y}, t, least);
  }
  return least;
}

double uniform(sim::Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

}  // namespace

HostilePerson::HostilePerson(Room room, const FullDeflection& full, std::uint64_t seed, double leaves)
    : room_(std::move(room)), full_(full), random_(seed), leaves_(leaves) {}

sim::Stick HostilePerson::update(const sim::Observation& seen) {
  if (seen.time >= leaves_) return {};
  if (seen.time >= phase_ends_) begin_phase(seen.time);
  if (phase_ == Phase::resting) return {};
  if (phase_ == Phase::aiming) {
    side_ = nearer_side(seen.pose);
  } else if (seen.time >= flips_) {
    side_ = -side_;
    flips_ = seen.time + uniform(random_, 0.05, 0.4);
  }
  return {side_, 1.0};
}

void HostilePerson::begin_phase(double now) {
  if (phase_ != Phase::resting) {
    phase_ = Phase::resting;
    phase_ends_ = now + uniform(random_, 1.0, 6.0);
    return;
  }
  phase_ = random_.uniform() < 0.6 ? Phase::aiming : Phase::flipping;
  phase_ends_ = now + uniform(random_, 0.5, 5.0);
  flips_ = now;
}

// Left 1, right -1; where neither is nearer, as before.
double HostilePerson::nearer_side(const sim::Pose& pose) const {
  const double left = room_along(room_, pose, full_.v, full_.omega);
  const double right = room_along(room_, pose, full_.v, -full_.omega);
  if (left == right) return side_;
  return left < right ? 1.0 : -1.0;
}

HelpfulPerson::HelpfulPerson(Room room, const FullDeflection& full) : room_(std::move(room)), full_(full) {}

sim::Stick HelpfulPerson::update(const sim::Observation& seen) {
  constexpr double kPeriod = 0.25;  // [s], of decisions
  if (seen.time >= decides_) {
    left_ = decide(seen.pose);
    decides_ = seen.time + kPeriod;
  }
  return left_ == 0.0 ? sim::Stick{} : sim::Stick{left_, 1.0};
}

// How far the plan's direction is to the left of the robot's [rad].
double HelpfulPerson::off_plan(const sim::Pose& pose) const {
  constexpr double kAhead = 0.8;  // [m], along the plan
  if (plan_.empty()) return 0.0;
  const Eigen::Vector2d here(pose.x, pose.y);
  const auto nearest = std::min_element(plan_.begin(), plan_.end(), [&here](const auto& a, const auto& b) {
    return (a - here).squaredNorm() < (b - here).squaredNorm();
  });
  auto ahead = nearest;
  for (double way = 0.0; way < kAhead && ahead + 1 != plan_.end(); ++ahead) way += (*(ahead + 1) - *ahead).norm();
  const Eigen::Vector2d to = *ahead - here;
  return sim::normalized(std::atan2(to.y(), to.x()) - pose.theta);
}

double HelpfulPerson::decide(const sim::Pose& pose) const {
  constexpr double kFaces = 0.15;  // [rad]
  const double off = off_plan(pose);
  if (std::abs(off) < kFaces) return 0.0;
  double best = 0.0, most = -std::numeric_limits<double>::infinity();
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const double room = room_along(room_, pose, full_.v, std::copysign(share * full_.omega, off));
    if (room <= most) continue;
    most = room;
    best = share;
  }
  return std::copysign(std::pow(best, 1.0 / full_.exponent), off);
}

}  // namespace study
}  // namespace hidwa_local_planner
