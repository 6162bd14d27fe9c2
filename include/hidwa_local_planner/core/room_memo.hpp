// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Poses that were found free, with the room around them: how far every point of the robot may move from there. A pose
/// near one of them is free without looking. It forgets what falls into the same slot.
class RoomMemo {
 public:
  /// Forgets all. `radius` [m] reaches from the robot's centre to its farthest point; `spacing` [m] between slots.
  void clear(double radius, double spacing) {
    ++generation_;
    radius_ = radius;
    slots_per_metre_ = 1.0 / spacing;
  }
  void note(const Pose2& pose, double room) { slots_[slot(pose)] = {pose, room, generation_}; }
  /// What is left of the room of a known pose [m]; not positive when none is near enough.
  double room_at(const Pose2& pose) const {
    const Entry& known = slots_[slot(pose)];
    if (known.generation != generation_) return 0.0;
    const double dx = pose.x - known.pose.x, dy = pose.y - known.pose.y;
    return known.room - std::sqrt(dx * dx + dy * dy) - std::abs(pose.theta - known.pose.theta) * radius_;
  }

 private:
  static constexpr std::size_t kSlots = 4096;
  static constexpr double kTurnsPerRadian = 8.0;
  struct Entry {
    Pose2 pose;
    double room = 0.0;
    std::uint64_t generation = 0;
  };
  static std::uint32_t whole(double value) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(value))); }
  std::size_t slot(const Pose2& pose) const {
    const std::uint32_t i = whole(pose.x * slots_per_metre_), j = whole(pose.y * slots_per_metre_);
    return ((i + 64 * j) ^ (whole(pose.theta * kTurnsPerRadian) * 2531U)) % kSlots;
  }

  std::array<Entry, kSlots> slots_{};
  std::uint64_t generation_ = 0;
  double radius_ = 0.0;
  double slots_per_metre_ = 20.0;
};

}  // namespace hidwa_local_planner
