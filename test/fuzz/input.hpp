// SPDX-License-Identifier: BSD-3-Clause
// A fuzzer's bytes as values. Where they end, everything is zero, so that every byte string is a case.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace hidwa_local_planner::fuzz {

class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  std::size_t left() const { return left_; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  bool flag() { return (byte() & 1U) != 0; }
  /// Both ends included, at most 65536 values.
  int integer(int lo, int hi) {
    const unsigned bits = byte() | (hi - lo > 255 ? static_cast<unsigned>(byte()) << 8U : 0U);
    return lo + static_cast<int>(bits % static_cast<unsigned>(hi - lo + 1));
  }
  /// In [lo, hi], in 65536 steps.
  double within(double lo, double hi) {
    const unsigned bits = static_cast<unsigned>(byte()) << 8U | byte();
    return lo + (hi - lo) * (static_cast<double>(bits) / 65535.0);
  }
  /// Mostly in [lo, hi]; one in eight is anything that a double can be.
  double number(double lo, double hi) { return byte() % 8 == 7 ? anything() : within(lo, hi); }
  double anything() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kWild[] = {std::numeric_limits<double>::quiet_NaN(),
                                kInfinity,
                                -kInfinity,
                                0.0,
                                -0.0,
                                1e-300,
                                1e300,
                                -1e300,
                                1e-9,
                                1e6,
                                -1e6,
                                1e9,
                                2147483648.0,
                                4294967296.0,
                                std::numeric_limits<double>::denorm_min()};
    constexpr int kCount = sizeof(kWild) / sizeof(kWild[0]);
    const int which = byte() % (kCount + 1);
    if (which < kCount) return kWild[which];
    std::uint64_t bits = 0;
    for (int k = 0; k < 8; ++k) bits = bits << 8U | byte();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  /// At most `most` bytes.
  std::string text(std::size_t most) {
    const std::size_t size = most < left_ ? most : left_;
    std::string text(reinterpret_cast<const char*>(at_), size);
    at_ += size;
    left_ -= size;
    return text;
  }
  std::string rest() { return text(left_); }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace hidwa_local_planner::fuzz
