// SPDX-License-Identifier: BSD-3-Clause
// BARN-2D in two small worlds of the test's own.
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/barn_drive.hpp"
#include "study/barn_person.hpp"
#include "study/error.hpp"
#include "study/program.hpp"
#include "study/table.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

namespace fs = std::filesystem;

// Walls left and right, and a wall across with a gap of three cells from column `gap` on. The way goes
// through its middle.
std::string world(int index, int gap) {
  std::string cells, path;
  for (int row = 20; row < 60; ++row) cells += " 5:" + std::to_string(row) + " 24:" + std::to_string(row);
  for (int column = 6; column < 24; ++column) {
    if (column < gap || column >= gap + 4) cells += " " + std::to_string(column) + ":45";
  }
  // Column a of the cells lies at x = -0.075 - 0.15 a, column c of the path at 0.15 c - 4.575.
  const int middle = 30 - gap - 2;
  for (int row = 0; row < 30; ++row) path += " " + std::to_string(middle) + ":" + std::to_string(row);
  return std::to_string(index) + " |" + cells + " |" + path + "\n";
}

class Barn : public StudyFolder {
 protected:
  void SetUp() override {
    StudyFolder::SetUp();
    write("worlds.txt", "# two\n" + world(3, 9) + world(8, 17));
  }
};

// Coarse, to be quick.
const std::string kBarn =
    "barn --worlds @worlds.txt --set plan.resolution=0.05 --set vx_samples=10 --set vth_samples=20";

TEST_F(Barn, DrivesInEveryModeWithoutAContact) {
  const Ended ended = run(kBarn + " --out @a");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.out.find("6 of 6 runs"), std::string::npos) << ended.out;
  for (const char* measure : {"contacts", "collision"}) {
    EXPECT_EQ(column("a", measure), std::vector<std::string>(6, "0")) << measure;
  }
  const std::vector<std::string> ids = column("a", "id");
  for (const std::string& id : ids) {
    const bool alone = at("a", id, "mode") == "AUTONOMY";
    EXPECT_TRUE(!alone || at("a", id, "success") == "1") << id;
    EXPECT_EQ(std::stod(at("a", id, "operator_active")) == 0.0, alone) << id;
  }
  EXPECT_EQ(read("a/summary.json").find("wall"), std::string::npos);
  EXPECT_NE(read("a/timing.json").find("wall_time"), std::string::npos);
}

TEST_F(Barn, TwiceAndInPartsGivesTheSameBytes) {
  const std::string line = kBarn + " --mode AUTONOMY,HOSTILE";
  ASSERT_EQ(run(line + " --out @a --threads 1").code, 0);
  ASSERT_EQ(run(line + " --out @b --threads 3").code, 0);
  expect_same("a", "b");
  expect_sum_of_its_parts(line, "a");
  fs::remove(folder_ / "a/rows/barn-P0003-HOSTILE-S00001.csv");
  const Ended again = run(line + " --out @a");
  ASSERT_EQ(again.code, 0) << again.errors;
  EXPECT_NE(again.errors.find("3 runs are finished already"), std::string::npos) << again.errors;
  expect_same("a", "b");
}

TEST_F(Barn, SetReachesPlannerAndCostmap) {
  const std::string line = kBarn + " --mode AUTONOMY";
  const Ended ended = run(line + " --out @a --vary max_vel_x=0.4,1.0 --no-paths");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const std::vector<std::string> times = column("a", "time");
  ASSERT_EQ(times.size(), 6u);
  for (std::size_t w = 0; w < 2; ++w) {  // as it is (0.5), then 0.4, then 1.0
    EXPECT_GT(std::stod(times[3 * w + 1]), 1.1 * std::stod(times[3 * w]));
    EXPECT_LT(std::stod(times[3 * w + 2]), 0.8 * std::stod(times[3 * w]));
  }
  EXPECT_NE(read("a/ranking.csv").find("1,AUTONOMY,max_vel_x=1.0"), std::string::npos) << read("a/ranking.csv");
  const Ended coarse = run(line + " --out @c --set costmap.resolution=0.1");
  ASSERT_EQ(coarse.code, 0) << coarse.errors;
  EXPECT_NE(column("c", "length")[0], column("a", "length")[0]);
}

TEST_F(Barn, FaultsEndWithTwoAndNameTheRemedy) {
  const std::string line = "barn --out @a --worlds @worlds.txt ";
  write("cut.txt", "# head\n3 | 0:0 0:1");
  expect_refused("barn --out @a --worlds @cut.txt", "cut.txt' line 2: it has 2 parts");
  expect_refused("barn --out @a --worlds @none.txt", "none.txt' cannot be read");
  expect_refused("barn --out @a", "--worlds is missing");
  expect_refused(line + "--mode SWITCHING", "AUTONOMY,HELPFUL,HOSTILE");
  expect_refused(line + "--participants 3", "--participants is for run, pilot and sweep");
  expect_refused("run --out @a --worlds @worlds.txt", "--worlds is for barn");
  expect_refused(line + "--set costmap.colour=1", "there is no costmap.colour");
  expect_refused(line + "--set costmap.resolution=9", "costmap.resolution needs a number");
  expect_refused(line + "--set participant.look_ahead=1", "barn has no participants");
  expect_refused(line + "--set mode=off", "--mode");
  expect_refused(line + "--set min_vel_x=2", "min_vel_x");
  expect_refused(line + "--grid sim_time=1,2 --vary vx_samples=5", "not both");
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST(BarnScore, IsBarnsMetric) {
  sim::BarnWorld world;
  world.cylinders = {{-1.25, 6.0}};
  for (int k = 0; k <= 10; ++k) world.path.emplace_back(-2.25, 4.0 + 0.5 * k);
  // 10 m straight on: OT = 5 s.
  drive::DriveResult result;
  result.arrived = true;
  result.duration = 20.0;
  EXPECT_NEAR(score_barn(world, result).metric, 5.0 / 20.0, 1e-12);
  result.duration = 6.0;  // not faster than twice OT counts
  EXPECT_NEAR(score_barn(world, result).metric, 5.0 / 10.0, 1e-12);
  result.duration = 70.0;  // nor slower than eight times
  EXPECT_NEAR(score_barn(world, result).metric, 5.0 / 40.0, 1e-12);
  result.contacts = 1;
  EXPECT_FALSE(score_barn(world, result).success);
  EXPECT_EQ(score_barn(world, result).metric, 0.0);
  result.contacts = 0;
  result.arrived = false;
  EXPECT_EQ(score_barn(world, result).metric, 0.0);
}

const FullDeflection kFull{0.5, 1.57, 2.0};

Room room_in(const std::shared_ptr<const sim::DiscField>& discs) {
  return [discs](const Eigen::Vector2d& point, double, double at_most) { return discs->distance(point, at_most); };
}

TEST(BarnPeople, AHostileOneTurnsToTheNearestCylinderAndFromSideToSide) {
  for (const double side : {-1.0, 1.0}) {
    const auto discs = std::make_shared<sim::DiscField>(std::vector<Eigen::Vector2d>{{0.4, 0.4 * side}}, 0.075);
    HostilePerson person(room_in(discs), kFull, 5);
    int towards = 0, away = 0, changes = 0;
    double before = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const double left = person.update({1.0 + 0.05 * k, {}, {}}).left;
      towards += left == side;
      away += left == -side;
      changes += left * before < 0.0;
      before = left;
    }
    EXPECT_GT(towards, 3 * away / 2) << side;
    EXPECT_GT(changes, 20) << side;
    EXPECT_LT(towards + away, 2000) << side;  // it lets go, too
  }
}

TEST(BarnPeople, AHelpfulOneTurnsToWhereThePlanLeads) {
  const auto discs = std::make_shared<sim::DiscField>(std::vector<Eigen::Vector2d>{}, 0.075);
  for (const double side : {-1.0, 1.0}) {
    HelpfulPerson person(room_in(discs), kFull);
    EXPECT_EQ(person.update({1.0, {}, {}}).left, 0.0);  // knows no plan
    person.set_plan({{0.0, 0.0}, {0.0, 0.5 * side}, {0.0, side}});
    EXPECT_EQ(person.update({1.1, {}, {}}).left, 0.0);  // decides every quarter of a second
    EXPECT_GT(person.update({1.3, {}, {}}).left * side, 0.0);
    EXPECT_EQ(person.update({1.6, {0.0, 0.0, 0.5 * M_PI * side}, {}}).left, 0.0);  // faces it
  }
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
