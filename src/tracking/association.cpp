// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/association.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kGate = 13.8;       // 99.9 % of chi-squared with two degrees of freedom
constexpr double kFarthest = 0.8;    // from the prediction, whatever the deviations [m]
constexpr double kShape = 0.08;      // what a body's shape and a changing view do to its centre [m]
constexpr double kLegOff = 0.17;     // deviation of a leg from the middle of the person [m]
constexpr double kSmall = 0.13;      // radius of what may be a leg [m]
constexpr double kLegsApart = 0.75;  // [m]

Eigen::Matrix2d room_of(const BodyFit& fit) {
  const double shape = fit.radius < kSmall ? kLegOff : kShape;
  return fit.covariance + shape * shape * Eigen::Matrix2d::Identity();
}

// May the track take this segment beside those that it has?
bool belongs(const Track& track, const BodyFit& fit, const std::vector<BodyFit>& fits) {
  if (track.segment_count == 0) return true;
  if (track.segment_count == static_cast<int>(track.segments.size())) return false;
  const BodyFit& first = fits[track.segments[0]];
  if (fit.radius < kSmall && first.radius < kSmall) {
    return track.segment_count == 1 && (fit.centre - first.centre).norm() < kLegsApart;
  }
  const double radius = track.two_legs ? 0.0 : track.radius;
  return (fit.centre - track.filter.position()).norm() < radius;  // a piece that something hides the rest of
}

}  // namespace

void Association::assign(const Beams& beams, const TrackerSettings& settings, std::vector<Segment>& segments,
                         std::vector<Track>& tracks) {
  fits_.clear();
  for (Segment& s : segments) {
    s.track = -1;
    fits_.push_back(fit_body(beams, s, settings.range_noise));
  }
  pairs_.clear();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    tracks[t].segment_count = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      BodyFit fit = fits_[s];
      const Segment& segment = segments[s];
      const Point& expected = tracks[t].filter.position();
      if ((fit.centre - expected).norm() > kFarthest + tracks[t].radius) continue;
      if (tracks[t].radius > fit.radius) {
        fit = fit_body(beams, segment, known_shape(tracks[t]), settings.range_noise);
      }
      if ((fit.centre - expected).norm() > kFarthest) continue;
      const double mismatch = tracks[t].filter.mismatch(fit.centre, room_of(fit));
      if (mismatch < kGate) pairs_.push_back({mismatch, t, s, tracks[t].confirmed});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
    return std::make_tuple(!a.confirmed, a.mismatch, a.track, a.segment) <
           std::make_tuple(!b.confirmed, b.mismatch, b.track, b.segment);
  });
  for (const Pair& pair : pairs_) {
    Track& track = tracks[pair.track];
    if (segments[pair.segment].track >= 0 || !belongs(track, fits_[pair.segment], fits_)) continue;
    segments[pair.segment].track = static_cast<std::int32_t>(pair.track);
    track.segments[static_cast<std::size_t>(track.segment_count++)] = pair.segment;
  }
}

bool Association::may_mix_legs(const Track& pair, const std::vector<Segment>& segments,
                               const std::vector<Track>& tracks) const {
  const auto is_near = [&](std::size_t leg) {
    const auto end = pair.segments.begin() + pair.segment_count;
    return std::any_of(pair.segments.begin(), end,
                       [&](std::size_t own) { return (fits_[leg].centre - fits_[own].centre).norm() < kLegsApart; });
  };
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::int32_t owner = segments[s].track;
    const bool paired = owner >= 0 && tracks[static_cast<std::size_t>(owner)].segment_count > 1;
    if (!paired && fits_[s].radius < kSmall && is_near(s)) return true;
  }
  return false;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
