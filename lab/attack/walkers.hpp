// SPDX-License-Identifier: BSD-3-Clause
// People who want to touch the robot while it moves. They keep their bounds of speed and acceleration, and what is told
// of them is wrong by up to three deviations, and old. They walk through walls. The contact check is this file's own.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "random.hpp"
#include "shape.hpp"
#include "world.hpp"

namespace hidwa_attack {

using hidwa_local_planner::MovingObstacleEstimates;
using hidwa_local_planner::Twist2;

/// What walkers are and what is known of them.
struct Bounds {
  double acc = 1.5, speed = 1.8;                       // what they keep [m/s^2, m/s]
  double position_error = 0.03, velocity_error = 0.1;  // a third of the largest error [m, m/s]
  double oldest = 0.15;                                // age of an estimate [s]
  double told_errors = 1.0;                            // times the errors: what the planner is told of them
  double lingering = 1.0 / 6.0;                        // the share of those who linger at the robot
  double appear = 0.0;  // nobody appears nearer to the robot's edge [m], and 3 m from its centre
};

/// What became of it.
struct Encounters {
  std::uint64_t met = 0;      // a walker comes within 1 m of the moving robot
  std::uint64_t moving = 0;   // touched while the robot moved
  std::uint64_t leaving = 0;  // likewise, by one whom the robot was leaving, as safety.md allows it
  double fastest = 0.0;       // of the robot's outermost point, at all these touches [m/s]
  std::uint64_t at_rest = 0;  // touched at rest
};

struct Walker {
  enum class Way { chase, intercept, pounce, wait, cut, linger };
  std::uint32_t id = 0;
  Spot p, v;  // [m, m/s]
  double radius = 0.3;
  Way way = Way::chase;
  bool close = false, touches = false;
  double stood = 0.0;                    // at the robot, since it rested [s]
  double idle = 0.0;                     // near a robot at rest [s]
  bool steps_in = false;                 // one who lingers does
  double nearest = 0.0;                  // so near one who lingers comes to a robot at rest [m]
  Spot stroll;                           // its velocity until it attacks [m/s]
  std::deque<std::array<Spot, 2>> past;  // places and velocities, one a step, newest first
};

class Walkers {
 public:
  static constexpr double kStep = 0.002;  // [s]
  static constexpr double kMoves = 0.01;  // the robot moves where its outermost point is faster [m/s]

  /// `robot`: its outline without padding, as it stands at `pose`.
  Walkers(int count, const Bounds& bounds, const Shape& robot, const Pose2& pose, std::uint64_t seed);

  /// All walk for kStep; the robot is here now.
  void step(const Pose2& pose, const Twist2& velocity);
  /// What is told of all of them now. Where `map` is given, with points of their outlines, wherever no cell of it is
  /// lethal: as a sensor sees them before free space.
  MovingObstacleEstimates told(const World* map = nullptr);
  const std::vector<Walker>& all() const { return walkers_; }
  const Walker& nearest() const;  // where there is one
  const Encounters& encounters() const { return encounters_; }
  /// From the robot's edge to a walker's [m]; negative where they overlap.
  double gap(const Walker& walker) const;

 private:
  double speed_of_edge() const { return std::abs(velocity_.v) + outermost_ * std::abs(velocity_.omega); }
  double appears() const;
  void place(Walker& walker);
  Spot wish_of(const Walker& walker) const;
  void move(Walker& walker);
  void look();
  Spot seen(const Walker& walker) const;
  bool is_left(const Walker& walker) const;
  double advance(const Walker& walker) const;
  double error(double third);
  Spot anywhere(double length);

  Bounds bounds_;
  Shape robot_;
  double outermost_;  // [m]
  Random random_;
  Pose2 pose_;
  Twist2 velocity_;
  std::vector<Walker> walkers_;
  std::uint32_t ids_ = 0;
  Encounters encounters_;
};

}  // namespace hidwa_attack
