// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/critic_loading.hpp"

#include <mutex>
#include <utility>

#include <ros/console.h>
#include <pluginlib/class_loader.hpp>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/ros/parameter_loading.hpp"

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
    return std::shared_ptr<Critic>(loaded, loaded->critic.get());
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
    ROS_WARN("critics of other packages cannot be looked for: %s", error.what());
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

StoredParameters::StoredParameters(std::string critic, const XmlRpc::XmlRpcValue& content)
    : critic_(std::move(critic)) {
  using XmlRpc::XmlRpcValue;
  if (!content.valid() || content.getType() != XmlRpcValue::TypeStruct) return;
  for (const auto& [key, value] : content) {
    switch (value.getType()) {
      case XmlRpcValue::TypeBoolean:
        values_[key] = static_cast<const bool&>(value);
        break;
      case XmlRpcValue::TypeInt:
        values_[key] = static_cast<double>(static_cast<const int&>(value));
        break;
      case XmlRpcValue::TypeDouble:
        values_[key] = static_cast<const double&>(value);
        break;
      case XmlRpcValue::TypeString:
        values_[key] = static_cast<const std::string&>(value);
        break;
      default:
        break;
    }
  }
}

double StoredParameters::number(const std::string& key, double fallback) const {
  const auto value = values_.find(key);
  if (value == values_.end()) return fallback;
  if (const double* number = std::get_if<double>(&value->second)) return *number;
  complain(key, "a number");
  return fallback;
}

bool StoredParameters::flag(const std::string& key, bool fallback) const {
  const auto value = values_.find(key);
  if (value == values_.end()) return fallback;
  if (const bool* flag = std::get_if<bool>(&value->second)) return *flag;
  complain(key, "true or false");
  return fallback;
}

void StoredParameters::complain(const std::string& key, const char* wanted) const {
  ROS_ERROR("%s/%s: expected %s; its default is used", critic_.c_str(), key.c_str(), wanted);
}

}  // namespace hidwa_local_planner
