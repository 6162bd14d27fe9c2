// SPDX-License-Identifier: BSD-3-Clause
// Records of cycles: lengths and bytes of up to eight that follow one another. A record is refused in words, or it is
// repeated: with a finite command, and without asking for more memory or time than a cycle may take.
#include <cstdint>
#include <string>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "record/cycle_replay.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

constexpr int kMostRecords = 8;

// What many samples cost is no finding; a map of 4000 x 4000 cells is.
bool expensive(const record::CycleReplay& replay) {
  const Parameters& p = replay.parameters();
  const Sampling& s = replay.record().sampling;
  const long vx = s.vx_samples > 0 ? s.vx_samples : p.vx_samples,
             vth = s.vth_samples > 0 ? s.vth_samples : p.vth_samples;
  return vx * vth > 5000 || std::max(s.search_poses, p.search_poses) > 20000 || replay.grid().costs.size() > 100000;
}

void take(record::CycleReplay& replay, const Bytes& bytes) {
  const record::CycleReplay::Reading reading = replay.take(bytes);
  require((reading == record::CycleReplay::Reading::damaged) == !replay.fault().empty(),
          "a damaged record without words");
  if (reading != record::CycleReplay::Reading::ready || expensive(replay)) return;
  const record::ReplayedCycle cycle = replay.run();
  require(is_finite(cycle.decision.command), "the command is not a number");
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner;
  fuzz::Input input(data, size);
  record::CycleReplay replay(critics::built_in());
  for (int k = 0; k < fuzz::kMostRecords && input.left() > 0; ++k) {
    const std::size_t length = input.byte() | static_cast<std::size_t>(input.byte()) << 8U;
    const std::string text = input.text(length);
    fuzz::take(replay, Bytes(text.begin(), text.end()));
  }
  return 0;
}
