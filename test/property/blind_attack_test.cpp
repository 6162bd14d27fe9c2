// SPDX-License-Identifier: BSD-3-Clause
// People who come out of where the robot's laser does not look, aimed at it, while autonomy drives to random goals or a
// hostile operator steers it into them. Nothing is told of them; where they are in view they are in the costmap. The
// laser is this file's own, the robot and the contact are in attacked_base.hpp.
//
// HIDWA_LONG: 1,500 encounters of each kind, 3,000 of each laser, where it is 25.
#include <algorithm>
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

const int encounters = test::effort(25, 1500);

constexpr double kTick = AttackedBase::kTick, kPeriod = AttackedBase::kPeriod;  // [s]
constexpr double kBlindSpeed = 0.1;                                             // [m/s]

struct Tally {
  int met = 0, touched = 0;
  int at_a_fast_place = 0;  // which moved towards somebody who had never been seen
  int seen_before = 0;      // likewise, towards somebody who had come into view
  int overtaken = 0;        // touched at a place that moved towards him slowly, or not at all
  double fastest = -1e9;    // of the first kind [m/s]
  double driven = 0.0;      // [m]
};

void set_outline(int kind, AttackedBase& base) {
  if (kind == 0) base.radius = 0.3;
  if (kind == 1) base.corners = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
  if (kind == 2) base.corners = {{0.7, 0.25}, {-0.2, 0.25}, {-0.2, -0.25}, {0.7, -0.25}};
}

class Encounter {
 public:
  Encounter(std::uint64_t seed, int view, double reverse, bool bounded, Tally& tally)
      : random_(seed), tally_(tally), view_(view * M_PI / 180.0) {
    set_outline(random_.integer(0, 2), base_);
    Parameters p;
    p.vx_samples = 14;
    p.vth_samples = 15;
    p.min_vel_x = -reverse;
    p.max_vel_x = random_.chance(0.5) ? 0.5 : 1.0;
    p.blind_speed = kBlindSpeed;
    if (!bounded) p.sensor_sectors = "all";
    fastest_ = p.max_vel_x;
    slowest_ = p.min_vel_x;
    base_.acc = p.acc_lim_x;
    base_.turn_acc = p.acc_lim_theta;
    EXPECT_TRUE(planner_.configure(p).empty());
    planner_.set_footprint(base_.radius > 0.0 ? test::round_outline(base_.radius) : base_.corners);
    laser_x_ = base_.radius > 0.0 ? 0.1 : base_.corners[0].x() - random_.uniform(0.0, 0.1);
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
      base_.move(now);
      if (there_ && (walk() || (where_ - base_.at).norm() > 6.0)) break;
    }
    tally_.driven += base_.driven;
  }

 private:
  static constexpr int kCells = 160;
  static constexpr double kCell = 0.05, kOrigin = -0.5 * kCells * kCell;  // [m]

  bool in_view(const Point& p) const { return base_.in_view(p, laser_x_, view_); }

  // A laser that sees all round sees him too: then he comes from anywhere.
  void appear() {
    there_ = true;
    ++tally_.met;
    for (int i = 0; i < 1000; ++i) {
      const double angle = random_.uniform(-M_PI, M_PI), far = random_.uniform(1.2, 2.5);
      where_ = base_.at + far * Point(std::cos(angle), std::sin(angle));
      if (!in_view(where_) || view_ > 6.28) break;
    }
    radius_ = random_.uniform(0.2, 0.3);
    speed_ = random_.uniform(0.3, 1.8);
    waits_ = random_.chance(0.3);
    ever_seen_ = false;
  }

  // Straight at the robot; some only stand in its way. True once he touches it.
  bool walk() {
    const Point to = base_.at - where_;
    if (!waits_ || to.norm() > 1.0) where_ += to.normalized() * speed_ * kTick;
    ever_seen_ = ever_seen_ || in_view(where_);
    const std::optional<double> towards = base_.touched(where_, radius_);
    if (!towards) return false;
    ++tally_.touched;
    if (*towards <= kBlindSpeed + 1e-6) {
      ++tally_.overtaken;
    } else if (ever_seen_) {
      ++tally_.seen_before;
    } else {
      ++tally_.at_a_fast_place;
    }
    if (!ever_seen_) tally_.fastest = std::max(tally_.fastest, *towards);
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
    s.pose = {base_.at.x(), base_.at.y(), base_.heading};
    s.velocity = base_.u;
    s.last_command = base_.last;
    s.period = kPeriod;
    s.time = now;
    s.sensor_sectors = {{{laser_x_, 0.0, 0.0}, view_, 10.0}};
    if ((goal_ - base_.at).norm() < 0.8 || random_.chance(0.005)) {
      const double x = random_.uniform(-2.5, 2.5), y = random_.uniform(-2.5, 2.5);
      goal_ = {x, y};
    }
    const Point way = goal_ - base_.at;
    const double direction = std::atan2(way.y(), way.x());
    for (double l = 0.0; l < way.norm(); l += 0.05) {
      const Point p = base_.at + l * way.normalized();
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
    base_.take(now, decision.outcome == Outcome::fail ? Twist2{} : decision.command);
  }

  Random random_;
  Tally& tally_;
  double view_;  // [rad]
  AttackedBase base_;
  double laser_x_ = 0.0, fastest_ = 0.5, slowest_ = 0.0;
  bool hostile_ = false, there_ = false, waits_ = false, ever_seen_ = false;
  Planner planner_{critics::built_in()};
  std::vector<std::uint8_t> costs_;
  Point goal_{0.0, 0.0}, where_{0.0, 0.0};
  double radius_ = 0.3, speed_ = 1.0;
  Twist2 whim_;
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
