// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tracking/association.hpp"
#include "tracking/field_of_view.hpp"
#include "tracking/free_memory.hpp"
#include "tracking/track.hpp"

namespace hidwa_local_planner {
namespace {

using tracking::Beam;
using tracking::PlaceKind;
using tracking::Segment;
using tracking::Sighting;
using tracking::Track;

constexpr double kLongestGap = 2.0;       // between scans; after a longer one nothing is known [s]
constexpr double kSeenThrough = 0.2;      // a track whose place is seen through for so long is gone [s]
constexpr double kWalked = 1.0;           // who has come so far has walked [m]
constexpr double kStirred = 2.0;          // what has not is dropped this time after it stopped [s]
constexpr double kCandidateCoast = 0.25;  // for how long a candidate may be out of sight [s]
constexpr double kLegsApart = 0.55;       // of two legs that begin a track [m]
constexpr double kSameBody = 0.3;         // tracks that are nearer to each other follow one body [m]
constexpr std::size_t kMostTracks = 128;
constexpr std::size_t kFewestPoints = 2;

}  // namespace

class Tracker::Impl {
 public:
  explicit Impl(const TrackerSettings& settings) : settings_(settings), memory_(settings) {
    tracks_.reserve(kMostTracks);
  }

  ScanUse update(const RangeScan& scan) {
    if (!fault_of(scan).empty()) return ScanUse::refused;
    ScanUse use = ScanUse::used;
    if (known_) {
      const double elapsed = scan.end() - beams_.end;
      if (elapsed < -0.5 || elapsed > kLongestGap) {
        reset();
        use = ScanUse::after_jump;
      } else if (elapsed <= 0.0) {
        return ScanUse::repeated;
      }
    }
    take(scan);
    return use;
  }

  void reset() {
    memory_.clear();
    tracks_.clear();
    obstacles_.clear();
    travel_ = tracking::Travel();
    known_ = false;
  }

  const MovingObstacleEstimates& obstacles() const { return obstacles_; }
  SensorSectors field_of_view() const { return view_.sectors(settings_.reach); }
  double stamp() const { return beams_.end; }
  std::size_t candidates() const {
    return static_cast<std::size_t>(
        std::count_if(tracks_.begin(), tracks_.end(), [](const Track& t) { return !t.confirmed; }));
  }

 private:
  void take(const RangeScan& scan) {
    const double elapsed = known_ ? scan.end() - beams_.end : 0.0;
    if (known_) {
      travel_.driven += distance(sensor_, scan.sensor_end);
      travel_.turned += std::abs(wrap_angle(scan.sensor_end.theta - sensor_.theta));
    }
    sensor_ = scan.sensor_end;
    known_ = true;
    tracking::to_beams(scan, settings_, beams_);
    view_.add(scan, beams_);
    memory_.centre_on(beams_.centre);
    memory_.judge(beams_, travel_);
    tracking::find_segments(beams_, settings_.range_noise, 2.0 * settings_.max_radius, segments_, hull_);
    drop_specks();
    follow();
    begin_tracks();
    end_tracks(elapsed);
    confirm();
    mark_points();
    memory_.take(beams_, travel_, elapsed);
    publish();
  }

  // One point is no body.
  void drop_specks() {
    segments_.erase(
        std::remove_if(segments_.begin(), segments_.end(), [](const Segment& s) { return s.points < kFewestPoints; }),
        segments_.end());
  }

  void follow() {
    for (Track& t : tracks_) t.filter.predict(0.5 * (beams_.stamp + beams_.end));
    association_.assign(beams_, settings_, segments_, tracks_);
    for (Track& t : tracks_) {
      if (t.segment_count == 0) continue;
      Sighting sighting = tracking::look(beams_, segments_, t, settings_);
      sighting.mixed = sighting.legs && association_.may_mix_legs(t, segments_, tracks_);
      tracking::correct_track(t, sighting, settings_);
    }
  }

  // Segments that no track took begin candidates; two legs together begin one.
  void begin_tracks() {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].track >= 0 || tracks_.size() >= kMostTracks) continue;
      Track seed;
      seed.segments[0] = i;
      seed.segment_count = 1;
      const Sighting first = tracking::look(beams_, segments_, seed, settings_);
      if (first.small) {
        const std::size_t other = other_leg(i, first.body.centre);
        if (other < segments_.size()) seed.segments[static_cast<std::size_t>(seed.segment_count++)] = other;
      }
      Track track = tracking::begin_track(tracking::look(beams_, segments_, seed, settings_), travel_, settings_);
      track.segments = seed.segments;
      track.segment_count = seed.segment_count;
      remember_first_points(track);
      for (int k = 0; k < track.segment_count; ++k) {
        segments_[track.segments[static_cast<std::size_t>(k)]].track = static_cast<std::int32_t>(tracks_.size());
      }
      tracks_.push_back(track);
    }
  }

  // The nearest segment after this one that may be its other leg; segments_.size(): there is none.
  std::size_t other_leg(std::size_t leg, const Point& centre) const {
    std::size_t best = segments_.size();
    double nearest = kLegsApart;
    for (std::size_t i = leg + 1; i < segments_.size(); ++i) {
      if (segments_[i].track >= 0) continue;
      Track one;
      one.segments[0] = i;
      one.segment_count = 1;
      const Sighting s = tracking::look(beams_, segments_, one, settings_);
      const double apart = (s.body.centre - centre).norm();
      if (s.small && apart < nearest) {
        nearest = apart;
        best = i;
      }
    }
    return best;
  }

  // A few, from one side of the body to the other.
  void remember_first_points(Track& track) const {
    std::size_t points = 0;
    for (int k = 0; k < track.segment_count; ++k)
      points += segments_[track.segments[static_cast<std::size_t>(k)]].points;
    const std::size_t most = track.first_points.size();
    std::size_t passed = 0;
    for (int k = 0; k < track.segment_count; ++k) {
      tracking::for_points(beams_, segments_[track.segments[static_cast<std::size_t>(k)]], [&](std::size_t i) {
        const bool taken = points <= most || passed * most / points != (passed + 1) * most / points;
        if (taken) track.first_points[static_cast<std::size_t>(track.first_count++)] = beams_.all[i].tip();
        ++passed;
      });
    }
  }

  void end_tracks(double elapsed) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      Track& t = tracks_[i];
      if (t.segment_count == 0 && tracking::seen_through(beams_, t.filter.position(), 0.2)) t.through += elapsed;
      if (is_over(t, elapsed) || follows_another(i)) continue;
      if (kept != i) tracks_[kept] = t;
      ++kept;
    }
    tracks_.resize(kept);
  }

  bool is_over(const Track& t, double elapsed) const {
    const double unseen = beams_.end - t.seen;
    if (!t.confirmed) {
      return unseen > std::max(kCandidateCoast, 1.5 * elapsed) || beams_.end - t.stood_since > stand_time(t);
    }
    return unseen > settings_.coast_time + elapsed || t.through >= std::max(kSeenThrough, 1.5 * elapsed) ||
           (t.seen - t.stood_since > stand_time(t) && !tracking::walks(t, settings_));
  }

  // Who has walked may walk on. What has only stirred, a door or a chair, is the costmap's soon.
  double stand_time(const Track& t) const {
    const bool walked = t.confirmed && (t.stood_at - t.began_at).norm() > kWalked;
    return walked ? settings_.stand_time : std::min(settings_.stand_time, kStirred);
  }

  // True for the later of two tracks in one place, or for the one that is not confirmed.
  bool follows_another(std::size_t i) const {
    const Track& t = tracks_[i];
    if (t.segment_count > 0) return false;  // it has a body of its own
    for (const Track& other : tracks_) {
      if (&other == &t || other.segment_count == 0 || !other.confirmed) continue;
      if ((other.filter.position() - t.filter.position()).norm() < kSameBody) return true;
    }
    return false;
  }

  void confirm() {
    for (Track& t : tracks_) {
      if (t.confirmed || t.segment_count == 0) continue;
      tracking::look_back(t, beams_);
      if (!tracking::known_to_move(t, beams_, segments_, travel_, settings_)) continue;
      t.confirmed = true;
      t.id = ++last_id_;
    }
  }

  // Beams that end at a confirmed track.
  void mark_points() {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (!tracks_[i].confirmed) continue;
      for (int k = 0; k < tracks_[i].segment_count; ++k) {
        const Segment& segment = segments_[tracks_[i].segments[static_cast<std::size_t>(k)]];
        tracking::for_points(beams_, segment,
                             [&](std::size_t b) { beams_.all[b].track = static_cast<std::int32_t>(i); });
      }
    }
  }

  void publish() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (!tracks_[i].confirmed) continue;
      if (count == obstacles_.size()) obstacles_.emplace_back();
      MovingObstacleEstimate& o = obstacles_[count++];
      std::vector<Point> points = std::move(o.points);
      o = tracking::to_obstacle(tracks_[i], beams_.end, settings_);
      points.clear();
      for (const Beam& beam : beams_.all) {
        if (beam.track == static_cast<std::int32_t>(i) && beam.kind == PlaceKind::was_free)
          points.push_back(beam.tip());
      }
      o.points = std::move(points);
    }
    obstacles_.resize(count);
    std::sort(obstacles_.begin(), obstacles_.end(),
              [](const MovingObstacleEstimate& a, const MovingObstacleEstimate& b) { return a.id < b.id; });
  }

  TrackerSettings settings_;
  tracking::FreeMemory memory_;
  tracking::Association association_;
  tracking::Beams beams_;
  tracking::FieldOfView view_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> hull_;
  std::vector<Track> tracks_;
  MovingObstacleEstimates obstacles_;
  tracking::Travel travel_;
  Pose2 sensor_;
  bool known_ = false;
  std::uint32_t last_id_ = 0;
};

Tracker::Tracker(const TrackerSettings& settings) {
  const std::string fault = fault_of(settings);
  if (!fault.empty()) throw std::invalid_argument("tracker: " + fault);
  impl_ = std::make_unique<Impl>(settings);
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

ScanUse Tracker::update(const RangeScan& scan) { return impl_->update(scan); }
const MovingObstacleEstimates& Tracker::obstacles() const { return impl_->obstacles(); }
SensorSectors Tracker::field_of_view() const { return impl_->field_of_view(); }
double Tracker::stamp() const { return impl_->stamp(); }
void Tracker::reset() { impl_->reset(); }
std::size_t Tracker::candidates() const { return impl_->candidates(); }

}  // namespace hidwa_local_planner
