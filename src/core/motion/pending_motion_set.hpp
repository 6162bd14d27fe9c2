// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/motion/pending_motion.hpp"

namespace hidwa_local_planner {

/// All pending motions that the robot may be in. Where odometry disagrees with the commands, the robot may follow
/// either, on each axis alone. The likely motions come first. The unlikely ones after them count only in the thorough
/// checks, and those of a base that lags only where there is no room for the growth (BrakingCheck).
class PendingMotionSet {
 public:
  static constexpr std::size_t kMostUnlikely = 6;
  static constexpr std::size_t kMost = 4 + kMostUnlikely + kLags.size();

  PendingMotionSet() = default;
  explicit PendingMotionSet(const PendingMotion& only) { first() = only; }

  /// The first motion, the likeliest one. Calling this empties the set of all others.
  PendingMotion& first() {
    count_ = 1;
    unlikely_ = lagging_ = 0;
    return motions_[0];
  }
  /// Adds, for every motion so far, the same motion with this velocity on one axis [m/s or rad/s]. Once per axis.
  void add_alternative(double Twist2::*axis, double velocity) {
    const std::size_t before = count_;
    for (std::size_t i = 0; i < before; ++i) {
      motions_[count_] = motions_[i];
      motions_[count_++].replace(axis, velocity);
    }
  }
  /// Adds an unlikely motion: at most kMostUnlikely, after all alternatives.
  PendingMotion& add_unlikely() { return motions_[count_ + unlikely_++]; }
  /// Adds one that lags: one for each of kLags, after all others.
  PendingMotion& add_lagging() { return motions_[all() + lagging_++]; }

  std::size_t likely() const { return count_; }
  std::size_t all() const { return count_ + unlikely_; }
  std::size_t with_lagging() const { return all() + lagging_; }
  const PendingMotion& operator[](std::size_t i) const { return motions_[i]; }
  /// The largest |v| and the largest |omega| of all motions [m/s, rad/s].
  Twist2 fastest() const {
    Twist2 most;
    for (std::size_t i = 0; i < all(); ++i) most = larger_of(most, motions_[i].fastest());
    return most;
  }

 private:
  std::array<PendingMotion, kMost> motions_;
  std::size_t count_ = 1;  // likely ones
  std::size_t unlikely_ = 0;
  std::size_t lagging_ = 0;
};

}  // namespace hidwa_local_planner
