// SPDX-License-Identifier: BSD-3-Clause
// Walkers who want to touch the robot while it moves, on an open floor. They, their contact check and what is told of
// them are the hostile campaign's; the base is this file's own.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <vector>

#include "attack/shape.hpp"
#include "attack/walkers.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/random.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::test::walkers {

using hidwa_attack::Encounters;
using hidwa_attack::Shape;
using hidwa_attack::Spot;
using hidwa_attack::Walker;
using hidwa_attack::Walkers;

constexpr double kTick = Walkers::kStep;  // of the world [s]

/// What walkers are, what is known of them, and of the base.
struct Bounds : hidwa_attack::Bounds {
  double told_acc = 1.5, told_speed = 1.8;  // what the planner is told
  double told_deviations = 3.0;             // so many count
  double base_latency = 0.1;                // [s]; the planner is told 0.1
  int count = 4;                            // of walkers
};

enum class Who { nobody, hostile, manual };

struct Count {
  Encounters encounters;
  double driven = 0.0, time = 0.0;  // [m, s]
  std::uint64_t refused = 0;        // cycles that said so
};

class World {
 public:
  World(std::uint64_t seed, Who who, const Bounds& bounds)
      : random_(seed),
        who_(who),
        bounds_(bounds),
        shape_(set_up()),
        walkers_(bounds.count, bounds, shape_, {}, random_.bits()) {
    turn_goal();
  }

  Count run(double duration) {
    double next = 0.0;
    for (double now = 0.0; now < duration; now += kTick) {
      if (now >= next) {
        cycle(now);
        next = now + (random_.chance(0.1) ? random_.uniform(kPeriod, kLatest) : kPeriod);
      }
      move_base(now);
      walkers_.step(robot_, velocity_);
      count_.time += kTick;
    }
    count_.encounters = walkers_.encounters();
    return count_;
  }

 private:
  static constexpr double kPeriod = 0.05, kLatest = 0.08;  // [s]

  Shape set_up() {
    Parameters p;
    p.vx_samples = 12;
    p.vth_samples = 15;
    p.moving_obstacle_acc = bounds_.told_acc;
    p.moving_obstacle_speed = bounds_.told_speed;
    p.moving_obstacle_deviations = bounds_.told_deviations;
    if (random_.chance(0.5)) p.min_vel_x = -0.2;
    if (random_.chance(0.3)) p.max_vel_x = 1.0;
    if (random_.chance(0.3)) p.acc_lim_x = 1.2;
    if (random_.chance(0.3)) p.SocialDistance_scale = 0.0;
    acc_ = p.acc_lim_x;
    turn_acc_ = p.acc_lim_theta;
    fastest_ = p.max_vel_x;
    even_ = random_.chance(0.5);
    const double kind = random_.uniform(0.0, 3.0);
    Polygon outline;
    Shape shape;
    if (kind < 1.0) {
      outline = round_outline(0.25);
      shape.radius = 0.25;
    } else {
      const double front = kind < 2.0 ? 0.25 : 0.6, rear = kind < 2.0 ? 0.25 : 0.1, side = kind < 2.0 ? 0.2 : 0.25;
      outline = {{front, side}, {-rear, side}, {-rear, -side}, {front, -side}};
      for (const Point& corner : outline) shape.corners.push_back({corner.x(), corner.y()});
    }
    planner_.configure(p);
    planner_.set_footprint(outline);
    costs_.assign(kCells * kCells, cost::kFree);
    return shape;
  }

  void turn_goal() {
    const double angle = random_.uniform(-M_PI, M_PI);
    goal_ = {robot_.x + 6.0 * std::cos(angle), robot_.y + 6.0 * std::sin(angle)};
  }

  OperatorIntent intent() {
    OperatorIntent wish;
    if (who_ == Who::nobody) return wish;
    const Walker& aim = walkers_.nearest();
    const double off = std::remainder(std::atan2(aim.p.y - robot_.y, aim.p.x - robot_.x) - robot_.theta, 2.0 * M_PI);
    if (random_.chance(0.02)) whim_ = random_.uniform(-1.0, 1.0);
    wish.u_h = {fastest_, random_.chance(0.8) ? std::min(1.0, std::max(-1.0, 2.0 * off)) : whim_};
    wish.state = who_ == Who::hostile ? OperatorStateId::shared : OperatorStateId::manual;
    wish.influence = who_ == Who::hostile ? Influence::shared : Influence::direct;
    wish.guarded = true;
    return wish;
  }

  double away() const { return std::hypot(goal_.x - robot_.x, goal_.y - robot_.y); }

  void cycle(double now) {
    Situation s;
    s.pose = robot_;
    s.velocity = velocity_;
    s.last_command = last_;
    s.period = kPeriod;
    s.longest_period = kLatest;
    s.time = now;
    if (away() < 1.0 || random_.chance(0.002)) turn_goal();
    const double heading = std::atan2(goal_.y - robot_.y, goal_.x - robot_.x);
    for (double l = 0.0; l < std::min(3.0, away()); l += 0.05) {
      s.plan.push_back({robot_.x + l * std::cos(heading), robot_.y + l * std::sin(heading), heading});
    }
    s.goal = {goal_.x, goal_.y, heading};
    s.moving_obstacles = walkers_.told();
    const double half = 0.5 * kCells * kCell;
    const GridView grid{costs_.data(), kCells, kCells, kCell, robot_.x - half, robot_.y - half};
    const Decision& decision = planner_.plan(s, grid, intent());
    last_ = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
    for (const RejectionCount& rejection : decision.rejections) count_.refused += rejection.name == "Moving obstacle";
    sent_.push_back({now, last_});
  }

  // A command reaches the base after the latency; the base reaches it at its limits at once, or evenly in a period.
  void move_base(double now) {
    while (!sent_.empty() && sent_.front().time + bounds_.base_latency <= now + 1e-9) {
      wanted_ = sent_.front().command;
      rate_ = even_ ? Twist2{std::abs(wanted_.v - velocity_.v) / kPeriod,
                             std::abs(wanted_.omega - velocity_.omega) / kPeriod}
                    : Twist2{1e9, 1e9};
      sent_.pop_front();
    }
    const auto towards = [](double from, double to, double most) {
      return from + std::min(most, std::max(-most, to - from));
    };
    velocity_.v = towards(velocity_.v, wanted_.v, std::min(acc_, rate_.v) * kTick);
    velocity_.omega = towards(velocity_.omega, wanted_.omega, std::min(turn_acc_, rate_.omega) * kTick);
    robot_.theta += 0.5 * velocity_.omega * kTick;
    robot_.x += velocity_.v * std::cos(robot_.theta) * kTick;
    robot_.y += velocity_.v * std::sin(robot_.theta) * kTick;
    robot_.theta += 0.5 * velocity_.omega * kTick;
    count_.driven += std::abs(velocity_.v) * kTick;
  }

  static constexpr int kCells = 120;
  static constexpr double kCell = 0.05;  // [m]
  struct Sent {
    double time;
    Twist2 command;
  };
  std::vector<std::uint8_t> costs_;
  Spot goal_;
  Twist2 last_, wanted_, rate_{1e9, 1e9};
  std::deque<Sent> sent_;
  double acc_ = 2.5, turn_acc_ = 3.2, fastest_ = 0.5, whim_ = 0.0;
  bool even_ = false;
  Count count_;
  Random random_;
  Who who_;
  Bounds bounds_;
  Planner planner_{critics::built_in()};
  Shape shape_;  // set_up() sets what is declared before
  Walkers walkers_;
  Pose2 robot_;
  Twist2 velocity_;
};

inline Count operator+(const Count& a, const Count& b) {
  const Encounters &x = a.encounters, &y = b.encounters;
  return {{x.met + y.met, x.moving + y.moving, x.leaving + y.leaving, std::max(x.fastest, y.fastest),
           x.at_rest + y.at_rest},
          a.driven + b.driven,
          a.time + b.time,
          a.refused + b.refused};
}

}  // namespace hidwa_local_planner::test::walkers
