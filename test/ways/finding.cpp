// SPDX-License-Identifier: BSD-3-Clause
// 1. A proof that there is none, in a region that no drive leaves: class `none`.
// 2. The remaining way from everywhere, for an outline without a margin. Where the start is not reached: `open`.
// 3. A way from the start, for an outline with the margin, led by that: class `sure`, else `open`.
#include "ways/finding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ways/proof.hpp"

namespace hidwa_ways {
namespace {

constexpr double kStretch = 1.0;   // so long is what a way leads to [m]
constexpr double kBetween = 3e-3;  // what a corner may come nearer between two looks of the search [m]
constexpr int kFineness = 8;       // a look each half degree
constexpr double kRoams = 1.5;     // with a map that rolls a drive leaves the first one by so much [m]

Region grown(const Region& region, double by) { return {region.x - by, region.y - by, region.side + 2.0 * by}; }

bool no_way(const Scene& scene, const Ground& ground) {
  const Region region = scene.rolling ? grown(scene.local_map(), kRoams) : scene.local_map();
  const Target target = through_target(scene);
  const auto surely = [&](double step, int headings) {
    const Lattice lattice(region, step, scene.start.theta, headings);
    return surely_no_way(ground, lattice, scene.body.shape, scene.reverse, scene.start, target,
                         through_distance(scene));
  };
  // Coarse cells take an eighth of the time where they suffice.
  return surely(0.025, 90) || surely(0.0125, 180);
}

// The outline must stay on the map.
Lattice lattice_of(const Scene& scene) {
  return {grown(scene.local_map(), -hidwa_attack::outermost(scene.body.shape) - 0.05), step_of(scene),
          scene.start.theta};
}

// From each pose the way that is left to the target: backwards from there until the start is found.
void measure(const Scene& scene, const Lattice& lattice, const Target& target, Finding& finding) {
  // A way with the margin is free at the middle of each cell that it passes.
  const double less = std::max(0.0, reach_of_cell(lattice, scene.body.shape) - scene.margin());
  Search::Make make;
  make.reverse = scene.reverse;
  make.undo = true;
  make.longest = kLongestWay;
  finding.field =
      std::make_unique<Search>(*finding.ground, lattice, hidwa_attack::padded(scene.body.shape, -less), make);
  for (int row = 0; row < lattice.across(); ++row) {
    for (int column = 0; column < lattice.across(); ++column) {
      const double x = lattice.middle_x(column), y = lattice.middle_y(row);
      if (!target.near(x, y, kArrives)) continue;
      for (int k = 0; k < lattice.headings(); ++k) finding.field->begin_at(x, y, k);
    }
  }
  const Pose2& start = scene.start;
  const int column = lattice.column(start.x), row = lattice.row(start.y);
  finding.field->run(
      [&](const Search::Node& node) {
        return node.heading == 0 && lattice.column(node.x) == column && lattice.row(node.y) == row;
      },
      [](const Search::Node&) { return 0.0; });
  finding.remaining = finding.field->cost_near(start);
}

bool find_way(const Scene& scene, const Lattice& lattice, const Target& target, Finding& finding) {
  Search::Make make;
  make.reverse = scene.reverse;
  make.longest = kLongestWay;
  make.fineness = kFineness;
  Search search(*finding.ground, lattice, hidwa_attack::padded(scene.body.shape, scene.margin() + kBetween), make);
  search.begin_at(scene.start.x, scene.start.y, 0);
  const int end = search.run(
      [&](const Search::Node& node) { return target.near(node.x, node.y, kArrives); },
      [&](const Search::Node& node) { return std::min(finding.field->cost_at(node), finding.remaining + 0.1); });
  if (end >= 0) finding.way = search.way_to(end);
  return end >= 0;
}

}  // namespace

const char* to_string(Class value) {
  switch (value) {
    case Class::sure:
      return "sure";
    case Class::none:
      return "none";
    case Class::open:
      return "open";
  }
  return "";
}

double step_of(const Scene& scene) { return std::min(0.025, scene.margin()); }

double through_distance(const Scene& scene) { return std::min(0.3, 2.0 * inscribed(scene.body.shape)); }

Target through_target(const Scene& scene) { return {scene.plan, kFurther, kFurther + 2.0 * kStretch}; }

Target through_or_farther(const Scene& scene) {
  return {scene.plan, kFurther, std::numeric_limits<double>::infinity()};
}

Finding examine(const Scene& scene) {
  Finding finding;
  finding.ground = std::make_unique<Ground>(scene.world);
  if (no_way(scene, *finding.ground)) {
    finding.answer = Class::none;
    return finding;
  }
  const Lattice lattice = lattice_of(scene);
  const Target target(scene.plan, kFurther, kFurther + kStretch);
  measure(scene, lattice, target, finding);
  if (std::isfinite(finding.remaining) && find_way(scene, lattice, target, finding)) finding.answer = Class::sure;
  return finding;
}

}  // namespace hidwa_ways
