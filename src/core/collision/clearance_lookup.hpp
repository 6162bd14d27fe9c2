// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/collision/collision.hpp"

namespace hidwa_local_planner {

/// The clearance of poses of one cycle: how far every point of the robot may move from a pose without colliding, at
/// least. Poses that were found free are remembered: one near them is free without looking. They are kept in fine and
/// in coarse slots; a pose that falls into a slot that is taken replaces the one in it.
class ClearanceLookup {
 public:
  /// Once per evaluation: forgets all. `checker` is prepared and outlives the questions; `radius` [m] reaches from the
  /// robot's centre to its farthest point; `resolution` of the map [m].
  void prepare(const CollisionChecker& checker, double radius, double resolution) {
    checker_ = &checker;
    extra_ = kExtra * resolution;
    ++generation_;
    radius_ = radius;
    slots_per_metre_ = 1.0 / (0.5 * resolution);
  }
  /// [m]; 0 where the robot collides. Once it is known to be more than `needed` [m], the search ends.
  double at(const Pose2& pose, const Rotation& heading, double needed = 0.0) {
    const Slot slot = slot_of(pose);
    double clearance = left_of(fine_[slot.fine], pose);
    if (!(clearance > 0.0)) clearance = left_of(coarse_[slot.coarse], pose);
    if (clearance > needed) return clearance;
    clearance = measure(pose, heading, needed);
    if (clearance > 0.0) fine_[slot.fine] = coarse_[slot.coarse] = {pose, clearance, generation_};
    return clearance;
  }
  /// Likewise, but always measured: poses around it do not count.
  double measure(const Pose2& pose, const Rotation& heading, double needed) const {
    return checker_->clearance(pose, heading, needed + extra_);
  }
  const CollisionChecker& checker() const { return *checker_; }

 private:
  // The search goes on for so many cells beyond what is needed: what it finds also answers for the next poses.
  static constexpr double kExtra = 2.0;
  static constexpr std::size_t kSlots = 2048;
  static constexpr double kFineTurns = 16.0;  // slots per radian
  struct Known {
    Pose2 pose;
    double clearance = 0.0;
    std::uint64_t generation = 0;
  };
  // What the clearance of a known pose leaves [m]; not positive where it is not near enough.
  double left_of(const Known& known, const Pose2& pose) const {
    if (known.generation != generation_) return 0.0;
    const double dx = pose.x - known.pose.x, dy = pose.y - known.pose.y;
    return known.clearance - std::sqrt(dx * dx + dy * dy) - std::abs(pose.theta - known.pose.theta) * radius_;
  }
  struct Slot {
    std::uint32_t fine, coarse;
  };
  Slot slot_of(const Pose2& pose) const {
    // Far below any pose, so that truncating is rounding down.
    const auto i = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.x * slots_per_metre_ + 1e9));
    const auto j = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.y * slots_per_metre_ + 1e9));
    const auto t = static_cast<std::uint32_t>(static_cast<std::int64_t>(pose.theta * kFineTurns + 1e9));
    return {mix(i, j, t), mix(i >> 1, j >> 1, t >> 1)};
  }
  static std::uint32_t mix(std::uint32_t i, std::uint32_t j, std::uint32_t t) {
    return ((i + 64 * j) ^ (t * 2531U)) % kSlots;
  }

  const CollisionChecker* checker_ = nullptr;
  double extra_ = 0.0;   // [m]
  double radius_ = 0.0;  // [m]
  double slots_per_metre_ = 20.0;
  std::array<Known, kSlots> fine_{}, coarse_{};
  std::uint64_t generation_ = 0;
};

}  // namespace hidwa_local_planner
