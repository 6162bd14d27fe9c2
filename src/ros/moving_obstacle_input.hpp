// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <topic_tools/shape_shifter.h>

#include "hidwa_local_planner/MovingObstacles.h"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "ros/loop_time.hpp"

namespace hidwa_local_planner {

/// What moves, as a tracker tells it: hidwa_local_planner/MovingObstacles, people_msgs/People or
/// costmap_converter/ObstacleArrayMsg. Thread-safe; both sides hold the lock for a pointer and some words only.
///
/// A message counts from its stamp on for moving_obstacle_timeout, until the next one comes. Its places are brought
/// into the costmap's frame by the transform at its stamp; velocities are only turned, whether or not their frame
/// moves. Where tf does not reach that far yet, the newest transform is taken. What cannot be used does not count, and
/// status() says why.
class MovingObstacleInput {
 public:
  // More than that is no list of what moves around a robot.
  static constexpr std::size_t kMost = 256;         // obstacles in a message
  static constexpr std::size_t kMostPoints = 4096;  // of an obstacle

  /// `handle` decides the namespace and whose thread serves the messages. An empty topic: to nothing.
  void subscribe(ros::NodeHandle handle, const std::string& topic);
  /// `received` counts where there is no stamp.
  void receive(const MovingObstacles::ConstPtr& message, const LoopTime& received);
  /// Of any type. One that is none of these is refused: the message before counts until it is too old.
  void receive(const topic_tools::ShapeShifter& message, const LoopTime& received);
  /// Time jumped back, or the sender is another one.
  void forget();

  /// What counts at `now` [s], in `frame`, with its age; replaces what is in `obstacles`.
  void read(double now, double timeout, const tf2::BufferCore& tf, const std::string& frame,
            MovingObstacleEstimates& obstacles);

  /// What the sensors look at that find what moves, as the newest message told it, in the frame `base` of the robot. It
  /// counts until another message tells something else. A sensor whose place is not known sees nothing.
  void read_sectors(const tf2::BufferCore& tf, const std::string& base, SensorSectors& sectors);

  struct Status {
    std::string topic;           // empty: nothing is listened to
    std::uint64_t messages = 0;  // received
    std::uint64_t refused = 0;   // obstacles and messages that could not be used
    std::size_t count = 0;       // that counted in the last cycle
    std::size_t sectors = 0;     // that sensors look at, as the newest message told it
    double age = 0.0;            // of the newest message in the last cycle [s]
    std::string fault;           // why nothing counts, or not all; empty where all is well
  };
  Status status() const;

 private:
  void report(std::size_t count, double age, std::string fault);

  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  MovingObstacles::ConstPtr newest_;
  MovingObstacles::ConstPtr sectors_of_;  // the last one that was heard, also when what moves does not count
  std::string unreadable_;                // why a message since then is none
  double told_of_ = 0.0;                  // when what the newest tells was so, by the loop's time [s]
  Status status_;
};

}  // namespace hidwa_local_planner
