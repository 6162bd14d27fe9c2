// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/admissibility.hpp"

namespace hidwa_local_planner {

void AdmissibilityCheck::prepare(const Parameters& parameters, const CollisionChecker& checker,
                                 const Footprint& footprint, double resolution, const Setup& setup) {
  setup_ = setup;
  checks_braking_ = parameters.admissibility == Admissibility::braking;
  const double radius = footprint.circumscribed_radius();
  clearances_.prepare(checker, radius, resolution);
  rollouts_.prepare(setup_, clearances_, radius, resolution);
  braking_.prepare(parameters, setup_, clearances_, radius, resolution);
}

}  // namespace hidwa_local_planner
