// SPDX-License-Identifier: BSD-3-Clause
// People who run out of doorways at the robot, no faster than `occlusion_speed`, while autonomy drives to random goals
// in a corridor and its rooms, or a hostile operator steers it. The laser at its middle looks 180, 270 or 360 degrees
// wide. They are told of, exactly, from 0.3 s after the first scan on that sees any part of them until 2 s after the
// last one: the tracker takes 0.25 s mostly, 0.4 s at most from where they are in view, and coasts for 2 s. World,
// laser and people are this file's own, the robot and the contact are in attacked_base.hpp.
//
// HIDWA_LONG: 3,000 encounters with each laser, where it is 50.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "property/attacked_base.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::AttackedBase;
using test::Random;

const int encounters = test::effort(50, 3000);

constexpr double kFinds = 0.3, kCoasts = 2.0;                                                      // [s]
constexpr double kTick = AttackedBase::kTick, kPeriod = AttackedBase::kPeriod, kScanPeriod = 0.1;  // [s]
constexpr double kBlindSpeed = 0.1, kRunSpeed = 1.3;                                               // [m/s]
constexpr double kTurns = 1.4;                                                                     // of people [m/s^2]
constexpr double kBody = 0.2;                                                                      // [m]

struct Tally {
  int met = 0, touched = 0;
  int at_a_fast_place = 0;              // which moved towards somebody whom nothing but an obstacle had ever hidden
  int out_of_view = 0;                  // likewise, towards somebody who had been where the laser does not look
  double fastest = -1e9, driven = 0.0;  // of the first kind [m/s]; [m]
};

// A wall, axis-parallel.
struct Box {
  double x0, y0, x1, y1;  // [m]
  double distance(const Point& p) const {
    return std::hypot(std::max({x0 - p.x(), 0.0, p.x() - x1}), std::max({y0 - p.y(), 0.0, p.y() - y1}));
  }
  // Whether a straight line enters it: the parameters at which it is between both pairs of sides overlap.
  bool crosses(const Point& a, const Point& b) const {
    double from = 0.0, to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double lo = axis == 0 ? x0 : y0, hi = axis == 0 ? x1 : y1, at = a[axis], way = b[axis] - a[axis];
      if (std::abs(way) < 1e-12) {
        if (at < lo || at > hi) return false;
        continue;
      }
      const double one = (lo - at) / way, other = (hi - at) / way;
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
    return from < to;
  }
};

class Encounter {
 public:
  Encounter(std::uint64_t seed, int view, Occlusion occlusion, Tally& tally)
      : random_(seed), tally_(tally), view_(view * M_PI / 180.0) {
    build();
    Parameters p;
    p.vx_samples = 14;
    p.vth_samples = 15;
    p.min_vel_x = -0.2;
    p.max_vel_x = random_.chance(0.5) ? 0.5 : 1.0;
    p.blind_speed = kBlindSpeed;
    p.occlusion = occlusion;
    p.occlusion_speed = kRunSpeed;
    fastest_ = p.max_vel_x;
    base_.acc = p.acc_lim_x = random_.pick({2.5, 0.8});
    EXPECT_TRUE(planner_.configure(p).empty());
    base_.corners = random_.chance(0.5) ? test::round_outline(0.3)
                                        : Polygon{{0.35, 0.22}, {-0.3, 0.22}, {-0.3, -0.22}, {0.35, -0.22}};
    planner_.set_footprint(base_.corners);
    hostile_ = random_.chance(0.5);
    near_ = random_.uniform(0.5, 1.5);
    base_.at = {-3.0, 0.0};
    goal_ = {3.0, 0.0};
  }

  void run() {
    double next = 0.0, scan = 0.0;
    for (double now = 0.0; now < 15.0; now += kTick) {
      if (!there_) hide();
      if (now >= scan) {
        look(now);
        scan = now + kScanPeriod;
      }
      if (now >= next) {
        cycle(now);
        next = now + kPeriod;
      }
      base_.move(now);
      if (there_ && (walk() || over_)) break;
    }
    tally_.driven += base_.driven;
  }

 private:
  static constexpr int kCells = 160;
  static constexpr double kCell = 0.05, kOrigin = -0.5 * kCells * kCell;  // [m]

  // A corridor along x with rooms on both sides, of which some have a door.
  void build() {
    half_ = random_.uniform(0.7, 1.2);
    for (const double side : {-1.0, 1.0}) {
      const double inner = side * half_, outer = side * (half_ + 0.1);
      const double y0 = std::min(inner, outer), y1 = std::max(inner, outer);
      double begin = -4.0;
      for (const double about : {-1.6, 0.4, 2.4}) {
        if (random_.chance(0.4)) continue;
        const double middle = about + random_.uniform(-0.3, 0.3), width = random_.uniform(0.8, 1.2);
        walls_.push_back({begin, y0, middle - 0.5 * width, y1});
        begin = middle + 0.5 * width;
        doors_.emplace_back(middle, 0.5 * (y0 + y1));
      }
      walls_.push_back({begin, y0, 4.0, y1});
    }
    costs_.assign(kCells * kCells, cost::kFree);
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const Point cell(kOrigin + (i + 0.5) * kCell, kOrigin + (j + 0.5) * kCell);
        for (const Box& wall : walls_) {
          if (wall.distance(cell) <= 0.5 * kCell) costs_[static_cast<std::size_t>(j * kCells + i)] = cost::kLethal;
        }
      }
    }
  }

  bool open(const Point& a, const Point& b) const {
    return std::none_of(walls_.begin(), walls_.end(), [&](const Box& wall) { return wall.crosses(a, b); });
  }
  double room_at(const Point& p) const {
    double least = 1e9;
    for (const Box& wall : walls_) least = std::min(least, wall.distance(p));
    return least;
  }
  bool in_view(const Point& p) const { return base_.in_view(p, 0.0, view_); }
  // Any part of him.
  bool sees() const {
    const Point across = Point(-(where_ - base_.at).y(), (where_ - base_.at).x()).normalized();
    for (int i = -9; i <= 9; ++i) {
      const Point part = where_ + (0.99 * kBody * i / 9) * across;
      if (in_view(part) && open(base_.at, part)) return true;
    }
    return false;
  }

  void look(double now) {
    if (!there_) return;
    if (now > last_seen_ + kCoasts) seen_ = told_ = false;
    if (!sees()) return;
    last_seen_ = now;
    if (!seen_) seen_at_ = now;
    seen_ = true;
    if (now < seen_at_ + kFinds - 1e-9) return;
    told_ = true;
    told_at_ = now;
    told_where_ = where_;
    told_velocity_ = velocity_;
  }

  // Where nobody sees him, near a door that the robot comes to.
  void hide() {
    if (doors_.empty()) return;
    const Point door = doors_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(doors_.size()) - 1))];
    const double reach = (door - base_.at).norm();
    if (reach > 2.0) return;
    const double dx = random_.uniform(-0.9, 0.9), dy = random_.uniform(0.0, 0.6);
    where_ = door + Point(dx, door.y() > 0.0 ? dy : -dy);
    if (room_at(where_) < kBody || sees()) return;
    // Straight on to where he comes through the door.
    const double beside = random_.uniform(-0.3, 0.3);
    const Point way = door + Point(beside, 0.0) - where_;
    if (way.norm() < 0.05) return;
    run_ = random_.uniform(0.6, 1.0) * kRunSpeed * way.normalized();
    if (random_.chance(0.7)) run_ *= kRunSpeed / run_.norm();
    velocity_ = {0.0, 0.0};
    door_ = door;
    waits_ = there_ = true;
    ++tally_.met;
  }

  // True once he touches the robot.
  bool walk() {
    const Point to = base_.at - where_;
    if (waits_ && (seen_ || (door_ - base_.at).norm() < near_)) {
      waits_ = false;
      velocity_ = run_;
    }
    if (!waits_ && (seen_ || std::abs(where_.y()) < half_ + 0.1)) {
      Point change = to.normalized() * velocity_.norm() - velocity_;
      if (seen_ && change.norm() > kTurns * kTick) change *= kTurns * kTick / change.norm();
      velocity_ += change;
    }
    where_ += velocity_ * kTick;
    was_out_of_view_ = was_out_of_view_ || !in_view(where_);
    over_ = room_at(where_) < 0.15 || to.norm() > 5.0;
    const std::optional<double> towards = base_.touched(where_, kBody);
    if (!towards) return false;
    ++tally_.touched;
    if (*towards > kBlindSpeed + 1e-6) ++(was_out_of_view_ ? tally_.out_of_view : tally_.at_a_fast_place);
    if (!was_out_of_view_) tally_.fastest = std::max(tally_.fastest, *towards);
    return true;
  }

  void new_goal() {
    if (!doors_.empty() && random_.chance(0.5)) {
      const Point door = doors_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(doors_.size()) - 1))];
      via_ = door;
      goal_ = door + Point(0.0, door.y() > 0.0 ? 1.2 : -1.2);
    } else {
      const double x = random_.uniform(-3.0, 3.0);
      goal_ = {x, 0.0};
      via_ = goal_;
    }
  }

  void add_line(std::vector<Pose2>& plan, const Point& from, const Point& to) {
    const Point way = to - from;
    for (double l = 0.0; l < way.norm(); l += 0.05) {
      const Point p = from + l * way.normalized();
      plan.push_back({p.x(), p.y(), std::atan2(way.y(), way.x())});
    }
  }

  void cycle(double now) {
    Situation s;
    s.pose = {base_.at.x(), base_.at.y(), base_.heading};
    s.velocity = base_.u;
    s.last_command = base_.last;
    s.period = kPeriod;
    s.time = now;
    s.sensor_sectors = {{{}, view_, 10.0}};
    if (told_) {
      MovingObstacleEstimate one;
      one.position = told_where_;
      one.velocity = told_velocity_;
      one.radius = kBody;
      one.age = now - told_at_;
      s.moving_obstacles.push_back(one);
    }
    if ((goal_ - base_.at).norm() < 0.5) new_goal();
    if ((via_ - base_.at).norm() < 0.4) via_ = goal_;
    add_line(s.plan, base_.at, via_);
    add_line(s.plan, via_, goal_);
    s.goal = {goal_.x(), goal_.y(), 0.0};
    OperatorIntent wish;
    if (hostile_) {
      if (random_.chance(0.05)) {
        const double omega = random_.uniform(-1.0, 1.0);
        whim_ = {random_.pick({fastest_, fastest_, 0.3, 0.0}), omega};
      }
      wish.state = OperatorStateId::manual;
      wish.influence = Influence::direct;
      wish.guarded = true;
      wish.u_h = whim_;
    }
    const GridView grid{costs_.data(), kCells, kCells, kCell, kOrigin, kOrigin};
    const Decision& decision = planner_.plan(s, grid, wish);
    base_.take(now, decision.outcome == Outcome::fail ? Twist2{} : decision.command);
  }

  Random random_;
  Tally& tally_;
  double view_;  // [rad]
  std::vector<Box> walls_;
  std::vector<Point> doors_;
  std::vector<std::uint8_t> costs_;
  AttackedBase base_;
  Planner planner_{critics::built_in()};
  bool hostile_ = false, there_ = false, waits_ = false, seen_ = false, told_ = false, over_ = false,
       was_out_of_view_ = false;
  double half_ = 1.0, near_ = 1.0, fastest_ = 0.5, seen_at_ = 0.0, last_seen_ = -1e9, told_at_ = 0.0;
  Point goal_{0.0, 0.0}, via_{3.0, 0.0}, where_{0.0, 0.0}, velocity_{0.0, 0.0}, run_{0.0, 0.0}, door_{0.0, 0.0};
  Point told_where_{0.0, 0.0}, told_velocity_{0.0, 0.0};
  Twist2 whim_;
};

Tally attack(int view, Occlusion occlusion, const char* name, int count) {
  Tally tally;
  for (int k = 0; k < count; ++k) Encounter(static_cast<std::uint64_t>(48100 + k), view, occlusion, tally).run();
  std::printf(
      "%3d degrees, %-6s %5d met, touched %4d, at a fast place %3d (%.3f m/s), out of view before %3d; %.0f m\n", view,
      name, tally.met, tally.touched, tally.at_a_fast_place, tally.fastest, tally.out_of_view, tally.driven);
  return tally;
}

TEST(DoorwayAttack, NobodyIsTouchedByAPlaceThatMovesTowardsHimFast) {
  for (const int view : {180, 270, 360}) {
    const Tally tally = attack(view, Occlusion::bound, "bound", encounters);
    EXPECT_EQ(tally.at_a_fast_place, 0) << view;
    EXPECT_GT(tally.touched, encounters / 10);
    EXPECT_GT(tally.driven, 0.5 * encounters);
  }
}

TEST(DoorwayAttack, FindsThemWhereTheBoundIsOff) {
  EXPECT_GT(attack(360, Occlusion::off, "off", std::max(150, encounters)).at_a_fast_place, 0);
}

}  // namespace
}  // namespace hidwa_local_planner
