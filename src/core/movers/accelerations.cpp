// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/accelerations.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

constexpr double kMemory = 0.2;               // what was so long ago counts 1/e as much [s]
constexpr double kExplains = 1.25 / kMemory;  // so much of an acceleration, per deviation of the velocity [1/s]
constexpr double kSameStamp = 1e-4;           // estimates that are no farther apart are one [s]
constexpr double kSettles = 0.2;              // for which an estimate follows a leap, or a new track its body [s]
constexpr double kLongAgo = 0.5;              // an estimate that was so long ago says nothing [s]

Point no_more_than(double most, const Point& vector) {
  const double size = vector.norm();
  return size > most ? Point(most / size * vector) : vector;
}

}  // namespace

void Accelerations::watch(const MovingObstacleEstimates& movers, double time) {
  memory_.begin();
  for (const MovingObstacleEstimate& mover : movers) {
    if (memory_.full()) return;
    const One* last = memory_.before(mover.id);
    const double stamp = time - mover.age;
    const double elapsed = last != nullptr ? stamp - last->stamp : kLongAgo;
    if (std::abs(elapsed) < kSameStamp) {
      memory_.keep(*last);
      continue;
    }
    One one{mover.id, mover.velocity, Point(0.0, 0.0), kExplains * mover.velocity_deviation, stamp, stamp};
    if (elapsed > 0.0 && elapsed < kLongAgo) {
      const Point change = (one.velocity - last->velocity) / elapsed;
      const double share = 1.0 - std::exp(-elapsed / kMemory);
      if (change.norm() < kLeap) one.leapt = last->leapt;
      if (stamp - one.leapt > kSettles) {
        one.acceleration = last->acceleration + share * (no_more_than(kBelieved, change) - last->acceleration);
      }
    }
    memory_.keep(one);
  }
}

Point Accelerations::of(std::uint32_t id) const {
  const One* one = memory_.now(id);
  if (one == nullptr || !one->acceleration.allFinite()) return {0.0, 0.0};  // not where it was loaded damaged
  const double size = one->acceleration.norm(), counts = size - one->explained;
  return counts > 0.0 ? no_more_than(std::min(counts, kBelieved), one->acceleration) : Point(0.0, 0.0);
}

}  // namespace hidwa_local_planner
