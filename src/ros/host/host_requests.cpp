// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/host_requests.hpp"

namespace hidwa_local_planner {

HostRequests::HostRequests() {
  using Message = const topic_tools::ShapeShifter::ConstPtr&;
  const boost::function<void(Message)> ask = [this](Message) { asked_ = true; };
  ros::NodeHandle action = thread_.serve(ros::NodeHandle("move_base"));
  goal_ = action.subscribe<topic_tools::ShapeShifter>("goal", 1, ask);
  cancel_ = action.subscribe<topic_tools::ShapeShifter>("cancel", 1, ask);
  thread_.start();
}

HostRequests::~HostRequests() { thread_.stop(); }

}  // namespace hidwa_local_planner
