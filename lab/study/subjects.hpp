// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "study/options.hpp"
#include "study/plan.hpp"
#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

inline const Parameters& parameters_of(const Subject& subject) { return subject.parameters; }

/// Of what has a Subject within it.
template <typename Driver>
const Parameters& parameters_of(const Driver& driver) {
  return driver.subject.parameters;
}

/// Who drives in each setting of a plan: `base`, then what the options set, then what the setting sets.
/// `assign(driver, assignment)` throws UsageError, and so does what makes no sense together.
template <typename Driver, typename Assign>
std::vector<Driver> drivers_of(const Options& options, const Plan& plan, const Driver& base, Assign assign) {
  std::vector<Driver> drivers;
  for (const Setting& setting : plan.settings) {
    drivers.push_back(base);
    for (const Assignment& set : options.sets) assign(drivers.back(), set);
    for (const Assignment& set : setting) assign(drivers.back(), set);
    check(setting, parameters_of(drivers.back()));
  }
  return drivers;
}

}  // namespace study
}  // namespace hidwa_local_planner
