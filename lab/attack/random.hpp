// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>

namespace hidwa_attack {

/// Random numbers that are the same everywhere: a 64-bit xorshift, multiplied (Vigna 2016), seeded by a hash.
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (int turn = 0; turn < 2; ++turn) {
      seed = (seed ^ (seed >> 33)) * 0xff51afd7ed558ccdULL + 0x2545f4914f6cdd1dULL;
    }
    state_ = seed | 1U;
    bits();
  }
  std::uint64_t bits() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return state_ * 0x2545f4914f6cdd1dULL;
  }
  /// In [lo, hi).
  double in(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(bits() >> 11) / 9007199254740992.0; }
  /// From lo to hi, both included.
  int whole(int lo, int hi) { return lo + static_cast<int>((bits() >> 32) % static_cast<std::uint64_t>(hi - lo + 1)); }
  bool chance(double probability) { return in(0.0, 1.0) < probability; }
  template <typename T>
  T of(std::initializer_list<T> values) {
    return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace hidwa_attack
