// SPDX-License-Identifier: BSD-3-Clause
#include "study/bystander.hpp"

#include <algorithm>
#include <utility>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kAttacked = 20.0;  // [s]

}  // namespace

Room room_among(std::shared_ptr<const sim::People> people, Room walls) {
  return [people = std::move(people), walls = std::move(walls)](const Eigen::Vector2d& point, double ahead,
                                                                double at_most) {
    double least = walls ? std::min(at_most, walls(point, ahead, at_most)) : at_most;
    for (const sim::Mover& mover : people->movers()) {
      least = std::min(least, (mover.position + ahead * mover.velocity - point).norm() - mover.radius);
    }
    return least;
  };
}

std::shared_ptr<sim::Operator> person_among(const std::string& mode, const Parameters& parameters, Room room,
                                            std::uint64_t seed) {
  const FullDeflection full{parameters.max_vel_x, parameters.max_vel_theta, parameters.exponent};
  if (mode == "HELPFUL") return std::make_shared<HelpfulPerson>(std::move(room), full);
  if (mode == "HOSTILE") return std::make_shared<HostilePerson>(std::move(room), full, seed);
  if (mode == "AFTERMATH") return std::make_shared<HostilePerson>(std::move(room), full, seed, kAttacked);
  return nullptr;
}

}  // namespace study
}  // namespace hidwa_local_planner
