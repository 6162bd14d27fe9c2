// SPDX-License-Identifier: BSD-3-Clause
#include "study/options.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

Options parse(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> arguments;
  for (std::string word; stream >> word;) arguments.push_back(word);
  return parse_options(arguments);
}

std::string fault_of(const std::string& line) {
  try {
    parse(line);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(Options, DefaultsAreThePapersNumbers) {
  const Options run = parse("run --out a");
  EXPECT_EQ(run.participants, 32);
  EXPECT_EQ(run.conditions.size(), 3u);
  EXPECT_EQ(run.guard, Guard::none);
  EXPECT_TRUE(run.resume);
  const Options pilot = parse("pilot --out a");
  EXPECT_EQ(pilot.participants, 8);
  EXPECT_EQ(pilot.conditions, std::vector<std::string>{"SJ"});
}

TEST(Options, TakeTheirValuesAfterAnEqualsSignToo) {
  const Options o = parse("sweep --out=a --start=-6.8,-4.9,1.5 --set=delta=1 --grid=s_v=1,2 --no-paths");
  EXPECT_EQ(o.out, "a");
  EXPECT_EQ(o.start->x, -6.8);
  ASSERT_EQ(o.sets.size(), 1u);
  EXPECT_EQ(o.sets.front().name, "delta");
  EXPECT_EQ(o.sets.front().value, "1");
  EXPECT_EQ(o.grid, std::vector<std::string>{"s_v=1,2"});
  EXPECT_FALSE(o.paths);
  EXPECT_NE(fault_of("run --out=a --no-paths=1").find("--no-paths takes no value"), std::string::npos);
  EXPECT_NE(fault_of("run --out=a --nothing=1").find("there is no option '--nothing'"), std::string::npos);
}

TEST(Options, AreRead) {
  const Options o = parse(
      "sweep --out a --map m.yaml --regions r.yaml --start 1,2,0.5 --goal 3,4,-1 --participants 5 --conditions SW,SJ "
      "--seed 9 --threads 3 --profile paper --guard nearest --set delta=1 --grid s_v=1,2 --grid delta=0 --shard 2/7 "
      "--no-resume --no-paths");
  EXPECT_EQ(o.out, "a");
  EXPECT_EQ(o.map, "m.yaml");
  EXPECT_EQ(o.start->y, 2.0);
  EXPECT_EQ(o.goal->theta, -1.0);
  EXPECT_EQ(o.conditions, (std::vector<std::string>{"SJ", "SW"}));
  EXPECT_EQ(o.seed, 9u);
  EXPECT_EQ(o.threads, 3u);
  EXPECT_EQ(o.profile, "paper");
  EXPECT_EQ(o.guard, Guard::nearest);
  EXPECT_EQ(o.sets.size(), 1u);
  EXPECT_EQ(o.grid.size(), 2u);
  EXPECT_EQ(o.shard, 2u);
  EXPECT_EQ(o.shards, 7u);
  EXPECT_FALSE(o.resume);
  EXPECT_FALSE(o.paths);
  EXPECT_EQ(parse("merge --out a b c").parts, (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(parse("run --help").command, "help");
  EXPECT_EQ(parse("--help").command, "help");
}

TEST(Options, FaultsNameTheOption) {
  EXPECT_NE(fault_of("").find("what to do"), std::string::npos);
  EXPECT_NE(fault_of("walk --out a").find("'walk'"), std::string::npos);
  EXPECT_NE(fault_of("run").find("--out"), std::string::npos);
  EXPECT_NE(fault_of("run --out").find("needs a value"), std::string::npos);
  EXPECT_NE(fault_of("run --out a --pace 3").find("'--pace'"), std::string::npos);
  EXPECT_NE(fault_of("run --out a stray").find("'stray'"), std::string::npos);
  for (const char* bad :
       {"--participants 0", "--participants 2.5", "--seed -1", "--threads 0", "--conditions SJ,SX", "--conditions ,",
        "--start 1,2", "--goal 1,2,x", "--profile best", "--guard some", "--shard 0/2", "--shard 3/2", "--shard 2",
        "--set delta", "--grid s_v=1,2", "--vary s_v=1,2"}) {
    const std::string option = std::string(bad).substr(0, std::string(bad).find(' '));
    const std::string fault = fault_of(std::string("run --out a ") + bad);
    EXPECT_NE(fault, "") << bad;
    if (option == "--set") continue;
    EXPECT_NE(fault.find(option), std::string::npos) << bad << ": " << fault;
  }
  EXPECT_NE(fault_of("sweep --out a").find("--grid"), std::string::npos);
  EXPECT_NE(fault_of("sweep --out a --grid s_v=1 --vary delta=1").find("either"), std::string::npos);
  EXPECT_NE(fault_of("pilot --out a --set s_v=1").find("s_v"), std::string::npos);
  EXPECT_NE(fault_of("merge --out a").find("parts"), std::string::npos);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
