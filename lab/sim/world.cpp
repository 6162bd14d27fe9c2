// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/contact.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kLongestStep = 0.01;  // [s]
constexpr int kHalvings = 12;          // of one step's travel: 10 ms at 0.5 m/s to 1.2 micrometres

Motion scaled(const Motion& motion, double share) { return {motion.distance * share, motion.angle * share}; }

}  // namespace

World::World(WorldSetup setup)
    : setup_(std::move(setup)),
      drive_(setup_.limits),
      odometry_(setup_.odometry_noise, setup_.seed),
      regions_(setup_.regions),
      watch_(setup_.footprint),
      pose_(setup_.start) {
  if (!setup_.map) throw std::invalid_argument("the simulated robot needs a map");
  if (setup_.footprint.size() < 3) throw std::invalid_argument("the footprint needs three corners or more");
  if (!is_free(pose_)) {
    throw std::invalid_argument("the start (" + std::to_string(pose_.x) + ", " + std::to_string(pose_.y) + ", " +
                                std::to_string(pose_.theta) + ") puts the footprint on an obstacle: choose a free one");
  }
  regions_.update(transformed(setup_.footprint, pose_));
}

void World::advance(double dt) {
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  for (int i = 0; i < steps; ++i) step(dt / steps);
}

bool World::is_free(const Pose& pose) const {
  const Polygon placed = transformed(setup_.footprint, pose);
  return !overlaps_occupied(*setup_.map, placed) && !(setup_.discs && setup_.discs->overlaps(placed));
}

Motion World::stop_at_obstacle(const Motion& motion) {
  double free = 0.0;
  double blocked = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (free + blocked);
    (is_free(moved(pose_, scaled(motion, middle))) ? free : blocked) = middle;
  }
  drive_.set_velocity(Velocity());
  in_contact_ = true;
  ++contacts_;
  last_free_ = moved(pose_, scaled(motion, free));
  pose_ = moved(pose_, scaled(motion, blocked));
  return scaled(motion, blocked);
}

Motion World::leave_obstacle(const Motion& motion) {
  // Away as commanded, or, where one axis is what still blocks, by the other alone.
  for (const Motion& way : {motion, Motion{motion.distance, 0.0}, Motion{0.0, motion.angle}}) {
    if (way.distance == 0.0 && way.angle == 0.0) continue;
    const Pose pose = moved(last_free_, way);
    if (!is_free(pose)) continue;
    const Velocity velocity = drive_.velocity();
    drive_.set_velocity({way.distance == 0.0 ? 0.0 : velocity.v, way.angle == 0.0 ? 0.0 : velocity.omega});
    in_contact_ = false;
    pose_ = pose;
    return way;
  }
  drive_.set_velocity(Velocity());
  return Motion();
}

void World::step(double dt) {
  Motion motion = drive_.step(time_, dt);
  const Pose next = moved(pose_, motion);
  if (in_contact_) {
    motion = leave_obstacle(motion);
  } else if (is_free(next)) {
    pose_ = next;
  } else {
    motion = stop_at_obstacle(motion);
  }
  time_ += dt;
  distance_ += std::abs(motion.distance);
  odometry_.step(motion, drive_.velocity(), dt);
  regions_.update(transformed(setup_.footprint, pose_));
  people_step(dt);
}

const std::vector<Mover>& World::movers() const {
  static const std::vector<Mover> nobody;
  return setup_.people ? setup_.people->movers() : nobody;
}

RobotSeen World::seen() const {
  const Velocity& velocity = drive_.velocity();
  return {{pose_.x, pose_.y},
          {velocity.v * std::cos(pose_.theta), velocity.v * std::sin(pose_.theta)},
          circumscribed_radius(setup_.footprint)};
}

void World::people_step(double dt) {
  if (setup_.people) setup_.people->advance(time_, seen());
  watch_.add(time_, dt, pose_, drive_.velocity(), movers());
}

}  // namespace sim
}  // namespace hidwa_local_planner
