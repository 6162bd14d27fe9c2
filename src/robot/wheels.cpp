// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wheels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/util/words.hpp"

namespace hidwa_local_planner::robot {
namespace {

constexpr double kAboutY = 0.9994;          // cosine of 2 degrees: axes farther from y are no wheels'
constexpr double kAlong = 0.9962;           // cosine of 5 degrees: a cylinder farther from the axis does not roll on it
constexpr double kOpposite = 0.005;         // two wheels of a pair may be so far from facing each other [m]
constexpr double kSmallest = 0.001;         // of a radius or a separation [m]
constexpr double kLargestRadius = 2.0;      // [m]
constexpr double kLargestSeparation = 5.0;  // as wheel_separation [m]

using Pair = std::pair<const Joint*, const Joint*>;  // left, right

bool about_y(const Joint& joint) { return std::abs(joint.axis.y()) > kAboutY; }

bool may_roll(const Shape& shape) { return shape.kind != Shape::Kind::box; }

bool may_drive(const Model& model, const Joint& joint) {
  if (joint.turning != Turning::freely || !joint.fixed_to_base || !about_y(joint)) return false;
  const Link& link = model.links[joint.child];
  return std::any_of(link.collisions.begin(), link.collisions.end(), may_roll) ||
         std::any_of(link.visuals.begin(), link.visuals.end(), may_roll);
}

bool opposite(const Joint& left, const Joint& right) {
  const Eigen::Vector3d mirrored(right.position.x(), -right.position.y(), right.position.z());
  return left.position.y() > kOpposite && (left.position - mirrored).cwiseAbs().maxCoeff() <= kOpposite;
}

std::vector<Pair> pairs_of(const Model& model) {
  std::vector<Pair> pairs;
  for (const Joint& left : model.joints) {
    if (!may_drive(model, left)) continue;
    for (const Joint& right : model.joints) {
      if (may_drive(model, right) && opposite(left, right)) pairs.emplace_back(&left, &right);
    }
  }
  return pairs;
}

std::string choice_of(const std::vector<Pair>& pairs) {
  const std::string remedy = "name the driving ones by wheel_joints";
  if (pairs.empty()) {
    return "no two joints turn freely about y, opposite each other, with a wheel on them: " + remedy;
  }
  std::string text = "more than one pair of wheels (";
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    text += (i == 0 ? "" : ", ") + pairs[i].first->name + " and " + pairs[i].second->name;
  }
  return text + "): " + remedy;
}

const Joint* joint_named(const Model& model, const std::string& name) {
  const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const Joint& candidate) { return candidate.name == name; });
  return joint == model.joints.end() ? nullptr : &*joint;
}

/// Why the joint of this name is no wheel's; empty where it is.
std::string joint_fault(const Model& model, const std::string& parameter, const std::string& name) {
  const Joint* joint = joint_named(model, name);
  if (joint == nullptr) {
    std::string text = name + ": there is no such joint (" + parameter + "); those that turn freely are";
    const std::size_t bare = text.size();
    for (const Joint& other : model.joints) {
      if (other.turning == Turning::freely) text += (text.size() == bare ? " " : ", ") + other.name;
    }
    return text.size() == bare ? text + " none" : text;
  }
  if (joint->turning == Turning::not_at_all) {
    return name + ": it does not turn (" + parameter + "): a wheel's joint is continuous";
  }
  if (!about_y(*joint)) {
    return name + ": it turns about (" + worded(joint->axis.x()) + ", " + worded(joint->axis.y()) + ", " +
           worded(joint->axis.z()) + ") of " + model.base +
           ", a driving wheel turns about y: correct its axis or origin";
  }
  return "";
}

/// What a link rolls on.
struct Rim {
  double radius = 0.0;  // [m]
  std::string missing;  // why there is none
  std::string fault;    // the radius is none
};

Rim rim_of(const Joint& joint, const Link& link) {
  Rim rim;
  const std::string of_link = joint.name + ": its link " + link.name;
  rim.missing = of_link + " has no geometry";
  for (const std::vector<Shape>* shapes : {&link.collisions, &link.visuals}) {
    for (const Shape& shape : *shapes) {
      const bool cylinder = shape.kind == Shape::Kind::cylinder;
      if (!cylinder && shape.kind != Shape::Kind::sphere) {
        rim.missing = of_link + " has no cylinder and no sphere, and a mesh or a box has no radius";
      } else if (cylinder && std::abs(shape.pose.linear().col(2).dot(joint.axis)) < kAlong) {
        rim.missing = of_link + " has a cylinder that does not lie along the joint's axis";
      } else if (!(shape.radius >= kSmallest && shape.radius <= kLargestRadius)) {
        rim.fault = of_link + " has a radius of " + worded(shape.radius) + " m, outside [" + worded(kSmallest) + ", " +
                    worded(kLargestRadius) + "] m: correct it in the URDF";
      } else {
        rim.radius = std::max(rim.radius, shape.radius);
      }
    }
    if (rim.radius > 0.0 || !rim.fault.empty()) break;
  }
  return rim;
}

/// Takes one wheel; returns the fault.
std::string add_wheel(Wheels& wheels, const Joint& joint, const Link& link) {
  if (joint.max_velocity) {
    const double velocity = *joint.max_velocity;
    if (!(velocity > 0.0) || !std::isfinite(velocity)) {
      return joint.name + ": <limit velocity> is " + worded(velocity) +
             " rad/s: set what the wheel can do, or remove <limit> from the continuous joint";
    }
    if (wheels.slower.empty() || velocity < wheels.max_velocity) {
      wheels.max_velocity = velocity;
      wheels.slower = joint.name;
    }
  }
  const Rim rim = rim_of(joint, link);
  if (!rim.fault.empty()) return rim.fault;
  if (rim.radius <= 0.0) {
    if (wheels.no_radius.empty())
      wheels.no_radius =
          rim.missing + ": set max_wheel_speed, or give the link a cylinder along the axis as collision geometry";
  } else {
    wheels.radius = wheels.radius > 0.0 ? std::min(wheels.radius, rim.radius) : rim.radius;
  }
  return "";
}

WheelSearch wheels_on(const Model& model, const Joint& left, const Joint& right) {
  WheelSearch search;
  Wheels wheels;
  wheels.left = left.name;
  wheels.right = right.name;
  wheels.separation = std::abs(left.position.y() - right.position.y());
  search.fault = add_wheel(wheels, left, model.links[left.child]);
  if (search.fault.empty()) search.fault = add_wheel(wheels, right, model.links[right.child]);
  if (search.fault.empty() && !(wheels.separation >= kSmallest && wheels.separation <= kLargestSeparation)) {
    search.fault = left.name + " and " + right.name + ": they lie " + worded(wheels.separation) +
                   " m apart across y, outside [" + worded(kSmallest) + ", " + worded(kLargestSeparation) +
                   "] m: correct their origins, or wheel_joints";
  }
  if (!wheels.no_radius.empty()) wheels.radius = 0.0;
  if (search.fault.empty()) search.wheels = std::move(wheels);
  return search;
}

}  // namespace

WheelSearch find_wheels(const Model& model, const std::string& left, const std::string& right) {
  WheelSearch search;
  if (left.empty() && right.empty()) {
    const std::vector<Pair> pairs = pairs_of(model);
    if (pairs.size() == 1) return wheels_on(model, *pairs[0].first, *pairs[0].second);
    search.fault = choice_of(pairs);
    search.undecided = true;
    return search;
  }
  if (left.empty() || right.empty()) {
    search.fault = "wheel_joints names one joint: name the left and the right one, or none to have them found";
    return search;
  }
  search.fault = joint_fault(model, "wheel_joints", left);
  if (search.fault.empty()) search.fault = joint_fault(model, "wheel_joints", right);
  if (!search.fault.empty()) return search;
  return wheels_on(model, *joint_named(model, left), *joint_named(model, right));
}

}  // namespace hidwa_local_planner::robot
