// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/util/archive.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

enum class Colour { red, green };

struct Everything {
  bool flag = true;
  int whole = -7;
  double number = -0.0;
  float small = 0.1F;
  Colour colour = Colour::green;
  std::string text = "a b";
  std::optional<double> maybe = 2.5;
  std::optional<bool> nothing;
  Polygon corners{{1.0, 2.0}, {3.0, 4.0}};
  Pose2 pose{1.0, 2.0, 3.0};
  Twist2 u{0.1, 0.2};
  Bytes bytes = Bytes(3, 255);

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.flag, self.whole, self.number, self.small, self.colour, self.text, self.maybe, self.nothing, self.corners,
       self.pose, self.u, self.bytes);
  }
};

Bytes bytes_of(const Everything& all) {
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(all);
  return bytes;
}

Everything changed() {
  Everything all;
  all.flag = false;
  all.whole = std::numeric_limits<int>::min();
  all.number = std::nan("");
  all.small = -1.0F;
  all.colour = Colour::red;
  all.text.clear();
  all.maybe.reset();
  all.nothing = true;
  all.corners.clear();
  all.pose = {};
  all.u = {-1e-300, INFINITY};
  all.bytes.clear();
  return all;
}

// Read into something else, what was written is there again: to the same bytes.
TEST(Archive, WhatIsReadIsWhatWasWritten) {
  for (const auto& [from, into] : {std::pair{Everything(), changed()}, std::pair{changed(), Everything()}}) {
    Everything read_back = into;
    const Bytes bytes = bytes_of(from);
    ArchiveReader read(bytes);
    read(read_back);
    EXPECT_TRUE(read.complete());
    EXPECT_EQ(bytes_of(read_back), bytes);
  }
  // 1 + 4 + 8 + 4 + 4, text 4 + 3, maybe 1 + 8, nothing 1, corners 4 + 2 x 16, pose 24, u 16, bytes 4 + 3
  EXPECT_EQ(bytes_of(Everything()).size(), 21u + 7u + 9u + 1u + 36u + 24u + 16u + 7u);
}

TEST(Archive, CutAnywhereItFailsAndReadsNothingBeyond) {
  const Bytes bytes = bytes_of(Everything());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
    ArchiveReader read(cut);
    Everything all;
    read(all);
    EXPECT_TRUE(read.failed()) << n;
    EXPECT_FALSE(read.complete()) << n;
  }
}

TEST(Archive, MoreThanWasAskedForIsNotComplete) {
  Bytes bytes = bytes_of(Everything());
  bytes.push_back(0);
  ArchiveReader read(bytes);
  Everything all;
  read(all);
  EXPECT_FALSE(read.failed());
  EXPECT_FALSE(read.complete());
}

// A length that lies is no reason to ask for 4 GB.
TEST(Archive, ALengthBeyondTheEndIsAFailure) {
  const Bytes bytes{255, 255, 255, 255, 1, 2, 3};
  ArchiveReader read(bytes);
  Polygon corners;
  read(corners);
  EXPECT_TRUE(read.failed());
  EXPECT_TRUE(corners.empty());
}

}  // namespace
}  // namespace hidwa_local_planner
