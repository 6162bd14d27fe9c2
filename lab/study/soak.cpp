// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "attack/drive.hpp"
#include "attack/hostile.hpp"
#include "core/util/words.hpp"
#include "study/progress.hpp"
#include "study/store.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

using hidwa_attack::CycleSeen;
using hidwa_attack::DriveResult;
using hidwa_attack::Spec;

constexpr int kMinute = 60000;           // [ms]
constexpr double kGrowth = 1.0;          // of memory after the first tenth, at most [MB]
constexpr double kSlower = 1.5;          // the last tenth's p99 over the first tenth's, at most
constexpr std::size_t kFewMinutes = 10;  // fewer say nothing of the cycle time

/// Memory in use [MB].
double memory() {
  std::ifstream file("/proc/self/statm");
  long pages = 0, resident = 0;
  file >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// One simulated minute.
struct Minute {
  double memory = 0.0;          // near its end [MB]
  double p50 = 0.0, p99 = 0.0;  // of the computing time of a cycle [ms]
  std::size_t cycles = 0;
};

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Looks on, minute by minute; no memory grows with the hours but a line a minute, which is reserved.
class Watch {
 public:
  Watch(double hours, std::ostream& told) : progress_(told, minutes_of(hours), "minutes") {
    minutes_.reserve(minutes_of(hours) + 2);
    times_.reserve(2000);
  }
  void see(const CycleSeen& cycle) {
    if (cycle.now / kMinute != minute_) end_minute(cycle.now / kMinute);
    if (times_.size() % kMemoryEvery == 0) memory_ = memory();
    times_.push_back(1e3 * cycle.spent);
    states_.insert(to_string(cycle.state));
    outcomes_.insert(to_string(cycle.outcome));
  }
  void finish() { end_minute(-1); }
  const std::vector<Minute>& minutes() const { return minutes_; }
  const std::set<std::string>& states() const { return states_; }
  const std::set<std::string>& outcomes() const { return outcomes_; }

 private:
  static constexpr std::size_t kMemoryEvery = 100;  // cycles
  static std::size_t minutes_of(double hours) { return static_cast<std::size_t>(std::ceil(60.0 * hours)); }
  void end_minute(int next) {
    if (!times_.empty()) {
      minutes_.push_back({memory_, quantile(times_, 0.5), quantile(times_, 0.99), times_.size()});
      progress_.step();
    }
    times_.clear();
    minute_ = next;
  }

  Progress progress_;
  int minute_ = 0;
  double memory_ = 0.0;        // [MB]
  std::vector<double> times_;  // of this minute [ms]
  std::vector<Minute> minutes_;
  std::set<std::string> states_, outcomes_;
};

// A robot of a usual kind; who sits at the stick changes mode and weights, and odometry falls silent now and then.
Spec spec_of(double hours) {
  Spec spec;
  spec.parameters.vx_samples = 10;
  spec.parameters.vth_samples = 15;
  spec.parameters.cycle_budget = -1.0;
  spec.place = hidwa_attack::Place::clutter;
  spec.link = hidwa_attack::Link::silent;
  spec.limits_change = true;
  spec.odometry = hidwa_attack::Odometry::silent;
  spec.late_share = 0.1;
  spec.late_most = 2.0;
  spec.walkers = 4;
  spec.seconds = static_cast<int>(std::lround(3600.0 * hours));
  return spec;
}

double most_memory(const std::vector<Minute>& minutes, std::size_t first, std::size_t last) {
  double most = 0.0;
  for (std::size_t k = first; k < last; ++k) most = std::max(most, minutes[k].memory);
  return most;
}

double median_p99(const std::vector<Minute>& minutes, std::size_t first, std::size_t last) {
  std::vector<double> values;
  for (std::size_t k = first; k < last; ++k) values.push_back(minutes[k].p99);
  return quantile(values, 0.5);
}

std::string csv(const std::vector<Minute>& minutes) {
  std::string text = "minute,memory_mb,p50_ms,p99_ms,cycles\n";
  for (std::size_t k = 0; k < minutes.size(); ++k) {
    const Minute& m = minutes[k];
    text += format("%zu,%.3f,%.4f,%.4f,%zu\n", k + 1, m.memory, m.p50, m.p99, m.cycles);
  }
  return text;
}

}  // namespace

int soak(const Options& options, std::ostream& out, std::ostream& errors) {
  std::filesystem::create_directories(options.out);
  const Spec spec = spec_of(options.hours);
  Watch watch(options.hours, errors);
  const DriveResult result =
      hidwa_attack::drive(spec, options.seed, nullptr, [&watch](const CycleSeen& cycle) { watch.see(cycle); });
  watch.finish();
  const std::vector<Minute>& minutes = watch.minutes();
  const std::size_t tenth = std::max<std::size_t>(1, minutes.size() / 10);
  // Memory that was reserved counts once it is used for the first time, as the search's in the first tight place.
  const double begin = most_memory(minutes, 0, tenth), most = most_memory(minutes, tenth, minutes.size());
  const double first = median_p99(minutes, 0, tenth),
               last = median_p99(minutes, minutes.size() - tenth, minutes.size());
  const bool slower = minutes.size() >= kFewMinutes && last > kSlower * first;
  const bool ended = result.seconds + 0.5 < static_cast<double>(spec.seconds);
  const bool held = !result.touched && result.encounters.moving == 0 && result.beyond == 0 && most - begin <= kGrowth &&
                    !slower && !ended;
  const nlohmann::json summary = {{"held", held},
                                  {"seed", options.seed},
                                  {"hours", result.seconds / 3600.0},
                                  {"cycles", result.cycles},
                                  {"memory_first_tenth_mb", begin},
                                  {"memory_after_mb", most},
                                  {"p99_first_tenth_ms", first},
                                  {"p99_last_tenth_ms", last},
                                  {"states", watch.states()},
                                  {"outcomes", watch.outcomes()},
                                  {"contacts", result.touched ? 1 : 0},
                                  {"commands_beyond_limits", result.beyond},
                                  {"encounters", result.encounters.met},
                                  {"touched_moving", result.encounters.moving}};
  const Store store(options.out);
  store.write("minutes.csv", csv(minutes));
  store.write("summary.json", summary.dump(2) + '\n');
  out << summary.dump(2) << '\n' << options.out << "/minutes.csv\n" << std::flush;
  return held ? 0 : 1;
}

}  // namespace study
}  // namespace hidwa_local_planner
