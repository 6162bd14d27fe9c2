// SPDX-License-Identifier: BSD-3-Clause
#include "ros/guarded_critic.hpp"

#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include <ros/console.h>

namespace hidwa_local_planner {
namespace {

constexpr double kSlow = 0.1;  // [s] in one cycle; most hosts call ten times a second or more
constexpr const char* kThrew = "it failed with an exception";

/// What the call threw, in words; nothing where all is well, and then nothing is allocated.
template <typename Call>
std::optional<std::string> failure_of(Call call) {
  try {
    call();
    return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "something that is no std::exception";
  }
}

}  // namespace

GuardedCritic::GuardedCritic(std::string name, std::shared_ptr<Critic> critic)
    : name_(std::move(name)), critic_(std::move(critic)) {}

// Once a second; not by ROS time, which hidwa_replay does not have.
bool GuardedCritic::due() const {
  const auto now = std::chrono::steady_clock::now();
  if (now < silent_until_) return false;
  silent_until_ = now + std::chrono::seconds(1);
  return true;
}

template <typename Call>
bool GuardedCritic::succeeds(const char* what, Call call) const {
  const std::optional<std::string> reason = failure_of(call);
  if (!reason) return true;
  if (!due()) return false;
  ROS_ERROR(
      "the critic %s threw in %s(): %s; a critic must not throw there. Mend it, or take it out of the "
      "parameter critics",
      name_.c_str(), what, reason->c_str());
  return false;
}

template <typename Call>
bool GuardedCritic::succeeds_in_time(const char* what, Call call) {
  const auto begin = std::chrono::steady_clock::now();
  const bool well = succeeds(what, call);
  spent_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (spent_ > kSlow && due()) {
    ROS_WARN(
        "the critic %s took %.2f s in one cycle: meanwhile the robot gets no command. Make it faster, or "
        "take it out of the parameter critics",
        name_.c_str(), spent_);
  }
  return well;
}

// Who configures the planner knows no names.
double GuardedCritic::configure(const Parameters& parameters, const ParameterSource& own) {
  double scale = 0.0;
  const std::optional<std::string> reason = failure_of([&] { scale = critic_->configure(parameters, own); });
  if (!reason) return scale;
  throw std::runtime_error(name_ + ": " + *reason + "; mend them, or take it out of the parameter critics");
}

void GuardedCritic::prepare(const CycleView& cycle) {
  spent_ = 0.0;
  prepared_ = succeeds_in_time("prepare", [&] { critic_->prepare(cycle); });
}

// What it has scored or rejected before it threw stands; the rest is rejected too.
void GuardedCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (prepared_ && succeeds_in_time("score", [&] { critic_->score(cycle, tile, scores); })) {
    complain_of_numbers(scores);
    return;
  }
  for (std::size_t c = 0; c < scores.count(); ++c) {
    if (!scores.rejected(c)) scores.reject(c, kThrew);
  }
}

// The planner rejects candidates with such scores in the critic's name.
void GuardedCritic::complain_of_numbers(TileScores& scores) const {
  if (!scores.any_set()) return;
  const double* raw = scores.set_all();
  std::size_t c = 0;
  while (c < scores.count() && (std::isfinite(raw[c]) || scores.rejected(c))) ++c;
  if (c == scores.count() || !due()) return;
  ROS_ERROR(
      "the critic %s gives scores that are no finite numbers: their candidates are rejected. Mend it (to "
      "reject, it calls reject()), or take it out of the parameter critics",
      name_.c_str());
}

void GuardedCritic::debrief(const CycleView& cycle, const Twist2& command) {
  succeeds("debrief", [&] { critic_->debrief(cycle, command); });
}

void GuardedCritic::reset() {
  succeeds("reset", [&] { critic_->reset(); });
}

void GuardedCritic::save(ArchiveWriter& state) const {
  succeeds("save", [&] { critic_->save(state); });
}

void GuardedCritic::load(ArchiveReader& state) {
  succeeds("load", [&] { critic_->load(state); });
}

}  // namespace hidwa_local_planner
