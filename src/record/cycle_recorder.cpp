// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_recorder.hpp"

#include <cstring>

#include "hidwa_local_planner/core/parameter_text.hpp"

namespace hidwa_local_planner {
namespace record {
namespace {

// To the bit: 0 and -0 are two.
bool same(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  static_assert(sizeof(Pose2) == 3 * sizeof(double), "no bytes between its members");
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Pose2)) == 0);
}

}  // namespace

void CycleRecorder::begin(const control::ControlLoop& loop, const control::Observation& observation,
                          const Sampling& sampling) {
  const bool key = cycles_since_key_ >= kKeyEvery;
  cycles_since_key_ = key ? 1 : cycles_since_key_ + 1;
  ++record_.sequence;
  record_.setup.reset();
  if (key) take_setup(loop);
  take_plan(loop.plan(), key);
  record_.observation = observation;
  record_.observation.costmap = {};
  record_.costmap.reset();
  if (observation.fault.empty()) record_.costmap = packed(observation.costmap);
  record_.sampling = sampling;
  record_.loop_state.clear();
  loop.save(record_.loop_state);
}

void CycleRecorder::take_setup(const control::ControlLoop& loop) {
  Setup& setup = record_.setup.emplace();
  setup.version = HIDWA_VERSION;
  setup.parameters = to_lines(loop.parameters());
  setup.critics = critics_;
  setup.outline = loop.planner().outline();
}

void CycleRecorder::take_plan(const std::vector<Pose2>& plan, bool key) {
  record_.plan.reset();
  if (!key && same(plan, plan_)) return;
  record_.plan = plan_ = plan;
}

const Bytes& CycleRecorder::finish(const control::Result& result, const Planner& planner) {
  record_.intent = result.intent;
  record_.decision = decision_record(result, planner);
  encode(record_, bytes_);
  return bytes_;
}

}  // namespace record
}  // namespace hidwa_local_planner
