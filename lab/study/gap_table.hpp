// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/gap_drive.hpp"
#include "study/groups.hpp"

namespace hidwa_local_planner {
namespace study {

/// runs.csv of narrowest gaps, a line an outline, setting and phase; summary.json by outline and setting; ranking.csv
/// by the mean width.
Tables gap_tables();

/// The line of one run.
Row gap_row(const Plan& plan, const Run& run, double phase, const GapSubject& subject, const Narrowest& narrowest);

}  // namespace study
}  // namespace hidwa_local_planner
