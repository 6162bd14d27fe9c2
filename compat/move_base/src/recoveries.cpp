// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/recoveries.h>
#include <ros/console.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace move_base {
namespace {

std::string textMember(XmlRpc::XmlRpcValue& entry, const char* key, const std::string& list) {
  if (entry.getType() != XmlRpc::XmlRpcValue::TypeStruct || !entry.hasMember(key) ||
      entry[key].getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw std::runtime_error("parameter " + list + ": each entry must be {name: ..., type: ...}");
  }
  return static_cast<std::string>(entry[key]);
}

}  // namespace

std::vector<Recoveries::Entry> Recoveries::readList(ros::NodeHandle& private_nh) {
  XmlRpc::XmlRpcValue list;
  const std::string key = private_nh.resolveName("recovery_behaviors");
  std::vector<Entry> entries;
  if (!private_nh.getParam("recovery_behaviors", list)) return entries;
  if (list.getType() != XmlRpc::XmlRpcValue::TypeArray) {
    throw std::runtime_error("parameter " + key + " must be a list of {name: ..., type: ...}");
  }
  for (int i = 0; i < list.size(); ++i) {
    Entry entry{textMember(list[i], "name", key), textMember(list[i], "type", key)};
    const auto same = [&entry](const Entry& other) { return other.name == entry.name; };
    if (std::any_of(entries.begin(), entries.end(), same)) {
      throw std::runtime_error("parameter " + key + " names \"" + entry.name + "\" twice; give each its own name");
    }
    entries.push_back(entry);
  }
  return entries;
}

void Recoveries::load(ros::NodeHandle& private_nh, tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& global_costmap,
                      costmap_2d::Costmap2DROS& local_costmap) {
  for (const Entry& entry : readList(private_nh)) {
    const auto behavior = loader_.createInstance(entry.type);
    behavior->initialize(entry.name, &tf, &global_costmap, &local_costmap);
    ROS_INFO("Recovery behaviour %s, a %s", entry.name.c_str(), entry.type.c_str());
    add(entry.name, behavior);
  }
}

void Recoveries::add(const std::string& name, boost::shared_ptr<nav_core::RecoveryBehavior> behavior) {
  behaviors_.push_back({name, std::move(behavior)});
}

void Recoveries::helped(Trigger trigger) {
  if (trigger == trigger_) next_ = 0;
}

void Recoveries::reset() {
  next_ = 0;
  trigger_ = Trigger::kPlanning;
}

void Recoveries::runNext() { behaviors_.at(next_++).behavior->runBehavior(); }

}  // namespace move_base
