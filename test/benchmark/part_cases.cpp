// SPDX-License-Identifier: BSD-3-Clause
// The parts of a cycle, each by itself, as Planner::plan puts them together.
#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"
#include "benchmark/cycle_case.hpp"
#include "benchmark/cycle_times.hpp"
#include "core/collision/admissibility.hpp"
#include "core/collision/cell_classes.hpp"
#include "core/collision/collision.hpp"
#include "core/distance/plan_grids.hpp"
#include "core/motion/command_history.hpp"
#include "core/motion/rollout.hpp"
#include "core/motion/samples.hpp"
#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner::test {
namespace {

class Parts {
 public:
  explicit Parts(const Scene& first)
      : parameters_(first.parameters),
        footprint_(Footprint::from_outline(first.outline, first.parameters.footprint_padding)) {
    start_.limits = VelocityLimits::from(parameters_);
    start_.pending = &pending_;
  }
  Parts(const Parts&) = delete;

  void take(const Scene& scene) {
    scene_ = &scene;
    grid_ = scene.grid();
    const Situation& s = scene.situation;
    commands_.forget();
    const double latency = parameters_.control_latency;
    commands_.observe(s.time, s.period, latency + s.period, s.last_command, start_.limits);
    start_.pose = start_.origin = s.pose;
    start_.reference = commands_.last();
    start_.period = start_.longest_period = s.period;
    commands_.play(start_.limits, s.period, latency, 0.0, pending_.first());
  }
  void sample() {
    SampleRequest request;
    request.previous = scene_->situation.last_command;
    request.operator_command = &scene_->intent.u_h;
    request.vx_samples = parameters_.vx_samples;
    request.vth_samples = parameters_.vth_samples;
    sampler_.make(parameters_, start_.limits, start_, request);
  }
  void start_rollout() { rollout_.run(parameters_, start_, sampler_.samples()); }
  void roll_out() {
    start_rollout();
    for (std::size_t t = 0; t < rollout_.tile_count(); ++t) benchmark::DoNotOptimize(rollout_.tile(t).x);
  }
  // As far as any rollout or stop.
  void find_reach() {
    double fastest = std::abs(start_.reference.v);
    for (const Sample& sample : sampler_.samples()) fastest = std::max(fastest, std::abs(sample.u.v));
    const double stop = start_.manoeuvre(0, {fastest, 0.0}, 0.0).reach(start_.limits);
    growth_ = BrakingCheck::most_growth(start_, footprint_.circumscribed_radius(), stop);
    reach_ = std::max(fastest * parameters_.sim_time, stop + growth_);
  }
  void mark_obstacles() {
    const double margin = std::max(0.5 * rollout_.longest_step(), grid_.resolution / 16.0);
    collision_.prepare(grid_, footprint_, parameters_.unknown_is_obstacle, pose(), reach_, margin,
                       growth_ + 2.0 * grid_.resolution);
    classes_.prepare(collision_, grid_, parameters_.unknown_is_obstacle, pose(), reach_);
  }
  void classify() {
    for (std::size_t t = 0; t < rollout_.tile_count(); ++t) {
      benchmark::DoNotOptimize(classes_.under(rollout_.tile(t)).classes);
    }
  }
  void judge() {
    admissibility_.prepare(parameters_, collision_, footprint_, grid_.resolution, {&start_});
    for (std::size_t t = 0; t < rollout_.tile_count(); ++t) {
      Tile tile = rollout_.tile(t);
      tile.cells = classes_.under(tile);
      reasons_.assign(tile.count, nullptr);
      admissibility_.check_rollouts(tile, reasons_.data());
      for (std::size_t c = 0; c < tile.count; ++c) {
        if (reasons_[c] == nullptr) benchmark::DoNotOptimize(admissibility_.can_brake(tile.sample(c), c));
      }
    }
  }
  // All three sets at once, as the critics ask for them.
  void measure_distances(Method method) {
    const double ahead = parameters_.forward_point_distance;
    grids_.prepare(grid_, scene_->situation.plan, method, parameters_.unknown_is_obstacle);
    grids_.expect(pose(), reach_ + std::max(parameters_.forward_point_distance, ahead));
    grids_.to_goal_ahead(ahead, pose(), scene_->situation.goal);
    benchmark::DoNotOptimize(grids_.to_path().table().units);
  }

 private:
  const Pose2& pose() const { return start_.pose; }

  Parameters parameters_;
  Footprint footprint_;
  const Scene* scene_ = nullptr;
  GridView grid_;
  CommandHistory commands_;
  CycleStart start_;
  PendingMotionSet pending_;
  double reach_ = 0.0, growth_ = 0.0;  // [m]
  Sampler sampler_;
  Rollout rollout_;
  CollisionChecker collision_;
  CellClasses classes_;
  AdmissibilityCheck admissibility_;
  std::vector<const char*> reasons_;  // of a tile
  PlanGrids grids_;
};

// What comes before in a cycle is done, but not timed.
struct Part {
  const char* name;
  void (*before)(Parts&);
  void (*timed)(Parts&);
};

void sample_and_start(Parts& parts) {
  parts.sample();
  parts.find_reach();
  parts.start_rollout();
}
void all_before_the_tiles(Parts& parts) {
  sample_and_start(parts);
  parts.mark_obstacles();
}

constexpr Part kParts[] = {
    {"sampling", [](Parts& /*parts*/) {}, [](Parts& parts) { parts.sample(); }},
    {"rollout", [](Parts& parts) { parts.sample(); }, [](Parts& parts) { parts.roll_out(); }},
    {"obstacles", sample_and_start, [](Parts& parts) { parts.mark_obstacles(); }},
    {"classes", all_before_the_tiles, [](Parts& parts) { parts.classify(); }},
    {"admissibility", all_before_the_tiles, [](Parts& parts) { parts.judge(); }},
    {"geodesic", sample_and_start, [](Parts& parts) { parts.measure_distances(Method::hidwa); }},
    {"l1", sample_and_start, [](Parts& parts) { parts.measure_distances(Method::paper); }},
};

void run_part(benchmark::State& state, const Effort& effort, const Part& part, CycleCase& cycles) {
  Parts parts(cycles.scene(0));
  CycleTimes times;
  times.measure(
      state, effort, cycles.size(),
      [&](std::size_t k) {
        parts.take(cycles.scene(k));
        part.before(parts);
      },
      [&](std::size_t /*k*/) { part.timed(parts); });
  const CycleCase::Size size = cycles.measure();
  times.report(state, size.candidates, size.poses);
}

void add(const Effort& effort, const Part& part, const char* load_name, const Setting& setting) {
  const std::string name = std::string("part/") + part.name + "/" + load_name + "/" + std::to_string(setting.cells) +
                           "/" + to_string(setting.body) + "/" + to_string(setting.ground);
  const auto body = [=](benchmark::State& state) {
    try {
      CycleCase cycles(load(load_name), setting);
      run_part(state, effort, part, cycles);
    } catch (const std::exception& fault) {
      state.SkipWithError(fault.what());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_parts(const Effort& effort) {
  for (const char* load_name : {"819", "2000"}) {
    for (const Body body : {Body::circle, Body::polygon}) {
      for (const Ground ground : {Ground::open, Ground::tight}) {
        for (const Part& part : kParts) add(effort, part, load_name, {120, body, ground});
      }
    }
  }
}

}  // namespace hidwa_local_planner::test
