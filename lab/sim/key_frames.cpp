// SPDX-License-Identifier: BSD-3-Clause
#include "sim/key_frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hidwa_local_planner {
namespace sim {

KeyFrameTrack::KeyFrameTrack(std::vector<KeyFrame> frames, KeyMotion motion)
    : frames_(std::move(frames)), motion_(motion) {
  if (frames_.size() < 2) throw std::invalid_argument("a track needs two key frames or more");
  if (frames_.front().time != 0.0) throw std::invalid_argument("a track's first key frame must be at time 0");
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    if (!std::isfinite(frames_[k].time) || !frames_[k].position.allFinite()) {
      throw std::invalid_argument("a key frame is not finite");
    }
    if (k > 0 && !(frames_[k].time > frames_[k - 1].time)) {
      throw std::invalid_argument("the times of a track's key frames must rise");
    }
  }
}

KeyFrameTrack::Place KeyFrameTrack::place(double time) const {
  double t = std::fmod(time, period());
  if (t < 0.0) t += period();
  const auto after = std::upper_bound(frames_.begin() + 1, frames_.end() - 1, t,
                                      [](double value, const KeyFrame& frame) { return value < frame.time; });
  const auto segment = static_cast<std::size_t>(after - frames_.begin()) - 1;
  const double duration = frames_[segment + 1].time - frames_[segment].time;
  return {segment, (t - frames_[segment].time) / duration, duration};
}

// Halved central differences inside, halved one-sided ones at the ends [m, over one key].
Eigen::Vector2d KeyFrameTrack::tangent(std::size_t key) const {
  const std::size_t before = key == 0 ? 0 : key - 1, after = std::min(key + 1, frames_.size() - 1);
  return 0.5 * (frames_[after].position - frames_[before].position);
}

Eigen::Vector2d KeyFrameTrack::position(double time) const {
  const auto [k, u, duration] = place(time);
  const Eigen::Vector2d &a = frames_[k].position, &b = frames_[k + 1].position;
  if (motion_ == KeyMotion::linear) return a + u * (b - a);
  // Cubic Hermite polynomial.
  const double u2 = u * u, u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * a + (u3 - 2.0 * u2 + u) * tangent(k) + (3.0 * u2 - 2.0 * u3) * b +
         (u3 - u2) * tangent(k + 1);
}

Eigen::Vector2d KeyFrameTrack::velocity(double time) const {
  const auto [k, u, duration] = place(time);
  const Eigen::Vector2d &a = frames_[k].position, &b = frames_[k + 1].position;
  if (motion_ == KeyMotion::linear) return (b - a) / duration;
  const double u2 = u * u;
  return ((6.0 * u2 - 6.0 * u) * (a - b) + (3.0 * u2 - 4.0 * u + 1.0) * tangent(k) +
          (3.0 * u2 - 2.0 * u) * tangent(k + 1)) /
         duration;
}

double KeyFrameTrack::leapt(double time) const {
  const double rounds = std::floor(time / period());
  return rounds < 1.0 ? -std::numeric_limits<double>::infinity() : rounds * period();
}

KeyFramePeople::KeyFramePeople(std::vector<KeyFrameTrack> tracks, double radius, double start)
    : tracks_(std::move(tracks)), start_(start) {
  if (!(radius > 0.0) || !std::isfinite(radius)) throw std::invalid_argument("a disc's radius must be positive");
  movers_.resize(tracks_.size());
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    movers_[k].id = static_cast<std::uint32_t>(k + 1);
    movers_[k].radius = radius;
  }
  advance(0.0, {});
}

void KeyFramePeople::advance(double time, const RobotSeen& /*robot*/) {
  const double now = start_ + time;
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    movers_[k].position = tracks_[k].position(now);
    movers_[k].velocity = tracks_[k].velocity(now);
    movers_[k].heading = std::atan2(movers_[k].velocity.y(), movers_[k].velocity.x());
    movers_[k].leapt = tracks_[k].leapt(now) - start_;
  }
}

}  // namespace sim
}  // namespace hidwa_local_planner
