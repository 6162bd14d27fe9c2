// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/key_frames.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

using Frames = std::vector<KeyFrame>;

// 1 s to the right, 2 s up, then a leap back.
const Frames kCorner{{0.0, {0.0, 0.0}}, {1.0, {2.0, 0.0}}, {3.0, {2.0, 4.0}}};

void expect_at(const Eigen::Vector2d& value, double x, double y) {
  EXPECT_NEAR(value.x(), x, 1e-12);
  EXPECT_NEAR(value.y(), y, 1e-12);
}

TEST(KeyFrameTrack, GoesStraightFromKeyToKey) {
  const KeyFrameTrack track(kCorner, KeyMotion::linear);
  expect_at(track.position(0.25), 0.5, 0.0);
  expect_at(track.velocity(0.25), 2.0, 0.0);  // 2 m in 1 s
  expect_at(track.position(2.5), 2.0, 3.0);   // three quarters of 4 m
  expect_at(track.velocity(2.5), 0.0, 2.0);   // 4 m in 2 s
  EXPECT_EQ(track.period(), 3.0);
}

TEST(KeyFrameTrack, LeapsFromTheLastKeyToTheFirst) {
  const KeyFrameTrack track(kCorner, KeyMotion::linear);
  expect_at(track.position(3.25), 0.5, 0.0);
  expect_at(track.velocity(3.25), 2.0, 0.0);
  EXPECT_LT(track.leapt(2.9), -1e9);
  EXPECT_EQ(track.leapt(3.25), 3.0);
  EXPECT_EQ(track.leapt(8.9), 6.0);
}

TEST(KeyFrameTrack, PlaysGazebosSpline) {
  const KeyFrameTrack track(kCorner, KeyMotion::spline);
  for (const KeyFrame& key : Frames{kCorner[0], kCorner[1]})
    expect_at(track.position(key.time), key.position.x(), key.position.y());
  // Segment 0, u = 1/2: (p0 + p1)/2 + (m0 - m1)/8. m0 = (p1 - p0)/2 = (1, 0); m1 = (p2 - p0)/2 = (1, 2).
  expect_at(track.position(0.5), 1.0, -0.25);
  // Segment 1, u = 1/2, m2 = (p2 - p1)/2 = (0, 2): (2, 2) + ((1, 2) - (0, 2))/8.
  expect_at(track.position(2.0), 2.125, 2.0);
}

TEST(KeyFrameTrack, ItsVelocityIsTheSlopeOfItsPosition) {
  constexpr double kH = 1e-6;
  for (const KeyMotion motion : {KeyMotion::linear, KeyMotion::spline}) {
    const KeyFrameTrack track(kCorner, motion);
    for (double t = 0.05; t < 2.95; t += 0.1) {
      const Eigen::Vector2d slope = (track.position(t + kH) - track.position(t - kH)) / (2.0 * kH);
      EXPECT_NEAR((slope - track.velocity(t)).norm(), 0.0, 1e-6) << t;
    }
  }
}

TEST(KeyFrameTrack, RefusesWhatIsNoTrack) {
  const double nan = std::nan("");
  for (const Frames& frames :
       {Frames{}, Frames{{0.0, {0.0, 0.0}}}, Frames{{1.0, {0.0, 0.0}}, {2.0, {1.0, 0.0}}},
        Frames{{0.0, {0.0, 0.0}}, {0.0, {1.0, 0.0}}}, Frames{{0.0, {0.0, 0.0}}, {2.0, {1.0, 0.0}}, {1.0, {1.0, 0.0}}},
        Frames{{0.0, {0.0, nan}}, {2.0, {1.0, 0.0}}}}) {
    EXPECT_THROW(KeyFrameTrack(frames, KeyMotion::linear), std::invalid_argument);
  }
}

TEST(KeyFramePeople, BeginTheirTracksBeforeTheDrive) {
  KeyFramePeople people({KeyFrameTrack(kCorner, KeyMotion::linear)}, 0.5, 2.0);
  ASSERT_EQ(people.movers().size(), 1U);
  expect_at(people.movers()[0].position, 2.0, 2.0);  // half way up
  EXPECT_EQ(people.movers()[0].radius, 0.5);
  people.advance(1.5, {});  // 3.5 on the tracks' clock: leapt at 3, 1 s after the drive began
  expect_at(people.movers()[0].position, 1.0, 0.0);
  EXPECT_EQ(people.movers()[0].leapt, 1.0);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
