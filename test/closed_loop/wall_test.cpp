// SPDX-License-Identifier: BSD-3-Clause
// A base with a latency, between walls, with a horizon so short that nothing but the check for braking keeps it off
// them: whoever steers it and whenever it is stopped, what is still under way never carries it into one.
#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>

#include <gtest/gtest.h>

#include "drive_on.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/drive_limits.hpp"
#include "support/naive_planner.hpp"
#include "support/random.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

struct Base {
  double v, omega;          // the fastest [m/s, rad/s]
  double acc_x, acc_theta;  // [m/s^2, rad/s^2]
  double latency;           // [s]
};
void PrintTo(const Base& b, std::ostream* out) {
  *out << b.v << " m/s, " << b.acc_x << " m/s^2, " << b.latency << " s";
}

constexpr double kWall = 1.975;  // [m] from the middle of the room to each of its walls, an edge of cells

class Room {
 public:
  explicit Room(const Base& base) : drive_(limits_of(parameters_of(base))) {
    scene_ = Scene::empty(121, 0.05);
    scene_.fill(-4.0, -4.0, 4.0, 4.0);
    for (int j = 0; j < scene_.size_y; ++j) {
      for (int i = 0; i < scene_.size_x; ++i) {
        const Point centre = scene_.grid().centre({i, j});
        if (std::max(std::abs(centre.x()), std::abs(centre.y())) < kWall) scene_.at({i, j}) = cost::kFree;
      }
    }
    scene_.parameters = parameters_of(base);
    scene_.intent.influence = Influence::direct;
    scene_.intent.guarded = true;
    loop_.emplace(scene_);
  }
  void stand(const Pose2& pose) { scene_.situation.pose = pose; }

  /// One control period; `stop`: the host stops it.
  Decision cycle(const Twist2& wanted, bool stop) {
    Situation& now = scene_.situation;
    now.velocity = {drive_.velocity().v, drive_.velocity().omega};
    scene_.intent.u_h = wanted;
    const control::Result result = loop_->cycle(stop);
    drive_on(now, drive_, result.command, 5, [](int) {});
    return *result.decision;
  }
  /// How far into an obstacle it reaches [m].
  double overlap() const {
    const Pose2& pose = scene_.situation.pose;
    return naive_overlap(scene_.grid(), naive_body(scene_), pose, true);
  }
  /// From its farthest corner to the walls [m].
  double gap() const {
    double farthest = 0.0;
    const Pose2& q = scene_.situation.pose;
    for (const Point& corner : scene_.outline) {
      const double c = std::cos(q.theta), s = std::sin(q.theta);
      farthest = std::max(
          {farthest, std::abs(q.x + c * corner.x() - s * corner.y()), std::abs(q.y + s * corner.x() + c * corner.y())});
    }
    return kWall - farthest;
  }

 private:
  static Parameters parameters_of(const Base& base) {
    Parameters p;
    p.max_vel_x = base.v;
    p.max_vel_theta = base.omega;
    p.acc_lim_x = base.acc_x;
    p.acc_lim_theta = base.acc_theta;
    p.control_latency = base.latency;
    p.sim_time = 0.2;  // far less than it needs to stop
    p.vth_samples = 11;
    p.escape = false;  // what touches, stays
    return p;
  }

  Scene scene_;
  sim::DiffDrive drive_;
  std::optional<SceneLoop> loop_;
};

// Now and then for some cycles.
class Stops {
 public:
  Stops(Random& random, double chance) : random_(random), chance_(chance) {}
  bool now() {
    if (left_ == 0 && random_.chance(chance_)) left_ = random_.integer(1, 6);
    return left_ > 0 && left_-- > 0;
  }

 private:
  Random& random_;
  double chance_;
  int left_ = 0;
};

class Wall : public ::testing::TestWithParam<Base> {};

TEST_P(Wall, StraightAtIt) {
  const Base base = GetParam();
  Random random(1);
  for (const double chance : {0.0, 0.15}) {
    double least = kWall, most = 0.0;
    for (int drives = 0; drives < 20; ++drives) {
      Room room(base);
      room.stand({random.uniform(-1.0, 0.0), 0.0, 0.0});
      Stops stops(random, chance);
      double gap = kWall;
      for (int k = 0; k < 300; ++k) {
        room.cycle({base.v, 0.0}, stops.now());
        gap = std::min(gap, room.gap());
      }
      least = std::min(least, gap);
      most = std::max(most, gap);
    }
    EXPECT_GT(least, 0.0) << "stopped with a chance of " << chance;
    EXPECT_LT(most, 0.1) << "stopped with a chance of " << chance;  // it did get there
  }
}

TEST_P(Wall, WhereverThePersonSteers) {
  const Base base = GetParam();
  Random random(2);
  double deepest = 0.0;
  int rejected = 0;
  for (int drives = 0; drives < 8; ++drives) {
    Room room(base);
    room.stand({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)});
    Stops stops(random, 0.05);
    Twist2 wanted;
    for (int k = 0; k < 400; ++k) {
      if (random.chance(0.1)) wanted = {random.uniform(0.3, 1.0) * base.v, random.uniform(-1.0, 1.0) * base.omega};
      rejected += !room.cycle(wanted, stops.now()).rejections.empty();
      deepest = std::max(deepest, room.overlap());
    }
  }
  // Speeding up counts as even where that is less than a thirty-second of a cell off, see ManoeuvreRoller.
  EXPECT_LT(deepest, 0.002);
  EXPECT_GT(rejected, 300);
}

INSTANTIATE_TEST_SUITE_P(Bases, Wall,
                         ::testing::Values(Base{0.5, 1.0, 2.5, 3.2, 0.1}, Base{2.0, 4.0, 10.0, 20.0, 0.05},
                                           Base{2.0, 4.0, 10.0, 20.0, 0.1}, Base{2.0, 4.0, 10.0, 20.0, 0.12},
                                           Base{1.0, 2.0, 2.0, 6.0, 0.17}));

}  // namespace
}  // namespace hidwa_local_planner::test
