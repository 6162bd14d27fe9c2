// SPDX-License-Identifier: BSD-3-Clause
// A bag as rosbag writes it, with connections and messages that nobody recorded, perhaps cut short: hidwa_replay's
// reading of it ends with cycles, or with a sentence. Other bytes of the file are not changed: rosbag reads beyond its
// buffers there.
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <rosbag/bag.h>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "record/cycle_replay.hpp"
#include "replay/cycle_bag.hpp"
#include "replay/options.hpp"
#include "support/shape.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

constexpr int kMostMessages = 8;
constexpr int kMostBytes = 8192;  // of a record or a message

const char* const kTopics[] = {"/planner/cycle", "/other/cycle", "cycle", ""};

Cycle cycle_of(Input& input) {
  Cycle message;
  message.header.stamp = ros::Time(input.within(0.0, 60.0));
  const std::string record = input.text(static_cast<std::size_t>(input.integer(0, kMostBytes)));
  message.record.assign(record.begin(), record.end());
  return message;
}

// Of the type of cycles, of another release's or of something else; whether its bytes are one or not.
topic_tools::ShapeShifter raw_of(Input& input) {
  const int kind = input.integer(0, 2);
  std::string bytes = input.text(static_cast<std::size_t>(input.integer(1, kMostBytes)));
  if (bytes.empty()) bytes.push_back('\0');
  return test::shape_of({bytes.begin(), bytes.end()},
                        kind == 2 ? "std_msgs/String" : ros::message_traits::DataType<Cycle>::value(),
                        kind == 1 ? std::string(32, '0') : ros::message_traits::MD5Sum<Cycle>::value(),
                        ros::message_traits::Definition<Cycle>::value());
}

void write_bag(Input& input, const std::string& path) {
  const int cut = input.integer(0, 3) == 0 ? input.integer(0, 65535) : 0;  // [byte], at the end
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    bag.setCompression(static_cast<rosbag::compression::CompressionType>(input.integer(0, 2)));
    bag.setChunkThreshold(static_cast<std::uint32_t>(input.integer(0, 255)) * 64U);
    for (int k = 0; k < kMostMessages && input.left() > 0; ++k) {
      const std::string topic = kTopics[input.integer(0, 3)];
      const ros::Time time(input.within(0.001, 60.0));
      if (input.flag()) {
        bag.write(topic, time, raw_of(input));
      } else {
        bag.write(topic, time, cycle_of(input));
      }
    }
  }
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (cut > 0)
    std::filesystem::resize_file(path, size - std::min<std::uintmax_t>(static_cast<std::uintmax_t>(cut), size));
}

void replay_bag(const std::string& path) {
  replay::CycleBag bag(path, "");
  record::CycleReplay cycles(critics::built_in());
  bag.for_each([&](const Cycle& message) {
    const Bytes bytes(message.record.begin(), message.record.end());
    const record::CycleReplay::Reading reading = cycles.take(bytes);
    require((reading == record::CycleReplay::Reading::damaged) == !cycles.fault().empty(),
            "a damaged record without words");
    return true;
  });
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner;
  setenv("PATH", "/nowhere", 1);  // `rosbag reindex`, which repairs a copy, is a program of Python
  static const std::string path = std::string(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") + "/hidwa_fuzz_" +
                                  std::to_string(getpid()) + ".bag";
  fuzz::Input input(data, size);
  try {
    fuzz::write_bag(input, path);
    fuzz::replay_bag(path);
  } catch (const std::exception& refusal) {  // main() says it
    fuzz::require(refusal.what()[0] != '\0', "a refusal without words");
  }
  std::filesystem::remove(path);
  return 0;
}
