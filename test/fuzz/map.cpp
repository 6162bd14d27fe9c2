// SPDX-License-Identifier: BSD-3-Clause
// Maps and regions: a YAML file, a zero byte, a PGM image. Each is read whole, or refused by a std::runtime_error.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/pgm.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

// In memory; it goes with the process.
class Folder {
 public:
  Folder() : path_(std::string(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") + "/hidwa_fuzz_XXXXXX") {
    require(mkdtemp(path_.data()) != nullptr, "no folder can be made");
  }
  ~Folder() {
    for (const char* name : {"/map.yaml", "/map.pgm"}) unlink((path_ + name).c_str());
    rmdir(path_.c_str());
  }
  std::string write(const char* name, const std::string& content) const {
    const std::string path = path_ + "/" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

 private:
  std::string path_;
};

// yaml-cpp goes down by calling itself, and takes a time that grows with the square of the depth: as deep as this is
// left to it.
constexpr int kDeepest = 50;
bool too_deep(const std::string& yaml) {
  int depth = 0;
  for (const char c : yaml) {
    if (c == '[' || c == '{' || c == '-' || c == '?' || c == ':' || c == '&' || c == '!') ++depth;
  }
  return depth > 20 * kDeepest;
}

template <typename Read>
void attempt(const Read& read) {
  try {
    read();
  } catch (const std::runtime_error& refusal) {
    require(refusal.what()[0] != '\0', "a refusal without words");
  }  // whatever else is thrown ends the program
}

void require_whole(const sim::OccupancyMap& map) {
  require(map.width > 0 && map.height > 0 && map.resolution > 0.0, "a map without cells");
  require(map.cells.size() == static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
          "cells are missing");
  require(std::isfinite(map.resolution) && std::isfinite(map.origin_x) && std::isfinite(map.origin_y),
          "the map lies nowhere");
}

void require_whole(const sim::RegionsFile& file) {
  for (const sim::Region& region : file.regions) {
    require(region.polygon.size() >= 3, "a region without area");
    for (const auto& corner : region.polygon) require(corner.allFinite(), "a corner is not a number");
  }
  for (const auto& pose : {file.start, file.goal}) {
    if (pose)
      require(std::isfinite(pose->x) && std::isfinite(pose->y) && std::isfinite(pose->theta), "a pose is not a number");
  }
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner;
  static const fuzz::Folder folder;
  const std::string all = fuzz::Input(data, size).rest();
  const std::size_t end = std::min(all.find('\0'), all.size());
  const std::string text = all.substr(0, end);
  if (fuzz::too_deep(text)) return 0;
  const std::string yaml = folder.write("map.yaml", text);
  const std::string image = folder.write("map.pgm", all.substr(std::min(end + 1, all.size())));
  fuzz::attempt([&] { fuzz::require_whole(sim::load_map(yaml)); });
  fuzz::attempt([&] { fuzz::require_whole(sim::load_regions(yaml)); });
  fuzz::attempt([&] { sim::read_pgm(image); });
  return 0;
}
