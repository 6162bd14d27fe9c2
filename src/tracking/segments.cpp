// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/segments.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr int kMostCuts = 3;        // of a cut surface
constexpr double kBeyond = 0.5;     // half of a large body [m]
constexpr double kDentNoise = 5.0;  // deviations of a range more
constexpr double kDent = 0.03;      // depth of a dent where two bodies meet, without noise [m]
constexpr double kNearer = 0.1;     // a neighbour nearer by so much may hide something [m]

bool movable(const Beam& beam) { return beam.hit && beam.kind != PlaceKind::standing; }

// True where the beam beside a segment's end beam does not show the end of the body itself.
bool hidden_beside(const Beams& beams, std::size_t end, bool forward) {
  const std::size_t n = beams.all.size();
  const bool border = forward ? end + 1 == n : end == 0;
  if (border && !beams.whole_turn) return true;
  const std::size_t beside = forward ? (border ? 0 : end + 1) : (border ? n - 1 : end - 1);
  const Beam& neighbour = beams.all[beside];
  const double length = beams.all[end].length;
  if (neighbour.length <= 0.0) return false;                               // nothing known: it is taken for the end
  if (!neighbour.hit && neighbour.length < length + kBeyond) return true;  // it may go on beyond the reach
  return neighbour.length < length - kNearer ||
         (neighbour.kind == PlaceKind::standing && neighbour.length < length + kNearer);
}

class SegmentFinder {
 public:
  SegmentFinder(const Beams& beams, double noise, double widest, std::vector<Segment>& out,
                std::vector<std::size_t>& hull)
      : beams_(beams), noise_(noise), widest_(widest), out_(out), hull_(hull) {
    hull_.reserve(beams.all.size());
  }

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
    add(current_, 0);
  }

  // Bodies that touch each other make one surface with a dent. Only what came into free space is taken apart: a corner
  // of a room is none.
  void add(const Segment& segment, int depth) {
    Segment near, far;
    if (depth < kMostCuts && 3 * segment.free_before >= segment.points && cut(segment, near, far)) {
      add(near, depth + 1);
      add(far, depth + 1);
      return;
    }
    out_.push_back(segment);
    Segment& added = out_.back();
    added.chord_begin = beams_.all[added.first].tip();
    added.chord_end = beams_.all[added.last].tip();
    if (added.chord() > widest_) {
      out_.pop_back();
      return;
    }
    added.hidden_first = added.hidden_first || hidden_beside(beams_, added.first, false);
    added.hidden_last = added.hidden_last || hidden_beside(beams_, added.last, true);
  }

  // Cuts a surface at its deepest dent, where that is deep enough. What lies on the dent's other side may hide more.
  bool cut(const Segment& segment, Segment& before, Segment& after) {
    const std::size_t at = deepest_dent(segment);
    if (at == segment.last) return false;
    before = after = segment;
    before.last = at;
    after.first = next(at);
    while (!beams_.all[after.first].hit) after.first = next(after.first);
    before.hidden_last = after.hidden_first = true;
    count(before);
    count(after);
    return true;
  }

  std::size_t next(std::size_t i) const { return i + 1 == beams_.all.size() ? 0 : i + 1; }

  void count(Segment& segment) const {
    segment.points = segment.free_before = 0;
    for_points(beams_, segment, [&](std::size_t i) {
      ++segment.points;
      if (beams_.all[i].kind == PlaceKind::was_free) ++segment.free_before;
    });
  }

  // Twice the area of the triangle from the sensor's side of a line through two beams' ends: positive, behind it.
  double behind(std::size_t a, std::size_t b, std::size_t i, double side) const {
    const Point u = beams_.all[b].tip() - beams_.all[a].tip(), v = beams_.all[i].tip() - beams_.all[a].tip();
    return side * (u.y() * v.x() - u.x() * v.y());
  }

  // The side of the convex hull that faces the sensor (Andrew's monotone chain: beams come in the order of bearing).
  void find_hull(const Segment& segment, double side) {
    hull_.clear();
    for_points(beams_, segment, [&](std::size_t i) {
      while (hull_.size() > 1 && behind(hull_[hull_.size() - 2], i, hull_.back(), side) >= 0.0) hull_.pop_back();
      hull_.push_back(i);
    });
  }

  // The point farthest behind the hull; the last one if none is deep.
  std::size_t deepest_dent(const Segment& segment) {
    const Point& eye = beams_.all[segment.first].origin;
    const Point begin = beams_.all[segment.first].tip() - eye, end = beams_.all[segment.last].tip() - eye;
    const double side = begin.x() * end.y() - begin.y() * end.x() >= 0.0 ? 1.0 : -1.0;
    find_hull(segment, side);
    std::size_t deepest = segment.last, corner = 0;
    double depth = kDent + kDentNoise * noise_;
    for_points(beams_, segment, [&](std::size_t i) {
      if (i == hull_[corner]) {
        corner = std::min(corner + 1, hull_.size() - 1);
        return;
      }
      const std::size_t a = hull_[corner - 1], b = hull_[corner];
      const double deep = behind(a, b, i, side) / (beams_.all[b].tip() - beams_.all[a].tip()).norm();
      if (deep <= depth) return;
      depth = deep;
      deepest = i;
    });
    return deepest;
  }

  const Beams& beams_;
  double noise_;
  double widest_;
  std::vector<Segment>& out_;
  std::vector<std::size_t>& hull_;  // indices of beams
  Segment current_;
  bool open_ = false;
  std::size_t silent_ = 0;
};

}  // namespace

void find_segments(const Beams& beams, double range_noise, double widest, std::vector<Segment>& out,
                   std::vector<std::size_t>& hull) {
  SegmentFinder(beams, range_noise, widest, out, hull).run();
}

}  // namespace tracking
}  // namespace hidwa_local_planner
