// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/host_frequency.hpp"

#include <cmath>
#include <string>

namespace hidwa_local_planner {
namespace {

constexpr char kParameter[] = "controller_frequency";
constexpr double kUsualFrequency = 20.0;  // of move_base's control cycle [Hz]

}  // namespace

HostFrequency::HostFrequency() : frequency_(kUsualFrequency) {
  ros::NodeHandle node("~");
  std::string key;
  double frequency = 0.0;
  if (node.searchParam(kParameter, key) && node.getParam(key, frequency)) take(frequency);
}

void HostFrequency::follow(ros::NodeHandle node) {
  subscriber_ = node.subscribe<dynamic_reconfigure::Config>(
      "parameter_updates", 10, [this](const dynamic_reconfigure::Config::ConstPtr& config) { receive(*config); });
}

void HostFrequency::take(double frequency) {
  if (std::isfinite(frequency) && frequency > 0.0) frequency_ = frequency;
}

void HostFrequency::receive(const dynamic_reconfigure::Config& config) {
  for (const dynamic_reconfigure::DoubleParameter& parameter : config.doubles) {
    if (parameter.name == kParameter) take(parameter.value);
  }
}

}  // namespace hidwa_local_planner
