// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/distance_sweep.hpp"

#include <algorithm>
#include <cstring>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kLanes = DistanceSweep::kLanes;

// The lanes of a cell in one register; its upper half idles.
typedef std::int16_t Lanes __attribute__((vector_size(16)));
typedef std::int64_t Halves __attribute__((vector_size(16)));

// By way of a register: through memory the narrow store would stall the wide load.
inline Lanes load(const std::int16_t* from) {
  std::int64_t bits;
  std::memcpy(&bits, from, sizeof(bits));
  const Halves halves{bits, 0};
  return reinterpret_cast<Lanes>(halves);
}

inline void store(const Lanes& lanes, std::int16_t* to) {
  const std::int64_t bits = reinterpret_cast<Halves>(lanes)[0];
  std::memcpy(to, &bits, sizeof(bits));
}

// Whether any of eight costs is 253 or more, inscribed, lethal or unknown: its highest bit is set, and adding 3 to the
// others carries into it.
inline bool may_block(const std::uint8_t* costs) {
  static_assert(cost::kInscribed == 253 && cost::kLethal == 254);
  std::uint64_t eight;
  std::memcpy(&eight, costs, sizeof(eight));
  return (((eight & 0x7F7F7F7F7F7F7F7FU) + 0x0303030303030303U) & eight & 0x8080808080808080U) != 0;
}

inline void block_some(const std::uint8_t* costs, int count, std::int16_t* mask) {
  for (int i = 0; i < count; ++i) {
    if (costs[i] != cost::kLethal && costs[i] != cost::kInscribed) continue;
    std::fill_n(mask + kLanes * static_cast<std::size_t>(i), kLanes, DistanceSweep::kFar);
  }
}

inline std::int16_t smaller(std::int16_t a, std::int16_t b) { return a < b ? a : b; }

// What the cells of a row become when each may take from the three next to it in row `from`. True when any changed.
HIDWA_VECTOR_CLONES
bool take_from(const std::int16_t* __restrict from, const std::int16_t* __restrict mask,
               const std::int16_t* __restrict row, std::int16_t* __restrict taken, std::size_t count,
               std::int16_t straight, std::int16_t diagonal) {
  std::int16_t changed = 0;
  const std::int16_t *before = from - kLanes, *behind = from + kLanes;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int16_t side = smaller(before[k], behind[k]);
    const auto across = static_cast<std::int16_t>(side + diagonal);
    const auto along = static_cast<std::int16_t>(from[k] + straight);
    const auto offer = static_cast<std::int16_t>(smaller(across, along) + mask[k]);
    const std::int16_t now = smaller(row[k], offer);
    changed = static_cast<std::int16_t>(changed | (now ^ row[k]));
    taken[k] = now;
  }
  return changed != 0;
}

// Both directions along a row at once: two independent chains, each a few cycles a cell.
void run_along(const std::int16_t* __restrict taken, const std::int16_t* __restrict mask,
               std::int16_t* __restrict rightward, std::int16_t* __restrict leftward, std::size_t cells,
               std::int16_t straight) {
  const Lanes step = Lanes{} + straight;
  Lanes right = Lanes{} + DistanceSweep::kFar;
  Lanes left = right;
  for (std::size_t i = 0, back = kLanes * (cells - 1); i < kLanes * cells; i += kLanes, back -= kLanes) {
    const Lanes ahead = load(taken + i);
    right = right + (step + load(mask + i));
    right = right < ahead ? right : ahead;
    store(right, rightward + i);
    const Lanes behind = load(taken + back);
    left = left + (step + load(mask + back));
    left = left < behind ? left : behind;
    store(left, leftward + back);
  }
}

HIDWA_VECTOR_CLONES
bool keep_smaller(const std::int16_t* __restrict rightward, const std::int16_t* __restrict leftward,
                  std::int16_t* __restrict row, std::size_t count) {
  std::int16_t changed = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int16_t now = smaller(rightward[k], leftward[k]);
    changed = static_cast<std::int16_t>(changed | (now ^ row[k]));
    row[k] = now;
  }
  return changed != 0;
}

}  // namespace

void DistanceSweep::reset(int width, int height, const Steps& steps) {
  width_ = width;
  height_ = height;
  stride_ = static_cast<std::size_t>(width) + 2;
  steps_ = steps;
  open_ = 0;
  const std::size_t cells = stride_ * (static_cast<std::size_t>(height) + 2);
  units_.assign(kLanes * cells, kFar);
  mask_.assign(kLanes * cells, 0);
  for (std::vector<std::int16_t>* row : {&taken_, &rightward_, &leftward_}) row->resize(kLanes * stride_);
  due_down_.assign(static_cast<std::size_t>(height), 0);
  due_up_.assign(static_cast<std::size_t>(height), 0);
}

void DistanceSweep::block_lethal_and_inscribed(int row, const std::uint8_t* costs) {
  std::int16_t* mask = mask_.data() + at({0, row});
  int i = 0;
  // The mask is 0 already, and most cells are free.
  for (; i + 8 <= width_; i += 8) {
    if (may_block(costs + i)) block_some(costs + i, 8, mask + kLanes * static_cast<std::size_t>(i));
  }
  block_some(costs + i, width_ - i, mask + kLanes * static_cast<std::size_t>(i));
}

void DistanceSweep::seed(int lane, Cell cell) {
  units_[at(cell) + static_cast<std::size_t>(lane)] = 0;
  due_down_[static_cast<std::size_t>(cell.j)] = 2;
}

void DistanceSweep::settle() {
  while (sweep(true) && sweep(false)) continue;
}

void DistanceSweep::settle_blocked() {
  for (std::int16_t& m : mask_) m = static_cast<std::int16_t>(m ^ kFar);
  open_ = static_cast<std::int16_t>(open_ ^ kFar);
  std::fill(due_down_.begin(), due_down_.end(), std::uint8_t{2});
  settle();
}

// True when there is more to do.
bool DistanceSweep::sweep(bool down) {
  std::vector<std::uint8_t>& due = down ? due_down_ : due_up_;
  for (int k = 0; k < height_; ++k) {
    const int row = down ? k : height_ - 1 - k;
    const auto r = static_cast<std::size_t>(row);
    if (due[r] == 0) continue;
    const bool anyhow = due[r] == 2;  // seeded: its own cells are to be run along
    due[r] = 0;
    const bool changed = update(row, down ? row - 1 : row + 1, anyhow);
    if (!changed && !anyhow) continue;
    if (row + 1 < height_) due_down_[r + 1] = std::max<std::uint8_t>(due_down_[r + 1], 1);
    if (row > 0) due_up_[r - 1] = std::max<std::uint8_t>(due_up_[r - 1], 1);
  }
  const auto pending = [](std::uint8_t d) { return d != 0; };
  return std::any_of(due_down_.begin(), due_down_.end(), pending) ||
         std::any_of(due_up_.begin(), due_up_.end(), pending);
}

bool DistanceSweep::update(int row, int from, bool anyhow) {
  const std::size_t first = at({0, row});
  const std::size_t count = kLanes * static_cast<std::size_t>(width_);
  const bool took = take_from(units_.data() + at({0, from}), mask_.data() + first, units_.data() + first, taken_.data(),
                              count, steps_.straight, steps_.diagonal);
  if (!took && !anyhow) return false;
  run_along(taken_.data(), mask_.data() + first, rightward_.data(), leftward_.data(), static_cast<std::size_t>(width_),
            steps_.straight);
  return keep_smaller(rightward_.data(), leftward_.data(), units_.data() + first, count);
}

}  // namespace hidwa_local_planner
