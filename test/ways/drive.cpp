// SPDX-License-Identifier: BSD-3-Clause
#include "ways/drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <ostream>
#include <stdexcept>

#include "attack/base.hpp"
#include "attack/contact_watch.hpp"
#include "control/control_loop.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "ways/grid_plan.hpp"
#include "ways/novelty.hpp"
#include "ways/processor_time.hpp"

namespace hidwa_ways {
namespace {

namespace control = hidwa_local_planner::control;
namespace critics = hidwa_local_planner::critics;
using hidwa_local_planner::Outcome;
using hidwa_local_planner::Twist2;

constexpr int kPeriod = 50;        // of the control cycle [ms]
constexpr int kReplans = 1000;     // of the global planner [ms]
constexpr double kNearer = 0.3;    // [m]
constexpr double kSoon = 5.0;      // within which a robot is nearer [s]
constexpr double kOpen = 10.0;     // how long a scene is driven of which nothing is asked [s]
constexpr double kAnswer = 2.0;    // beyond the patience: a robot without a way says so [s]
constexpr double kLongest = 40.0;  // [s]

hidwa_attack::Base::Make base_of(const hidwa_local_planner::Parameters& p) {
  hidwa_attack::Base::Make make;
  make.x = {p.acc_lim_x, p.braking_x()};
  make.theta = {p.acc_lim_theta, p.braking_theta()};
  make.period = 1e-3 * kPeriod;
  make.latency = static_cast<int>(std::lround(1e3 * p.control_latency));
  return make;
}

class Drive {
 public:
  Drive(const Scene& scene, const Finding& finding, Result& result, std::ostream* trace, std::vector<Pose2>* driven)
      : scene_(scene),
        finding_(finding),
        result_(result),
        trace_(trace),
        driven_(driven),
        parameters_(scene.parameters()),
        map_(scene.world, kLocalMap, inscribed(scene.body.shape)),
        base_(base_of(parameters_), scene.start, scene.seed),
        contacts_(scene.world, hidwa_attack::padded(scene.body.shape, parameters_.footprint_padding)),
        target_(finding.answer == Class::sure ? through_or_farther(scene) : through_target(scene)),
        loop_(critics::built_in()) {
    const std::vector<std::string> faults = loop_.configure(parameters_);
    if (!faults.empty()) throw std::logic_error(faults.front());
    hidwa_local_planner::Polygon outline;
    for (const Spot& corner : hidwa_attack::told_corners(scene.body.shape)) outline.emplace_back(corner.x, corner.y);
    loop_.set_footprint(outline);
    set_limits();
    if (trace_ != nullptr) *trace_ << "t,x,y,theta,v,omega,command_v,command_omega,outcome,remaining,depth,problem\n";
  }

  void go() {
    for (int now = 0; !over(1e-3 * now); ++now) {
      if (now == 0 || (scene_.replans && now % kReplans == 0)) plan(now);
      if (now % kPeriod == 0) cycle(now);
      base_.step(now);
      contacts_.observe(now, base_.pose(), base_.velocity());
    }
    result_.touched = contacts_.touched();
    result_.depth = contacts_.deepest_touch();
  }

 private:
  // Whose own way is slow may take longer.
  void set_limits() {
    result_.through_limit = kOpen;
    if (finding_.answer != Class::sure) return;
    const Pace pace = scene_.pace();
    result_.way_length = finding_.way.length();
    result_.way_time = finding_.way.time(pace);
    result_.through_limit = 3.0 * result_.way_time + 3.0;
    result_.nearer_limit = std::max(kSoon, 2.0 + 1.5 * time_to_be_nearer(pace));
  }

  // On the way that the search found [s].
  double time_to_be_nearer(const Pace& pace) const {
    Way part{finding_.way.start, {}};
    Pose2 at = part.start;
    for (const Move& move : finding_.way.moves) {
      part.moves.push_back(move);
      at = after(at, move);
      if (finding_.field->cost_near(at) <= finding_.remaining - kNearer) break;
    }
    return part.time(pace);
  }

  bool over(double now) const {
    if (now > kLongest || (contacts_.touched() && now > 1e-3 * contacts_.touched_at() + 1.0)) return true;
    if (result_.through_at >= 0.0) return true;
    if (finding_.answer == Class::none) return result_.failed_at >= 0.0 || result_.failed_late;
    return now > result_.through_limit;
  }

  void plan(int now) {
    std::vector<Pose2> plan = scene_.plan;
    const Spot at{base_.pose().x, base_.pose().y};
    if (now > 0) {
      if (!planner_of_plans_) make_planner_of_plans();
      if (!planner_of_plans_->reaches(at)) return;
      plan = planner_of_plans_->from(at);
      plan.back() = scene_.plan.back();  // the same goal, its heading too
    }
    loop_.set_plan(std::move(plan), "map", time_at(now), 1e-3 * kPeriod);
  }

  void make_planner_of_plans() {
    const double side = std::max(scene_.world.width(), scene_.world.height());
    hidwa_attack::LocalMap whole(scene_.world, side, inscribed(scene_.body.shape));
    const Pose2& goal = scene_.plan.back();
    planner_of_plans_ = std::make_unique<GridPlan>(whole.around({0.5 * side, 0.5 * side, 0.0}), Spot{goal.x, goal.y});
  }

  // Any clock will do but one that begins at zero.
  static double time_at(int now) { return 100.0 + 1e-3 * now; }

  void cycle(int now) {
    control::Observation observation;
    observation.timing.now = time_at(now);
    observation.timing.period = observation.timing.interval = 1e-3 * kPeriod;
    observation.velocity = base_.velocity();
    observation.pose = base_.pose();
    observation.costmap = map_.around(scene_.rolling ? base_.pose() : scene_.start);
    const double begun = processor_time();
    const control::Result cycle = loop_.step(observation, {});
    result_.worst_cycle = std::max(result_.worst_cycle, processor_time() - begun);
    ++result_.cycles;
    base_.send(now, cycle.command);
    const std::string problem = cycle.decision != nullptr ? cycle.decision->problem : "";
    judge(1e-3 * now, cycle.outcome == Outcome::fail ? problem : "");
    stamp(cycle.command);
    if (driven_ != nullptr) driven_->push_back(base_.pose());
    if (trace_ != nullptr) write(1e-3 * now, cycle, problem);
  }

  void judge(double now, const std::string& failure) {
    const Pose2& pose = base_.pose();
    novelty_.observe(now, pose);
    if (result_.failed_at < 0.0 && !failure.empty()) {
      result_.failed_at = now;
      result_.problem = failure;
    }
    if (now > novelty_.since() + parameters_.stall_time + kAnswer && result_.failed_at < 0.0)
      result_.failed_late = true;
    if (finding_.answer == Class::sure && result_.nearer_at < 0.0 && remaining() <= finding_.remaining - kNearer)
      result_.nearer_at = now;
    if (!target_.near(pose.x, pose.y, through_distance(scene_))) return;
    result_.through_at = now;
    if (result_.nearer_at < 0.0) result_.nearer_at = now;
  }

  double remaining() const { return finding_.field ? finding_.field->cost_near(base_.pose()) : -1.0; }

  // A sum of all that was commanded and driven, to the bit.
  void stamp(const Twist2& command) {
    for (const double value : {command.v, command.omega, base_.pose().x, base_.pose().y, base_.pose().theta}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      result_.print = (result_.print ^ bits) * 1099511628211ULL;
    }
  }

  void write(double now, const control::Result& cycle, const std::string& problem) {
    const Pose2& q = base_.pose();
    const Twist2 u = base_.velocity();
    *trace_ << now << ',' << q.x << ',' << q.y << ',' << q.theta << ',' << u.v << ',' << u.omega << ','
            << cycle.command.v << ',' << cycle.command.omega << ',' << to_string(cycle.outcome) << ',' << remaining()
            << ',' << contacts_.depth_now() << ",\"" << problem << "\"\n";
  }

  const Scene& scene_;
  const Finding& finding_;
  Result& result_;
  std::ostream* trace_;
  std::vector<Pose2>* driven_;
  hidwa_local_planner::Parameters parameters_;
  hidwa_attack::LocalMap map_;
  hidwa_attack::Base base_;
  hidwa_attack::ContactWatch contacts_;
  Target target_;
  control::ControlLoop loop_;
  std::unique_ptr<GridPlan> planner_of_plans_;
  Novelty novelty_;
};

}  // namespace

void drive(const Scene& scene, const Finding& finding, Result& result, std::ostream* trace,
           std::vector<Pose2>* driven) {
  Drive(scene, finding, result, trace, driven).go();
}

}  // namespace hidwa_ways
