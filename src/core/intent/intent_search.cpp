// SPDX-License-Identifier: BSD-3-Clause
#include "core/intent/intent_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/intent/held_direction.hpp"

namespace hidwa_local_planner {
namespace {

// The look-ahead distance, beyond the outline: a part for geometry, and a part that grows with the speed.
constexpr double kAheadLeast = 1.2;  // [m]
constexpr double kAheadTime = 1.5;   // [s]
constexpr double kAheadMost = 2.5;   // [m]

// A path of an operator who turns goes on for no more than this [rad].
constexpr double kMostTurn = 1.5;

// An arc of the search, and the poses that it keeps.
constexpr double kArc = 0.15;  // [m]
constexpr std::size_t kMostNodes = 2500;

// Poses of one bin are alike: its side, and its heading.
constexpr double kBin = 0.06;         // [m]
constexpr double kHeadingBin = 0.04;  // [rad]

// The sharpest bend: the robot slows down for it [1/m], [m/s].
constexpr double kSharpest = 2.5;
constexpr double kBendSpeed = 0.25;

// What a path costs beyond its length, per metre: all off the direction, and without clearance.
constexpr double kOffCost = 0.4;
constexpr double kTightCost = 4.0;
constexpr double kBendCost = 0.02;  // [m] for 1/m of change
constexpr double kTurnCost = 0.5;   // a turn on the spot first [m]
constexpr double kSideCost = 0.3;   // another side than before [m]

// Least extra progress of a path where the operator's own motion is blocked [m].
constexpr double kFarther = 0.3;

// The least clearance of an arc, as a share of a cell, and of the one that the robot has at the start.
constexpr double kNeededOfCell = 0.25;
constexpr double kNeededOfStart = 0.8;

// Distance to the target of pure pursuit: at rest [m], and its growth with the speed [s].
constexpr double kAim = 0.35;
constexpr double kAimTime = 0.3;

// Turns on the spot that are tried first [rad].
constexpr double kTurnStep = 0.08;

// Duration of a first turn on the spot [s].
constexpr double kTurnTime = 0.5;

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

}  // namespace

IntentSearch::IntentSearch() {
  nodes_.reserve(kMostNodes);
  queue_.reserve(kMostNodes);
}

IntentSearch::Result IntentSearch::run(const Cycle& cycle, const Request& request) {
  const double v = std::abs(request.wanted.v);
  if (v * kSharpest < std::abs(request.wanted.omega) || v <= 0.0) return {request.wanted, 0};  // about on the spot
  prepare(cycle, request);
  const Result own{{request.wanted.v, request.wanted.omega + v * bend_home(request.off)}, 0};
  Node start;
  start.pose = request.start;
  start.off = request.off;
  start.clearance = clearance_at(start.pose);
  if (start.clearance <= 0.0) return own;
  needed_ = std::min(kNeededOfCell * cycle.grid.resolution, kNeededOfStart * start.clearance);
  const Node kept = own_motion(start);
  if (kept.progress >= ahead_ && kept.clearance >= comfort_) return own;
  const int last = search(start, request.side);
  const Node& end = nodes_[static_cast<std::size_t>(last)];
  if (kept.progress < ahead_ && end.progress < kept.progress + kFarther) return own;
  return aim(last, request);
}

void IntentSearch::prepare(const Cycle& cycle, const Request& request) {
  cycle_ = &cycle;
  const double v = std::abs(request.wanted.v), cell = cycle.grid.resolution;
  const double radius = cycle.footprint.circumscribed_radius();
  forward_ = request.wanted.v < 0.0 ? -1.0 : 1.0;
  curvature_ = request.wanted.omega / v;
  ahead_ = radius + std::clamp(kAheadTime * v, kAheadLeast, kAheadMost);
  if (curvature_ != 0.0) ahead_ = std::min(ahead_, kMostTurn / std::abs(curvature_));
  comfort_ = std::max(2.0 * cell, 0.15);
  counted_ = comfort_ + 2.0 * cell;
  sharpest_ = std::min(kSharpest, cycle.start.limits.theta.max / kBendSpeed);
  gentle_ = 0.25 * sharpest_;
  origin_ = request.start;
  checker_.prepare(cycle.grid, cycle.footprint, cycle.parameters.unknown_is_obstacle, request.start,
                   1.2 * ahead_ + kArc, cell / 16.0, counted_);
}

// What moves counts where it is now.
double IntentSearch::clearance_at(const Pose2& pose) const {
  const Rotation heading = Rotation::of(pose.theta);
  double clearance = checker_.clearance(pose, heading, counted_);
  for (const MovingObstacleEstimate& mover : cycle_->situation.moving_obstacles) {
    const Point to = mover.position_now() - Point(pose.x, pose.y);
    const Point seen = heading.undo(to);
    const double reach = cycle_->footprint.circumscribed_radius() + mover.radius + counted_;
    if (seen.squaredNorm() > reach * reach) continue;
    clearance = std::min(clearance, std::max(0.0, cycle_->footprint.distance_to(seen) - mover.radius));
  }
  return clearance;
}

Pose2 IntentSearch::after(const Pose2& from, const Arc& arc) const {
  const double turn = arc.curvature * arc.length;
  const double half = 0.5 * turn;
  const double chord = forward_ * arc.length * (std::abs(half) > 1e-6 ? std::sin(half) / half : 1.0);
  return {from.x + chord * std::cos(from.theta + half), from.y + chord * std::sin(from.theta + half),
          from.theta + turn};
}

// Goes on along an arc. Returns the least clearance of its poses; 0 where that is too little: then `node` stays.
double IntentSearch::go_along(const Arc& arc, Node& node) const {
  const double cell = cycle_->grid.resolution;
  const double reach = arc.length * (1.0 + std::abs(arc.curvature) * cycle_->footprint.circumscribed_radius());
  Pose2 pose;
  double least = node.clearance, clearance = node.clearance;
  for (double gone = 0.0; gone < reach;) {
    gone = std::min(reach, gone + std::max(clearance - needed_, 0.5 * cell));
    pose = after(node.pose, {arc.length * (gone / reach), arc.curvature});
    clearance = clearance_at(pose);
    if (clearance < needed_) return 0.0;
    least = std::min(least, clearance);
  }
  node.pose = pose;
  node.clearance = clearance;
  return least;
}

// The curvature that leads back to the operator's direction [1/m].
double IntentSearch::bend_home(double off) const { return std::clamp(-off / (2.0 * kArc), -gentle_, gentle_); }

// How far the operator's own motion leads, and its least clearance.
IntentSearch::Node IntentSearch::own_motion(const Node& start) const {
  Node end = start;
  double least = start.clearance;
  while (end.progress < ahead_) {
    const double bend = bend_home(end.off);
    const double clearance = go_along({kArc, curvature_ + bend}, end);
    if (clearance <= 0.0) break;
    least = std::min(least, clearance);
    end.off += bend * kArc;
    end.progress += kArc * std::cos(end.off);
  }
  end.clearance = least;
  return end;
}

// Returns the node that leads farthest; of those that lead to the end the cheapest.
int IntentSearch::search(const Node& start, int side) {
  nodes_.clear();
  queue_.clear();
  bins_.reset(kMostNodes);
  push(start);
  turn_first(start, side);
  std::uint32_t farthest = 0;
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end());
    const std::uint32_t next = queue_.back().second;
    queue_.pop_back();
    if (nodes_[next].progress > nodes_[farthest].progress) farthest = next;
    if (nodes_[next].progress >= ahead_ || nodes_.size() >= kMostNodes) break;
    leave(next, side);
  }
  return static_cast<int>(farthest);
}

void IntentSearch::leave(std::uint32_t from, int side) {
  const Node node = nodes_[from];
  for (const double tried : {0.0, gentle_, -gentle_, sharpest_, -sharpest_, bend_home(node.off)}) {
    Node end = node;
    const double most = std::max(HeldDirection::kMost, std::abs(node.off));
    end.off = std::clamp(node.off + tried * kArc, -most, most);
    const double bend = (end.off - node.off) / kArc;
    const double least = go_along({kArc, curvature_ + bend}, end);
    if (least <= 0.0) continue;
    const double middle = 0.5 * (node.off + end.off), share = end.off / HeldDirection::kMost;
    end.progress = node.progress + kArc * std::cos(middle);
    end.bend = bend;
    end.parent = static_cast<std::int32_t>(from);
    end.cost += kArc * (1.0 + kOffCost * share * share + kTightCost * std::max(0.0, 1.0 - least / comfort_)) +
                kBendCost * std::abs(bend - node.bend);
    if (node.side == 0 && std::abs(end.off) > std::abs(node.off)) {
      end.side = sign(end.off);
      if (side != 0 && end.side != side) end.cost += kSideCost;
    }
    push(end);
  }
}

// A robot so close to an obstacle that no arc leads past it may turn on the spot first.
void IntentSearch::turn_first(const Node& start, int side) {
  for (const double way : {1.0, -1.0}) {
    Node node = start;
    for (double turned = kTurnStep; turned <= 2.0 * HeldDirection::kMost; turned += kTurnStep) {
      node.off = start.off + way * turned;
      node.pose.theta = start.pose.theta + way * turned;
      node.clearance = clearance_at(node.pose);
      if (node.clearance <= 0.0 || std::abs(node.off) > HeldDirection::kMost) break;
      node.parent = 0;
      node.side = sign(node.off);
      node.cost = kTurnCost + 0.2 * turned + (side != 0 && node.side != side ? kSideCost : 0.0);
      push(node);
    }
  }
}

std::uint64_t IntentSearch::bin_of(const Node& node) const {
  const auto index = [](double value, double bin) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / bin)) + (1 << 19)) & 0xFFFFF;
  };
  return index(node.pose.x - origin_.x, kBin) << 40 | index(node.pose.y - origin_.y, kBin) << 20 |
         index(node.off, kHeadingBin);
}

void IntentSearch::push(const Node& node) {
  const std::uint64_t bin = bin_of(node);
  const std::uint32_t known = bins_.find(bin);
  if (known != BinTable::kNone && nodes_[known].cost - nodes_[known].progress <= node.cost - node.progress) return;
  if (nodes_.size() >= kMostNodes) return;
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  bins_.set(bin, index);
  queue_.emplace_back(-(node.cost + std::max(0.0, ahead_ - node.progress)), index);
  std::push_heap(queue_.begin(), queue_.end());
}

IntentSearch::Result IntentSearch::aim(int last, const Request& request) const {
  const auto at = [this](int i) -> const Node& { return nodes_[static_cast<std::size_t>(i)]; };
  const double v = std::abs(request.wanted.v), distant = kAim + kAimTime * v;
  const Node* target = &at(last);
  const Node* first = target;  // after the start
  const int side = target->side;
  for (int i = last; i > 0; i = at(i).parent) {
    first = &at(i);
    if (distance(at(i).pose, request.start) >= distant) target = first;
  }
  const double turn_limit = cycle_->start.limits.theta.max;
  if (first->progress == 0.0 && first != &at(0)) {
    const double turn = first->off - request.off;
    return {{0.0, std::clamp(turn / kTurnTime, -turn_limit, turn_limit)}, side};
  }
  const Rotation heading = Rotation::of(request.start.theta);
  const double dx = target->pose.x - request.start.x, dy = target->pose.y - request.start.y;
  const double aside = heading.c * dy - heading.s * dx, squared = dx * dx + dy * dy;
  const double curvature = squared > 0.0 ? 2.0 * aside / squared : 0.0;
  const double speed = std::abs(curvature) * v > turn_limit ? turn_limit / std::abs(curvature) : v;
  return {{forward_ * speed, curvature * forward_ * speed}, side};
}

}  // namespace hidwa_local_planner
