// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "study/participant.hpp"

namespace hidwa_local_planner {
namespace study {

/// All that a setting may change.
struct Subject {
  Parameters parameters;
  Participant participant;
  double link_delay = 0.0;  // [s], from the person's hand to the planner
};

/// NAME=VALUE: a parameter of the planner, participant.TRAIT or link_delay, as the user writes it.
struct Assignment {
  std::string name;
  std::string value;
};

/// What one setting of an experiment changes.
using Setting = std::vector<Assignment>;

/// `s_v=200;delta=1`, or `default` where nothing is changed.
std::string to_string(const Setting& setting);

/// Reads NAME=VALUE. Throws UsageError.
Assignment parse_assignment(const std::string& text);

/// The number that a text is; throws UsageError, which calls it `name`, where it is none from `least` to `greatest`.
double number_within(const std::string& name, const std::string& text, double least, double greatest);

/// Makes one assignment. Throws UsageError naming what is wrong.
void assign(Subject& subject, const Assignment& assignment);

/// Every combination of `name=v1,v2,...`, the last one changing fastest; one empty setting where there is
/// none. Throws UsageError.
std::vector<Setting> combinations(const std::vector<std::string>& grid);

/// An empty setting, then each value of `name=v1,v2,...` alone: what matters, and how much. Throws UsageError.
std::vector<Setting> variations(const std::vector<std::string>& varied);

/// Throws UsageError naming the setting where the parameters that it comes to make no sense.
void check(const Setting& setting, const Parameters& parameters);

/// Takes the parameters under HIDWAPlannerROS in a YAML file. Throws UsageError.
void assign_file(Parameters& parameters, const std::string& path);

}  // namespace study
}  // namespace hidwa_local_planner
