// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace hidwa_local_planner::test {

enum class Body { circle, polygon };  // of radius 0.30 m, or 0.42 m x 0.33 m
enum class Ground { open, tight };    // a corridor, or the BARN worlds where they are tight

const char* to_string(Body body);
const char* to_string(Ground ground);

/// What a set of situations is like.
struct Setting {
  int cells = 120;  // of the map, a side; 0.05 m each
  Body body = Body::polygon;
  Ground ground = Ground::tight;
};

/// 64 situations, the same in every run: a rolling window of inflated costs around a robot that stands free
/// on the course's path, drives along it, could still stop, and is steered by a person. The plan reaches from
/// 1 m behind to 3 m ahead. Default parameters. Made when first asked for; throws std::runtime_error where
/// the worlds are absent.
const std::vector<Scene>& situations(const Setting& setting);

}  // namespace hidwa_local_planner::test
