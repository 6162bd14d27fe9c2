// SPDX-License-Identifier: BSD-3-Clause
// What a critic of another package can ask, through the public headers alone, against the slow way and against the
// critics of this package.
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/naive_collision.hpp"
#include "support/naive_planner.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

using Question = std::function<void(const CycleView&, const Tile&, TileScores&)>;

// Does in score() what a test says, and scores 0.
class Asker : public Critic {
 public:
  explicit Asker(Question question) : question_(std::move(question)) {}
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override { question_(cycle, tile, scores); }

 private:
  Question question_;
};

/// What a cycle came to. The names of terms are the planner's: it lives as long.
struct Asked {
  std::shared_ptr<Planner> planner;
  std::vector<CandidateReport> records;
  const CandidateReport& operator[](std::size_t candidate) const { return records[candidate]; }
};

// Plans one cycle in which an Asker comes before `others`.
Asked ask(const Scene& scene, const std::string& others, const Question& question) {
  CriticRegistry registry = critics::built_in();
  registry.add("Asker", [&question] { return std::make_shared<Asker>(question); });
  const auto planner = std::make_shared<Planner>(std::move(registry));
  Parameters parameters = scene.parameters;
  parameters.critics = "Asker" + (others.empty() ? "" : ", " + others);
  EXPECT_EQ(planner->configure(parameters), std::vector<std::string>{});
  planner->set_footprint(scene.outline);
  planner->plan(scene.situation, scene.grid(), scene.intent);
  return {planner, planner->candidates()};
}

Scene autonomous(std::uint64_t seed) {
  Scene scene = test::random_scene(seed);
  scene.intent = OperatorIntent();
  return scene;
}

double term(const CandidateReport& record, const std::string& name) {
  for (const CriticTerm& t : record.terms) {
    if (t.name == name) return t.raw;
  }
  ADD_FAILURE() << "no term " << name;
  return 0.0;
}

TEST(Surroundings, DistancesAreThoseThatTheMapGridCriticsScore) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = autonomous(seed);
    scene.parameters.forward_point_distance = 0.3;
    std::map<std::size_t, std::map<std::string, double>> found;  // of a candidate
    const auto records = ask(scene, "PathDist, GoalDist, PathAlign, GoalAlign",
                             [&found](const CycleView& cycle, const Tile& tile, TileScores& scores) {
                               if (!cycle.plan_on_map()) return;
                               if (tile.first == 0) found.clear();  // a cycle may weigh twice: the last counts
                               std::vector<double> distances(tile.count);
                               const auto note = [&](const char* name, const PlanDistance& to, double forward) {
                                 const bool all = tile.distances(to, forward, scores, distances.data());
                                 bool none_negative = true;
                                 for (std::size_t c = 0; c < tile.count; ++c) {
                                   none_negative = none_negative && distances[c] >= 0.0;
                                   if (!scores.rejected(c) && distances[c] >= 0.0)
                                     found[tile.first + c][name] = distances[c];
                                 }
                                 EXPECT_EQ(all, none_negative);
                               };
                               note("PathDist", PlanDistance::to_path(), 0.0);
                               note("GoalDist", PlanDistance::to_goal(), 0.0);
                               note("PathAlign", PlanDistance::to_path(), 0.3);
                               note("GoalAlign", PlanDistance::to_goal(0.3), 0.3);
                             });
    for (const auto& [candidate, by_name] : found) {
      const CandidateReport& record = records[candidate];
      if (!record.legal()) continue;
      for (const auto& [name, distance] : by_name) {
        if (name == "PathAlign" && distance == 0.0) continue;
        if (name == "PathAlign" && term(record, name) == 0.0) continue;  // off near the goal
        ASSERT_EQ(term(record, name), distance) << name;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10000);
}

// Only two are kept ready: further ones are made whenever they are asked for, and are the same.
TEST(Surroundings, AnyNumberOfGoalsAhead) {
  const Scene scene = Scene::empty(81);
  using Found = std::map<double, std::vector<double>>;
  const auto asked_for = [&scene](const std::vector<double>& aheads) {
    Found found;
    ask(scene, "", [&](const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) {
      for (const double ahead : aheads) {
        std::vector<double> distances(tile.count);
        tile.distances(PlanDistance::to_goal(ahead), 0.0, scores, distances.data());
        found[ahead].insert(found[ahead].end(), distances.begin(), distances.end());
      }
    });
    return found;
  };
  const std::vector<double> aheads{0.1, 0.2, 0.3, 0.5};
  const Found together = asked_for(aheads);
  for (const double ahead : aheads) {
    EXPECT_EQ(asked_for({ahead}).at(ahead), together.at(ahead)) << ahead;
    EXPECT_NE(together.at(ahead), asked_for({0.0}).at(0.0)) << ahead;
  }
}

TEST(Surroundings, ThereAreNoDistancesWhereThePlanIsElsewhere) {
  Scene scene = Scene::empty();
  for (Pose2& pose : scene.situation.plan) pose.x += 100.0;
  scene.situation.goal.x += 100.0;
  scene.steer({0.3, 0.0});
  int tiles = 0;
  ask(scene, "", [&tiles](const CycleView& cycle, const Tile& tile, TileScores& scores) {
    EXPECT_FALSE(cycle.plan_on_map());
    std::vector<double> distances(tile.count, 1.0);
    EXPECT_FALSE(tile.distances(PlanDistance::to_path(), 0.0, scores, distances.data()));
    for (const double distance : distances) EXPECT_LT(distance, 0.0);
    ++tiles;
  });
  EXPECT_GT(tiles, 0);
}

TEST(Surroundings, CostsAndBlockedCentresAreThoseOfTheirCells) {
  long inside = 0, beyond = 0, blocked = 0, free = 0;
  for (std::uint64_t seed = 0; seed <= 150; ++seed) {
    Scene scene = seed > 0 ? autonomous(seed) : Scene::empty(21);  // which it drives out of
    if (seed == 0) scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
    ask(scene, "", [&](const CycleView& cycle, const Tile& tile, TileScores& /*scores*/) {
      std::vector<double> costs(tile.count);
      std::vector<bool> expected(tile.count, false);
      for (std::size_t k = 0; k <= tile.steps; ++k) {
        tile.costs(k, costs.data());
        for (std::size_t c = 0; c < tile.count; ++c) {
          const Cell cell = cycle.grid->cell_at(tile.x_at(k, c), tile.y_at(k, c));
          const bool on_map = cycle.grid->contains(cell);
          const std::uint8_t value = on_map ? cycle.grid->at(cell) : cost::kLethal;
          ASSERT_EQ(costs[c], on_map ? value : 0.0);
          ++(on_map ? inside : beyond);
          expected[c] = expected[c] || value == cost::kLethal || value == cost::kInscribed ||
                        (value == cost::kUnknown && scene.parameters.unknown_is_obstacle);
        }
      }
      for (std::size_t c = 0; c < tile.count; ++c) {
        ASSERT_EQ(tile.centre_blocked(c), expected[c]);
        ++(expected[c] ? blocked : free);
      }
    });
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(beyond, 100);
  EXPECT_GT(blocked, 1000);
  EXPECT_GT(free, 1000);
}

TEST(Surroundings, ClearancesAreSafeAndReachUpToTwoCells) {
  // A robot of 0.4 m x 0.4 m that drives straight on to a wall.
  Scene scene = Scene::empty(81);
  scene.parameters.footprint_padding = 0.0;
  scene.fill(0.8, -1.0, 0.9, 1.0);
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  Cell first = scene.grid().cell_at(0.0, 0.0);
  while (scene.at(first) != cost::kLethal) ++first.i;
  const double side = scene.grid().centre(first).x() - 0.025;  // of the wall
  int touching = 0, near = 0, far = 0;
  ask(scene, "", [&](const CycleView& /*cycle*/, const Tile& tile, TileScores& /*scores*/) {
    if (tile.omega != 0.0) return;
    std::vector<double> found(tile.count);
    for (std::size_t k = 0; k <= tile.steps; ++k) {
      tile.clearances(k, found.data());
      for (std::size_t c = 0; c < tile.count; ++c) {
        const double gap = side - (tile.x_at(k, c) + 0.2);
        if (gap < -1e-6) {
          ASSERT_EQ(found[c], 0.0);
          ++touching;
        } else if (gap > 1e-6) {
          ASSERT_GT(found[c], 0.0);
          ASSERT_LE(found[c], std::min(gap, 0.1) + 1e-9);
          ASSERT_GE(found[c], std::min(gap, 0.1) - 1e-6);
          ++(gap < 0.1 ? near : far);
        }
      }
    }
  });
  EXPECT_GT(touching, 10);
  EXPECT_GT(near, 10);
  EXPECT_GT(far, 10);
}

}  // namespace
}  // namespace hidwa_local_planner
