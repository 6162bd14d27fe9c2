// SPDX-License-Identifier: BSD-3-Clause
#include "control/sample_budget.hpp"

#include <algorithm>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kAim = 0.7;      // of the budget, where thinning leads
constexpr double kMost = 0.8;     // of the budget, what samples that come back may lead to
constexpr double kGrowth = 1.25;  // of the candidates, at most, in one step back (but never less than a level)
constexpr int kPatience = 40;     // calm cycles
constexpr int kLongestPatience = 640;

// Fewer samples than these are never left. Odd counts stay odd and even ones even: a window that is symmetric
// about 0 keeps its samples' places relative to 0.
int least(int full) { return std::min(full, full % 2 == 0 ? 6 : 5); }

int pairs_to_lose(int full) { return (full - least(full)) / 2; }

bool same(const Sampling& a, const Sampling& b) {
  return a.vx_samples == b.vx_samples && a.vth_samples == b.vth_samples && a.search_poses == b.search_poses;
}

// The third longest of five: the median.
double typical_of(std::array<double, 5> durations) {
  std::nth_element(durations.begin(), durations.begin() + 2, durations.end());
  return durations[2];
}

}  // namespace

void SampleBudget::configure(const Sampling& full) {
  if (same(full, full_)) return;
  *this = SampleBudget();
  full_ = full;
  in_force_ = full;
  patience_ = kPatience;
}

SampleBudget::Event SampleBudget::observe(double duration, double budget) {
  if (budget < 0.0) return move_to(0);
  recent_[next_] = duration;
  next_ = (next_ + 1) % recent_.size();
  const double typical = typical_of(recent_);
  return typical > budget ? thin(typical, budget) : restore(duration, budget);
}

int SampleBudget::last_level() const {
  return std::max(pairs_to_lose(full_.vx_samples), pairs_to_lose(full_.vth_samples));
}

Sampling SampleBudget::at(int level) const {
  const int last = last_level();
  if (last == 0) return full_;
  const auto thinned = [level, last](int full) {
    return full - 2 * ((level * pairs_to_lose(full) + last / 2) / last);  // rounded to the nearest pair
  };
  Sampling sampling = full_;
  sampling.vx_samples = thinned(full_.vx_samples);
  sampling.vth_samples = thinned(full_.vth_samples);
  return sampling;
}

double SampleBudget::candidates(int level) const {
  const Sampling sampling = at(level);
  return static_cast<double>(sampling.vx_samples) * sampling.vth_samples;
}

SampleBudget::Event SampleBudget::move_to(int level) {
  if (level == level_) return Event::none;
  const bool was_thinned = thinned();
  level_ = level;
  in_force_ = at(level);
  recent_.fill(0.0);
  calm_ = 0;
  if (was_thinned == thinned()) return Event::none;
  return thinned() ? Event::thinning_began : Event::thinning_ended;
}

// A cycle's time falls at most in proportion to its candidates: where part of it is constant, this is called
// again.
SampleBudget::Event SampleBudget::thin(double typical, double budget) {
  const double affordable = candidates(level_) * kAim * budget / typical;
  int level = level_;
  while (level < last_level() && candidates(level) > affordable) ++level;
  if (came_back_) patience_ = std::min(2 * patience_, kLongestPatience);
  came_back_ = false;
  return move_to(level);
}

SampleBudget::Event SampleBudget::restore(double duration, double budget) {
  int level = std::max(level_ - 1, 0);
  while (level > 0 && candidates(level - 1) <= kGrowth * candidates(level_)) --level;
  const bool affordable = duration * candidates(level) / candidates(level_) <= kMost * budget;
  calm_ = affordable ? std::min(calm_ + 1, kLongestPatience) : std::max(calm_ - patience_ / 2, 0);
  if (!thinned()) {
    if (calm_ < kLongestPatience) return Event::none;
    patience_ = kPatience;
    came_back_ = false;
    return Event::none;
  }
  if (calm_ < patience_) return Event::none;
  came_back_ = true;
  return move_to(level);
}

Sampling configured_samples(const Parameters& parameters) {
  Sampling samples;
  samples.vx_samples = parameters.vx_samples;
  samples.vth_samples = parameters.vth_samples;
  samples.search_poses = parameters.search_poses;
  return samples;
}

double cycle_budget(const Parameters& parameters, double period) {
  return parameters.cycle_budget == 0.0 ? 0.5 * period : parameters.cycle_budget;
}

std::string thinning_complaint(const Sampling& in_force, const Sampling& full, double budget) {
  if (same(in_force, full)) return "";
  const bool fewest = in_force.vx_samples == least(full.vx_samples) && in_force.vth_samples == least(full.vth_samples);
  return format(
      "cycles take longer than the budget of %.1f ms: samples thinned from %d x %d to %d x %d%s; lower "
      "vx_samples or vth_samples, raise cycle_budget, or reduce the load of the machine",
      1e3 * budget, full.vx_samples, full.vth_samples, in_force.vx_samples, in_force.vth_samples,
      fewest ? ", the fewest" : "");
}

}  // namespace hidwa_local_planner
