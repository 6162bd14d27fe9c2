// SPDX-License-Identifier: BSD-3-Clause
// People who come out of where the robot's laser does not look, aimed at it, while autonomy drives to random goals or a
// hostile operator steers it into them. Nothing is told of them; where they are in view they are in the costmap. The
// robot, its laser and the contact are this file's own.
//
// HIDWA_LONG: 1,500 encounters of each kind, 3,000 of each laser, where it is 25.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;

const int encounters = test::effort(25, 1500);

constexpr double kTick = 0.005, kPeriod = 0.05, kLatency = 0.1;  // [s]
constexpr double kBlindSpeed = 0.1;                              // [m/s]

struct Tally {
  int met = 0, touched = 0;
  int at_a_fast_place = 0;  // which moved towards somebody who had never been seen
  int seen_before = 0;      // likewise, towards somebody who had come into view
  int overtaken = 0;        // touched at a place that moved towards him slowly, or not at all
  double fastest = -1e9;    // of the first kind [m/s]
  double driven = 0.0;      // [m]
};

struct Outline {
  Polygon corners;      // [m]; going left round
  double radius = 0.0;  // of a circle [m]
};

Outline outline_of(int kind) {
  if (kind == 0) return {{}, 0.3};
  if (kind == 1) return {{{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}, 0.0};
  return {{{0.7, 0.25}, {-0.2, 0.25}, {-0.2, -0.25}, {0.7, -0.25}}, 0.0};
}

// The point of the outline that is nearest to a point outside of it; robot frame.
Point nearest(const Outline& outline, const Point& to) {
  if (outline.radius > 0.0) return to * (outline.radius / to.norm());
  Point best(0.0, 0.0);
  double least = 1e9;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Point a = outline.corners[i], way = outline.corners[(i + 1) % outline.corners.size()] - a;
    const Point point = a + way * std::clamp((to - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    if ((to - point).norm() < least) {
      least = (to - point).norm();
      best = point;
    }
  }
  return best;
}

class Encounter {
 public:
  Encounter(std::uint64_t seed, int view, double reverse, bool bounded, Tally& tally)
      : random_(seed), tally_(tally), view_(view * M_PI / 180.0), outline_(outline_of(random_.integer(0, 2))) {
    Parameters p;
    p.vx_samples = 14;
    p.vth_samples = 15;
    p.min_vel_x = -reverse;
    p.max_vel_x = random_.chance(0.5) ? 0.5 : 1.0;
    p.blind_speed = kBlindSpeed;
    if (!bounded) p.sensor_sectors = "all";
    fastest_ = p.max_vel_x;
    slowest_ = p.min_vel_x;
    acc_ = p.acc_lim_x;
    turn_acc_ = p.acc_lim_theta;
    EXPECT_TRUE(planner_.configure(p).empty());
    Polygon told = outline_.corners;
    if (outline_.radius > 0.0) {
      for (int i = 0; i < 16; ++i) {
        told.emplace_back(outline_.radius * std::cos(M_PI * i / 8), outline_.radius * std::sin(M_PI * i / 8));
      }
    }
    planner_.set_footprint(told);
    laser_x_ = outline_.radius > 0.0 ? 0.1 : outline_.corners[0].x() - random_.uniform(0.0, 0.1);
    costs_.assign(kCells * kCells, cost::kFree);
    hostile_ = random_.chance(0.5);
    goal_ = 5.0 * Point(1.0, random_.uniform(-1.0, 1.0));
  }

  void run() {
    // A second alone, then somebody appears where the laser does not look.
    double next = 0.0, scan = 0.0, alone = random_.uniform(0.5, 3.0);
    for (double now = 0.0; now < alone + 6.0; now += kTick) {
      if (now >= alone && !there_) appear();
      if (now >= scan) {
        look();
        scan = now + 0.1;
      }
      if (now >= next) {
        cycle(now);
        next = now + kPeriod;
      }
      move(now);
      if (there_ && (walk() || (where_ - at_).norm() > 6.0)) break;
    }
  }

 private:
  static constexpr int kCells = 160;
  static constexpr double kCell = 0.05, kOrigin = -0.5 * kCells * kCell;  // [m]

  Point in_robot(const Point& p) const {
    const Point d = p - at_;
    return {std::cos(heading_) * d.x() + std::sin(heading_) * d.y(),
            std::cos(heading_) * d.y() - std::sin(heading_) * d.x()};
  }
  Point in_world(const Point& p) const {
    return at_ + Point(std::cos(heading_) * p.x() - std::sin(heading_) * p.y(),
                       std::sin(heading_) * p.x() + std::cos(heading_) * p.y());
  }
  bool in_view(const Point& world) const {
    const Point p = in_robot(world) - Point(laser_x_, 0.0);
    return view_ > 6.28 || std::abs(std::atan2(p.y(), p.x())) < 0.5 * view_;
  }

  // A laser that sees all round sees him too: then he comes from anywhere.
  void appear() {
    there_ = true;
    ++tally_.met;
    for (int i = 0; i < 1000; ++i) {
      const double angle = random_.uniform(-M_PI, M_PI), far = random_.uniform(1.2, 2.5);
      where_ = at_ + far * Point(std::cos(angle), std::sin(angle));
      if (!in_view(where_) || view_ > 6.28) break;
    }
    radius_ = random_.uniform(0.2, 0.3);
    speed_ = random_.uniform(0.3, 1.8);
    waits_ = random_.chance(0.3);
    ever_seen_ = false;
  }

  // Straight at the robot; some only stand in its way. True once he touches it.
  bool walk() {
    const Point to = at_ - where_;
    if (!waits_ || to.norm() > 1.0) where_ += to.normalized() * speed_ * kTick;
    ever_seen_ = ever_seen_ || in_view(where_);
    const Point he = in_robot(where_), place = nearest(outline_, he);
    if ((he - place).norm() > radius_) return false;
    const Point velocity(u_.v - u_.omega * place.y(), u_.omega * place.x());
    const double towards = velocity.dot((he - place).normalized());
    ++tally_.touched;
    if (towards <= kBlindSpeed + 1e-6) {
      ++tally_.overtaken;
    } else if (ever_seen_) {
      ++tally_.seen_before;
    } else {
      ++tally_.at_a_fast_place;
    }
    if (!ever_seen_) tally_.fastest = std::max(tally_.fastest, towards);
    return true;
  }

  // Where the laser looks the map is as it is now; elsewhere as it was.
  void look() {
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const Point cell(kOrigin + (i + 0.5) * kCell, kOrigin + (j + 0.5) * kCell);
        if (!in_view(cell)) continue;
        const bool his = there_ && (cell - where_).norm() < radius_;
        costs_[static_cast<std::size_t>(j * kCells + i)] = his ? cost::kLethal : cost::kFree;
      }
    }
  }

  void cycle(double now) {
    Situation s;
    s.pose = {at_.x(), at_.y(), heading_};
    s.velocity = u_;
    s.last_command = last_;
    s.period = kPeriod;
    s.time = now;
    s.sensor_sectors = {{{laser_x_, 0.0, 0.0}, view_, 10.0}};
    if ((goal_ - at_).norm() < 0.8 || random_.chance(0.005)) {
      const double x = random_.uniform(-2.5, 2.5), y = random_.uniform(-2.5, 2.5);
      goal_ = {x, y};
    }
    const Point way = goal_ - at_;
    const double direction = std::atan2(way.y(), way.x());
    for (double l = 0.0; l < way.norm(); l += 0.05) {
      const Point p = at_ + l * way.normalized();
      s.plan.push_back({p.x(), p.y(), direction});
    }
    s.goal = {goal_.x(), goal_.y(), direction};
    OperatorIntent wish;
    if (hostile_) {
      if (random_.chance(0.05)) {
        const double v = random_.pick({slowest_, fastest_, 0.0}), omega = random_.uniform(-1.0, 1.0);
        whim_ = {v, omega};
      }
      wish = {};
      wish.state = OperatorStateId::manual;
      wish.influence = Influence::direct;
      wish.guarded = true;
      wish.u_h = whim_;
    }
    const GridView grid{costs_.data(), kCells, kCells, kCell, kOrigin, kOrigin};
    const Decision& decision = planner_.plan(s, grid, wish);
    last_ = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
    sent_.push_back({now + kLatency, last_});
  }

  void move(double now) {
    while (!sent_.empty() && sent_.front().first <= now + 1e-9) {
      wanted_ = sent_.front().second;
      sent_.pop_front();
      // Evenly over the period.
      rate_ = {std::min(acc_, std::abs(wanted_.v - u_.v) / kPeriod),
               std::min(turn_acc_, std::abs(wanted_.omega - u_.omega) / kPeriod)};
    }
    const auto towards = [](double from, double to, double most) { return from + std::clamp(to - from, -most, most); };
    u_ = {towards(u_.v, wanted_.v, rate_.v * kTick), towards(u_.omega, wanted_.omega, rate_.omega * kTick)};
    heading_ += u_.omega * kTick;
    at_ += u_.v * kTick * Point(std::cos(heading_), std::sin(heading_));
    tally_.driven += std::abs(u_.v) * kTick;
  }

  Random random_;
  Tally& tally_;
  double view_;  // [rad]
  Outline outline_;
  double laser_x_ = 0.0, fastest_ = 0.5, slowest_ = 0.0, acc_ = 2.5, turn_acc_ = 3.2;
  bool hostile_ = false, there_ = false, waits_ = false, ever_seen_ = false;
  Planner planner_{critics::built_in()};
  std::vector<std::uint8_t> costs_;
  Point goal_{0.0, 0.0}, at_{0.0, 0.0}, where_{0.0, 0.0};
  double heading_ = 0.0, radius_ = 0.3, speed_ = 1.0;
  Twist2 u_, last_, wanted_, rate_, whim_;
  std::deque<std::pair<double, Twist2>> sent_;
};

Tally attack(int view, double reverse, bool bounded) {
  Tally tally;
  for (int k = 0; k < encounters; ++k) {
    Encounter(static_cast<std::uint64_t>(4810 + k), view, reverse, bounded, tally).run();
  }
  std::printf(
      "%3d degrees, reverse %.1f, %-8s %5d met, touched %4d: unseen at a fast place %3d (%.3f m/s), seen before %3d, "
      "others %4d; %.0f m\n",
      view, reverse, bounded ? "bounded:" : "free:", tally.met, tally.touched, tally.at_a_fast_place, tally.fastest,
      tally.seen_before, tally.overtaken, tally.driven);
  return tally;
}

TEST(BlindAttack, NobodyWhoWasNeverSeenIsTouchedByAPlaceThatMovesTowardsHimFast) {
  for (const int view : {180, 270, 360}) {
    for (const double reverse : {0.2, 1.0}) {
      const Tally tally = attack(view, reverse, true);
      EXPECT_EQ(tally.at_a_fast_place, 0) << view << " " << reverse;
      EXPECT_GT(tally.touched, encounters / 10);
    }
  }
}

TEST(BlindAttack, FindsThemWhereTheBoundIsOff) {
  for (const int view : {180, 270}) EXPECT_GT(attack(view, 1.0, false).at_a_fast_place, 0) << view;
}

}  // namespace
}  // namespace hidwa_local_planner
