// SPDX-License-Identifier: BSD-3-Clause
// What finer samples buy: how smoothly the robot drives, and how near it comes to an operator command that is rejected.
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"
#include "drive/drive.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "sim/random.hpp"
#include "support/office.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr Sampling kFinest{160, 240};

// Pushes to one side or the other for a while, again and again, wherever the robot is.
class Pusher : public sim::Operator {
 public:
  explicit Pusher(std::uint64_t seed) : random_(seed) {}
  sim::Stick update(const sim::Observation& seen) override {
    if (seen.time >= next_) {
      until_ = seen.time + 1.0 + 1.5 * random_.uniform();
      left_ = (random_.uniform() < 0.5 ? -1.0 : 1.0) * (0.35 + 0.65 * random_.uniform());
      next_ = until_ + 3.0 + 3.0 * random_.uniform();
    }
    return {seen.time < until_ ? left_ : 0.0, 0.0};
  }

 private:
  sim::Random random_;
  double next_ = 4.0;                                        // [s]
  double until_ = -std::numeric_limits<double>::infinity();  // [s]
  double left_ = 0.0;
};

// Of the cycles in which the person's own command was rejected.
struct Rejected {
  int cycles = 0;
  double deviation = 0.0;  // summed: s_v |v_h - v| + s_omega |omega_h - omega| of the choice
  double excess = 0.0;     // summed: J of the choice above that with the finest samples
};

double deviation_of(const Decision& decision, const Twist2& u_h, const Parameters& p) {
  return p.s_v * std::abs(u_h.v - decision.sample.v) + p.s_omega * std::abs(u_h.omega - decision.sample.omega);
}

// The same cycles of the same drives for every sampling: the default's drives, looked at by two planners more.
void look_at_rejections(const Sampling& sampling, std::uint64_t seed, Rejected& rejected) {
  drive::DriveSetup setup = office(0.0);
  setup.laser_seed = seed;
  setup.person = std::make_shared<Pusher>(seed);
  Planner planner(critics::built_in()), finest(critics::built_in());
  for (Planner* each : {&planner, &finest}) {
    if (!each->configure(setup.parameters).empty()) throw std::runtime_error("the default parameters are refused");
    each->set_footprint(setup.outline);
  }
  int number = 0;
  drive::drive(setup, [&](const drive::Cycle& cycle) {
    if (cycle.intent.influence != Influence::shared || cycle.decision.operator_rejected_by.empty()) return;
    if (number++ % 5 != 0) return;
    planner.reset();
    finest.reset();
    const Decision& choice = planner.plan(cycle.situation, cycle.grid, cycle.intent, sampling);
    const Decision& best = finest.plan(cycle.situation, cycle.grid, cycle.intent, kFinest);
    if (choice.outcome != Outcome::drive || best.outcome != Outcome::drive) return;
    ++rejected.cycles;
    rejected.deviation += deviation_of(choice, cycle.intent.u_h, planner.parameters());
    rejected.excess += choice.total - best.total;
  });
}

void run_samples(benchmark::State& state, const Sampling& sampling, std::uint64_t drives) {
  drive::DriveResult alone;
  Rejected rejected;
  for (auto _ : state) {
    try {
      drive::DriveSetup setup = office(0.0);
      setup.parameters.vx_samples = sampling.vx_samples;
      setup.parameters.vth_samples = sampling.vth_samples;
      alone = drive::drive(setup);
      for (std::uint64_t seed = 1; seed <= drives; ++seed) look_at_rejections(sampling, seed, rejected);
    } catch (const std::exception& fault) {
      state.SkipWithError(fault.what());
      return;
    }
  }
  state.counters["omega_change"] = alone.omega_change;
  state.counters["duration_s"] = alone.duration;
  state.counters["rejected_cycles"] = rejected.cycles;
  if (rejected.cycles == 0) return;
  state.counters["deviation"] = rejected.deviation / rejected.cycles;
  state.counters["excess"] = rejected.excess / rejected.cycles;
}

}  // namespace

void register_samples(const Effort& effort) {
  const std::uint64_t drives = effort.cycles >= 1000 ? 3 : 1;
  for (const Sampling sampling :
       {Sampling{10, 10}, Sampling{20, 20}, Sampling{20, 40}, Sampling{40, 60}, Sampling{80, 120}}) {
    const std::string name =
        "samples/" + std::to_string(sampling.vx_samples) + "x" + std::to_string(sampling.vth_samples);
    benchmark::RegisterBenchmark(name.c_str(), [sampling, drives](benchmark::State& state) {
      run_samples(state, sampling, drives);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace hidwa_local_planner::test
