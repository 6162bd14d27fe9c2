// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/robot_keepers.hpp"

#include <algorithm>
#include <utility>

namespace hidwa_local_planner {

RobotKeepers& RobotKeepers::of_process() {
  static RobotKeepers keepers;
  return keepers;
}

RobotKeepers::Entry::Entry(RobotKeepers& keepers, Keep keep) : keepers_(keepers) {
  const std::lock_guard<std::mutex> lock(keepers_.mutex_);
  keepers_.keepers_.emplace_back(this, std::move(keep));
}

RobotKeepers::Entry::~Entry() {
  const std::lock_guard<std::mutex> lock(keepers_.mutex_);
  auto& all = keepers_.keepers_;
  all.erase(std::remove_if(all.begin(), all.end(), [this](const auto& one) { return one.first == this; }), all.end());
}

std::optional<RestCommand> RobotKeepers::keep() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (keepers_.empty()) return std::nullopt;
  return keepers_.back().second();
}

}  // namespace hidwa_local_planner
