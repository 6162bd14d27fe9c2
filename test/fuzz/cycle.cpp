// SPDX-License-Identifier: BSD-3-Clause
// Costmap, plan and situation: whatever they hold, the planner answers with a finite command inside its limits.
#include <cstdint>
#include <vector>

#include "fuzz/input.hpp"
#include "fuzz/mover.hpp"
#include "fuzz/require.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

// Valid ones, few samples: what the parameters can be is the other target's matter.
Parameters parameters_of(Input& input) {
  Parameters p;
  p.vx_samples = input.integer(2, 6);
  p.vth_samples = input.integer(2, 8);
  p.search_poses = input.integer(10, 200);
  p.sim_time = input.within(0.2, 2.0);
  p.max_vel_x = input.within(0.0, 2.0);
  p.min_vel_x = -input.within(0.0, 1.0);
  p.max_vel_theta = input.within(0.0, 3.0);
  p.acc_lim_x = input.within(0.05, 5.0);
  p.acc_lim_theta = input.within(0.05, 8.0);
  p.decel_lim_x = input.within(-5.0, 5.0);
  p.control_latency = input.within(0.0, 0.5);
  p.footprint_padding = input.within(0.0, 0.2);
  p.authority = input.within(0.0, 1.0);
  const unsigned choices = static_cast<unsigned>(input.integer(0, 65535));
  p.generator = (choices & 1U) != 0 ? Generator::dwa : Generator::standard;
  p.method = (choices & 2U) != 0 ? Method::paper : Method::hidwa;
  p.admissibility = (choices & 16U) != 0 ? Admissibility::horizon : Admissibility::braking;
  p.unknown_is_obstacle = (choices & 128U) == 0;
  p.moving_obstacles_clear_cells = (choices & 512U) == 0;
  if ((choices & 1024U) != 0) {
    p.critics =
        "RotateToGoal, Oscillation, BaseObstacle, GoalAlign, PathAlign, PathDist, GoalDist, SocialDistance, "
        "PreferForward, "
        "Twirling, ObstacleFootprint";
  }
  if ((choices & 2048U) != 0) {
    p.wheel_separation = 0.4;
    p.max_wheel_speed = 1.0;
  }
  if ((choices & 8192U) != 0) p.occlusion = Occlusion::off;
  if ((choices & 16384U) != 0 && p.admissibility == Admissibility::braking) p.occlusion = Occlusion::bound;
  if ((choices & 4096U) != 0) p.min_in_place_vel_theta = 0.5 * p.max_vel_theta;
  return p;
}

// Round or with up to eight corners; one in eight numbers is anything.
Polygon outline_of(Input& input) {
  if (input.flag()) return test::round_outline(input.number(0.1, 0.5));
  if (input.flag()) return {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}};
  Polygon outline;
  for (int k = input.integer(0, 8); k > 0; --k) {
    const double x = input.number(-0.6, 0.6), y = input.number(-0.6, 0.6);
    outline.emplace_back(x, y);
  }
  return outline;
}

struct Costs {
  std::vector<std::uint8_t> cells;
  GridView view;
};

// Runs of equal cells, all round a free middle where the bytes say so.
Costs costs_of(Input& input) {
  Costs costs;
  const int width = input.integer(0, 48), height = input.integer(0, 48);
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  constexpr std::uint8_t kValues[] = {cost::kFree, cost::kLethal, cost::kInscribed, cost::kUnknown, 100};
  costs.cells.reserve(count + 256);
  while (costs.cells.size() < count) {
    const std::uint8_t kind = input.byte();
    const std::size_t length = input.left() == 0 ? count : static_cast<std::size_t>(input.byte()) + 1;
    costs.cells.insert(costs.cells.end(), length, kValues[kind % 5]);
    if (costs.cells.size() > count + 256) break;
  }
  costs.cells.resize(count);
  costs.view = {costs.cells.data(),     width, height, input.number(0.02, 0.2), input.number(-4.0, 0.0),
                input.number(-4.0, 0.0)};
  return costs;
}

Pose2 pose_of(Input& input) { return {input.number(-2.0, 2.0), input.number(-2.0, 2.0), input.number(-7.0, 7.0)}; }
Twist2 twist_of(Input& input) { return {input.number(-1.0, 2.0), input.number(-3.0, 3.0)}; }

void look(Input& input, Situation& situation) {
  situation.pose = pose_of(input);
  situation.velocity = twist_of(input);
  if (input.flag()) situation.last_command = twist_of(input);
  situation.goal = pose_of(input);
  situation.goal_latched = input.integer(0, 7) == 0;
  situation.period = input.number(0.02, 0.2);
  situation.longest_period = input.number(0.0, 0.3);
  situation.pose_age = input.number(0.0, 0.3);
  situation.resumed = input.integer(0, 15) == 0;
  situation.time += input.number(0.0, 0.2);
  situation.plan.clear();
  Pose2 at = pose_of(input);
  const int poses = input.integer(0, 40);
  for (int k = 0; k < poses; ++k) {
    situation.plan.push_back(at);
    at.theta += input.within(-0.5, 0.5);
    at.x += 0.05 * std::cos(at.theta);
    at.y += 0.05 * std::sin(at.theta);
    if (input.integer(0, 31) == 31) at = pose_of(input);
  }
  situation.moving_obstacles.clear();
  for (int k = input.integer(0, 4); k > 0; --k) {
    MovingObstacleEstimate mover = mover_of(input, 3.0, 0.5);
    for (int point = input.integer(0, 8); point > 0; --point) {
      const double x = mover.position.x() + input.number(-0.3, 0.3), y = mover.position.y() + input.number(-0.3, 0.3);
      mover.points.emplace_back(x, y);
    }
    situation.moving_obstacles.push_back(mover);
  }
  situation.sensor_sectors.clear();
  for (int k = input.integer(0, 2); k > 0; --k) {
    const Pose2 mounted{input.number(-0.5, 0.5), input.number(-0.5, 0.5), input.number(-4.0, 4.0)};
    const double width = input.number(0.0, 7.0), range = input.number(0.0, 10.0);
    situation.sensor_sectors.push_back({mounted, width, range});
  }
}

OperatorIntent intent_of(Input& input) {
  OperatorIntent intent;
  intent.state = static_cast<OperatorStateId>(input.integer(0, 6));
  intent.influence = static_cast<Influence>(input.integer(0, 3));
  intent.guarded = input.integer(0, 3) != 0;
  intent.u_h = twist_of(input);
  return intent;
}

bool plausible(double period) { return period >= 1e-3 && period <= 1.0; }

// Braking may make up for a cycle that is late: over the longest period of the last seconds [s].
double longest(const Situation& situation) {
  return std::isfinite(situation.longest_period) ? std::max(situation.period, situation.longest_period)
                                                 : situation.period;
}

void run(Input input) {
  const Parameters parameters = parameters_of(input);
  Planner planner(critics::built_in());
  if (!planner.configure(parameters).empty()) return;
  planner.set_footprint(outline_of(input));
  Situation situation;
  Costs costs = costs_of(input);
  for (int cycle = 0; cycle < 4 && (cycle == 0 || input.left() > 0); ++cycle) {
    look(input, situation);
    const OperatorIntent intent = intent_of(input);
    Sampling sampling;
    sampling.report = static_cast<Report>(input.integer(0, 2));
    const Decision& decision = planner.plan(situation, costs.view, intent, sampling);
    const Twist2 last = situation.last_command;
    require_within_limits(decision.command, last, parameters);
    require(std::isfinite(decision.total) && std::isfinite(decision.agreement), "the explanation is not a number");
    const bool believable = std::abs(last.v) <= 20.0 && std::abs(last.omega) <= 50.0;
    if (believable && plausible(situation.period) && decision.problem_kind == Problem::none) {
      require_within_accelerations(decision.command, last, decision.reference, parameters, longest(situation));
    }
    for (const Pose2& pose : decision.trajectory) require(is_finite(pose), "a pose of the trajectory is not a number");
    situation.last_command = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
    if (input.integer(0, 3) == 0) costs = costs_of(input);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hidwa_local_planner::fuzz::run({data, size});
  return 0;
}
