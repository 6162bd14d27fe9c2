// SPDX-License-Identifier: BSD-3-Clause
// A bag file: hidwa_replay's reading of it ends with cycles, or with a sentence.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/record/cycle_replay.hpp"
#include "replay/cycle_bag.hpp"
#include "replay/options.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

std::string write(const std::string& content) {
  static const std::string path = std::string(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") + "/hidwa_fuzz_" +
                                  std::to_string(getpid()) + ".bag";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file != nullptr, "no file can be written");
  std::fwrite(content.data(), 1, content.size(), file);
  std::fclose(file);
  return path;
}

void replay_bag(const std::string& path) {
  replay::CycleBag bag(path, "");
  record::CycleReplay cycles(critics::built_in());
  int left = 20;
  bag.for_each([&](const Cycle& message) {
    const Bytes bytes(message.record.begin(), message.record.end());
    const record::CycleReplay::Reading reading = cycles.take(bytes);
    require((reading == record::CycleReplay::Reading::damaged) == !cycles.fault().empty(),
            "a damaged record without words");
    return --left > 0;
  });
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner;
  setenv("PATH", "/nowhere", 1);  // `rosbag reindex`, which repairs a copy, is a program of Python
  const std::string path = fuzz::write(fuzz::Input(data, size).rest());
  try {
    fuzz::replay_bag(path);
  } catch (const std::exception& refusal) {  // main() says it
    fuzz::require(refusal.what()[0] != '\0', "a refusal without words");
  }
  return 0;
}
