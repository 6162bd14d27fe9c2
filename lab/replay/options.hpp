// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "moment.hpp"
#include "record/cycle_replay.hpp"

namespace hidwa_local_planner {
namespace replay {

/// What is wrong with the input, for the user; the program ends with status 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line.
struct Options {
  std::string bag;
  std::string topic;  // empty: the only one there is
  std::vector<record::ParameterChange> changes;
  std::optional<Moment> at;
  std::string out;  // folder; empty: the bag's name and _replay, where the program runs
  bool picture = true;
  bool help = false;
};

/// Throws UsageError.
Options parse(const std::vector<std::string>& arguments);
const char* help();

}  // namespace replay
}  // namespace hidwa_local_planner
