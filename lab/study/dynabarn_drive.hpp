// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drive/drive.hpp"
#include "sim/dynabarn_world.hpp"
#include "study/barn_drive.hpp"

namespace hidwa_local_planner {
namespace study {

constexpr int kSeedsOfWorld = 100;  // at most: a run's number is this times its world's index, plus its seed's

/// DynaBARN-2D's court and the robot in it, made once for a setting; drives in several threads may share it.
class DynabarnCourt {
 public:
  DynabarnCourt(const BarnSubject& subject, drive::Tracking tracking, sim::KeyMotion motion);

  /// A drive in one of its worlds, `release` [s] after the cylinders began; it ends 1 m from the goal, at the first
  /// touch, or after 100 s. All that is random depends on the seeds alone.
  drive::DriveResult drive(const sim::DynabarnWorld& world, const std::string& mode, double release,
                           std::uint64_t world_seed, std::uint64_t person_seed) const;

 private:
  drive::DriveSetup setup_;
  sim::KeyMotion motion_;
};

/// The time of a drive's release on the cylinders' clock [s]: uniform over 0 to 20 s.
double release_time(std::uint64_t world_seed);

}  // namespace study
}  // namespace hidwa_local_planner
