// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/way_finder.hpp"

namespace hidwa_local_planner {

void WayFinder::reserve() {
  search_.reserve();
  way_back_.reserve(StepBack::kMostPoses);
}

void WayFinder::clear() {
  search_.clear();
  with_movers_ = without_movers_ = false;
}

void WayFinder::begin(const Cycle& cycle, const Pose2& start, Target target, const StepBack& trail) {
  const Situation& situation = cycle.situation;
  const bool back = target == Target::back;
  if (back) trail.write_way_back(start, way_back_);
  make_search_task(start, back ? way_back_ : situation.plan, cycle.grid, cycle.footprint, cycle.parameters,
                   cycle.start.limits, task_);
  if (target == Target::goal) aim_at_goal(situation.goal, cycle.parameters, task_);
  with_movers_ = !without_movers_ && !situation.moving_obstacles.empty();
  if (with_movers_) add_movers(situation.moving_obstacles, cycle.footprint, task_);
  if (without_movers_) remove_movers(situation.moving_obstacles, task_);
  search_.begin(task_);
}

bool WayFinder::repeat_without_movers(const Cycle& cycle, Target target, const StepBack& trail) {
  if (!with_movers_) return false;
  without_movers_ = true;
  begin(cycle, start(), target, trail);
  return true;
}

WaySearch::State WayFinder::run(const Cycle& cycle, Way& way) {
  const int poses = cycle.sampling.search_poses > 0 ? cycle.sampling.search_poses : cycle.parameters.search_poses;
  const WaySearch::State state = search_.run(poses);
  if (state == WaySearch::State::found) search_.write(way);
  return state;
}

}  // namespace hidwa_local_planner
