// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "random.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// What a robot knows of its own motion: everything that was true, and what a faulty sensor makes of it.
class Sensors {
 public:
  Sensors(const Spec& spec, std::uint64_t seed) : spec_(spec), random_(seed) {}

  /// The truth, each millisecond.
  void record(const Pose2& pose, const Twist2& velocity) {
    truth_.push_back({pose, velocity});
    if (truth_.size() > kRemembered) truth_.pop_front();
  }
  /// The pose of `age` [ms] ago.
  const Pose2& pose(int age) const { return at(age).pose; }
  /// The reading of the cycle at `now` [ms]; none while odometry is silent.
  std::optional<Twist2> odometry(int now);

 private:
  struct Moment {
    Pose2 pose;
    Twist2 velocity;
  };
  const Moment& at(int age) const {
    const auto back = static_cast<std::size_t>(age) + 1;
    return back <= truth_.size() ? truth_[truth_.size() - back] : truth_.front();
  }
  Twist2 noisy(const Twist2& true_one);
  Twist2 outlier(const Twist2& true_one);
  Twist2 slipped(const Twist2& true_one);
  bool silent(int now);
  bool flickers();

  const Spec& spec_;
  Random random_;
  static constexpr std::size_t kRemembered = 3000;  // longer than any age [ms]
  std::deque<Moment> truth_;
  int silent_until_ = 0, dead_from_ = 0;  // [ms]
  int silent_cycles_ = 0;                 // that are left
  int wrong_ = 0, right_ = 0;             // readings: wrong ones that are left, right ones in a row
};

}  // namespace hidwa_attack
