// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/host_calls.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <dynamic_reconfigure/Config.h>

#include "ros/host/cycle_tick.hpp"

namespace hidwa_local_planner {
namespace {

constexpr char kFrequency[] = "controller_frequency";

// A host may ask for a value beyond the parameter's range.
double in_range(const std::string& parameter, double value) {
  const ParameterInfo& info = parameter_info(parameter);
  return std::isfinite(value) ? std::clamp(value, info.min, info.max) : info.max;
}

}  // namespace

HostCalls::HostCalls(ros::NodeHandle node) {
  std::string key;
  double frequency = 0.0;
  if (node.searchParam(kFrequency, key) && node.getParam(key, frequency)) take_frequency(frequency);
  host_parameters_ = node.subscribe<dynamic_reconfigure::Config>(
      "parameter_updates", 10, [this](const dynamic_reconfigure::Config::ConstPtr& config) {
        for (const dynamic_reconfigure::DoubleParameter& parameter : config->doubles) {
          if (parameter.name == kFrequency) take_frequency(parameter.value);
        }
      });
}

void HostCalls::take_frequency(double frequency) {
  if (std::isfinite(frequency) && frequency > 0.0) host_frequency_ = frequency;
}

double HostCalls::period(const Parameters& parameters) const {
  const double own = parameters.controller_frequency;
  return 1.0 / (own > 0.0 ? own : host_frequency_.load());
}

void HostCalls::cycle_called() {
  silence_ = time_in_cycle();
  called_ = std::chrono::steady_clock::now();
}

// The host's frequency may change meanwhile: a cycle asks for the period once.
control::Timing HostCalls::begin_cycle(double now, const Parameters& parameters, const std::optional<double>& last) {
  const double nominal = period(parameters);
  const CycleTick tick = cycle_tick(now, nominal, last);
  if (!tick.paused) watch_.observe(now, tick.interval);
  was_away_ = host_was_away(tick, nominal, silence_);
  return {now, nominal, watch_.longest(nominal), tick.paused ? 0.0 : tick.interval, tick.jumped_back};
}

control::Timing HostCalls::between_cycles(double now, const Parameters& parameters) const {
  const double nominal = period(parameters);
  return {now, nominal, watch_.longest(nominal), 0.0, false};
}

double HostCalls::time_in_cycle() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - called_).count();
}

bool HostCalls::set_tolerances(double xy, double yaw) {
  const Tolerances wanted{in_range("xy_goal_tolerance", xy), in_range("yaw_goal_tolerance", yaw)};
  if (tolerances_ && tolerances_->xy == wanted.xy && tolerances_->yaw == wanted.yaw) return false;
  tolerances_ = wanted;
  return true;
}

void HostCalls::apply_tolerances(Parameters& parameters) const {
  if (!tolerances_) return;
  parameters.xy_goal_tolerance = tolerances_->xy;
  parameters.yaw_goal_tolerance = tolerances_->yaw;
}

bool HostCalls::tell_goal_reached(bool reached, bool host_stops, bool stands) {
  arriving_ = reached && !host_stops && !stands;
  return reached && !arriving_;
}

}  // namespace hidwa_local_planner
