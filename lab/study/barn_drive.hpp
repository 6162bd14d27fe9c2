// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "sim/barn_world.hpp"
#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// The modes of BARN-2D: AUTONOMY, SHARED with a HELPFUL or a HOSTILE person, and AFTERMATH: a HOSTILE person for 20 s,
/// then nobody.
const std::vector<std::string>& barn_modes();
/// Those that are driven where none are named: all but AFTERMATH.
std::vector<std::string> usual_barn_modes();

/// All that a setting of BARN-2D may change.
struct BarnSubject {
  Subject subject;  // parameters and link; its participant does not count
  drive::CostmapSettings costmap;
  double padding = 0.0;           // [m], footprint_padding of the local costmap
  double plan_resolution = 0.05;  // [m], of the grid on which the way is planned
  double plan_radius = 0.0;       // [m], see drive::DriveSetup
};

/// As the package's files say: launch/params/jackal.yaml and barn.yaml. Throws UsageError.
BarnSubject barn_subject(const std::string& jackal_file, const std::string& barn_file);

/// Makes one assignment: a parameter of the planner, link_delay, costmap.NAME or plan.NAME. Throws UsageError
/// naming what is wrong.
void assign_barn(BarnSubject& subject, const Assignment& assignment);

/// A drive through a world; it ends 1 m from the goal, at the first contact, or after 100 s. All that is
/// random depends on the seeds alone.
drive::DriveResult drive_barn(const sim::BarnWorld& world, const BarnSubject& subject, const std::string& mode,
                              std::uint64_t world_seed, std::uint64_t person_seed);

/// What a drive came to by BARN's metric, and how hard its world is.
struct BarnScore {
  bool success = false;
  double optimal_time = 0.0;    // [s], reference path at 2 m/s
  double metric = 0.0;          // success x OT / clip(AT, 2 OT, 8 OT)
  double path_clearance = 0.0;  // [m], mean free space between the reference path and the cylinders
};
BarnScore score_barn(const sim::BarnWorld& world, const drive::DriveResult& result);

}  // namespace study
}  // namespace hidwa_local_planner
