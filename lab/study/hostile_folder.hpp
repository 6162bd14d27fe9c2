// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "attack/hostile.hpp"
#include "attack/result.hpp"

namespace hidwa_local_planner {
namespace study {

/// The folder of a hostile study. hostile.json says what decides about it; drives.csv has a line a drive, as they end;
/// summary.json is made of them.
class HostileFolder {
 public:
  /// Begins or goes on. Throws UsageError where the folder holds another study, or cannot be made.
  HostileFolder(std::string folder, const std::string& manifest);

  /// One that is there. Throws UsageError.
  explicit HostileFolder(std::string folder);

  const std::string& manifest() const { return manifest_; }
  const std::map<std::uint64_t, std::string>& lines() const { return lines_; }  // by the drive's index
  /// Adds a drive; one at a time.
  void keep(std::uint64_t index, const std::string& line);
  /// Writes drives.csv in the order of the drives, and summary.json. Returns the summary.
  nlohmann::json finish();

 private:
  void read_lines();

  std::filesystem::path folder_;
  std::string manifest_;
  std::map<std::uint64_t, std::string> lines_;
};

/// A drive's line: as the head has it, without an end of line.
std::string hostile_head();
std::string hostile_line(std::uint64_t index, const hidwa_attack::HostileDrive& drive,
                         const hidwa_attack::DriveResult& result);

}  // namespace study
}  // namespace hidwa_local_planner
