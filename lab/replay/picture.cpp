// SPDX-License-Identifier: BSD-3-Clause
#include "picture.hpp"

#include <filesystem>
#include <system_error>

#include "run_program.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

namespace fs = std::filesystem;

// Beside this program where both are installed, else where it was built from.
std::string find_script() {
  std::error_code none;
  const fs::path beside = fs::read_symlink("/proc/self/exe", none).parent_path() / "replay_picture";
  if (fs::exists(beside, none)) return beside.string();
  return (fs::path(HIDWA_SCRIPTS) / "replay_picture").string();
}

}  // namespace

std::string draw(const std::string& kind, const std::string& data, const std::string& png) {
  const int status = run_program({find_script(), kind, data, png}, Output::shown);
  if (status == 0) return "";
  return "no picture: replay_picture " + (status == kNotFound ? std::string("is not there") : "failed") +
         " (it needs python3-matplotlib; the figures are in " + data + ")";
}

}  // namespace replay
}  // namespace hidwa_local_planner
