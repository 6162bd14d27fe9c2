// SPDX-License-Identifier: BSD-3-Clause
// Oscillation, which remembers, on random histories. The other critics: planner_twin_test.cpp.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/critic_bench.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticBench;
using test::Random;
using test::Scene;

// Keeps the whole history and reads the ban out of it each time.
class NaiveOscillation {
 public:
  void note(const Pose2& pose, double time, const Twist2& command) {
    events_.push_back({pose, time, command});
    bool changed = flip(&Twist2::v) || (slow(command) && flip(&Twist2::omega));
    if (changed) since_ = events_.back();
    if (ban(&Twist2::v) == 0 && ban(&Twist2::omega) == 0) return;
    const double turned = std::abs(std::remainder(pose.theta - since_.pose.theta, 2 * M_PI));
    if (distance(pose, since_.pose) > 0.05 || turned > 0.2) {
      events_.clear();
    }
  }
  bool rejects(const Twist2& u) const { return u.v * ban(&Twist2::v) < 0.0 || u.omega * ban(&Twist2::omega) < 0.0; }

 private:
  struct Event {
    Pose2 pose;
    double time = 0.0;
    Twist2 command;
  };
  static bool slow(const Twist2& u) { return std::abs(u.v) <= 0.05; }
  // The signs of an axis since the last reset, zeros and (for turning) fast ones left out.
  std::vector<int> signs(double Twist2::*axis) const {
    std::vector<int> found;
    for (const Event& event : events_) {
      if (axis == &Twist2::omega && !slow(event.command)) continue;
      const double value = event.command.*axis;
      if (value != 0.0) found.push_back(value > 0.0 ? 1 : -1);
    }
    return found;
  }
  // The last command changed the sign.
  bool flip(double Twist2::*axis) const {
    const std::vector<int> s = signs(axis);
    return events_.back().command.*axis != 0.0 && s.size() > 1 && s[s.size() - 1] != s[s.size() - 2];
  }
  // The direction of the last change of sign; 0 before the first.
  int ban(double Twist2::*axis) const {
    const std::vector<int> s = signs(axis);
    for (std::size_t i = s.size(); i-- > 1;) {
      if (s[i] != s[i - 1]) return s[i];
    }
    return 0;
  }

  std::vector<Event> events_;
  Event since_;
};

TEST(OscillationTwin, RandomHistories) {
  Random random(31);
  int rejected = 0, resets = 0;
  for (int history = 0; history < 400; ++history) {
    Scene scene = Scene::empty(21);
    CriticBench bench("Oscillation", scene);
    NaiveOscillation naive;
    Situation& s = bench.scene().situation;
    bool banned = false;
    for (int k = 0; k < 60; ++k) {
      s.time += 0.05;
      s.pose.x += random.uniform(-0.02, 0.02);
      s.pose.theta += random.uniform(-0.05, 0.05);
      const Twist2 command{random.pick({0.0, 0.0, 0.04, -0.04, 0.3}), random.pick({0.0, 0.5, -0.5})};
      bench.prepare();
      bench.debrief(command);
      naive.note(s.pose, s.time, command);
      bool any = false;
      for (const Twist2& u : {Twist2{0.2, 0.0}, Twist2{-0.2, 0.0}, Twist2{0.0, 0.4}, Twist2{0.0, -0.4}, Twist2{}}) {
        ASSERT_EQ(bench.score(u, {{}, {}}).rejected(), naive.rejects(u)) << history << " " << k;
        any = any || naive.rejects(u);
      }
      rejected += any;
      resets += banned && !any;
      banned = any;
    }
  }
  EXPECT_GT(rejected, 1000);
  EXPECT_GT(resets, 20);
}

}  // namespace
}  // namespace hidwa_local_planner
