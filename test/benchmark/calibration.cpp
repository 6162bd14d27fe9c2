// SPDX-License-Identifier: BSD-3-Clause
// What a pose must cost at the very least on this machine, with this compiler and these flags.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"
#include "benchmark/cycle_case.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr int kSide = 120;  // [cells]

class Calibration {
 public:
  explicit Calibration(const Load& load)
      : omegas_(static_cast<std::size_t>(load.vth_samples) + 1),
        x_(static_cast<std::size_t>(load.vx_samples)),
        y_(x_.size()),
        v_(x_.size()),
        at_(x_.size()),
        sums_(x_.size()) {
    for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = static_cast<std::uint8_t>(i * 37 % 253);
    for (std::size_t c = 0; c < v_.size(); ++c) v_[c] = static_cast<double>(c) / static_cast<double>(v_.size());
  }

  std::size_t candidates() const { return omegas_ * v_.size(); }
  std::size_t poses() const { return candidates() * kSteps; }

  const std::vector<std::uint32_t>& run() {
    for (std::size_t w = 0; w < omegas_; ++w) {
      const double turn = 2.0 * static_cast<double>(w) / static_cast<double>(omegas_) - 1.0;
      std::fill(x_.begin(), x_.end(), 0.5 * kSide);
      std::fill(y_.begin(), y_.end(), 0.5 * kSide);
      for (std::size_t k = 0; k < kSteps; ++k) step(1.0 - 0.01 * static_cast<double>(k), turn);
    }
    return sums_;
  }

 private:
  static constexpr std::size_t kSteps = 37;  // about the default profile's mean

  // Two multiply-adds and one gather a candidate.
  void step(double step_x, double step_y) {
    const std::size_t n = v_.size();
    double* x = x_.data();
    double* y = y_.data();
    const double* v = v_.data();
    std::int32_t* at = at_.data();
    for (std::size_t c = 0; c < n; ++c) {
      x[c] += v[c] * step_x;
      y[c] += v[c] * step_y;
      at[c] = static_cast<std::int32_t>(y[c]) * kSide + static_cast<std::int32_t>(x[c]);
    }
    for (std::size_t c = 0; c < n; ++c) sums_[c] += table_[static_cast<std::size_t>(at[c])];
  }

  std::size_t omegas_;
  std::vector<double> x_, y_, v_;
  std::vector<std::int32_t> at_;
  std::vector<std::uint32_t> sums_;
  std::array<std::uint8_t, kSide * kSide> table_{};
};

void run_calibration(benchmark::State& state, const Effort& effort, const Load& load) {
  Calibration calibration(load);
  CycleTimes times;
  times.measure(state, effort, 64, [&](std::size_t /*k*/) {
    benchmark::DoNotOptimize(calibration.run().data());
    benchmark::ClobberMemory();
  });
  times.report(state, calibration.candidates(), calibration.poses());
}

}  // namespace

void register_calibration(const Effort& effort) {
  for (const char* name : {"2000", "100000"}) {
    const Load& chosen = load(name);
    benchmark::RegisterBenchmark((std::string("calibration/pose/") + name).c_str(), [=](benchmark::State& state) {
      run_calibration(state, effort, chosen);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace hidwa_local_planner::test
