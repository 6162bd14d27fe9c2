// SPDX-License-Identifier: BSD-3-Clause
// How a host calls the planner. This folder holds what exists only because of the ways of the hosts, move_base and Move
// Base Flex:
//
//   hidwa_planner_ros, controller     their calls, one class each
//   host_calls, cycle_tick            their rate and its pauses, in which another node may drive; their checks of the
//                                     goal between two cycles; the tolerances of Move Base Flex
//   goal_succession                   plans of move_base to a goal that it no longer pursues
//   drive_without_goal, host_actions  the operator drives while the host has no goal
//   cancel_request                    Move Base Flex cancels a drive
//   yielding_recovery, robot_keepers  move_base recovers
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "control/control_loop.hpp"
#include "control/period_watch.hpp"

namespace hidwa_local_planner {

/// When a host calls, and what it asks for besides. Not thread-safe: the host's control thread. The host's rate, its
/// parameter controller_frequency, can change while move_base runs.
class HostCalls {
 public:
  /// Reads the host's rate in its private namespace `node`, or in one above it. The callback queue of `node` serves
  /// what the host's dynamic_reconfigure server announces.
  explicit HostCalls(ros::NodeHandle node);

  /// The nominal control period [s].
  double period(const Parameters& parameters) const;
  /// The host calls a control cycle: time_in_cycle() counts from here.
  void cycle_called();
  /// The cycle begins at `now`; `last`: the one before began then [s].
  control::Timing begin_cycle(double now, const Parameters& parameters, const std::optional<double>& last);
  /// Of a call between two cycles.
  control::Timing between_cycles(double now, const Parameters& parameters) const;
  double longest_period(double period) const { return watch_.longest(period); }  // of late [s]; see PeriodWatch
  /// Since the cycle was called, on the wall [s].
  double time_in_cycle() const;
  /// Another node may have driven before this cycle.
  bool was_away() const { return was_away_; }

  /// Where the goal is reached, instead of what the parameters say [m], [rad]; brought into the parameters' ranges.
  /// False where nothing changed.
  bool set_tolerances(double xy, double yaw);
  void apply_tolerances(Parameters& parameters) const;

  /// Whether the host is told that the goal is reached. A host that does not stop the robot then (`host_stops` false)
  /// hears it only when cycles have brought it to rest.
  bool tell_goal_reached(bool reached, bool host_stops, bool stands);
  /// The robot is at the goal, and cycles are to bring it to rest.
  bool arriving() const { return arriving_; }

 private:
  struct Tolerances {
    double xy = 0.0, yaw = 0.0;  // [m], [rad]
  };

  void take_frequency(double frequency);

  std::atomic<double> host_frequency_{20.0};  // of its control cycle [Hz]; at first move_base's usual one
  ros::Subscriber host_parameters_;
  PeriodWatch watch_;
  std::chrono::steady_clock::time_point called_;  // time of the last call; the epoch before the first
  double silence_ = 0.0;                          // before that [s]
  bool was_away_ = false;
  bool arriving_ = false;
  std::optional<Tolerances> tolerances_;
};

}  // namespace hidwa_local_planner
