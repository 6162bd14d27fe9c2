// SPDX-License-Identifier: BSD-3-Clause
// A search in space and time: which motion now leaves a way that nothing that moves will touch, and gets on.
//
// 1. A way is a sequence of motions: a velocity that the robot goes to within its limits and then keeps, the first one
//    for 0.4 s, the others for equal parts of the rest: ahead, back, at rest, turning. There are 6 x 5 first motions,
//    and 6 x 3 of the others: more of those are slower, and no better.
// 2. What moves is expected to keep its velocity. A way ends where the outline touches it, at rest too, or a wall.
//    Passive safety would not let the robot drive on where the mover may be there, within moving_obstacle_acc, before
//    the robot has come to rest: there it brakes, and waits until the motion ends. Else it trusts in ways out that are
//    closed to it when it comes there.
// 3. A way costs seconds: what is left to drive from its end (PlanGuide), and for every moment within a distance D of
//    something that moves
//      scale (1 - d / D)^2 exp(-t / 2 s) dt,   D = evasion_distance + (0.1 m/s + s_v) t
//    with the deviation s_v of its velocity. So far away it counts less, and where it will be is less sure. A change of
//    velocity costs a little, so that of ways that are nearly as good the calm one is taken.
// 4. After each motion the cheapest ways go on, of those that end nearly alike the cheapest one (a beam search). A way
//    that would be touched if it went straight on counts there as if it cost more, by as many seconds as it would be
//    touched before the end.
//
// Each first motion is worth what the cheapest way is that begins with it. Ways that are touched cost more than any
// other, the sooner the more. The own motions, autonomy's choice and what was chosen before, are followed up to the end
// even where another motion ends nearly alike: what they are worth is always known. Nothing is kept from cycle to
// cycle, nothing is allocated after the first one. Nothing here makes a command legal: the choice asks for that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/cycle/cycle.hpp"
#include "core/search/plan_guide.hpp"
#include "core/util/rotation.hpp"

namespace hidwa_local_planner {

class EvasionSearch {
 public:
  /// What a way costs that is touched, at least [s].
  static constexpr double kTouched = 1e4;

  /// What a search starts from. All of it outlives the search. A motion whose command the cycle's MoverCheck rejects is
  /// no first motion.
  struct Start {
    const Cycle& cycle;
    const VelocityLimits& limits;     // of its motions
    const CollisionChecker& checker;  // prepared
    TurnedPose from;                  // where the robot is when a command takes effect
    Twist2 velocity;                  // then [m/s, rad/s]
    double delay = 0.0;               // until then [s]
  };
  /// A first motion, and what the cheapest way costs that begins with it.
  struct Branch {
    Twist2 motion;      // [m/s, rad/s]
    double cost = 0.0;  // [s]; infinite where it is not known
  };

  /// Where a robot comes to that keeps one motion.
  struct ConstantMotion {
    bool untouched = false;   // up to the end
    bool untroubled = false;  // and nothing comes near
    double spent = 0.0;       // what coming near and changes of velocity cost [s]
    double x = 0.0, y = 0.0;  // at the end [m]
    Rotation heading;
    double cost(const PlanGuide& guide) const { return spent + guide.time_left(x, y, heading); }
  };

  EvasionSearch();
  /// How far ahead it looks [m]: nothing farther from the robot counts.
  static double reach(const Parameters& parameters, const VelocityLimits& limits);
  /// Whether anything that moves may come near. Before everything else.
  bool look(const Start& scene, const MovingObstacleEstimates& movers);
  /// What becomes of a robot that keeps this motion up to the end.
  ConstantMotion keep(const Start& scene, const Twist2& motion);
  /// No way costs less [s], but for one that cuts a bend of the plan short: it gets on as fast as the robot can,
  /// straight towards the plan's end, and comes near nothing.
  double least(const Start& scene, const PlanGuide& guide) const;
  /// `own`: first motions of which ways are always followed up; branches() begins with what they come to. There is one
  /// at least.
  void run(const Start& scene, const PlanGuide& guide, const std::vector<Twist2>& own);
  const std::vector<Branch>& branches() const { return branches_; }
  /// What the cheapest of them costs [s].
  double cheapest() const;

 private:
  static constexpr int kLevels = 6;
  static constexpr std::size_t kBeam = 8;
  static constexpr std::size_t kSteps = 4;  // of a motion

  struct Mover {
    double x, y, vx, vy;        // now [m], [m/s]
    double radius;              // [m]
    double kept, kept_grows;    // D and how fast it grows [m], [m/s]
    double ax = 0.0, ay = 0.0;  // while it goes on changing its velocity [m/s^2]

    // At a time; `bent`: what bend() says of it.
    double x_at(double time, double bent) const { return x + vx * time + ax * bent; }
    double y_at(double time, double bent) const { return y + vy * time + ay * bent; }
  };
  struct State {
    double x = 0.0, y = 0.0;
    Rotation heading;
    double v = 0.0, omega = 0.0;
    double nearness = 0.0;  // what coming near has cost so far [s]
    double unrest = 0.0;    // what changes of velocity have cost [s]
    double until = 0.0;     // untouched so long [s]
    double cost = 0.0;      // [s]
    double promise = 0.0;   // the cost, and more where it leads to a touch as it goes on [s]
    std::uint32_t first = 0;
  };
  // A motion of a level: when, and in what steps.
  struct Span {
    double from = 0.0, step = 0.0;       // [s]
    std::array<double, kSteps> share{};  // what a step's nearness costs [s]
    double length() const { return static_cast<double>(share.size()) * step; }
    double end() const { return from + length(); }
    double time(std::size_t k) const { return from + static_cast<double>(k + 1) * step; }  // after the k-th step [s]
  };

  void list_motions(const Start& scene, const std::vector<Twist2>& own);
  static bool may_begin(const Start& scene, const Twist2& motion);
  void plan_spans(const Start& scene);
  bool drive_on(const Start& scene, double v, const Rotation& half_turn, double step, double time, State& state) const;
  bool go(const Start& scene, const Twist2& motion, const Span& span, State& state) const;
  bool blocked(const Start& scene, const State& state) const;
  void extend(const Start& scene, const PlanGuide& guide, const State& from, const std::vector<Twist2>& motions,
              const Span& span);
  static double unrest(const State& from, const State& to);
  void note_touched(const State& state);
  void keep_best();
  const State* best_of(std::size_t first) const;
  static bool alike(const State& a, const State& b);

  // What moves: evasion_movers.cpp.
  struct Stopping {
    double time = 0.0;  // until the robot rests, less half of the braking; 0 where it does [s]
    double way = 0.0;   // until then [m]
    double room = 0.0;  // by which a mover may be elsewhere then [m]
  };
  static Stopping stopping(const Start& scene, double v);
  double bend(double time) const;
  void find_near(const Start& scene, const State& from, const Span& span);
  bool must_stop(const Start& scene, const State& state, double time) const;
  double nearness(const Start& scene, const State& state, double time, bool& touched) const;
  double touched_early(const Start& scene, const State& state, double time) const;

  std::vector<Mover> movers_, near_;
  std::vector<Twist2> first_motions_, next_motions_;  // of a way: the first one, and the others [m/s, rad/s]
  std::size_t own_ = 0;                               // the number of its own motions
  std::array<Span, kLevels> spans_;
  double horizon_ = 0.0;    // [s]
  double bends_for_ = 0.0;  // velocities go on changing so long [s]
  double fastest_ = 0.0;    // [m/s]
  bool walls_ = true;       // near what is gone on from
  std::vector<State> beam_, next_;
  std::vector<std::pair<double, std::uint32_t>> queue_;  // promise, of next_
  std::vector<Branch> branches_;                         // [motions]
};

}  // namespace hidwa_local_planner
