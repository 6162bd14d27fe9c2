// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What one cycle of keeping the robot at rest came to.
struct RestCommand {
  Twist2 command;         // to be sent: brakes within the limits, then zero [m/s, rad/s]
  bool stands = false;    // the command asked for rest, and the robot is at rest
  bool attended = false;  // the operator stops or steers the robot
  double period = 0.0;    // until the next cycle [s]
};

/// The planners of this process, for a recovery behaviour in the same process. Each planner can keep the robot at rest,
/// and knows whether the operator stops or steers it. Both are plugins of one library, which a process loads once.
/// Thread-safe.
class RobotKeepers {
 public:
  using Keep = std::function<RestCommand()>;

  /// Those of this process.
  static RobotKeepers& of_process();

  /// A planner that can be asked for as long as this exists.
  class Entry {
   public:
    Entry(RobotKeepers& keepers, Keep keep);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

   private:
    RobotKeepers& keepers_;
  };

  /// One cycle by the planner that came last; none where there is no planner. Comes from the thread that calls the
  /// planner otherwise: a host drives or recovers, never both.
  std::optional<RestCommand> keep() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<const Entry*, Keep>> keepers_;
};

}  // namespace hidwa_local_planner
