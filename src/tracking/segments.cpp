// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/segments.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr std::size_t kSilentBeams = 2;   // may lie between two points of a surface
constexpr double kStep = 0.12;            // between neighbouring points of a surface, at no distance [m]
constexpr double kStepsPerSpacing = 2.5;  // more at a distance: so many times the distance between beams
constexpr double kWidestStep = 0.35;      // [m]
constexpr double kNearer = 0.1;           // a neighbour nearer by so much may hide something [m]

bool movable(const Beam& beam) { return beam.hit && beam.kind != PlaceKind::standing; }

bool same_surface(const Beams& beams, std::size_t a, std::size_t b, std::size_t steps, double noise) {
  const Beam& one = beams.all[a];
  const Beam& other = beams.all[b];
  const double spacing = std::min(one.length, other.length) * beams.increment * static_cast<double>(steps);
  const double limit = std::min(kStep + 3.0 * noise + kStepsPerSpacing * spacing, kWidestStep + 3.0 * noise);
  return (one.tip() - other.tip()).norm() <= limit;
}

// True where the beam beside a segment's end beam does not show the end of the body itself.
bool hidden_beside(const Beams& beams, std::size_t end, bool forward) {
  const std::size_t n = beams.all.size();
  const bool border = forward ? end + 1 == n : end == 0;
  if (border && !beams.whole_turn) return true;
  const std::size_t beside = forward ? (border ? 0 : end + 1) : (border ? n - 1 : end - 1);
  const Beam& neighbour = beams.all[beside];
  const double length = beams.all[end].length;
  if (neighbour.length <= 0.0) return false;  // nothing known: it is taken for the end
  return neighbour.length < length - kNearer ||
         (neighbour.kind == PlaceKind::standing && neighbour.length < length + kNearer);
}

class SegmentFinder {
 public:
  SegmentFinder(const Beams& beams, double noise, double widest, std::vector<Segment>& out)
      : beams_(beams), noise_(noise), widest_(widest), out_(out) {}

  void run() {
    out_.clear();
    const std::size_t n = beams_.all.size();
    const std::size_t start = start_index();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (start + k) % n;
      if (movable(beams_.all[i])) {
        take(i);
      } else if (beams_.all[i].length > 0.0 || ++silent_ > kSilentBeams) {
        close();  // a longer beam, one that ends at what stands, or too many that say nothing
      }
    }
    close();
  }

 private:
  // In a whole turn no segment may be cut where the scan begins: it is gone through from the first cut on.
  std::size_t start_index() const {
    const std::size_t n = beams_.all.size();
    if (!beams_.whole_turn) return 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i == 0 ? n - 1 : i - 1;
      const bool joined =
          movable(beams_.all[i]) && movable(beams_.all[before]) && same_surface(beams_, before, i, 1, noise_);
      if (!joined && beams_.all[before].length > 0.0) return i;
    }
    return 0;
  }

  void take(std::size_t i) {
    if (open_ && !same_surface(beams_, current_.last, i, silent_ + 1, noise_)) close();
    if (!open_) {
      current_ = Segment();
      current_.first = i;
      open_ = true;
    }
    current_.last = i;
    ++current_.points;
    if (beams_.all[i].kind == PlaceKind::was_free) ++current_.free_before;
    silent_ = 0;
  }

  void close() {
    silent_ = 0;
    if (!open_) return;
    open_ = false;
    current_.chord_begin = beams_.all[current_.first].tip();
    current_.chord_end = beams_.all[current_.last].tip();
    if (current_.chord() > widest_) return;
    current_.hidden_first = hidden_beside(beams_, current_.first, false);
    current_.hidden_last = hidden_beside(beams_, current_.last, true);
    out_.push_back(current_);
  }

  const Beams& beams_;
  double noise_;
  double widest_;
  std::vector<Segment>& out_;
  Segment current_;
  bool open_ = false;
  std::size_t silent_ = 0;
};

}  // namespace

void find_segments(const Beams& beams, double range_noise, double widest, std::vector<Segment>& out) {
  SegmentFinder(beams, range_noise, widest, out).run();
}

}  // namespace tracking
}  // namespace hidwa_local_planner
