// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// Finds the node of a bin: a hash table with open addressing (linear probing). Emptying it costs nothing: every slot
/// says which search it was filled for.
class BinTable {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Room for `bins` of them. Empty.
  void reset(std::size_t bins) {
    std::size_t size = 1;
    while (size < 2 * bins) size *= 2;
    if (slots_.size() != size || ++search_ == 0) {
      slots_.assign(size, Slot{});
      search_ = 1;
    }
  }
  /// The node of a bin; kNone where it has none.
  std::uint32_t find(std::uint64_t bin) const {
    const Slot& slot = slots_[place_of(bin)];
    return slot.search == search_ ? slot.node : kNone;
  }
  /// Of at most as many bins as there is room for.
  void set(std::uint64_t bin, std::uint32_t node) { slots_[place_of(bin)] = {bin, node, search_}; }

 private:
  // The bin's slot, or a free one for it.
  std::size_t place_of(std::uint64_t bin) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>((bin * 0x9E3779B97F4A7C15ULL) >> 32) & mask;
    while (slots_[i].search == search_ && slots_[i].bin != bin) i = (i + 1) & mask;
    return i;
  }

  struct Slot {
    std::uint64_t bin = 0;
    std::uint32_t node = kNone;
    std::uint32_t search = 0;  // that it belongs to; 0: none
  };
  std::vector<Slot> slots_;
  std::uint32_t search_ = 0;
};

}  // namespace hidwa_local_planner
