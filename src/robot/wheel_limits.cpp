// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wheel_limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner::robot {
namespace {

constexpr double kSame = 0.02;  // lengths that differ by less are one

// A URDF that takes more than this share of what the parameters ask for may hold a number that nobody meant: many
// generators and examples write velocity="1" where the motor's limit is not known.
constexpr double kSuspicious = 0.5;

constexpr const char* kParameter = "max_wheel_speed";  // what limits where no joint does

bool all_in_range(const Parameters& p) {
  for (const char* name : {"max_vel_x", "min_vel_x", "max_vel_theta", "wheel_separation", "max_wheel_speed"}) {
    if (!parameter_info(name).is_in_range(p)) return false;
  }
  return true;
}

void compare_separation(std::vector<Remark>& remarks, double own, const Wheels& wheels) {
  const double urdf = wheels.separation;
  if (own == 0.0 || urdf == 0.0 || std::abs(own - urdf) <= kSame * urdf) return;
  remarks.push_back({Remark::Level::warning, "wheel_separation differs",
                     "wheel_separation = " + worded(own) + " m holds, but the URDF says " + worded(urdf) + " m (" +
                         wheels.left + ", " + wheels.right + "): correct one of them"});
}

/// Says which of two limits on one thing holds, and returns the tighter one.
double tighter(std::vector<Remark>& remarks, const std::string& joint, double by_joint, const std::string& name,
               double own, const std::string& unit) {
  const std::string allows = joint + " allows " + worded(by_joint) + " " + unit;
  if (own <= by_joint) {
    remarks.push_back(
        {Remark::Level::info, name + " holds", allows + ", " + name + " " + worded(own) + " " + unit + " holds"});
    return own;
  }
  std::string text = allows + " and holds: " + name + " " + worded(own) + " " + unit + " is more";
  const bool suspicious = joint != kParameter && by_joint < kSuspicious * own;
  if (suspicious) {
    text +=
        ". That is less than half: if the <limit velocity> of the joint is no more than a placeholder, correct it "
        "(in rad/s), or set robot_description_param to \"\" for no limit by the URDF";
  }
  remarks.push_back({suspicious ? Remark::Level::warning : Remark::Level::info,
                     joint + (suspicious ? " halves " : " holds against ") + name, text});
  return by_joint;
}

}  // namespace

LimitedParameters limited(const Parameters& wanted, const Wheels& wheels) {
  LimitedParameters result{wanted, {}};
  std::vector<Remark>& remarks = result.remarks;
  if (!all_in_range(wanted)) return result;  // whoever validates them says so
  compare_separation(remarks, wanted.wheel_separation, wheels);
  const double separation = wanted.wheel_separation > 0.0 ? wanted.wheel_separation : wheels.separation;
  const bool joint_limits = wheels.max_velocity > 0.0 && wheels.radius > 0.0;
  if (wheels.max_velocity > 0.0 && !joint_limits && wanted.max_wheel_speed <= 0.0) {
    remarks.push_back({Remark::Level::fault, "no radius", wheels.no_radius});
    return result;
  }
  if (!joint_limits && wanted.max_wheel_speed <= 0.0) {
    remarks.push_back(
        {Remark::Level::info, "no velocity",
         wheels.left + " and " + wheels.right + " have no <limit velocity>: the limits of the parameters hold"});
    return result;
  }

  Parameters& p = result.parameters;
  std::string by = kParameter;
  double fastest = wanted.max_wheel_speed;  // [m/s]
  if (joint_limits) {
    by = wheels.slower;
    fastest = std::min(wheels.radius * wheels.max_velocity, parameter_info(kParameter).max);
    if (wanted.max_wheel_speed > 0.0) {
      fastest = tighter(remarks, by, fastest, kParameter, wanted.max_wheel_speed, "m/s");
      if (fastest == wanted.max_wheel_speed) by = kParameter;
    }
  }
  p.wheel_separation = separation;
  p.max_wheel_speed = fastest;
  const double turn = 2.0 * fastest / separation;  // [rad/s]
  p.max_vel_x = tighter(remarks, by, fastest, "max_vel_x", wanted.max_vel_x, "m/s");
  p.min_vel_x = std::max(wanted.min_vel_x, -fastest);
  p.max_vel_theta = tighter(remarks, by, turn, "max_vel_theta", wanted.max_vel_theta, "rad/s");
  return result;
}

}  // namespace hidwa_local_planner::robot
