// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// For how long the robot has come to no pose that it had not been at: one that turns to and fro moves, and gets
/// nowhere. Remembers the last eight poses, 0.1 m or 20 degrees apart.
class Novelty {
 public:
  static constexpr double kApart = 0.1;         // [m]
  static constexpr double kTurnedApart = 0.35;  // [rad]

  void reset() { next_ = count_ = 0; }
  void observe(const Pose2& pose, double now) {
    if (count_ > 0 && now >= since_ && known(pose)) return;
    poses_[next_] = pose;
    next_ = (next_ + 1) % static_cast<std::uint32_t>(poses_.size());
    count_ = count_ < poses_.size() ? count_ + 1 : count_;
    since_ = now;
  }
  /// [s]
  double time_without(double now) const { return count_ > 0 ? now - since_ : 0.0; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.next_, self.count_, self.since_);
    for (auto& pose : self.poses_) io(pose);
    if constexpr (!std::is_const_v<Self>) self.next_ %= static_cast<std::uint32_t>(self.poses_.size());
  }

 private:
  bool known(const Pose2& pose) const {
    for (std::size_t k = 0; k < count_ && k < poses_.size(); ++k) {
      if (distance(poses_[k], pose) < kApart && std::abs(wrap_angle(poses_[k].theta - pose.theta)) < kTurnedApart) {
        return true;
      }
    }
    return false;
  }

  std::array<Pose2, 8> poses_{};
  std::uint32_t next_ = 0, count_ = 0;
  double since_ = 0.0;  // the last new one [s]
};

}  // namespace hidwa_local_planner
