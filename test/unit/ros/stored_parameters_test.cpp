// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "ros/critic_loading.hpp"
#include "ros/parameter_set.hpp"
#include "unit/ros/parameter_files.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

TEST(StoredParameters, ValuesOfEveryTypeWithFallbacks) {
  const XmlRpcValue content = file_of({{"limit", 0.5},
                                       {"count", 3},
                                       {"strict", true},
                                       {"side", "left"},
                                       {"speeds", list_of<double>({0.25, 0.5})},
                                       {"steps", list_of<int>({1, 2})},
                                       {"zones", list_of<std::string>({"door", "ramp"})},
                                       {"none", list_of<int>({})}});
  const StoredParameters own("TurnLimit", content);
  EXPECT_EQ(own.number("limit", 1.0), 0.5);
  EXPECT_EQ(own.number("count", 1.0), 3.0);
  EXPECT_EQ(own.number("missing", 1.5), 1.5);
  EXPECT_TRUE(own.flag("strict", false));
  EXPECT_TRUE(own.flag("missing", true));
  EXPECT_EQ(own.word("side", "both"), "left");
  EXPECT_EQ(own.word("missing", "both"), "both");
  EXPECT_EQ(own.numbers("speeds", {}), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(own.numbers("steps", {}), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(own.numbers("missing", {7.0}), std::vector<double>{7.0});
  EXPECT_EQ(own.words("zones", {}), (std::vector<std::string>{"door", "ramp"}));
  EXPECT_EQ(own.words("missing", {"room"}), std::vector<std::string>{"room"});
  EXPECT_TRUE(own.words("none", {"room"}).empty());
  EXPECT_TRUE(own.numbers("none", {7.0}).empty());
  EXPECT_EQ(own.faults(), std::vector<std::string>{});
}

TEST(StoredParameters, AnotherTypeIsAFaultThatNamesWhatIsExpectedAndWhatWasFound) {
  XmlRpcValue content;
  content["limit"] = "0,5";
  content["strict"] = 1;
  content["side"] = false;
  content["speeds"] = 0.5;
  content["zones"] = list_of<int>({1});
  const StoredParameters own("TurnLimit", content);
  EXPECT_EQ(own.number("limit", 2.5), 2.5);
  EXPECT_FALSE(own.flag("strict", false));
  EXPECT_EQ(own.word("side", "both"), "both");
  EXPECT_EQ(own.numbers("speeds", {7.0}), std::vector<double>{7.0});
  EXPECT_EQ(own.words("zones", {"room"}), std::vector<std::string>{"room"});
  const std::vector<std::string> expected{
      "TurnLimit/limit: expected a number, found 0,5 (YAML takes it for a text: write numbers like 0.001 or 1.0e-3, "
      "without quotes)",
      "TurnLimit/strict: expected true or false, found 1",
      "TurnLimit/side: expected a word, found false (YAML reads on, off, yes and no as true and false: write it in "
      "quotes)",
      "TurnLimit/speeds: expected a list of numbers, found 0.5",
      "TurnLimit/zones: expected a list of words, found {1}"};
  EXPECT_EQ(own.faults(), expected);
}

// Has parameters of every type; `side` is one of two words.
class Choosy : public Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& own) override {
    own.numbers("speeds", {});
    own.words("zones", {});
    own.flag("strict", false);
    if (own.word("side", "left") != "left") throw std::invalid_argument("Choosy/side: expected left");
    return own.number("scale", 1.0);
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

CriticRegistry with_choosy() {
  CriticRegistry registry = critics::built_in();
  for (const char* name : {"a/Choosy", "b/Choosy"}) registry.add(name, [] { return std::make_shared<Choosy>(); });
  return registry;
}

TEST(TryOut, KeysThatACriticDoesNotAskForAreNamedWithTheLikelyRightOne) {
  ParameterSet set;
  set.parameters.critics = "PathDist, a/Choosy, b/Choosy";
  set.content["Choosy"]["scale"] = 2.0;
  set.content["Choosy"]["spedes"] = list_of<double>({0.5});
  set.content["Choosy"]["weather"] = "fine";
  set.content["PathDist"]["scale"] = 7.0;  // in DWB's layout: load_parameters() judges it
  const Trial trial = try_out(set, with_choosy());
  EXPECT_EQ(trial.faults, std::vector<std::string>{});
  const std::vector<std::string> expected{
      "unknown parameter Choosy/spedes of the critic a/Choosy: it has no effect; do you mean Choosy/speeds?",
      "unknown parameter Choosy/weather of the critic a/Choosy: it has no effect; it knows scale side speeds strict "
      "zones"};
  EXPECT_EQ(trial.warnings, expected);
}

TEST(TryOut, WrongTypesAndWordsAreFaults) {
  ParameterSet set;
  set.parameters.critics = "PathDist, a/Choosy";
  set.content["Choosy"]["speeds"] = "fast";
  EXPECT_EQ(try_out(set, with_choosy()).faults,
            std::vector<std::string>{"Choosy/speeds: expected a list of numbers, found fast"});
  set.content["Choosy"]["speeds"] = list_of<double>({0.5});
  set.content["Choosy"]["side"] = "right";
  const std::vector<std::string> faults = try_out(set, with_choosy()).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("Choosy/side: expected left"), std::string::npos) << faults[0];
  set.content["Choosy"]["side"] = "left";
  EXPECT_TRUE(try_out(set, with_choosy()).faults.empty());
}

TEST(StoredParameters, OfACriticByItsShortName) {
  ParameterSet set;
  set.content["TurnLimit"]["limit"] = 0.25;
  EXPECT_EQ(set.source_for("some_package/TurnLimit")->number("limit", 1.0), 0.25);
  EXPECT_EQ(set.source_for("Other")->number("limit", 1.0), 1.0);
  EXPECT_EQ(ParameterSet().source_for("Other")->number("limit", 1.0), 1.0);
}

// What a record holds: only critics of other packages, and every number to the bit.
TEST(ParameterSet, ForeignCriticsGoThroughXml) {
  ParameterSet set;
  set.parameters.critics = "PathDist, some_package/TurnLimit, Silent";
  set.content["TurnLimit"]["limit"] = 1.0 / 3.0;
  set.content["TurnLimit"]["strict"] = true;
  set.content["TurnLimit"]["side"] = "<left & right>";
  set.content["TurnLimit"]["speeds"] = list_of<double>({1.0 / 7.0, 2.0});
  set.content["TurnLimit"]["zones"] = list_of<std::string>({"door", "ramp"});
  set.content["PathDist"]["scale"] = 7.0;
  set.content["sim_time"] = 1.0;
  const std::string text = foreign_content(set);
  EXPECT_EQ(text.find("PathDist"), std::string::npos);
  EXPECT_EQ(text.find("sim_time"), std::string::npos);
  const ParameterSet read = with_foreign_content(text);
  const auto own = read.source_for("some_package/TurnLimit");
  EXPECT_EQ(own->number("limit", 0.0), 1.0 / 3.0);
  EXPECT_TRUE(own->flag("strict", false));
  EXPECT_EQ(own->word("side", ""), "<left & right>");
  EXPECT_EQ(own->numbers("speeds", {}), (std::vector<double>{1.0 / 7.0, 2.0}));
  EXPECT_EQ(own->words("zones", {}), (std::vector<std::string>{"door", "ramp"}));
  set.parameters.critics = "PathDist";
  EXPECT_EQ(foreign_content(set), "");
  EXPECT_EQ(foreign_content(ParameterSet()), "");
  for (const char* bad : {"", "no xml", "<value><struct>"}) {
    EXPECT_EQ(with_foreign_content(bad).source_for("TurnLimit")->number("limit", 4.0), 4.0) << bad;
  }
}

TEST(TryOut, FaultsNameUnknownCriticsAndWhatThereIs) {
  ParameterSet set;
  set.parameters.critics = "PathDist, NoSuchCritic";
  const auto faults = try_out(set, critics::built_in()).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("NoSuchCritic"), std::string::npos);
  EXPECT_NE(faults[0].find("GoalDist"), std::string::npos);
  set.parameters.critics = "PathDist";
  EXPECT_TRUE(try_out(set, critics::built_in()).faults.empty());
}

TEST(TryOut, ACriticThatCannotBeMadeIsAFault) {
  CriticRegistry registry = critics::built_in();
  registry.add("Broken", [] { return std::shared_ptr<Critic>(); });
  ParameterSet set;
  set.parameters.critics = "PathDist, Broken";
  const auto faults = try_out(set, registry).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("Broken"), std::string::npos);
}

}  // namespace
}  // namespace hidwa_local_planner
