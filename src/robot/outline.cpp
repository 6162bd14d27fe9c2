// SPDX-License-Identifier: BSD-3-Clause
#include "robot/outline.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/outline.hpp"
#include "core/util/words.hpp"

namespace hidwa_local_planner::robot {
namespace {

constexpr int kRound = 32;         // corners of a circle
constexpr double kFarthest = 5.0;  // of a corner from the base [m]

bool has_size(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return shape.size.minCoeff() > 0.0;
    case Shape::Kind::cylinder:
      return shape.radius > 0.0 && shape.length > 0.0;
    case Shape::Kind::sphere:
      return shape.radius > 0.0;
    default:
      return false;
  }
}

/// Corner `i` of a polygon round the unit circle.
Point round_corner(int i) {
  const double angle = 2.0 * M_PI * (i + 0.5) / kRound;
  return Point(std::cos(angle), std::sin(angle)) / std::cos(M_PI / kRound);
}

void add_projection(const Shape& shape, std::vector<Point>& points) {
  if (shape.kind == Shape::Kind::sphere) {
    const Point centre = shape.pose.translation().head<2>();
    for (int i = 0; i < kRound; ++i) points.push_back(centre + shape.radius * round_corner(i));
    return;
  }
  const bool box = shape.kind == Shape::Kind::box;
  for (const double up : {-0.5, 0.5}) {
    for (int i = 0; i < (box ? 4 : kRound); ++i) {
      Eigen::Vector3d corner;
      if (box) {
        corner = Eigen::Vector3d(i < 2 ? 0.5 : -0.5, i % 2 == 0 ? 0.5 : -0.5, up).cwiseProduct(shape.size);
      } else {
        corner << shape.radius * round_corner(i), up * shape.length;
      }
      points.push_back((shape.pose * corner).head<2>());
    }
  }
}

}  // namespace

Outline outline_of(const Model& model) {
  Outline outline;
  std::vector<Point> points;
  for (const Link& link : model.links) {
    for (const Shape& shape : link.collisions) {
      if (!has_size(shape)) {
        if (outline.skipped.empty() || outline.skipped.back() != link.name) outline.skipped.push_back(link.name);
        continue;
      }
      const std::size_t first = points.size();
      add_projection(shape, points);
      for (std::size_t i = first; i < points.size(); ++i) {
        if (points[i].norm() <= kFarthest) continue;
        outline.fault = link.name + ": its collision geometry reaches " + worded(points[i].norm()) + " m from " +
                        model.base + ", beyond " + worded(kFarthest) + " m: correct it in the URDF";
        return outline;
      }
    }
  }
  outline.corners = convex_hull(std::move(points));
  if (outline.corners.size() < 3) {
    outline.corners.clear();
    outline.fault = "no link has a box, a cylinder or a sphere as collision geometry";
  }
  return outline;
}

}  // namespace hidwa_local_planner::robot
