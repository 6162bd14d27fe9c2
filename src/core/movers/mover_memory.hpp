// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// What is remembered of single moving obstacles from one cycle to the next, of kMost at once. One has an `id`.
template <typename One>
class MoverMemory {
 public:
  static constexpr std::size_t kMost = 64;

  MoverMemory() {
    before_.reserve(kMost);
    now_.reserve(kMost);
  }
  void forget() {
    before_.clear();
    now_.clear();
  }
  /// Once a cycle, before anything is kept in it.
  void begin() {
    before_.swap(now_);
    now_.clear();
  }
  bool any() const { return !now_.empty(); }
  bool full() const { return now_.size() >= kMost; }
  const One& keep(const One& one) {
    now_.push_back(one);
    return now_.back();
  }
  /// What was kept in the cycle before, and in this one; null: nothing.
  const One* before(std::uint32_t id) const { return find(before_, id); }
  const One* now(std::uint32_t id) const { return find(now_, id); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.now_);
  }

 private:
  static const One* find(const std::vector<One>& all, std::uint32_t id) {
    const auto found = std::find_if(all.begin(), all.end(), [id](const One& one) { return one.id == id; });
    return found != all.end() ? &*found : nullptr;
  }

  std::vector<One> before_, now_;
};

}  // namespace hidwa_local_planner
