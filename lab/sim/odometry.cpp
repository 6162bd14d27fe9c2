// SPDX-License-Identifier: BSD-3-Clause
#include "sim/odometry.hpp"

#include <stdexcept>

namespace hidwa_local_planner {
namespace sim {

Odometry::Odometry(const OdometryNoise& noise, std::uint64_t seed)
    : noise_(noise), random_(seed), slip_age_(noise.slip_period) {
  if (!(noise.slip_x >= 0.0 && noise.slip_theta >= 0.0 && noise.slip_period > 0.0)) {
    throw std::invalid_argument("odometry noise: slips must not be negative, slip_period must be positive");
  }
}

void Odometry::step(const Motion& motion, const Velocity& velocity, double dt) {
  if (slip_age_ >= noise_.slip_period) {
    slip_x_ = noise_.slip_x * random_.normal();
    slip_theta_ = noise_.slip_theta * random_.normal();
    slip_age_ = 0.0;
  }
  slip_age_ += dt;
  pose_ = moved(pose_, {motion.distance * (1.0 + slip_x_), motion.angle * (1.0 + slip_theta_)});
  velocity_ = {velocity.v * (1.0 + slip_x_), velocity.omega * (1.0 + slip_theta_)};
}

}  // namespace sim
}  // namespace hidwa_local_planner
