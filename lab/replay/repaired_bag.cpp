// SPDX-License-Identifier: BSD-3-Clause
#include "repaired_bag.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <rosbag/exceptions.h>

#include "options.hpp"
#include "run_program.hpp"

namespace hidwa_local_planner {
namespace replay {

namespace fs = std::filesystem;

namespace {

bool begins_as_a_bag(const std::string& path) {
  std::string begin(7, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == "#ROSBAG";
}

}  // namespace

RepairedBag::RepairedBag(const std::string& path) {
  std::error_code none;
  if (!fs::exists(path, none)) throw UsageError(path + ": there is no such file");
  if (!fs::is_regular_file(path, none)) throw UsageError(path + " is no file");
  if (!begins_as_a_bag(path)) throw UsageError(path + " is no bag: it does not begin with #ROSBAG");
  try {
    bag_.open(path, rosbag::bagmode::Read);
    return;
  } catch (const rosbag::BagUnindexedException&) {
    fault_ = path + " was cut short: it has no index";
  } catch (const rosbag::BagIOException& error) {
    fault_ = path + " was cut short (" + error.what() + ")";
  } catch (const rosbag::BagException& error) {
    fault_ = path + " is damaged (" + error.what() + ")";
  }
  bag_.close();
  open_copy(path);
}

// The rosbag library's own repair exists in Python only, as `rosbag reindex`.
void RepairedBag::open_copy(const std::string& path) {
  std::string pattern = (fs::temp_directory_path() / "hidwa_replay_XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw UsageError(fault_ + "; no temporary folder can be made for a copy");
  folder_ = pattern;
  const std::string copy = (fs::path(folder_) / "copy.bag").string();
  try {
    fs::copy_file(path, copy);
    const int status = run_program({"rosbag", "reindex", "-q", "-f", copy}, Output::silent);
    if (status == kNotFound) throw UsageError(fault_ + "; to read its intact part install python3-rosbag");
    bag_.open(copy, rosbag::bagmode::Read);
  } catch (const fs::filesystem_error& error) {
    throw UsageError(fault_ + "; no copy can be made: " + error.what());
  } catch (const rosbag::BagException&) {
    throw UsageError(fault_ + "; no part of it can be read");
  }
}

RepairedBag::~RepairedBag() {
  bag_.close();
  std::error_code none;
  if (!folder_.empty()) fs::remove_all(folder_, none);
}

}  // namespace replay
}  // namespace hidwa_local_planner
