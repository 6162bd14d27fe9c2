// SPDX-License-Identifier: BSD-3-Clause
// hidwa_tracker: laser scans in, moving obstacles out.

#include <cstdint>
#include <deque>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>

#include "tracking/laser_choice.hpp"
#include "tracking/node_messages.hpp"
#include "tracking/node_parameters.hpp"
#include "tracking/tracker.hpp"

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr std::size_t kMostWaiting = 10;  // scans that wait for their transform
constexpr double kLookAgain = 0.01;       // after which they are tried again [s]
constexpr double kReport = 1.0;           // between diagnostics [s]

/// What happened since the node began.
struct Counts {
  std::uint64_t scans = 0;
  std::uint64_t used = 0;
  std::uint64_t repeated = 0;
  std::uint64_t refused = 0;
  std::uint64_t without_transform = 0;
  std::uint64_t late = 0;
  std::uint64_t jumps = 0;
};

class TrackerNode {
 public:
  TrackerNode(const NodeParameters& parameters, const ros::NodeHandle& private_node)
      : p_(parameters), tracker_(p_.tracker), listener_(buffer_), updater_(ros::NodeHandle(), private_node) {
    obstacles_ = node_.advertise<MovingObstacles>("moving_obstacles", 1);
    markers_ = node_.advertise<visualization_msgs::MarkerArray>("moving_obstacle_markers", 1);
    scans_ = node_.subscribe<sensor_msgs::LaserScan>(
        "scan", 5, [this](const sensor_msgs::LaserScan::ConstPtr& m) { receive(m); }, ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay());
    updater_.setHardwareID("none");
    updater_.add("tracker", [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
    again_ = node_.createWallTimer(ros::WallDuration(kLookAgain), [this](const ros::WallTimerEvent&) { work(); });
    report_ = node_.createWallTimer(ros::WallDuration(kReport),
                                    [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  }

 private:
  struct Waiting {
    sensor_msgs::LaserScan::ConstPtr scan;
    ros::WallTime since;
  };

  void receive(const sensor_msgs::LaserScan::ConstPtr& scan) {
    ++counts_.scans;
    waiting_.push_back({scan, ros::WallTime::now()});
    if (waiting_.size() > kMostWaiting) drop_first("too many scans wait for it");
    work();
  }

  // Takes scans in their order, as soon as their transform is there.
  void work() {
    while (!waiting_.empty()) {
      const sensor_msgs::LaserScan& scan = *waiting_.front().scan;
      std::string error;
      if (buffer_.canTransform(p_.fixed_frame, without_slash(scan.header.frame_id), scan.header.stamp, &error)) {
        const sensor_msgs::LaserScan::ConstPtr kept = waiting_.front().scan;
        waiting_.pop_front();
        use(*kept);
      } else if ((ros::WallTime::now() - waiting_.front().since).toSec() > p_.transform_timeout) {
        drop_first(error);
      } else {
        return;
      }
    }
  }

  void drop_first(const std::string& reason) {
    ++counts_.without_transform;
    transform_fault_ = "no transform from " + p_.fixed_frame + " to " + waiting_.front().scan->header.frame_id +
                       " at the scan's time (" + reason +
                       "): let the robot's driver publish it, or set ~fixed_frame to the odometry's frame";
    ROS_WARN_STREAM_THROTTLE(5.0, "a scan was dropped: " << transform_fault_);
    waiting_.pop_front();
  }

  void use(const sensor_msgs::LaserScan& message) {
    try {
      const geometry_msgs::Transform sensor =
          buffer_.lookupTransform(p_.fixed_frame, without_slash(message.header.frame_id), message.header.stamp)
              .transform;
      const Mounting mounting = mounting_of(sensor);
      if (mounting == Mounting::tilted)
        return refuse("the laser is tilted by more than 18 degrees: it must scan level");
      if (message.header.stamp.isZero()) {
        return refuse("the scans have no stamp, so where the laser was is not known: the driver must set header.stamp");
      }
      to_range_scan(message, mounting, next_);
      next_.sensor = next_.sensor_end = to_sensor_pose(sensor);
      std::string fault = fault_of(next_);
      if (fault.empty()) {
        fault = choice_.fault(without_slash(message.header.frame_id), ros::WallTime::now().toSec());
      }
      if (!fault.empty()) return refuse(fault);
      const Pose2 before = scan_.sensor;
      std::swap(scan_, next_);
      scan_.sensor_end = pose_at_end(before, message);
      mounting_ = mounting;
      laser_frame_ = without_slash(message.header.frame_id);
      take(fault_of(scan_));
    } catch (const tf2::TransformException& e) {
      ++counts_.without_transform;
      transform_fault_ = e.what();
    }
  }

  // Where the sensor was at the last beam: by its transform if that is there already; else as it went on from the scan
  // before, since waiting would cost a whole turn of the laser.
  Pose2 pose_at_end(const Pose2& before, const sensor_msgs::LaserScan& message) {
    const double duration = scan_.end() - scan_.stamp;
    if (!(duration > 0.0 && duration < 2.0)) return scan_.sensor;
    const ros::Time end = message.header.stamp + ros::Duration(duration);
    const std::string frame = without_slash(message.header.frame_id);
    if (buffer_.canTransform(p_.fixed_frame, frame, end)) {
      return to_sensor_pose(buffer_.lookupTransform(p_.fixed_frame, frame, end).transform);
    }
    const double elapsed = scan_.stamp - stamp_before_;
    const double share = elapsed > 0.0 && elapsed < 1.0 ? duration / elapsed : 0.0;
    const Pose2& now = scan_.sensor;
    return {now.x + share * (now.x - before.x), now.y + share * (now.y - before.y),
            now.theta + share * wrap_angle(now.theta - before.theta)};
  }

  void take(const std::string& fault) {
    stamp_before_ = scan_.stamp;
    if (!fault.empty()) return refuse(fault);
    coarse_ = coarse(scan_.angle_increment);
    const ScanUse use = tracker_.update(scan_);
    if (use == ScanUse::repeated) ++counts_.repeated;
    if (use == ScanUse::after_jump) ++counts_.jumps;
    if (use == ScanUse::repeated || use == ScanUse::refused) return;
    ++counts_.used;
    lag_ = ros::Time::now().toSec() - scan_.end();
    if (lag_ > p_.lag_max) ++counts_.late;
    publish();
  }

  void refuse(const std::string& fault) {
    ++counts_.refused;
    scan_fault_ = fault;
    ROS_WARN_STREAM_THROTTLE(5.0, "a scan was refused: " << fault << "; check the laser's driver");
  }

  void publish() {
    MovingObstacles message = to_message(tracker_.obstacles(), p_.fixed_frame, ros::Time(tracker_.stamp()));
    message.sensor_sectors = to_message(tracker_.field_of_view(), mounting_, laser_frame_);
    obstacles_.publish(message);
    if (markers_.getNumSubscribers() > 0) markers_.publish(to_markers(message));
    followed_ = message.obstacles.size();
  }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status) {
    using Status = diagnostic_msgs::DiagnosticStatus;
    status.summary(Status::OK, "tracking");
    if (counts_.scans == reported_.scans) {
      status.mergeSummary(Status::WARN,
                          "no scan on " + scans_.getTopic() + ": check the laser, and scan_topic in the launch file");
    }
    if (counts_.late > reported_.late) {
      status.mergeSummary(Status::WARN,
                          "scans are used late: lighten the machine's load, synchronise its clock with the laser's");
    }
    if (scans_.getNumPublishers() > 1) {
      status.mergeSummary(Status::WARN, std::to_string(scans_.getNumPublishers()) + " nodes publish " +
                                            scans_.getTopic() + ": only one laser is tracked");
    }
    if (!coarse_.empty()) status.mergeSummary(Status::WARN, coarse_);
    if (counts_.repeated > reported_.repeated && counts_.used == reported_.used) {
      status.mergeSummary(Status::ERROR,
                          "each scan has the stamp of the one before, or an earlier one: the laser's "
                          "driver must stamp each scan anew");
    }
    if (counts_.refused > reported_.refused) status.mergeSummary(Status::ERROR, "scans are refused: " + scan_fault_);
    if (counts_.without_transform > reported_.without_transform) status.mergeSummary(Status::ERROR, transform_fault_);
    reported_ = counts_;
    status.add("scans", counts_.scans);
    status.add("scans used", counts_.used);
    status.add("scans repeated", counts_.repeated);
    status.add("scans refused", counts_.refused);
    status.add("scans without a transform", counts_.without_transform);
    status.add("scans late", counts_.late);
    status.add("jumps of time", counts_.jumps);
    status.add("lag of the last scan [s]", lag_);
    status.add("moving obstacles", followed_);
    status.add("candidates", tracker_.candidates());
  }

  NodeParameters p_;
  Tracker tracker_;
  RangeScan scan_;                         // the last one that was used
  RangeScan next_;                         // is looked at before it takes that place
  Mounting mounting_ = Mounting::upright;  // of the laser at the last scan that was used
  std::string laser_frame_;                // likewise
  double stamp_before_ = -1.0;             // of the scan before [s]
  double lag_ = 0.0;                       // from the end of a scan to its use [s]
  std::size_t followed_ = 0;
  Counts counts_, reported_;
  std::string transform_fault_, scan_fault_, coarse_;
  LaserChoice choice_;
  std::deque<Waiting> waiting_;

  ros::NodeHandle node_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  diagnostic_updater::Updater updater_;
  ros::Publisher obstacles_, markers_;
  ros::Subscriber scans_;
  ros::WallTimer again_, report_;
};

}  // namespace
}  // namespace tracking
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  ros::init(argc, argv, "hidwa_tracker");
  const ros::NodeHandle private_node("~");  // outlives the error below: the log ends with the last handle
  try {
    hidwa_local_planner::tracking::TrackerNode node(hidwa_local_planner::tracking::read_node_parameters(private_node),
                                                    private_node);
    ros::spin();
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
  return 0;
}
