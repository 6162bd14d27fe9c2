// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/drive.hpp"

namespace hidwa_local_planner::test {

/// The drive through the package's office, with the default parameters, a noisy laser and nobody on board.
drive::DriveSetup office_drive();

}  // namespace hidwa_local_planner::test
