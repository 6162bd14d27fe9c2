// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/accelerations.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

constexpr double kMemory = 0.1;      // what was so long ago counts 1/e as much [s]
constexpr double kSameStamp = 1e-4;  // estimates that are no farther apart are one [s]
constexpr double kSettles = 0.2;     // for which an estimate follows a leap, or a new track its body [s]
constexpr double kLongAgo = 0.5;     // an estimate that was so long ago says nothing [s]

}  // namespace

Accelerations::Accelerations() {
  before_.reserve(kMost);
  now_.reserve(kMost);
}

void Accelerations::watch(const MovingObstacleEstimates& movers, double time) {
  before_.swap(now_);
  now_.clear();
  for (std::size_t i = 0; i < std::min(movers.size(), kMost); ++i) {
    const MovingObstacleEstimate& mover = movers[i];
    const double stamp = time - mover.age;
    One one{mover.id, mover.velocity, Point(0.0, 0.0), stamp, stamp};
    const One* last = find(before_, mover.id, i);
    const double elapsed = last != nullptr ? one.stamp - last->stamp : kLongAgo;
    if (std::abs(elapsed) < kSameStamp) {
      one = *last;
    } else if (elapsed > 0.0 && elapsed < kLongAgo) {
      const Point change = (one.velocity - last->velocity) / elapsed;
      const double share = 1.0 - std::exp(-elapsed / kMemory);
      if (change.norm() < kLeap) one.leapt = last->leapt;
      if (stamp - one.leapt > kSettles) one.acceleration = last->acceleration + share * (change - last->acceleration);
    }
    now_.push_back(one);
  }
}

Point Accelerations::of(std::uint32_t id) const {
  const One* one = find(now_, id, 0);
  if (one == nullptr || !one->acceleration.allFinite()) return {0.0, 0.0};  // not where it was loaded damaged
  const double size = one->acceleration.norm();
  return size > kBelieved ? Point(kBelieved / size * one->acceleration) : one->acceleration;
}

// Most are where they were in the list before.
const Accelerations::One* Accelerations::find(const std::vector<One>& all, std::uint32_t id, std::size_t from) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const One& one = all[(from + k) % all.size()];
    if (one.id == id) return &one;
  }
  return nullptr;
}

}  // namespace hidwa_local_planner
