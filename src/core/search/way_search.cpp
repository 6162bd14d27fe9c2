// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/way_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace {

// Poses that are remembered, and bins.
constexpr std::size_t kMostNodes = std::size_t{1} << 18;

constexpr std::size_t kMostQueued = 2 * kMostNodes;

// That can be left: once in each pass.
constexpr std::int64_t kMostPoses = 2 * std::int64_t{kMostNodes};

// Memory is kept for so many stations of a way.
constexpr std::size_t kUsualStations = 1024;

// Clearances count up to so many cells.
constexpr double kClearanceCells = 1.0;

// The clearance that a move needs: a share of a cell, or of the most that the robot has had so far.
constexpr double kNeededOfCell = 0.0625;
constexpr double kNeededOfMost = 0.8;

// Below this share of a cell, of 0.05 m at most, the robot all but touches.
constexpr double kTouchesBelow = 0.25;

// How much longer a move counts without any clearance, and where it has less than a robot usually needs.
constexpr double kTightFactor = 3.0;
constexpr double kTouchingFactor = 10.0;

// A change between forwards, backwards and turning takes so long [s].
constexpr double kChangeTime = 0.3;

// The distance to the target counts so much: above 1 it finds sooner, and a way that is longer by no more than that.
constexpr double kGreed = 1.6;

// A way is smoothed so often. Twice takes away most of the weaving; more often, stations that stay stand out, and a
// robot stops there.
constexpr int kSmoothings = 2;

// All around the robot so far away nothing is near: poses are coarse there [cells].
constexpr double kOpenCells = 3.0;

// From 0 to the last of a whole turn.
int whole(int heading) { return (heading + kHeadings) % kHeadings; }

}  // namespace

Rotation WaySearch::rotation(int heading) const { return rotations_[static_cast<std::size_t>(whole(heading))]; }

double WaySearch::heading_of(int heading) const { return wrap_angle(task_.start.theta + heading * kHeadingStep); }

void WaySearch::reserve() {
  if (nodes_.capacity() >= kMostNodes) return;
  nodes_.resize(kMostNodes);  // written once: reserved memory is provided when it is first used
  nodes_.clear();
  queue_.resize(kMostQueued);
  queue_.clear();
  bins_.reset(kMostNodes);
}

void WaySearch::begin(const SearchTask& task) {
  const bool same_robot = task.outline == task_.outline && task.radius == task_.radius && !footprint_.empty();
  task_ = task;
  if (!same_robot) footprint_ = task_.footprint();
  prepare();
  poses_ = 0;
  end_ = Node();
  least_left_ = std::numeric_limits<double>::infinity();
  begin_pass(Pass::coarse);
}

// A search that is under way here is gone on with, if it is the same one.
void WaySearch::repeat(bool searching, const SearchTask& task, std::int64_t poses) {
  if (!searching || poses < 0 || poses > kMostPoses || !task.plausible()) return clear();
  if (state_ != State::searching || poses < poses_ || !(task == task_)) begin(task);
  run(static_cast<int>(poses - poses_));
}

void WaySearch::prepare() {
  const Pose2 middle{task_.map.origin_x + 0.5 * task_.map.size_x * task_.map.resolution,
                     task_.map.origin_y + 0.5 * task_.map.size_y * task_.map.resolution, 0.0};
  const double across = 0.5 * std::max(task_.map.size_x, task_.map.size_y) * task_.map.resolution;
  checker_.prepare(task_.grid(), footprint_, task_.unknown_is_obstacle, middle, across, task_.map.resolution / 16.0,
                   kClearanceCells * task_.map.resolution);
  to_target_.prepare(task_, checker_);
  rotations_.resize(kHeadings);
  for (int k = 0; k < kHeadings; ++k) {
    const double heading = task_.start.theta + k * kHeadingStep;
    rotations_[static_cast<std::size_t>(k)] = Rotation::direction(heading);
  }
  reserve();
  placed_.reserve(footprint_.outline().size());
}

void WaySearch::begin_pass(Pass pass) {
  pass_ = pass;
  moves_.make(task_, footprint_.circumscribed_radius(), pass);
  nodes_.clear();
  queue_.clear();
  bins_.reset(kMostNodes);
  state_ = State::no_way;
  add_start();
}

void WaySearch::add_start() {
  Node node;
  node.x = task_.start.x;
  node.y = task_.start.y;
  node.clearance = static_cast<float>(clearance_at(task_.start, rotation(0)));
  node.needed = needed_from(node.clearance, 0.0);
  if (node.clearance <= 0.0F || bound(node) < 0.0) {
    end_ = node;  // the end() of a robot that comes nowhere
    return;
  }
  state_ = State::searching;
  push(node);
}

WaySearch::State WaySearch::run(int poses) {
  for (int k = 0; k < poses && state_ == State::searching; ++k) {
    while (!queue_.empty() && nodes_[queue_.front().node].left) {
      std::pop_heap(queue_.begin(), queue_.end());
      queue_.pop_back();
    }
    if (queue_.empty() && pass_ == Pass::coarse) begin_pass(Pass::close);
    if (queue_.empty()) {
      state_ = State::no_way;
      break;
    }
    const std::uint32_t next = queue_.front().node;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    ++poses_;
    leave(next);
  }
  return state_;
}

void WaySearch::leave(std::uint32_t from) {
  Node& node = nodes_[from];
  node.left = true;
  const double left = to_target_.at(node.x, node.y);
  if (left >= 0.0 && left < least_left_) {
    least_left_ = left;
    end_ = node;
  }
  if (left == 0.0 && turn_left(node) <= task_.heading_off) {
    end_ = node;
    state_ = State::found;
    return;
  }
  const MoveSet& moves = moves_.of(fineness(node));
  for (const Move& move : moves.moves) try_move(from, move);
}

void WaySearch::try_move(std::uint32_t from, const Move& move) {
  const Node start = nodes_[from];
  const Rotation r = rotation(start.heading);
  Node end = start;
  const Point place = r.placed(start.x, start.y, move.x, move.y);
  end.x = place.x();
  end.y = place.y();
  end.heading = static_cast<std::int16_t>(whole(start.heading + move.turn));
  end.parent = static_cast<std::int32_t>(from);
  end.move = static_cast<std::uint8_t>(move.kind);
  end.left = false;
  if (!task_.grid().contains(task_.grid().cell_at(end.x, end.y))) return;
  const bool changes = start.move != end.move && start.move != static_cast<std::uint8_t>(MoveKind::none);
  const double soonest = start.time + move.time + (changes ? kChangeTime : 0.0);
  // What is certainly too late need not be looked at more closely.
  end.clearance = static_cast<float>(kClearanceCells * task_.map.resolution);
  end.time = static_cast<float>(soonest);
  const std::uint32_t known = bins_.find(bin_of(end));
  if (known != BinTable::kNone && nodes_[known].time <= end.time) return;
  const Clearance clearance = clearance_along(start, move);
  if (clearance.least <= 0.0) return;
  end.clearance = static_cast<float>(clearance.at_end);
  end.needed = needed_from(clearance.at_end, start.needed);
  end.time = static_cast<float>(soonest + tightness(move, clearance.least) * move.time);
  push(end);
}

// How much longer a move counts. A circle that turns comes no nearer to anything.
double WaySearch::tightness(const Move& move, double clearance) const {
  if (move.kind == MoveKind::turn && footprint_.is_circle()) return 0.0;
  const double tight = 1.0 - clearance / (kClearanceCells * task_.map.resolution);
  const double touching = std::max(0.0, 1.0 - clearance / (kNeededOfCell * task_.map.resolution));
  return kTightFactor * tight + kTouchingFactor * touching;
}

float WaySearch::needed_from(double clearance, double needed) const {
  return static_cast<float>(
      std::max(needed, std::min(kNeededOfCell * task_.map.resolution, kNeededOfMost * clearance)));
}

WaySearch::Clearance WaySearch::clearance_along(const Node& from, const Move& move) const {
  const double needed = from.needed;
  if (move.kind == MoveKind::turn && footprint_.is_circle()) return {from.clearance, from.clearance};
  const Rotation r = rotation(from.heading);
  Clearance found{from.clearance, from.clearance};
  double gone = std::max(0.0, from.clearance - needed) / move.reach;
  while (true) {
    const double share = std::min(gone, 1.0);
    const Pose2 part = part_of(move, share);
    const Rotation turned = share >= 1.0 ? rotation(from.heading + move.turn) : r.turned(Rotation::of(part.theta));
    const Point place = r.placed(from.x, from.y, part.x, part.y);
    found.at_end = clearance_at({place.x(), place.y(), 0.0}, turned);
    if (found.at_end < needed || found.at_end <= 0.0) return {};
    found.least = std::min(found.least, found.at_end);
    if (share >= 1.0) return found;
    // At least half of what is needed: it ends, and what lies between is free still.
    gone = share + std::max(found.at_end - 0.5 * needed, 0.5 * needed) / move.reach;
  }
}

// Up to a cell [m].
double WaySearch::clearance_at(const Pose2& position, const Rotation& heading) const {
  return checker_.clearance(position, heading, kClearanceCells * task_.map.resolution);
}

Fineness WaySearch::fineness(const Node& node) const {
  if (node.clearance < kTouchesBelow * std::min(task_.map.resolution, kUsualCell)) return Fineness::touching;
  return checker_.clear_around(node.x, node.y, kOpenCells * task_.map.resolution) ? Fineness::open : Fineness::tight;
}

std::uint64_t WaySearch::bin_of(const Node& node) const {
  const Fineness fine = fineness(node);
  const MoveSet& set = moves_.of(fine);
  const auto i = static_cast<std::uint64_t>((node.x - task_.map.origin_x) / set.bin);
  const auto j = static_cast<std::uint64_t>((node.y - task_.map.origin_y) / set.bin);
  const auto k = static_cast<std::uint64_t>(node.heading / set.heading_bin);
  return (((static_cast<std::uint64_t>(fine) << 20 | i) << 20 | j) << 9) | k;
}

void WaySearch::push(const Node& node) {
  const std::uint64_t bin = bin_of(node);
  const std::uint32_t known = bins_.find(bin);
  if (known != BinTable::kNone && nodes_[known].time <= node.time) return;
  const double later = bound(node);
  if (later < 0.0) return;
  if (nodes_.size() >= kMostNodes) {
    state_ = State::cut_short;
    return;
  }
  if (known != BinTable::kNone) nodes_[known].left = true;  // the new one is quicker
  const auto fresh = static_cast<std::uint32_t>(nodes_.size());
  bins_.set(bin, fresh);
  nodes_.push_back(node);
  queue_.push_back({static_cast<float>(later), fresh});
  std::push_heap(queue_.begin(), queue_.end());
}

// The time by way of a node, nearly at least [s]; negative where nothing leads on from there.
double WaySearch::bound(const Node& node) {
  const double left = to_target_.at(node.x, node.y);
  if (left < 0.0) return -1.0;
  const double driving = left / std::max(task_.forward, task_.backward);
  const double turn = turn_left(node) - task_.heading_off;
  const double turning = turn > 0.0 && task_.turning > 0.0 ? turn / task_.turning : 0.0;
  return node.time + kGreed * std::max(driving, turning);
}

// To the heading that the way has to end with [rad].
double WaySearch::turn_left(const Node& node) const {
  return std::abs(wrap_angle(task_.heading - heading_of(node.heading)));
}

void WaySearch::write(Way& way) const {
  way.clear();
  way.reserve(kUsualStations);
  if (state_ != State::found) return;
  double left = 0.0;
  for (const Node* node = &end_;;) {
    way.add({{node->x, node->y, heading_of(node->heading)}, left});
    if (node->parent < 0) break;
    const Node* before = &nodes_[static_cast<std::size_t>(node->parent)];
    left += time_between(*before, *node);
    node = before;
  }
  way.reverse();
  // Its headings step by step are those of its moves: a robot that keeps to them weaves. No station comes nearer to
  // anything.
  const auto may_go = [&](const Pose2& from, const Pose2& to) {
    return clearance_at(to, Rotation::of(to.theta)) >= clearance_at(from, Rotation::of(from.theta));
  };
  for (int k = 0; k < kSmoothings; ++k) way.smooth(may_go);
}

// At the limits: what clearances and changes count besides is for choosing a way [s].
double WaySearch::time_between(const Node& a, const Node& b) const {
  const double turn = std::abs(heading_of(b.heading) - heading_of(a.heading));
  const bool backward = b.move == static_cast<std::uint8_t>(MoveKind::backward);
  const double speed = backward ? task_.backward : task_.forward;
  const double driving =
      b.move == static_cast<std::uint8_t>(MoveKind::turn) ? 0.0 : std::hypot(b.x - a.x, b.y - a.y) / speed;
  return std::max(driving, task_.turning > 0.0 ? std::abs(wrap_angle(turn)) / task_.turning : 0.0);
}

WaySearch::End WaySearch::end() {
  End end;
  if (rotations_.empty()) return end;  // never begun
  const Node& node = end_;
  const Rotation r = rotation(node.heading);
  end.pose = {node.x, node.y, heading_of(node.heading)};
  placed_.clear();
  for (const Point& p : footprint_.outline()) placed_.push_back(r.placed(node.x, node.y, p.x(), p.y()));
  end.gap = std::numeric_limits<double>::infinity();
  for (int j = 0; j < task_.map.size_y; ++j) {
    for (int i = 0; i < task_.map.size_x; ++i) {
      const Point centre = task_.grid().centre({i, j});
      const double gap = checker_.obstacle({i, j}) ? gap_to(end.pose, centre) : end.gap;
      if (gap >= end.gap) continue;
      end.gap = gap;
      end.obstacle = centre;
      end.obstacle_known = true;
      end.unknown = task_.grid().at({i, j}) == cost::kUnknown;
    }
  }
  return end;
}

// From the outline at end() to a cell [m].
double WaySearch::gap_to(const Pose2& pose, const Point& centre) const {
  const double side = task_.map.resolution, x = centre.x() - 0.5 * side, y = centre.y() - 0.5 * side;
  if (footprint_.is_circle()) {
    const double dx = std::max(std::abs(centre.x() - pose.x) - 0.5 * side, 0.0);
    const double dy = std::max(std::abs(centre.y() - pose.y) - 0.5 * side, 0.0);
    return std::max(std::hypot(dx, dy) - footprint_.radius(), 0.0);
  }
  return overlaps_square(placed_, x, y, side) ? 0.0 : distance_to_square(placed_, x, y, side);
}

}  // namespace hidwa_local_planner
