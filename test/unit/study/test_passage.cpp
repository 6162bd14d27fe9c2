// SPDX-License-Identifier: BSD-3-Clause
// Passages: how steadily a robot gets through, counted by hand, and through a doorway that just fits.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/passage_table.hpp"
#include "study/passage_watch.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// A drive along the x axis to (10, 0), a sample each second at x = its time, with these speeds.
drive::DriveResult drive_of(const std::vector<double>& speeds) {
  drive::DriveResult drive;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    drive::DriveSample sample;
    sample.time = static_cast<double>(k);
    sample.pose.x = static_cast<double>(k);
    sample.command.v = speeds[k];
    drive.samples.push_back(sample);
  }
  drive.duration = static_cast<double>(speeds.size());
  return drive;
}

Passage seen(const std::vector<double>& speeds) { return passage_of(drive_of(speeds), {10.0, 0.0, 0.0}, 0.25); }

TEST(PassageWatch, CountsStandsThatFollowAMotion) {
  // Stands from 0 s to 2 s (before it moved: no stop), from 3 s to 4 s and from 5 s to 8 s.
  const Passage passage = seen({0.0, 0.009, 0.5, 0.0, 0.5, 0.0, 0.0, 0.0, 0.02});
  EXPECT_EQ(passage.stops, 2);
  EXPECT_EQ(passage.longest_stand, 3.0);
  EXPECT_EQ(passage.standing, 2.0 + 1.0 + 3.0);
}

TEST(PassageWatch, ARobotThatNeverMovesStandsFromBeginningToEnd) {
  const Passage passage = seen({0.0, 0.0, 0.0});
  EXPECT_EQ(passage.stops, 0);
  EXPECT_EQ(passage.longest_stand, 3.0);
}

TEST(PassageWatch, ATurnOnTheSpotIsNoStand) {
  drive::DriveResult drive = drive_of({0.5, 0.0, 0.5});
  drive.samples[1].command.omega = -0.02;
  EXPECT_EQ(passage_of(drive, {10.0, 0.0, 0.0}, 0.25).stops, 0);
}

TEST(PassageWatch, WhatComesAtTheGoalDoesNotCount) {
  // The ten first samples lead to x = 9; the stand at x = 10 and those after it are at the goal.
  const Passage passage = seen({0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.0, 0.0, 0.5, 0.0});
  EXPECT_EQ(passage.stops, 1);
  EXPECT_EQ(passage.longest_stand, 1.0);
}

// A room of 6 m x 3 m with a wall across it at x = 3 m, and in that a doorway of 16 cells, 0.80 m, about y = 1.4 m: the
// robot with its padding is 0.62 m wide.
class Doorway : public StudyFolder {
 protected:
  void SetUp() override {
    StudyFolder::SetUp();
    std::string image = "P2\n120 60\n255\n";
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 120; ++column) {
        const bool border = row == 0 || row == 59 || column == 0 || column == 119;
        const bool wall = column >= 60 && column < 63 && (row < 24 || row >= 40);
        image += border || wall ? "0 " : "254 ";
      }
      image += '\n';
    }
    write("doorway.pgm", image);
    write("doorway.yaml",
          "image: doorway.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
          "free_thresh: 0.196\n");
  }
};

// The short form of the bar: all arrive, none stands for more than 3 s, none stops more than twice.
TEST_F(Doorway, IsPassedSteadilyInSpiteOfNoise) {
  const Ended ended = run("passage --map @doorway.yaml --out @out --start 1,1.1,0.3 --goal 5,1.9,0 --seeds 6");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  using Cells = std::vector<std::string>;
  EXPECT_EQ(column("out", "arrived"), Cells(6, "1"));
  EXPECT_EQ(column("out", "contacts"), Cells(6, "0"));
  EXPECT_EQ(column("out", "steady"), Cells(6, "1"));
  for (const std::string& longest : column("out", "longest_stand")) EXPECT_LE(std::stod(longest), kLongestStand);
  for (const std::string& stops : column("out", "stops")) EXPECT_LE(std::stoi(stops), kMostStops);
}

TEST_F(Doorway, ShardsAreTheSame) {
  const std::string all = "passage --map @doorway.yaml --start 1,1.5,0 --goal 2.5,1.5,0 --seeds 2";
  ASSERT_EQ(run(all + " --out @whole").code, 0);
  expect_sum_of_its_parts(all, "whole");
}

TEST_F(Doorway, WhatMakesNoSenseIsRefused) {
  const std::string line = "passage --out @o --map @doorway.yaml ";
  expect_refused(line + "--goal 5,1.5,0", "there is no start");
  expect_refused(line + "--start 3.1,0.5,0 --goal 5,1.5,0", "the robot does not fit at its start");
  expect_refused("passage --out @o --people 3", "--people is for crowd");
  expect_refused("passage --out @o --mode AUTONOMY", "--mode is for barn, dynabarn and crowd");
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
