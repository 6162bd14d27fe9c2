// SPDX-License-Identifier: BSD-3-Clause
// Small studies in a hall with a region to avoid in the middle.
#include "study/program.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/table.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

namespace fs = std::filesystem;

class StudyProgram : public StudyFolder {
 protected:
  void SetUp() override {
    StudyFolder::SetUp();
    // 10 m x 6 m, walls all round.
    std::ofstream pgm(folder_ / "hall.pgm", std::ios::binary);
    pgm << "P5\n200 120\n255\n";
    for (int row = 0; row < 120; ++row) {
      for (int column = 0; column < 200; ++column) {
        const bool wall = row < 2 || row >= 118 || column < 2 || column >= 198;
        pgm.put(wall ? '\0' : static_cast<char>(0xfe));
      }
    }
    write("hall.yaml",
          "image: hall.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
          "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    write("regions.yaml",
          "start: [1.0, 3.0, 0.0]\ngoal: [8.8, 3.0, 0.0]\nregions:\n"
          "  - {name: wet, polygon: [[4.5, 2.7], [5.3, 2.7], [5.3, 3.3], [4.5, 3.3]]}\n");
  }

  std::vector<std::string> in_hall() const { return {"--map", path("hall.yaml"), "--regions", path("regions.yaml")}; }
  Ended study(const std::string& line) const { return run(line, in_hall()); }

  std::vector<Row> rows(const std::string& out) const {
    std::vector<Row> lines = lines_of(out);
    EXPECT_EQ(lines.at(0), columns());
    lines.erase(lines.begin());
    return lines;
  }
};

TEST_F(StudyProgram, EverybodyDrivesInEveryCondition) {
  const Ended ended = study("run --out @a --participants 2 --threads 2");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.out.find("6 of 6 runs"), std::string::npos);
  const std::vector<Row> all = rows("a");
  ASSERT_EQ(all.size(), 6u);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  for (const Row& row : all) {
    ASSERT_EQ(row.size(), columns().size());
    EXPECT_EQ(cell(row, "ending"), "arrived") << row.front();
    EXPECT_GE(value(row, "interventions"), 1) << row.front();
    EXPECT_GT(value(row, "operator_active"), 0.0) << row.front();
    if (cell(row, "condition") != "SW") {
      EXPECT_EQ(cell(row, "contacts"), "0") << row.front();
    }
    const std::string ways = read("a/paths/" + row.front() + ".csv");
    EXPECT_NE(ways.find("AUTONOMY"), std::string::npos);
    EXPECT_EQ(ways.find("MANUAL") != std::string::npos, cell(row, "condition") == "SW") << row.front();
    EXPECT_EQ(ways.find("SHARED") != std::string::npos, cell(row, "condition") != "SW") << row.front();
  }
  EXPECT_NE(read("a/timing.json").find("\"runs_made\": 6"), std::string::npos);
  EXPECT_EQ(read("a/summary.json").find("wall"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "a/ranking.csv"));
}

TEST_F(StudyProgram, TwiceAndInPartsGivesTheSameBytes) {
  ASSERT_EQ(study("run --out @a --participants 3 --threads 1").code, 0);
  ASSERT_EQ(study("run --out @b --participants 3 --threads 3").code, 0);
  expect_same("a", "b");
  EXPECT_EQ(rows("a").size(), 9u);
  expect_sum_of_its_parts("run --participants 3", "a", in_hall());
}

TEST_F(StudyProgram, ShardsMayShareAFolder) {
  ASSERT_EQ(study("run --out @a --participants 2 --conditions SJ").code, 0);
  for (const char* part : {"1/2", "2/2"}) {
    ASSERT_EQ(study(std::string("run --out @b --participants 2 --conditions SJ --shard ") + part).code, 0);
  }
  expect_same("a", "b");
}

TEST_F(StudyProgram, GoesOnWhereItWasEnded) {
  ASSERT_EQ(study("run --out @a --participants 2 --conditions SJ,SW").code, 0);
  const std::string before = read("a/runs.csv"), summary = read("a/summary.json");
  fs::remove(folder_ / "a/rows/run-P0002-SJ-S00001.csv");
  write("a/rows/run-P0001-SW-S00001.csv", "run-P0001-SW-S00001,half a li");
  const Ended again = study("run --out @a --participants 2 --conditions SJ,SW");
  ASSERT_EQ(again.code, 0) << again.errors;
  EXPECT_NE(again.errors.find("2 runs are finished already"), std::string::npos);
  EXPECT_NE(read("a/timing.json").find("\"runs_made\": 2"), std::string::npos);
  EXPECT_EQ(read("a/runs.csv"), before);
  EXPECT_EQ(read("a/summary.json"), summary);
  ASSERT_EQ(study("run --out @a --participants 2 --conditions SJ,SW --no-resume").code, 0);
  EXPECT_NE(read("a/timing.json").find("\"runs_made\": 4"), std::string::npos);
  EXPECT_EQ(read("a/runs.csv"), before);
}

TEST_F(StudyProgram, AnotherStudyDoesNotMixWithWhatIsThere) {
  ASSERT_EQ(study("run --out @a --participants 1 --conditions SJ").code, 0);
  const std::string before = read("a/runs.csv");
  for (const char* other : {"--seed 2", "--set delta=1", "--profile paper", "--guard nearest", "--participants 2"}) {
    expect_refused(std::string("run --out @a --participants 1 --conditions SJ ") + other, "another study", in_hall());
  }
  EXPECT_EQ(read("a/runs.csv"), before);
}

TEST_F(StudyProgram, SetReachesThePlannerThePersonAndTheLink) {
  ASSERT_EQ(study("run --out @a --participants 1 --conditions SJ").code, 0);
  ASSERT_EQ(study("run --out @slow --participants 1 --conditions SJ --set max_vel_x=0.3").code, 0);
  ASSERT_EQ(study("run --out @late --participants 1 --conditions SJ --set link_delay=0.4").code, 0);
  ASSERT_EQ(study("run --out @dull --participants 1 --conditions SJ --set participant.reaction_time=1.5").code, 0);
  EXPECT_GT(value(rows("slow")[0], "duration"), 1.3 * value(rows("a")[0], "duration"));
  EXPECT_NE(rows("late")[0], rows("a")[0]);
  EXPECT_NE(rows("dull")[0], rows("a")[0]);
  EXPECT_EQ(cell(rows("late")[0], "seed"), cell(rows("a")[0], "seed"));
}

TEST_F(StudyProgram, ASweepRanksItsSettings) {
  const Ended ended = study("sweep --out @a --participants 1 --grid max_vel_x=0.3,0.5 --no-paths");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_EQ(rows("a").size(), 2u);
  const std::string ranking = read("a/ranking.csv");
  EXPECT_NE(ranking.find("1,SJ,max_vel_x=0.5"), std::string::npos) << ranking;
  EXPECT_NE(ranking.find("2,SJ,max_vel_x=0.3"), std::string::npos) << ranking;
  EXPECT_TRUE(fs::is_empty(folder_ / "a/paths"));
}

TEST_F(StudyProgram, ThePilotHasFourCombinations) {
  ASSERT_EQ(study("pilot --out @a --participants 1").code, 0);
  const std::vector<Row> all = rows("a");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(cell(all[3], "setting"), "s_v=400;s_omega=800;delta=1");
}

TEST_F(StudyProgram, FaultsEndWithTwoAndNameTheRemedy) {
  expect_refused("run --out @a --set s_w=1", "no parameter 's_w'", in_hall());
  expect_refused("run --out @a --set min_vel_x=2", "min_vel_x", in_hall());
  expect_refused("sweep --out @a --grid s_v=1,-1", "s_v", in_hall());
  expect_refused("run --out @a --start 0,0,0", "--start", in_hall());
  expect_refused("run --out @a --goal 30,0,0", "--goal", in_hall());
  expect_refused("run --out @a --map @nowhere.yaml", "nowhere.yaml");
  expect_refused("run --out @a --map @hall.yaml", "--start");
  expect_refused("run", "--out", in_hall());
  EXPECT_FALSE(fs::exists(folder_ / "a"));
  expect_refused("merge --out @a @b", "plan.csv");
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(StudyProgram, MergeRefusesWhatIsMissingOrDoesNotBelong) {
  ASSERT_EQ(study("run --out @p1 --participants 2 --conditions SJ --shard 1/2").code, 0);
  expect_refused("merge --out @m @p1", "run-P0002-SJ-S00001 is in none");
  EXPECT_FALSE(fs::exists(folder_ / "m"));
  ASSERT_EQ(study("run --out @p2 --participants 2 --conditions SJ --shard 2/2 --seed 5").code, 0);
  expect_refused("merge --out @n @p1 @p2", "different studies");
}

TEST_F(StudyProgram, AFolderThatCannotBeMadeEndsWithOne) {
  write("file", "");
  EXPECT_EQ(study("run --out @file/a --participants 1").code, 1);
}

TEST_F(StudyProgram, HelpIsNoFault) {
  const Ended ended = run("--help");
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.out.find("hidwa_study sweep"), std::string::npos);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
