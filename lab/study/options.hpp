// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drive/setup.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "sim/key_frames.hpp"
#include "sim/polygon.hpp"
#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// What the command line says.
struct Options {
  // run, pilot, sweep, barn, dynabarn, crowd, passage, gap, attack, merge or help
  std::string command;
  std::string out;
  std::string map;                       // empty: the package's office; attack: further ones, with commas between them
  std::string regions;                   // likewise; none: no regions
  std::optional<sim::Pose> start, goal;  // map frame; none: the regions file's
  int participants = 32;
  std::vector<std::string> conditions{"SJ", "SG", "SW"};  // attack: others, attack_conditions()
  std::uint64_t seed = 1;
  std::size_t threads = 0;  // 0: as many as the computer has cores
  std::string profile = "default";
  Guard guard = Guard::none;  // SW
  std::vector<Assignment> sets;
  std::vector<std::string> grid;  // sweep: name=value,value,...; all combinations
  std::vector<std::string> vary;  // sweep: likewise; one at a time
  std::size_t shard = 1, shards = 1;
  bool resume = true;
  bool paths = true;
  std::vector<std::string> parts;                     // merge
  std::string worlds;                                 // barn, dynabarn, attack: the file
  std::vector<std::string> modes;                     // barn, dynabarn, crowd
  int seeds = 10;                                     // dynabarn: of each world; crowd, passage: in all
  drive::Tracking tracking = drive::Tracking::truth;  // dynabarn, crowd
  sim::KeyMotion motion = sim::KeyMotion::linear;     // dynabarn
  double speed = 2.0;                                 // dynabarn: max_vel_x [m/s]
  bool list = false;                                  // attack: only say what conditions there are
  int drives = 300;                                   // attack: of each condition
  int seconds = 20;                                   // attack: of a drive [s]
  std::optional<std::uint64_t> drive;                 // attack: this one alone
  int people = 20;                                    // crowd
  std::vector<std::string> outlines;                  // gap
  int phases = 8;                                     // gap
  double yielding = 0.5;                              // crowd: share of people who keep away from the robot
};

/// Reads the arguments after the program's name. Throws UsageError.
Options parse_options(const std::vector<std::string>& arguments);

/// What --grid or --vary asks for; one empty setting where neither does. Throws UsageError.
std::vector<Setting> settings_of(const Options& options);

/// What there is to be said by --help.
std::string help();

}  // namespace study
}  // namespace hidwa_local_planner
