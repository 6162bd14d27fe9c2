// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <std_msgs/String.h>

#include "hidwa_local_planner/core/critic_registry.hpp"
#include "ros/parameter_loading.hpp"
#include "ros/parameter_set.hpp"
#include "ros/reconfigure.hpp"
#include "ros/robot_description.hpp"

namespace hidwa_local_planner {

/// The parameters of a planner: the parameter server's at the start, then those of dynamic_reconfigure. A set is judged
/// by the thread that changes it, and does not change any more. It comes into force between two cycles.
class ParameterUpdates {
 public:
  /// What a set of parameters changes.
  struct Targets {
    /// Subscribes to the topics; returns the fault in words. From the thread that changes parameters.
    std::function<std::string(const Parameters&)> listen;
    /// Puts a set in force; returns the faults, and with any nothing changes. From the thread of the cycles.
    std::function<std::vector<std::string>(const ParameterSet&)> configure;
    /// A set was accepted. From the thread that changes parameters.
    std::function<void(const Parameters&)> accepted;
  };

  /// `name`: the planner's; `handle`: its namespace, with the callback queue that serves dynamic_reconfigure. `base`:
  /// the robot's frame.
  ParameterUpdates(std::string name, const ros::NodeHandle& handle, const std::string& base, CriticRegistry registry);

  /// Takes what the parameter server holds, and starts dynamic_reconfigure. Where that is not valid the defaults are in
  /// force, and fault() says why. Returns how many values the parameter server had. From then on a device without the
  /// right buttons can ask for a mode by topic, below the planner's name: `set_mode` (std_msgs/String).
  std::size_t start(Targets targets);
  /// A set was accepted that is not in force yet. From any thread.
  bool waits() const { return std::atomic_load(&pending_) != nullptr; }
  /// The last valid set, in force or about to be. From any thread.
  std::shared_ptr<const ParameterSet> accepted() const { return std::atomic_load(&accepted_); }
  /// Between two cycles: puts the newest accepted set in force. True where there was one.
  bool take();
  /// Between two cycles: puts the set in force once more, since the host changed its tolerances.
  void repeat();
  /// Why the parameters at the start cannot drive; empty where they can, and once a valid set came. Of the thread of
  /// the cycles.
  const std::string& fault() const { return fault_; }
  const CriticRegistry& registry() const { return registry_; }  // by which sets are judged
  /// See RobotDescription; only before callbacks are served.
  void give_outline(costmap_2d::Costmap2DROS& costmap) const {
    description_.give_outline(costmap, accepted_->parameters.footprint_from_urdf);
  }

 private:
  using SharedSet = std::shared_ptr<const ParameterSet>;

  LoadedParameters load();
  std::vector<std::string> judge(const Parameters& wanted);
  void warn(const std::vector<std::string>& warnings) const;
  void warn_of_misplaced() const;
  void set_mode(const std::string& mode);

  const std::string name_;
  ros::NodeHandle handle_;
  RobotDescription description_;
  const CriticRegistry registry_;
  Targets targets_;
  SharedSet accepted_;  // written by std::atomic_store() once other threads may read it
  SharedSet pending_;   // accepted, in force from the next cycle on; two threads: only by std::atomic_...
  SharedSet in_force_;
  std::string fault_;
  std::unique_ptr<Reconfigure> reconfigure_;
  ros::Subscriber set_mode_;
};

}  // namespace hidwa_local_planner
