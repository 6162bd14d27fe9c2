// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "sim/mover.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Where something is at a time.
struct KeyFrame {
  double time = 0.0;                                   // [s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
};

/// How it moves from one key frame to the next: straight on with one velocity, or along the Catmull-Rom spline over
/// the key frames' index that Gazebo plays (its velocity is steady too, but overshoots where times are uneven).
enum class KeyMotion { linear, spline };

/// A track through key frames, over and over again: from the last one it leaps to the first.
class KeyFrameTrack {
 public:
  /// Two key frames or more, the first at time 0, times rising. Throws std::invalid_argument.
  KeyFrameTrack(std::vector<KeyFrame> frames, KeyMotion motion);

  Eigen::Vector2d position(double time) const;  // [m]
  Eigen::Vector2d velocity(double time) const;  // [m/s], of the way to the next key frame; leaps have none
  /// When it last leapt [s]: minus infinity before the first time.
  double leapt(double time) const;
  double period() const { return frames_.back().time; }  // [s]

 private:
  struct Place {
    std::size_t segment;
    double share;     // of the segment, [0, 1)
    double duration;  // of the segment [s]
  };
  Place place(double time) const;
  Eigen::Vector2d tangent(std::size_t key) const;

  std::vector<KeyFrame> frames_;
  KeyMotion motion_;
};

/// Discs on such tracks. They mind neither the robot nor one another.
class KeyFramePeople : public People {
 public:
  /// `radius` [m], of every disc; `start` [s]: on the tracks' clock when the drive's begins.
  KeyFramePeople(std::vector<KeyFrameTrack> tracks, double radius, double start);

  void advance(double time, const RobotSeen& robot) override;

 private:
  std::vector<KeyFrameTrack> tracks_;
  double start_;  // [s]
};

}  // namespace sim
}  // namespace hidwa_local_planner
