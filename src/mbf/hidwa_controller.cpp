// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <mbf_costmap_core/costmap_controller.h>
#include <mbf_msgs/ExePathResult.h>
#include <ros/time.h>
#include <pluginlib/class_list_macros.hpp>

#include "ros/host/controller.hpp"

namespace hidwa_local_planner {
namespace {

// By their names: the numbers changed between versions of Move Base Flex.
std::uint32_t code_of(ControllerOutcome outcome) {
  using Result = mbf_msgs::ExePathResult;
  switch (outcome) {
    case ControllerOutcome::success:
      return Result::SUCCESS;
    case ControllerOutcome::canceled:
      return Result::CANCELED;
    case ControllerOutcome::no_valid_command:
      return Result::NO_VALID_CMD;
    case ControllerOutcome::collision:
      return Result::COLLISION;
    case ControllerOutcome::missed_path:
      return Result::MISSED_PATH;
    case ControllerOutcome::blocked_path:
      return Result::BLOCKED_PATH;
    case ControllerOutcome::invalid_path:
      return Result::INVALID_PATH;
    case ControllerOutcome::map_error:
      return Result::MAP_ERROR;
    case ControllerOutcome::tf_error:
      return Result::TF_ERROR;
    case ControllerOutcome::not_initialized:
      return Result::NOT_INITIALIZED;
    case ControllerOutcome::internal_error:
      break;
  }
  return Result::INTERNAL_ERROR;
}

}  // namespace

/// The planner as Move Base Flex loads it. Pose and velocity that it passes are not used: the velocity is empty in
/// its releases, and the pose is in another frame than the costmap.
class HIDWAController : public mbf_costmap_core::CostmapController {
 public:
  void initialize(std::string name, TF* tf, costmap_2d::Costmap2DROS* costmap_ros) override {
    controller_.initialize(name, tf, costmap_ros);
  }
  bool setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) override { return controller_.set_plan(plan); }
  std::uint32_t computeVelocityCommands(const geometry_msgs::PoseStamped&, const geometry_msgs::TwistStamped&,
                                        geometry_msgs::TwistStamped& cmd_vel, std::string& message) override {
    const ControllerOutcome outcome = controller_.compute(cmd_vel.twist, message);
    cmd_vel.header.stamp = ros::Time::now();
    return code_of(outcome);
  }
  bool isGoalReached(double dist_tolerance, double angle_tolerance) override {
    return controller_.goal_reached(dist_tolerance, angle_tolerance);
  }
  bool cancel() override {
    controller_.cancel();
    return true;
  }

 private:
  Controller controller_;
};

}  // namespace hidwa_local_planner

PLUGINLIB_EXPORT_CLASS(hidwa_local_planner::HIDWAController, mbf_costmap_core::CostmapController)
