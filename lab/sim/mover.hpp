// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace hidwa_local_planner {
namespace sim {

/// What a laser at shin height sees of somebody.
enum class Body { whole, legs };

/// Somebody or something that moves, as it truly is; map frame.
struct Mover {
  std::uint32_t id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // of its centre [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  double radius = 0.0;                                 // of the disc that holds all of it [m]
  Body body = Body::whole;
  double heading = 0.0;                                     // where its front is [rad]
  double gait = 0.0;                                        // phase of its steps [rad]
  double leapt = -std::numeric_limits<double>::infinity();  // when it last was put somewhere else at once [s]
};

/// The robot, as those around it see it; map frame.
struct RobotSeen {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  double radius = 0.0;                                 // of the disc that holds all of it [m]
};

/// All who move around the robot.
class People {
 public:
  virtual ~People() = default;

  /// Goes on to `time` [s]; times do not fall.
  virtual void advance(double time, const RobotSeen& robot) = 0;

  const std::vector<Mover>& movers() const { return movers_; }

 protected:
  std::vector<Mover> movers_;
};

}  // namespace sim
}  // namespace hidwa_local_planner
