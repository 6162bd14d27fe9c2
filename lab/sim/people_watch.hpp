// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sim/diff_drive.hpp"
#include "sim/mover.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// The robot moves where its outermost point is faster than this.
constexpr double kMoves = 0.01;  // [m/s]

/// The first moment of an uninterrupted overlap of the robot with somebody.
struct Touch {
  double time = 0.0;                                            // [s]
  std::uint32_t id = 0;                                         // of the mover
  bool robot_moved = false;                                     // or stood
  bool by_robot = false;                                        // it moved into the mover faster than the mover into it
  double robot_speed = 0.0;                                     // of its outermost point [m/s]
  double speed = 0.0;                                           // of the mover [m/s]
  double since_leap = std::numeric_limits<double>::infinity();  // of the mover [s]
};

/// Judges how the robot fares among people, against their true discs and its true outline. It shares no code with
/// the planner.
class PeopleWatch {
 public:
  /// `outline`: of the robot, unpadded, robot frame [m].
  explicit PeopleWatch(Polygon outline);

  /// `dt` [s] have passed; the robot is at `pose` and has moved with `velocity` since.
  void add(double time, double dt, const Pose& pose, const Velocity& velocity, const std::vector<Mover>& movers);

  const std::vector<Touch>& touches() const { return touches_; }
  int touches_moving() const { return moving_; }
  int touches_at_rest() const { return static_cast<int>(touches_.size()) - moving_; }
  /// How often somebody was within kEncounter of the moving robot: each uninterrupted stay counts once.
  int encounters() const { return encounters_; }
  double closest() const { return closest_; }                // [m], between outline and disc; infinite: never anybody
  double personal_space() const { return personal_space_; }  // [s], moving within kPersonalSpace of somebody
  double standing() const { return standing_; }              // [s], the robot did not move

  static constexpr double kEncounter = 1.0;      // [m]
  static constexpr double kPersonalSpace = 0.5;  // [m]

 private:
  struct Past {
    bool touching = false;
    bool met = false;  // this stay within kEncounter has been counted
  };
  Touch touch(double time, const Pose& pose, const Velocity& velocity, const Mover& mover) const;

  Polygon outline_;
  double radius_;  // of the circle round the outline [m]
  std::vector<Past> past_;
  std::vector<Touch> touches_;
  int moving_ = 0, encounters_ = 0;
  double closest_ = std::numeric_limits<double>::infinity();
  double personal_space_ = 0.0, standing_ = 0.0;
};

}  // namespace sim
}  // namespace hidwa_local_planner
