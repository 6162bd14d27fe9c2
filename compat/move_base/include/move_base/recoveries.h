// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/recovery_behavior.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <pluginlib/class_loader.hpp>

#include <boost/shared_ptr.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace move_base {

/// What is tried, one after the other, before a goal is given up; and what asked for it.
class Recoveries {
 public:
  enum class Trigger { kPlanning, kControlling, kOscillation };

  /// One entry of the list `recovery_behaviors`.
  struct Entry {
    std::string name;
    std::string type;
  };
  /// The list in the node's namespace; empty where there is none. Throws std::runtime_error when it is malformed or
  /// names one twice.
  static std::vector<Entry> readList(ros::NodeHandle& private_nh);

  /// Loads what the list names. Throws std::runtime_error, or what pluginlib throws, where that cannot be had.
  void load(ros::NodeHandle& private_nh, tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& global_costmap,
            costmap_2d::Costmap2DROS& local_costmap);
  void add(const std::string& name, boost::shared_ptr<nav_core::RecoveryBehavior> behavior);

  void askedBy(Trigger trigger) { trigger_ = trigger; }
  Trigger trigger() const { return trigger_; }
  /// What `trigger` asked for has helped: the next need begins with the first one again.
  void helped(Trigger trigger);
  /// A goal begins or ends.
  void reset();

  /// True while there is one left to try.
  bool left() const { return next_ < behaviors_.size(); }
  const std::string& nextName() const { return behaviors_.at(next_).name; }
  std::size_t nextNumber() const { return next_; }
  std::size_t size() const { return behaviors_.size(); }
  /// Runs the next one; returns when it has ended.
  void runNext();

 private:
  struct Named {
    std::string name;
    boost::shared_ptr<nav_core::RecoveryBehavior> behavior;
  };
  pluginlib::ClassLoader<nav_core::RecoveryBehavior> loader_{"nav_core", "nav_core::RecoveryBehavior"};
  std::vector<Named> behaviors_;
  std::size_t next_ = 0;
  Trigger trigger_ = Trigger::kPlanning;
};

}  // namespace move_base
