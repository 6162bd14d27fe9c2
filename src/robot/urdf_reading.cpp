// SPDX-License-Identifier: BSD-3-Clause
#include "robot/urdf_reading.hpp"

#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <utility>

#include <urdf_parser/urdf_parser.h>

#include "urdf_log.hpp"

namespace hidwa_local_planner::robot {
namespace {

Eigen::Vector3d vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d pose_of(const urdf::Pose& pose) {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
  pose.rotation.getQuaternion(x, y, z, w);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  result.translation() = vector_of(pose.position);
  return result;
}

/// One <collision> or <visual> of a link at `place`.
template <typename Part>
Shape shape_of(const Part& part, const Eigen::Isometry3d& place) {
  Shape shape;
  shape.pose = place * pose_of(part.origin);
  const urdf::Geometry* geometry = part.geometry.get();
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry)) {
    shape.kind = Shape::Kind::box;
    shape.size = vector_of(box->dim);
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry)) {
    shape.kind = Shape::Kind::cylinder;
    shape.radius = cylinder->radius;
    shape.length = cylinder->length;
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry)) {
    shape.kind = Shape::Kind::sphere;
    shape.radius = sphere->radius;
  }
  return shape;
}

template <typename Parts>
std::vector<Shape> shapes_of(const Parts& parts, const Eigen::Isometry3d& place) {
  std::vector<Shape> shapes;
  for (const auto& part : parts) {
    if (part && part->geometry) shapes.push_back(shape_of(*part, place));
  }
  return shapes;
}

Turning turning_of(const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::CONTINUOUS) return Turning::freely;
  if (joint.type != urdf::Joint::REVOLUTE) return Turning::not_at_all;
  const double range = joint.limits ? joint.limits->upper - joint.limits->lower : 0.0;  // [rad]
  return range == 0.0 || range > 2.0 * M_PI ? Turning::freely : Turning::within_bounds;
}

/// A link on the way through the tree.
struct Visit {
  urdf::LinkConstSharedPtr link;
  Eigen::Isometry3d pose;  // in the root's frame, later in the base's
  bool fixed = true;       // to the root
};

/// Every link that the root carries, parents first; each once, whatever the joints say.
std::vector<Visit> walk(const urdf::ModelInterface& urdf, std::map<std::string, std::size_t>& index) {
  std::vector<Visit> visits{{urdf.getRoot(), Eigen::Isometry3d::Identity(), true}};
  index[visits[0].link->name] = 0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit parent = visits[i];
    for (const urdf::JointSharedPtr& joint : parent.link->child_joints) {
      const urdf::LinkConstSharedPtr child = urdf.getLink(joint->child_link_name);
      if (!child || !index.emplace(child->name, visits.size()).second) continue;
      visits.push_back({child, parent.pose * pose_of(joint->parent_to_joint_origin_transform),
                        parent.fixed && joint->type == urdf::Joint::FIXED});
    }
  }
  return visits;
}

Joint joint_of(const urdf::Joint& joint, std::size_t child, const Visit& parent, const Visit& moved) {
  Joint result;
  result.name = joint.name;
  result.child = child;
  result.turning = turning_of(joint);
  result.fixed_to_base = parent.fixed;
  result.position = moved.pose.translation();
  result.axis = moved.pose.linear() * vector_of(joint.axis).normalized();
  if (joint.limits) result.max_velocity = joint.limits->velocity;
  return result;
}

Model model_of(const urdf::ModelInterface& urdf, const std::string& base_frame, std::string& warning) {
  std::map<std::string, std::size_t> index;
  std::vector<Visit> visits = walk(urdf, index);
  Model model;
  model.base = base_frame.substr(base_frame.find_last_of('/') + 1);
  if (index.count(model.base) == 0) {
    warning = "there is no link " + model.base + " (the costmap's robot_base_frame): the root link " +
              urdf.getRoot()->name + " is taken for it";
    model.base = urdf.getRoot()->name;
  }
  const Eigen::Isometry3d to_base = visits[index[model.base]].pose.inverse();
  for (Visit& visit : visits) {
    visit.pose = to_base * visit.pose;
    model.links.push_back({visit.link->name, shapes_of(visit.link->collision_array, visit.pose),
                           shapes_of(visit.link->visual_array, visit.pose)});
  }
  for (std::size_t i = 1; i < visits.size(); ++i) {
    const urdf::JointSharedPtr& joint = visits[i].link->parent_joint;
    if (!joint || index.count(joint->parent_link_name) == 0) continue;
    model.joints.push_back(joint_of(*joint, i, visits[index[joint->parent_link_name]], visits[i]));
  }
  return model;
}

std::string no_urdf(const std::string& why) {
  return "it is not a valid URDF (" + why + "): correct it; check_urdf shows how far it can be read";
}

}  // namespace

UrdfReading read_urdf(const std::string& text, const std::string& base_frame) {
  UrdfReading reading;
  try {
    const UrdfLog log(text);
    const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(text);
    if (urdf && urdf->getRoot()) {
      reading.model = model_of(*urdf, base_frame, reading.warning);
    } else {
      reading.fault = no_urdf(log.errors());
    }
  } catch (const std::exception& error) {
    reading.fault = no_urdf(error.what());
  } catch (...) {
    reading.fault = no_urdf("it cannot be parsed");
  }
  return reading;
}

}  // namespace hidwa_local_planner::robot
