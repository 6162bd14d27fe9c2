// SPDX-License-Identifier: BSD-3-Clause
// Parameter sets, as lines of text: each is refused in words, or the robot drives with it inside its limits.
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "fuzz/small_world.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

// What many samples cost is no finding: such sets are checked, but not driven.
constexpr int kMostSamples = 5000;

void require_words(const std::vector<std::string>& faults) {
  for (const std::string& fault : faults) require(!fault.empty(), "a fault without words");
}

// What is read of what was written is the same.
void require_round_trip(const Parameters& parameters) {
  Parameters again;
  const std::string lines = to_lines(parameters);
  require(set_lines(again, lines).empty(), "lines of our own are not read");
  require(to_lines(again) == lines, "what was written is read as something else");
}

void drive(const Parameters& parameters) {
  const SmallWorld world;
  control::ControlLoop loop(critics::built_in());
  const std::vector<std::string> faults = loop.configure(parameters);
  require_words(faults);
  const bool many = parameters.vx_samples * parameters.vth_samples > kMostSamples || parameters.search_poses > 20000;
  if (!faults.empty() || many) return;
  loop.set_footprint(SmallWorld::outline());
  loop.set_plan(SmallWorld::plan(), "map", 0.0, 0.05);
  Twist2 last;
  for (int cycle = 0; cycle < 3; ++cycle) {
    const control::Result result = loop.step(world.observe(10.0 + 0.05 * cycle, 0.05, last), {});
    require_within_limits(result.command, last, parameters);
    const Twist2 from = result.decision != nullptr ? result.decision->reference : last;
    require_within_accelerations(result.command, last, from, parameters, 0.05);
    last = result.command;
  }
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner;
  Parameters parameters;
  parameters.vx_samples = parameters.vth_samples = 5;
  fuzz::require_words(set_lines(parameters, fuzz::Input(data, size).rest()));
  if (validate(parameters).empty()) fuzz::require_round_trip(parameters);
  fuzz::drive(parameters);
  return 0;
}
