// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/distance_sweep.hpp"

#include <algorithm>
#include <cstring>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kLanes = DistanceSweep::kLanes;

// The lanes of two cells in one register.
typedef std::int16_t Lanes __attribute__((vector_size(16)));
typedef std::int64_t Halves __attribute__((vector_size(16)));

// By way of a register: through memory the narrow stores would stall the wide load.
inline Lanes load(const std::int16_t* one, const std::int16_t* other) {
  std::int64_t first, second;
  std::memcpy(&first, one, sizeof(first));
  std::memcpy(&second, other, sizeof(second));
  const Halves halves{first, second};
  return reinterpret_cast<Lanes>(halves);
}

inline void store(const Lanes& lanes, std::int16_t* one, std::int16_t* other) {
  const auto halves = reinterpret_cast<Halves>(lanes);
  const std::int64_t first = halves[0], second = halves[1];
  std::memcpy(one, &first, sizeof(first));
  std::memcpy(other, &second, sizeof(second));
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
    if (!cost::blocks(costs[i])) continue;
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

// Both directions along a row at once, in one register.
void run_along(const std::int16_t* __restrict taken, const std::int16_t* __restrict mask,
               std::int16_t* __restrict rightward, std::int16_t* __restrict leftward, std::size_t cells,
               std::int16_t straight) {
  const Lanes step = Lanes{} + straight;
  Lanes reached = Lanes{} + DistanceSweep::kFar;
  for (std::size_t i = 0, back = kLanes * (cells - 1); i < kLanes * cells; i += kLanes, back -= kLanes) {
    const Lanes known = load(taken + i, taken + back);
    reached = reached + (step + load(mask + i, mask + back));
    reached = reached < known ? reached : known;
    store(reached, rightward + i, leftward + back);
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
  units_.resize(kLanes * cells);
  mask_.resize(kLanes * cells);
  std::memset(units_.data(), kFar & 0xFF, units_.size() * sizeof(kFar));
  std::memset(mask_.data(), 0, mask_.size() * sizeof(kFar));
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
