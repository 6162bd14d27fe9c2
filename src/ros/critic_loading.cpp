// SPDX-License-Identifier: BSD-3-Clause
#include "ros/critic_loading.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <ros/console.h>
#include <pluginlib/class_loader.hpp>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "ros/guarded_critic.hpp"
#include "ros/parameter_loading.hpp"

namespace hidwa_local_planner {
namespace {

/// pluginlib's loader, which is not thread-safe, behind a lock.
struct PluginLoader {
  std::mutex mutex;
  pluginlib::ClassLoader<Critic> loader{"hidwa_local_planner", "hidwa_local_planner::Critic"};
};

/// A loaded critic; its library stays until it is gone.
struct LoadedCritic {
  std::shared_ptr<PluginLoader> plugins;
  boost::shared_ptr<Critic> critic;
};

/// Null, and the reason in the log, where it cannot be had.
std::shared_ptr<Critic> make(const std::shared_ptr<PluginLoader>& plugins, const std::string& name) {
  try {
    const std::lock_guard<std::mutex> lock(plugins->mutex);
    auto loaded = std::make_shared<LoadedCritic>();
    loaded->plugins = plugins;
    loaded->critic = plugins->loader.createInstance(name);
    return std::make_shared<GuardedCritic>(name, std::shared_ptr<Critic>(loaded, loaded->critic.get()));
  } catch (const std::exception& error) {
    ROS_ERROR("the critic %s cannot be loaded: %s", name.c_str(), error.what());
  } catch (...) {
    ROS_ERROR("the critic %s cannot be loaded: its constructor failed", name.c_str());
  }
  return nullptr;
}

}  // namespace

CriticRegistry registry_with_plugins() {
  CriticRegistry registry = critics::built_in();
  std::shared_ptr<PluginLoader> plugins;
  try {
    plugins = std::make_shared<PluginLoader>();
  } catch (const std::exception& error) {
    ROS_WARN("pluginlib cannot list the critics of other packages: %s", error.what());
    return registry;
  }
  const std::vector<std::string> declared = plugins->loader.getDeclaredClasses();
  std::map<std::string, int> bearers;  // of a short name
  for (const std::string& name : declared) ++bearers[short_name(name)];
  for (const std::string& name : declared) {
    const CriticRegistry::Maker maker = [plugins, name] { return make(plugins, name); };
    registry.add(name, maker);
    registry.add(plugins->loader.getClassType(name), maker);
    const std::string brief = short_name(name);
    if (bearers[brief] == 1 && !registry.knows(brief)) registry.add(brief, maker);
  }
  return registry;
}

}  // namespace hidwa_local_planner
