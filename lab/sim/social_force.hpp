// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace hidwa_local_planner {
namespace sim {

/// The social forces of Helbing and Molnar (1995, "Social force model for pedestrian dynamics", Phys. Rev. E 51,
/// 4282), with their constants. All are accelerations [m/s^2].

/// Towards the velocity that somebody wants (eq. 2): they would reach it within 0.5 s.
Eigen::Vector2d drive_force(const Eigen::Vector2d& velocity, const Eigen::Vector2d& wanted);

/// Away from another one at `away` [m] from there to here, who walks with `other` [m/s] (eqs. 3 and 4): the
/// equipotentials are ellipses along the other's next 2 s.
Eigen::Vector2d repulsion(const Eigen::Vector2d& away, const Eigen::Vector2d& other);

/// Away from a wall at `distance` [m] in direction -`away` (unit vector; eq. 5).
Eigen::Vector2d wall_force(double distance, const Eigen::Vector2d& away);

/// What a force counts that comes from behind: what lies within 100 degrees of where one wants to go counts wholly,
/// the rest half (eqs. 7 and 8).
double sight(const Eigen::Vector2d& ahead, const Eigen::Vector2d& force);

}  // namespace sim
}  // namespace hidwa_local_planner
