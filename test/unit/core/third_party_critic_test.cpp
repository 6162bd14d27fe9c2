// SPDX-License-Identifier: BSD-3-Clause
// Critics of other packages: chosen by name, weighed, and not trusted.
#include <limits>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::rejections_by;
using test::Scene;

enum class Rejects { none, left, all };

// Says `value` of every candidate that it does not reject.
class Opinion : public Critic {
 public:
  explicit Opinion(double value, Rejects rejects = Rejects::none) : value_(value), rejects_(rejects) {}
  double configure(const Parameters& /*parameters*/, const ParameterSource& own) override {
    return own.number("scale", 2.0);
  }
  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (rejects_ == Rejects::all || (rejects_ == Rejects::left && tile.omega > 0.0)) {
        scores.reject(c, "in my opinion");
      } else {
        scores.set(c, value_);
      }
    }
  }

 private:
  double value_;
  Rejects rejects_;
};

// The built-in critics, and this one by the name of Opinion.
CriticRegistry with(const std::shared_ptr<Critic>& opinion) {
  CriticRegistry registry = critics::built_in();
  registry.add("Opinion", [opinion] { return opinion; });
  return registry;
}

// What is set for Opinion alone.
template <typename Source>
std::unique_ptr<ParameterSource> of_opinion(const std::string& name) {
  if (name == "Opinion") return std::make_unique<Source>();
  return nullptr;
}

Scene asking(double v = 0.5) {
  Scene scene = Scene::empty(81);
  scene.situation.velocity = scene.situation.last_command = {v, 0.0};
  scene.parameters.critics = "PathDist, Opinion";
  return scene;
}

TEST(ThirdPartyCritic, IsWeighedAndListed) {
  PlannerBench bench(asking(), with(std::make_shared<Opinion>(3.0)));
  const Decision& decision = bench.cycle();
  ASSERT_EQ(decision.terms.size(), 3u);
  EXPECT_EQ(decision.terms[1].name, "Opinion");
  EXPECT_EQ(decision.terms[1].raw, 3.0);
  EXPECT_EQ(decision.terms[1].weight, 2.0);
  EXPECT_NEAR(decision.total, decision.terms[0].raw * 16.0 + 6.0, 1e-9);
}

TEST(ThirdPartyCritic, ReadsItsOwnParameters) {
  struct Source : ParameterSource {
    double number(const std::string& key, double fallback) const override { return key == "scale" ? 5.0 : fallback; }
  };
  Planner planner(with(std::make_shared<Opinion>(3.0)));
  const Scene scene = asking();
  ASSERT_TRUE(planner.configure(scene.parameters, of_opinion<Source>).empty());
  planner.set_footprint(scene.outline);
  EXPECT_EQ(planner.plan(scene.situation, scene.grid(), scene.intent).terms[1].weight, 5.0);
}

TEST(ThirdPartyCritic, AValueThatItCannotReadIsAFaultOfTheSet) {
  struct Source : ParameterSource {
    std::vector<std::string> faults() const override { return {"Opinion/scale: expected a number, found x"}; }
  };
  Planner planner(with(std::make_shared<Opinion>(3.0)));
  Parameters parameters = asking().parameters;
  parameters.sim_time = 1.25;
  EXPECT_EQ(planner.configure(parameters, of_opinion<Source>),
            std::vector<std::string>{"Opinion/scale: expected a number, found x"});
  EXPECT_NE(planner.parameters().sim_time, 1.25);
  EXPECT_TRUE(planner.configure(parameters).empty());
  EXPECT_EQ(planner.parameters().sim_time, 1.25);
}

TEST(ThirdPartyCritic, ItsRejectionsCountUnderItsName) {
  PlannerBench bench(asking(), with(std::make_shared<Opinion>(0.0, Rejects::left)));
  const Decision& decision = bench.cycle();
  EXPECT_EQ(rejections_by(decision, "Opinion"), 200u);  // 20 speeds x 10 left turns
  EXPECT_EQ(decision.outcome, Outcome::drive);
}

TEST(ThirdPartyCritic, RejectingEverythingBrakesThenFails) {
  PlannerBench bench(asking(0.2), with(std::make_shared<Opinion>(0.0, Rejects::all)));
  const Decision first = bench.drive();
  EXPECT_EQ(first.outcome, Outcome::brake);
  EXPECT_NEAR(first.command.v, 0.075, 1e-12);  // 0.2 - 0.125
  EXPECT_EQ(rejections_by(first, "Opinion"), first.candidates);
  bench.drive();
  EXPECT_EQ(bench.drive().outcome, Outcome::fail);
}

TEST(ThirdPartyCritic, IsToldWhereThePersonDecides) {
  // Rejects left turns for the sake of autonomy.
  struct Considerate : Opinion {
    Considerate() : Opinion(0.0, Rejects::left) {}
    void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override {
      if (!cycle.operator_decides) Opinion::score(cycle, tile, scores);
    }
  };
  struct Case {
    Influence influence;
    bool goal_latched, decides;
  };
  const Case cases[] = {{Influence::none, false, false},   {Influence::none, true, false},
                        {Influence::shared, false, false}, {Influence::shared, true, true},
                        {Influence::direct, false, true},  {Influence::direct, true, true}};
  for (const Case& c : cases) {
    Scene scene = asking();
    scene.intent.influence = c.influence;
    scene.situation.goal_latched = c.goal_latched;
    PlannerBench bench(scene, with(std::make_shared<Considerate>()));
    EXPECT_EQ(rejections_by(bench.cycle(), "Opinion") == 0, c.decides);
  }
}

TEST(ThirdPartyCritic, NotANumberIsARejectionOfTheOneThatSaidIt) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    PlannerBench bench(asking(0.2), with(std::make_shared<Opinion>(value)));
    const Decision& decision = bench.cycle();
    EXPECT_EQ(decision.outcome, Outcome::brake);
    EXPECT_NEAR(decision.command.v, 0.075, 1e-12);
    EXPECT_EQ(rejections_by(decision, "Opinion"), decision.candidates);
    EXPECT_EQ(rejections_by(decision, "PathDist"), 0u);
  }
}

TEST(ThirdPartyCritic, WeightZeroTurnsItOffRejectionsIncluded) {
  struct Off : Opinion {
    Off() : Opinion(0.0, Rejects::all) {}
    double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 0.0; }
  };
  PlannerBench bench(asking(), with(std::make_shared<Off>()));
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::drive);
  EXPECT_EQ(decision.legal, decision.candidates);
}

}  // namespace
}  // namespace hidwa_local_planner
