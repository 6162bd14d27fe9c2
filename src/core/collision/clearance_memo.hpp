// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Poses that were found free, each with its clearance: how far every point of the robot may move from there. A pose
/// near one of them is free without looking. Kept in fine and in coarse slots; a pose that falls into a slot that is
/// taken replaces the one in it.
class ClearanceMemo {
 public:
  /// Forgets all. `radius` [m] reaches from the robot's centre to its farthest point; `spacing` [m] is between the
  /// finer slots.
  void clear(double radius, double spacing) {
    ++generation_;
    radius_ = radius;
    slots_per_metre_ = 1.0 / spacing;
  }
  void note(const Pose2& pose, double clearance) {
    const Slot at = slot(pose);
    fine_[at.fine] = coarse_[at.coarse] = {pose, clearance, generation_};
  }
  /// The clearance that a known pose nearby leaves [m]; not positive when none is near enough.
  double at(const Pose2& pose) const {
    const Slot at = slot(pose);
    const double left = left_of(fine_[at.fine], pose);
    return left > 0.0 ? left : left_of(coarse_[at.coarse], pose);
  }

 private:
  static constexpr std::size_t kSlots = 2048;
  static constexpr double kFineTurns = 16.0;  // slots per radian
  struct Entry {
    Pose2 pose;
    double clearance = 0.0;
    std::uint64_t generation = 0;
  };
  double left_of(const Entry& known, const Pose2& pose) const {
    if (known.generation != generation_) return 0.0;
    const double dx = pose.x - known.pose.x, dy = pose.y - known.pose.y;
    return known.clearance - std::sqrt(dx * dx + dy * dy) - std::abs(pose.theta - known.pose.theta) * radius_;
  }
  struct Slot {
    std::uint32_t fine, coarse;
  };
  Slot slot(const Pose2& pose) const {
    // Far below any pose, so that truncating is rounding down.
    const auto i = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.x * slots_per_metre_ + 1e9));
    const auto j = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.y * slots_per_metre_ + 1e9));
    const auto t = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.theta * kFineTurns + 1e9));
    return {mix(i, j, t), mix(i >> 1, j >> 1, t >> 1)};
  }
  static std::uint32_t mix(std::uint32_t i, std::uint32_t j, std::uint32_t t) {
    return ((i + 64 * j) ^ (t * 2531U)) % kSlots;
  }

  std::array<Entry, kSlots> fine_{}, coarse_{};
  std::uint64_t generation_ = 0;
  double radius_ = 0.0;
  double slots_per_metre_ = 20.0;
};

}  // namespace hidwa_local_planner
