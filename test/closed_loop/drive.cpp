// SPDX-License-Identifier: BSD-3-Clause
#include "closed_loop/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "hidwa_local_planner/core/goal_checker.hpp"
#include "hidwa_local_planner/core/plan_window.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "hidwa_local_planner/sim/distance_field.hpp"
#include "hidwa_local_planner/sim/grid_route.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr double kPeriod = 0.05;      // of the control cycle [s]
constexpr double kReplan = 1.0;       // [s]
constexpr double kWindow = 4.0;       // side of the local costmap [m]
constexpr double kScaling = 3.0;      // cost_scaling_factor [1/m]
constexpr double kInflation = 0.55;   // [m]

Pose2 pose_of(const sim::Pose& pose) { return {pose.x, pose.y, pose.theta}; }

// The inflated costs of the whole map, from the distance field: costmap_2d's formula.
std::vector<std::uint8_t> inflated(const sim::OccupancyMap& map, const sim::DistanceField& field, double inscribed) {
  std::vector<std::uint8_t> costs(map.cells.size(), cost::kFree);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double distance = field.at_cell(column, row);
      std::uint8_t& value = costs[map.index(column, row)];
      if (map.occupied(column, row)) {
        value = cost::kLethal;
      } else if (distance <= inscribed) {
        value = cost::kInscribed;
      } else if (distance <= kInflation) {
        value = static_cast<std::uint8_t>(252.0 * std::exp(-kScaling * (distance - inscribed)));
      }
    }
  }
  return costs;
}

// The outline that the planner is told: of costmap_2d's robot_radius, or the footprint.
Polygon planning_outline(const DriveSetup& setup) {
  if (setup.robot_radius <= 0.0) return Polygon(setup.footprint.begin(), setup.footprint.end());
  const sim::Polygon circle = sim::circle_polygon(setup.robot_radius, 16);
  return Polygon(circle.begin(), circle.end());
}

class Drive {
 public:
  explicit Drive(const DriveSetup& setup)
      : setup_(setup),
        field_(sim::DistanceField::to_obstacles(*setup.map)),
        costs_(inflated(*setup.map, field_, Footprint::from_outline(planning_outline(setup), 0.0).inscribed_radius())),
        route_(*setup.map, sim::RouteClearance{}, {setup.goal.x, setup.goal.y}),
        world_(world_setup(setup)) {
    planner_.configure(setup.parameters);
    planner_.set_footprint(planning_outline(setup));
    person_.configure(setup.parameters);
  }

  DriveResult run() {
    double next_plan = 0.0, next_joy = 0.0;
    while (world_.time() < setup_.time_limit) {
      const double now = world_.time();
      if (now >= next_plan - 1e-9) {
        replan();
        next_plan = now + kReplan;
      }
      if (now >= next_joy - 1e-9) {
        listen(now);
        next_joy = now + 0.05;
      }
      if (cycle(now)) break;
      world_.advance(kPeriod);
    }
    return finish();
  }

 private:
  static sim::WorldSetup world_setup(const DriveSetup& setup) {
    sim::WorldSetup world;
    world.map = setup.map;
    world.regions = setup.regions;
    world.footprint = setup.footprint;
    world.limits.latency = setup.latency;
    world.limits.max_vel_x = 2.0;
    world.start = setup.start;
    return world;
  }

  void replan() {
    std::vector<Pose2> plan;
    const sim::Route route = route_.from({world_.pose().x, world_.pose().y});
    for (std::size_t i = 0; i < route.size(); ++i) {
      const std::size_t next = std::min(i + 1, route.size() - 1);
      const std::size_t from = next == i && i > 0 ? i - 1 : i;
      const double heading = std::atan2(route[next].y() - route[from].y(), route[next].x() - route[from].x());
      plan.push_back({route[i].x(), route[i].y(), heading});
    }
    if (!plan.empty()) plan.back() = pose_of(setup_.goal);
    window_.set_plan(plan);
  }

  void listen(double now) {
    if (!setup_.person) return;
    const sim::Stick stick = setup_.person->update({now, world_.pose(), world_.velocity()});
    input::StickMessage message;
    message.axes = {static_cast<float>(stick.left), static_cast<float>(stick.up)};
    message.stamp = message.received = now;
    person_.receive(message);
  }

  // The costmap's window, aligned to the map's cells.
  GridView local_grid() {
    const sim::OccupancyMap& map = *setup_.map;
    const int cells = static_cast<int>(std::lround(kWindow / map.resolution));
    const int first_i = map.column(world_.pose().x) - cells / 2;
    const int first_j = map.row(world_.pose().y) - cells / 2;
    local_.assign(static_cast<std::size_t>(cells * cells), cost::kLethal);
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        if (!map.inside(first_i + i, first_j + j)) continue;
        local_[static_cast<std::size_t>(j * cells + i)] = costs_[map.index(first_i + i, first_j + j)];
      }
    }
    return {local_.data(),
            cells,
            cells,
            map.resolution,
            map.origin_x + first_i * map.resolution,
            map.origin_y + first_j * map.resolution};
  }

  bool cycle(double now) {
    const Parameters& p = planner_.parameters();
    Situation situation;
    situation.pose = pose_of(world_.pose());
    situation.velocity = {world_.velocity().v, world_.velocity().omega};
    situation.last_command = last_;
    situation.goal = pose_of(setup_.goal);
    situation.period = kPeriod;
    situation.time = now;
    const double least = p.forward_prune_auto ? 1.2 * p.max_vel_x * p.sim_time : 0.0;
    const double ahead = std::max(p.forward_prune_distance, least);
    const PlanWindow::Range range = window_.around(situation.pose, p.prune_distance, ahead);
    situation.plan.assign(window_.plan().begin() + static_cast<std::ptrdiff_t>(range.begin),
                          window_.plan().begin() + static_cast<std::ptrdiff_t>(range.end));
    if (goal_.update(situation.pose, situation.velocity, situation.goal, p)) {
      result_.arrived = true;
      return true;
    }
    situation.goal_latched = goal_.latched();
    const OperatorIntent intent = person_.update(now);
    const auto begin = std::chrono::steady_clock::now();
    const Decision& decision = planner_.plan(situation, local_grid(), intent);
    result_.planning += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Twist2 sent = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
    world_.command({sent.v, sent.omega});
    person_.debrief(now, {!decision.operator_refused_by.empty(), std::abs(sent.v) < 1e-3 && std::abs(sent.omega) < 1e-3,
                          goal_.latched(), sent, situation.velocity});
    record(now, sent, intent, decision);
    last_ = sent;
    return false;
  }

  void record(double now, const Twist2& sent, const OperatorIntent& intent, const Decision& decision) {
    if (decision.outcome == Outcome::fail) ++result_.failures;
    if (decision.outcome == Outcome::brake) ++result_.brakes;
    turned_ += std::abs(sent.omega - last_.omega);
    result_.samples.push_back({now, world_.pose(), sent, intent.u_h, person_.state(), decision.outcome, decision.problem});
  }

  DriveResult finish() {
    result_.duration = world_.time();
    result_.length = world_.distance();
    result_.contacts = world_.contacts();
    result_.regions_crossed = world_.regions().crossed();
    if (!result_.samples.empty()) result_.roughness = turned_ / static_cast<double>(result_.samples.size());
    return std::move(result_);
  }

  const DriveSetup& setup_;
  sim::DistanceField field_;
  std::vector<std::uint8_t> costs_;
  sim::GridRoute route_;
  sim::World world_;
  Planner planner_;
  input::OperatorStateMachine person_;
  PlanWindow window_;
  GoalChecker goal_;
  std::vector<std::uint8_t> local_;
  Twist2 last_;
  double turned_ = 0.0;  // [rad/s]
  DriveResult result_;
};

}  // namespace

DriveResult drive(const DriveSetup& setup) { return Drive(setup).run(); }

}  // namespace hidwa_local_planner::test
