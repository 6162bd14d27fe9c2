// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

/// Two may wait for each other: somebody in a doorway, and a robot that stands before it. After some patience the robot
/// goes back the way it has come, so that the other one gets out.
class StepBack {
 public:
  /// It goes back twice from one place, the second time after twice the patience. It is elsewhere at this distance [m].
  static constexpr std::uint32_t kMost = 2;
  static constexpr double kElsewhere = 3.0;
  /// A way back has no more poses.
  static constexpr std::size_t kMostPoses = 16;

  void reset() { *this = {}; }
  /// Once a cycle. `blocked`: the robot stands, and something that moves is in its only way.
  void observe(const Pose2& pose, bool blocked, double now) {
    remember(pose);
    if (times_ > 0 && distance(pose, stood_) > kElsewhere) times_ = 0;
    blocked_.observe(now, blocked);
  }
  /// It has waited for its patience [s], and has come from somewhere. Not with a patience of 0.
  bool due(double patience, double now) const {
    return patience > 0.0 && times_ < kMost && count_ >= kFewest &&
           blocked_.for_at_least(patience * static_cast<double>(1U << times_), now);
  }
  /// It goes back from here, if a way leads there.
  void begin(const Pose2& pose) {
    stood_ = pose;
    ++times_;
    blocked_.reset();
  }
  /// No way leads there: this time does not count, and it waits for its patience again.
  void fail() { times_ = times_ > 0 ? times_ - 1 : 0; }
  /// From the robot to where it was some metres ago.
  void write_way_back(const Pose2& pose, std::vector<Pose2>& way) const {
    way.assign(1, pose);
    for (std::uint32_t k = 1; k <= count_; ++k) way.push_back(pose_at(trail_[(next_ + kTrail - k) % kTrail]));
  }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.next_, self.count_, self.times_);
    if (self.times_ > 0) io(self.stood_);
    io(self.blocked_);
    for (std::uint32_t k = 0; k < self.count_ && k < kTrail; ++k) io(self.trail_[k].x, self.trail_[k].y);
    if constexpr (!std::is_const_v<Self>) {
      self.next_ %= kTrail;
      self.count_ = std::min(self.count_, kTrail);
      self.times_ = std::min(self.times_, kMost);
      for (const Position& position : self.trail_) {
        if (!std::isfinite(position.x) || !std::isfinite(position.y)) self.count_ = 0;  // damaged
      }
    }
  }

 private:
  static constexpr std::uint32_t kTrail = kMostPoses - 1;
  static constexpr std::uint32_t kFewest = 5;  // to go back along
  static constexpr double kApart = 0.2;        // [m]
  // A trail is recorded in every cycle: no more of it than is needed.
  struct Position {
    float x = 0.0F, y = 0.0F;  // costmap frame [m]
  };
  static Pose2 pose_at(const Position& position) {
    return {static_cast<double>(position.x), static_cast<double>(position.y), 0.0};
  }

  void remember(const Pose2& pose) {
    if (count_ > 0 && distance(pose_at(trail_[(next_ + kTrail - 1) % kTrail]), pose) < kApart) return;
    trail_[next_] = {static_cast<float>(pose.x), static_cast<float>(pose.y)};
    next_ = (next_ + 1) % kTrail;
    count_ = std::min(count_ + 1, kTrail);
  }

  std::array<Position, kTrail> trail_{};  // the newest before next_
  std::uint32_t next_ = 0, count_ = 0;
  std::uint32_t times_ = 0;  // that it has gone back from near the place where it stood
  Pose2 stood_;
  ConditionTimer blocked_;
};

}  // namespace hidwa_local_planner
