// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/setup.hpp"
#include "study/barn_drive.hpp"

namespace hidwa_local_planner {
namespace study {

/// A simulated Jackal with the subject's parameters and costmap: all of a drive's setup but where it drives, with whom
/// and under which rules.
drive::DriveSetup jackal(const BarnSubject& subject);

}  // namespace study
}  // namespace hidwa_local_planner
