// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// A planner that is as new for each scene, in the same memory: to ask for the memory of a path search takes longer
/// than most cycles do.
class RenewedPlanner {
 public:
  RenewedPlanner() { planner_.save(blank_); }

  /// The planner, configured for the scene. It remembers no cycle.
  Planner& operator()(const Scene& scene) {
    EXPECT_TRUE(planner_.configure(scene.parameters).empty());
    planner_.set_footprint(scene.outline);
    planner_.load(blank_);
    planner_.reset();
    return planner_;
  }

 private:
  Planner planner_{critics::built_in()};
  Bytes blank_;
};

}  // namespace hidwa_local_planner::test
