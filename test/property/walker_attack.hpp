// SPDX-License-Identifier: BSD-3-Clause
// Walkers who want to touch the robot while it moves. They keep their bounds of speed and acceleration, and what is
// told of them is wrong by up to three deviations, and old. Everything but the planner itself is this file's own: the
// base, the walkers, the contact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner::test::walkers {

constexpr double kTick = 0.002;  // of the world [s]

/// What walkers are and what is known of them.
struct Bounds {
  double acc = 1.5, speed = 1.8;                       // what they keep [m/s^2, m/s]
  double position_error = 0.03, velocity_error = 0.1;  // a third of the largest error [m, m/s]
  double oldest = 0.15;                                // age of an estimate [s]
  double told_acc = 1.5, told_speed = 1.8;             // what the planner is told
  double told_errors = 1.0;                            // times the errors: what it is told of them
  double base_latency = 0.1;                           // [s]; the planner is told 0.1
};

enum class Who { nobody, hostile, manual };

struct Count {
  std::uint64_t encounters = 0;     // a walker comes within 1 m of the moving robot
  std::uint64_t moving = 0;         // touched while moving
  std::uint64_t leaving = 0;        // likewise, by one whom the robot was leaving: who stood at it when it set off
  std::uint64_t at_rest = 0;        // touched at rest
  double driven = 0.0, time = 0.0;  // [m, s]
  std::uint64_t refused = 0;        // cycles that said so
};

struct Vec {
  double x = 0.0, y = 0.0;
  Vec operator+(const Vec& o) const { return {x + o.x, y + o.y}; }
  Vec operator-(const Vec& o) const { return {x - o.x, y - o.y}; }
  Vec operator*(double f) const { return {x * f, y * f}; }
  double norm() const { return std::hypot(x, y); }
  Vec capped(double most) const {
    const double n = norm();
    return n > most ? *this * (most / n) : *this;
  }
  Vec unit() const {
    const double n = norm();
    return n > 1e-12 ? *this * (1.0 / n) : Vec{1.0, 0.0};
  }
};

/// From a point to a polygon by its sides, negative inside; its own code.
inline double gap_of(const std::vector<Vec>& corners, const Vec& p) {
  double least = 1e9;
  bool in = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vec a = corners[j], b = corners[i], d = b - a, f = p - a;
    const double t = std::min(1.0, std::max(0.0, (f.x * d.x + f.y * d.y) / (d.x * d.x + d.y * d.y)));
    least = std::min(least, (f - d * t).norm());
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in ? -least : least;
}

struct Robot {
  double x = 0.0, y = 0.0, theta = 0.0, v = 0.0, omega = 0.0;
  std::vector<Vec> corners;  // none: a circle
  double radius = 0.0;       // of the farthest point [m]

  double gap(const Vec& p) const {
    const double c = std::cos(theta), s = std::sin(theta);
    const Vec own{c * (p.x - x) + s * (p.y - y), -s * (p.x - x) + c * (p.y - y)};
    return corners.empty() ? own.norm() - radius : gap_of(corners, own);
  }
  /// Of the outermost point [m/s].
  double speed() const { return std::abs(v) + radius * std::abs(omega); }
};

struct Walker {
  enum class Plan { chase, intercept, pounce, wait, cut };
  std::uint32_t id = 0;
  Vec p, v;
  double radius = 0.3;
  Plan plan = Plan::chase;
  bool close = false, touches = false, stood_at_start = false;
  double idle = 0.0;                    // near a robot at rest [s]
  Vec way;                              // where it goes until it attacks
  std::deque<std::array<Vec, 2>> past;  // states, one a tick, newest first
};

class World {
 public:
  World(std::uint64_t seed, Who who, const Bounds& bounds) : random_(seed), who_(who), bounds_(bounds) { set_up(); }

  Count run(double duration) {
    double next = 0.0;
    for (double now = 0.0; now < duration; now += kTick) {
      if (now >= next) {
        cycle(now);
        next = now + (random_.chance(0.1) ? random_.uniform(kPeriod, kLatest) : kPeriod);
      }
      move_base(now);
      for (Walker& walker : walkers_) move(walker);
      look_for_contacts();
      count_.time += kTick;
    }
    return count_;
  }

 private:
  static constexpr double kPeriod = 0.05, kLatest = 0.08;  // [s]

  void set_up() {
    Parameters p;
    p.vx_samples = 12;
    p.vth_samples = 15;
    p.moving_obstacle_acc = bounds_.told_acc;
    p.moving_obstacle_speed = bounds_.told_speed;
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
    if (kind < 1.0) {
      for (int i = 0; i < 16; ++i) outline.emplace_back(0.25 * std::cos(M_PI * i / 8), 0.25 * std::sin(M_PI * i / 8));
      robot_.radius = 0.25;
    } else {
      const double front = kind < 2.0 ? 0.25 : 0.6, rear = kind < 2.0 ? 0.25 : 0.1, side = kind < 2.0 ? 0.2 : 0.25;
      outline = {{front, side}, {-rear, side}, {-rear, -side}, {front, -side}};
      for (const Point& corner : outline) robot_.corners.push_back({corner.x(), corner.y()});
      robot_.radius = std::hypot(front, side);
    }
    planner_.configure(p);
    planner_.set_footprint(outline);
    costs_.assign(kCells * kCells, cost::kFree);
    for (int i = 0; i < 4; ++i) {
      walkers_.emplace_back();
      place(walkers_.back());
    }
    turn_goal();
  }

  // Out of sight of what the robot does until it rests.
  void place(Walker& walker) {
    const double angle = random_.uniform(-M_PI, M_PI), away = random_.uniform(3.0, 4.5);
    Walker fresh;
    fresh.id = ++ids_;
    fresh.p = Vec{robot_.x, robot_.y} + Vec{std::cos(angle), std::sin(angle)} * away;
    fresh.v = Vec{random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0)}.capped(bounds_.speed);
    fresh.radius = random_.uniform(0.15, 0.4);
    fresh.plan = static_cast<Walker::Plan>(random_.integer(0, 4));
    fresh.way = (Vec{robot_.x, robot_.y} - fresh.p).unit() * random_.uniform(0.3, bounds_.speed);
    walker = fresh;
  }

  void turn_goal() {
    const double angle = random_.uniform(-M_PI, M_PI);
    goal_ = {robot_.x + 6.0 * std::cos(angle), robot_.y + 6.0 * std::sin(angle)};
  }

  double error(double third) { return 3.0 * third * (random_.chance(0.5) ? 1.0 : random_.uniform(0.0, 1.0)); }
  Vec anywhere(double length) {
    const double angle = random_.uniform(-M_PI, M_PI);
    return Vec{std::cos(angle), std::sin(angle)} * length;
  }

  MovingObstacleEstimate told(const Walker& walker) {
    const auto ticks = static_cast<std::size_t>(random_.uniform(0.0, bounds_.oldest) / kTick);
    const std::size_t back = walker.past.empty() ? 0 : std::min(ticks, walker.past.size() - 1);
    const Vec p = walker.past.empty() ? walker.p : walker.past[back][0];
    const Vec v = walker.past.empty() ? walker.v : walker.past[back][1];
    const Vec said_p = p + anywhere(error(bounds_.position_error)),
              said_v = v + anywhere(error(bounds_.velocity_error));
    MovingObstacleEstimate one;
    one.id = walker.id;
    one.position = {said_p.x, said_p.y};
    one.velocity = {said_v.x, said_v.y};
    one.radius = walker.radius;
    one.position_deviation = bounds_.told_errors * bounds_.position_error;
    one.velocity_deviation = bounds_.told_errors * bounds_.velocity_error;
    one.age = static_cast<double>(back) * kTick;
    return one;
  }

  const Walker& nearest() const {
    return *std::min_element(walkers_.begin(), walkers_.end(), [this](const Walker& a, const Walker& b) {
      return robot_.gap(a.p) - a.radius < robot_.gap(b.p) - b.radius;
    });
  }

  OperatorIntent intent() {
    OperatorIntent wish;
    if (who_ == Who::nobody) return wish;
    const Walker& aim = nearest();
    const double off = std::remainder(std::atan2(aim.p.y - robot_.y, aim.p.x - robot_.x) - robot_.theta, 2.0 * M_PI);
    if (random_.chance(0.02)) whim_ = random_.uniform(-1.0, 1.0);
    wish.u_h = {fastest_, random_.chance(0.8) ? std::min(1.0, std::max(-1.0, 2.0 * off)) : whim_};
    wish.state = who_ == Who::hostile ? OperatorStateId::shared : OperatorStateId::manual;
    wish.influence = who_ == Who::hostile ? Influence::shared : Influence::direct;
    wish.guarded = true;
    return wish;
  }

  void cycle(double now) {
    Situation s;
    s.pose = {robot_.x, robot_.y, robot_.theta};
    s.velocity = {robot_.v, robot_.omega};
    s.last_command = last_;
    s.period = kPeriod;
    s.longest_period = kLatest;
    s.time = now;
    if ((goal_ - Vec{robot_.x, robot_.y}).norm() < 1.0 || random_.chance(0.002)) turn_goal();
    const Vec way = goal_ - Vec{robot_.x, robot_.y};
    const double heading = std::atan2(way.y, way.x);
    for (double l = 0.0; l < std::min(3.0, way.norm()); l += 0.05) {
      s.plan.push_back({robot_.x + l * std::cos(heading), robot_.y + l * std::sin(heading), heading});
    }
    s.goal = {goal_.x, goal_.y, heading};
    for (const Walker& walker : walkers_) s.moving_obstacles.push_back(told(walker));
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
      rate_ = even_ ? Twist2{std::abs(wanted_.v - robot_.v) / kPeriod, std::abs(wanted_.omega - robot_.omega) / kPeriod}
                    : Twist2{1e9, 1e9};
      sent_.pop_front();
    }
    const auto towards = [](double from, double to, double most) {
      return from + std::min(most, std::max(-most, to - from));
    };
    robot_.v = towards(robot_.v, wanted_.v, std::min(acc_, rate_.v) * kTick);
    robot_.omega = towards(robot_.omega, wanted_.omega, std::min(turn_acc_, rate_.omega) * kTick);
    robot_.theta += 0.5 * robot_.omega * kTick;
    robot_.x += robot_.v * std::cos(robot_.theta) * kTick;
    robot_.y += robot_.v * std::sin(robot_.theta) * kTick;
    robot_.theta += 0.5 * robot_.omega * kTick;
    count_.driven += std::abs(robot_.v) * kTick;
  }

  Vec wish_of(const Walker& walker) const {
    const Vec robot{robot_.x, robot_.y};
    const Vec to = robot - walker.p;
    const Vec robot_velocity{robot_.v * std::cos(robot_.theta), robot_.v * std::sin(robot_.theta)};
    const double gap = robot_.gap(walker.p) - walker.radius;
    switch (walker.plan) {
      case Walker::Plan::chase:
        return to.unit() * bounds_.speed;
      case Walker::Plan::intercept:
        return (to + robot_velocity * (to.norm() / bounds_.speed)).unit() * bounds_.speed;
      case Walker::Plan::pounce:
        return gap > 0.9 ? walker.way : (to + robot_velocity * 0.3).unit() * bounds_.speed;
      case Walker::Plan::wait:
        return gap > 0.8 ? Vec{} : (to + robot_velocity * 0.2).unit() * bounds_.speed;
      case Walker::Plan::cut:
        return (robot + robot_velocity.unit() * (robot_.radius + walker.radius + 0.25) - walker.p) * 3.0;
    }
    return {};
  }

  // As hard as the bounds allow.
  void move(Walker& walker) {
    const Vec change = (wish_of(walker).capped(bounds_.speed) - walker.v).capped(bounds_.acc * kTick);
    walker.p = walker.p + walker.v * kTick + change * (0.5 * kTick);
    walker.v = walker.v + change;
    walker.past.push_front({walker.p, walker.v});
    if (walker.past.size() > 200) walker.past.pop_back();
  }

  void look_for_contacts() {
    const bool moves = robot_.speed() > 0.01;
    for (Walker& walker : walkers_) {
      const double gap = robot_.gap(walker.p) - walker.radius;
      // Where a set can be around the robot: both errors twice, and what a step allows.
      const double band = 6.0 * (bounds_.position_error + bounds_.oldest * bounds_.velocity_error) + 0.05;
      if (!moves) walker.stood_at_start = gap < band;
      if (moves && gap > band) walker.stood_at_start = false;
      if (gap <= 1.0 && moves && !walker.close) ++count_.encounters;
      walker.close = (walker.close || moves) && gap <= 1.0;
      if (gap <= 0.0 && !walker.touches) {
        if (!moves) ++count_.at_rest;
        if (moves) ++(walker.stood_at_start ? count_.leaving : count_.moving);
      }
      // Who touches a robot at rest touches it still when it sets off: counted once.
      walker.touches = gap <= 0.0;
      walker.idle = gap <= 0.5 && !moves ? walker.idle + kTick : 0.0;
      if (walker.idle > 0.6 || walker.touches || gap > 6.0) place(walker);
    }
  }

  static constexpr int kCells = 120;
  static constexpr double kCell = 0.05;  // [m]
  struct Sent {
    double time;
    Twist2 command;
  };
  Random random_;
  Who who_;
  Bounds bounds_;
  Planner planner_{critics::built_in()};
  std::vector<std::uint8_t> costs_;
  Robot robot_;
  std::vector<Walker> walkers_;
  std::uint32_t ids_ = 0;
  Vec goal_;
  Twist2 last_, wanted_, rate_{1e9, 1e9};
  std::deque<Sent> sent_;
  double acc_ = 2.5, turn_acc_ = 3.2, fastest_ = 0.5, whim_ = 0.0;
  bool even_ = false;
  Count count_;
};

inline Count operator+(const Count& a, const Count& b) {
  return {a.encounters + b.encounters, a.moving + b.moving, a.leaving + b.leaving, a.at_rest + b.at_rest,
          a.driven + b.driven,         a.time + b.time,     a.refused + b.refused};
}

}  // namespace hidwa_local_planner::test::walkers
