// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "study/groups.hpp"

namespace hidwa_local_planner {
namespace study {

/// Those of the study with simulated people: by setting, then by condition.
Tables people_tables();

/// Those of an experiment: run, pilot, sweep, barn, dynabarn, crowd, passage, gap or attack.
Tables tables_of(const std::string& experiment);

}  // namespace study
}  // namespace hidwa_local_planner
