// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <move_base/recoveries.h>

#include <memory>
#include <string>

namespace move_base {
namespace {

typedef Recoveries::Trigger Trigger;

class Noted : public nav_core::RecoveryBehavior {
 public:
  Noted(std::string& log, const char* name) : log_(log), name_(name) {}
  void initialize(std::string, tf2_ros::Buffer*, costmap_2d::Costmap2DROS*, costmap_2d::Costmap2DROS*) override {}
  void runBehavior() override { log_ += name_; }

 private:
  std::string& log_;
  const char* name_;
};

class RecoveriesTest : public testing::Test {
 protected:
  RecoveriesTest() {
    for (const char* name : {"a", "b"}) {
      recoveries_.add(name, boost::shared_ptr<nav_core::RecoveryBehavior>(new Noted(log_, name)));
    }
  }
  void runAll() {
    while (recoveries_.left()) recoveries_.runNext();
  }

  std::string log_;
  Recoveries recoveries_;
};

TEST_F(RecoveriesTest, EachIsTriedOnceInOrder) {
  EXPECT_EQ(recoveries_.size(), 2u);
  EXPECT_EQ(recoveries_.nextName(), "a");
  recoveries_.runNext();
  EXPECT_EQ(recoveries_.nextName(), "b");
  EXPECT_EQ(recoveries_.nextNumber(), 1u);
  recoveries_.runNext();
  EXPECT_FALSE(recoveries_.left());
  EXPECT_EQ(log_, "ab");
}

TEST_F(RecoveriesTest, OnlyWhatAskedForThemBeginsThemAnew) {
  recoveries_.askedBy(Trigger::kControlling);
  runAll();
  recoveries_.helped(Trigger::kPlanning);
  recoveries_.helped(Trigger::kOscillation);
  EXPECT_FALSE(recoveries_.left());
  recoveries_.helped(Trigger::kControlling);
  runAll();
  EXPECT_EQ(log_, "abab");
}

TEST_F(RecoveriesTest, AGoalBeginsThemAnew) {
  recoveries_.askedBy(Trigger::kOscillation);
  runAll();
  recoveries_.reset();
  EXPECT_TRUE(recoveries_.left());
  EXPECT_EQ(recoveries_.trigger(), Trigger::kPlanning);
}

}  // namespace
}  // namespace move_base
