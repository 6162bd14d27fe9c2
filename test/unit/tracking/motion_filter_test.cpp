// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_filter.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "support/scan_world.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::normal;
using test::Random;

struct Reading {
  double time;
  Point place;
  double deviation;
};

Eigen::Matrix2d covariance_of(double deviation) { return deviation * deviation * Eigen::Matrix2d::Identity(); }

std::vector<Reading> readings_of(Random& random, const Point& start, const Point& velocity, int count) {
  std::vector<Reading> readings;
  double time = 3.0;
  for (int i = 0; i < count; ++i) {
    time += random.uniform(0.02, 0.2);
    const double deviation = random.uniform(0.01, 0.1);
    const Point noise{deviation * normal(random), deviation * normal(random)};
    readings.push_back({time, start + (time - 3.0) * velocity + noise, deviation});
  }
  return readings;
}

// Without disturbance the filter is a weighted straight-line fit with the prior as one more reading of each: all at
// once, by the normal equations.
TEST(MotionFilter, IsTheLeastSquaresFitOfAStraightLine) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Point start{random.uniform(-5, 5), random.uniform(-5, 5)},
        velocity{random.uniform(-2, 2), random.uniform(-2, 2)};
    const std::vector<Reading> readings = readings_of(random, start, velocity, 12);
    const Point prior(1.0, 2.0);
    MotionFilter filter(prior, covariance_of(0.5), 1.5, 3.0);
    for (const Reading& r : readings) {
      filter.predict(r.time, 0.0);
      filter.correct(r.place, covariance_of(r.deviation));
    }
    const double end = readings.back().time;
    Eigen::Matrix2d normal_matrix = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d right = Eigen::Matrix2d::Zero();  // a column an axis
    const auto add = [&](const Eigen::Vector2d& row, const Point& value, double deviation) {
      normal_matrix += row * row.transpose() / (deviation * deviation);
      right += row * value.transpose() / (deviation * deviation);
    };
    add({1.0, 3.0 - end}, prior, 0.5);
    add({0.0, 1.0}, Point(0.0, 0.0), 1.5);
    for (const Reading& r : readings) add({1.0, r.time - end}, r.place, r.deviation);
    const Eigen::Matrix2d covariance = normal_matrix.inverse();
    const Eigen::Matrix2d fitted = covariance * right;
    EXPECT_LT((filter.position() - Point(fitted.row(0))).norm(), 1e-9);
    EXPECT_LT((filter.velocity() - Point(fitted.row(1))).norm(), 1e-9);
    EXPECT_NEAR(filter.position_deviation(), std::sqrt(covariance(0, 0)), 1e-9);
    EXPECT_NEAR(filter.velocity_deviation(), std::sqrt(covariance(1, 1)), 1e-9);
  }
}

// A body that truly follows the model: mismatches and errors have the mean of chi-squared with two degrees of
// freedom, 2.
TEST(MotionFilter, DeviationsAreThoseOfTheErrors) {
  Random random(2);
  const double density = 0.2, dt = 0.05, deviation = 0.03;
  const Eigen::Matrix2d covariance = covariance_of(deviation);
  double mismatch = 0.0, place = 0.0, speed = 0.0;
  int count = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Point p(0.0, 0.0), v{normal(random), normal(random)};
    MotionFilter filter({deviation * normal(random), deviation * normal(random)}, covariance, 1.0, 0.0);
    for (int i = 1; i <= 60; ++i) {
      for (int k = 0; k < 20; ++k) {  // white acceleration, nearly
        const double h = dt / 20.0;
        p += h * v;
        v += std::sqrt(density * h) * Point{normal(random), normal(random)};
      }
      filter.predict(i * dt, density);
      const double m = filter.correct(p + deviation * Point{normal(random), normal(random)}, covariance);
      if (i % 15 != 0) continue;
      mismatch += m;
      place += (filter.position() - p).squaredNorm() / std::pow(filter.position_deviation(), 2);
      speed += (filter.velocity() - v).squaredNorm() / std::pow(filter.velocity_deviation(), 2);
      ++count;
    }
  }
  // 1,600 values of variance 4, not all independent: the mean's deviation is below 2 / sqrt(400) = 0.1.
  EXPECT_NEAR(mismatch / count, 2.0, 0.3);
  EXPECT_NEAR(place / count, 2.0, 0.3);
  EXPECT_NEAR(speed / count, 2.0, 0.3);
}

TEST(MotionFilter, AnEarlierTimeChangesNothing) {
  MotionFilter filter({1.0, 2.0}, covariance_of(0.1), 1.0, 5.0);
  filter.predict(4.0, 1.0);
  EXPECT_EQ(filter.time(), 5.0);
  EXPECT_DOUBLE_EQ(filter.position_deviation(), 0.1);
}

// A walker's track after `steps` readings of 0.05 s each, since a leap from one velocity to another.
ManoeuvreFilter after_leap(Random& random, const Point& from, const Point& to, double deviation, int steps) {
  const Eigen::Matrix2d covariance = covariance_of(deviation);
  const auto noise = [&] { return Point{deviation * normal(random), deviation * normal(random)}; };
  Point p(0.0, 0.0);
  ManoeuvreFilter filter(p + noise(), covariance, 1.2, 0.0, 0.8);
  for (int i = 1; i <= 60 + steps; ++i) {
    p += 0.05 * (i <= 60 ? from : to);
    filter.predict(0.05 * i);
    filter.correct(p + noise(), covariance);
  }
  return filter;
}

double rms_after_leap(const Point& from, const Point& to, int steps, double& told, double deviation = 0.015) {
  Random random(9);
  double squares = 0.0;
  told = 0.0;
  const int trials = 200;
  for (int i = 0; i < trials; ++i) {
    const ManoeuvreFilter filter = after_leap(random, from, to, deviation, steps);
    squares += (filter.velocity() - to).squaredNorm();
    told += filter.velocity_deviation() / trials;
  }
  return std::sqrt(squares / (2.0 * trials));  // along an axis
}

// Who walks on is known well, and the deviation says so.
TEST(ManoeuvreFilter, KnowsWhoWalksOn) {
  double told = 0.0;
  const double error = rms_after_leap({1.2, 0.5}, {1.2, 0.5}, 20, told);
  EXPECT_LT(error, 0.05);
  EXPECT_LT(told, 0.08);
  EXPECT_GT(told, error);
}

// Two readings after a leap of 2 m/s the filter knows that it knows little, after five the new velocity.
TEST(ManoeuvreFilter, FollowsALeap) {
  double told = 0.0;
  EXPECT_LT(rms_after_leap({1.0, 0.0}, {-1.0, 0.0}, 2, told), 1.5);
  EXPECT_GT(told, 0.3);
  const double error = rms_after_leap({1.0, 0.0}, {-1.0, 0.0}, 5, told);
  EXPECT_LT(error, 0.25);
  EXPECT_LT(error, 2.0 * told);
}

// The velocity between two readings 0.05 s apart is known to sqrt(2) times their deviation over 0.05 s: 0.085 m/s for 3
// mm. So with close readings a leap is over with the third one; with vague ones it may go on.
TEST(ManoeuvreFilter, ALeapIsOverSoonerTheBetterTheReadings) {
  double told = 0.0;
  EXPECT_LT(rms_after_leap({1.0, 0.0}, {-0.5, 0.0}, 3, told, 0.003), 0.12);
  EXPECT_LT(told, 0.15);
  const double error = rms_after_leap({1.0, 0.0}, {-0.5, 0.0}, 5, told, 0.05);
  EXPECT_GT(told, 0.3);
  EXPECT_LT(error, 2.5 * told);
}

TEST(ManoeuvreFilter, AnEarlierTimeChangesNothing) {
  ManoeuvreFilter filter({1.0, 2.0}, covariance_of(0.1), 1.0, 5.0, 0.8);
  filter.predict(4.0);
  EXPECT_EQ(filter.time(), 5.0);
  EXPECT_DOUBLE_EQ(filter.position_deviation(), 0.1);
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
