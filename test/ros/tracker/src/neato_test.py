#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A recorded drive behind a person: one track for most of it, as fast as the nearest points ahead say without any tracker."""
import collections
import math
import os
import sys
import threading
import time
import unittest

import numpy as np
import rosbag
import rospy
import rostest
from hidwa_local_planner.msg import MovingObstacles
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

FASTER = 4.0             # than it was recorded
LASER = (-0.1016, math.pi)   # mounted behind the robot's centre, looking back: x [m] and heading [rad]
WINDOW = 1.0             # of the straight line through the reference, to each side [s]


def nearest_ahead(scan, pose):
    """The middle of the points within 0.5 m of the nearest one ahead, in odom; None: there is none."""
    x, y, heading = pose
    x, y, heading = x + LASER[0] * math.cos(heading), y + LASER[0] * math.sin(heading), heading + LASER[1]
    ranges = np.array(scan.ranges)
    bearings = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    ahead = np.abs(np.mod(bearings, 2 * math.pi) - math.pi) < 0.7
    ahead &= (ranges > 0.3) & (ranges < 1.6)
    if ahead.sum() < 3:
        return None
    points = np.stack([x + ranges * np.cos(heading + bearings), y + ranges * np.sin(heading + bearings)], axis=1)
    nearest = points[np.argmin(np.where(ahead, ranges, np.inf))]
    return points[ahead & (np.hypot(*(points - nearest).T) < 0.5)].mean(axis=0)


class NeatoTest(unittest.TestCase):
    def setUp(self):
        self.told, self.changed = [], threading.Condition()
        rospy.Subscriber('moving_obstacles', MovingObstacles, self.take)

    def take(self, message):
        with self.changed:
            self.told.append(message)
            self.changed.notify_all()

    def play(self, bag):
        """Sends transforms and scans; returns the scans and the robot's poses in odom, by time."""
        transforms = rospy.Publisher('/tf', TFMessage, queue_size=100)
        scans = rospy.Publisher('scan', LaserScan, queue_size=10)
        while scans.get_num_connections() == 0 or transforms.get_num_connections() == 0:
            time.sleep(0.05)
        sent, poses = [], []
        begin, first = time.monotonic(), None
        for topic, message, stamp in bag.read_messages(topics=['/tf', '/scan']):
            first = first or stamp.to_sec()
            time.sleep(max(0.0, begin + (stamp.to_sec() - first) / FASTER - time.monotonic()))
            if topic == '/tf':
                transforms.publish(message)
                poses += [(t.header.stamp.to_sec(), t.transform.translation.x, t.transform.translation.y,
                           2 * math.atan2(t.transform.rotation.z, t.transform.rotation.w))
                          for t in message.transforms if t.header.frame_id == 'odom']
            else:
                scans.publish(message)
                sent.append(message)
        return sent, np.array(poses)

    def reference(self, scans, poses):
        """[(time, x, y)] of what is nearest ahead."""
        headings = np.unwrap(poses[:, 3])
        found = []
        for scan in scans:
            at = scan.header.stamp.to_sec()
            pose = [np.interp(at, poses[:, 0], column) for column in (poses[:, 1], poses[:, 2], headings)]
            place = nearest_ahead(scan, pose)
            if place is not None:
                found.append((at + 0.1, *place))  # a turn takes 0.2 s
        return np.array(found)

    def test_one_track_at_the_person_speed(self):
        if not os.path.exists(BAG):
            self.skipTest(f'{BAG} is not there')
        with rosbag.Bag(BAG) as bag:
            scans, poses = self.play(bag)
        with self.changed:
            self.changed.wait_for(lambda: len(self.told) > 0.9 * len(scans), timeout=180)
        self.assertGreater(len(self.told), 0.9 * len(scans))
        lengths = collections.Counter(o.id for message in self.told for o in message.obstacles)
        self.assertTrue(lengths, 'nobody was found')
        person, length = lengths.most_common(1)[0]
        print(f'{len(scans)} scans, {len(self.told)} used; tracks: {dict(lengths)}')
        self.assertGreater(length, 0.6 * len(scans))
        found = self.reference(scans, poses)
        wrong, speeds = [], []
        for message in self.told:
            for o in message.obstacles:
                at = message.header.stamp.to_sec()
                near = np.abs(found[:, 0] - at) < WINDOW
                if o.id != person or near.sum() < 5:
                    continue
                velocity = [np.polyfit(found[near, 0] - at, found[near, axis], 1)[0] for axis in (1, 2)]
                wrong.append(math.hypot(o.velocity.x - velocity[0], o.velocity.y - velocity[1]))
                speeds.append((math.hypot(*velocity), math.hypot(o.velocity.x, o.velocity.y)))
        rms = float(np.sqrt(np.mean(np.square(wrong))))
        by_scan, by_track = np.mean(speeds, axis=0)
        print(f'velocity: {rms:.3f} m/s rms from the line through 2 s; mean speed {by_track:.3f} m/s, by the scan {by_scan:.3f} m/s')
        self.assertLess(rms, 0.2)
        self.assertAlmostEqual(by_track, by_scan, delta=0.1)


BAG = sys.argv[1]

if __name__ == '__main__':
    rospy.init_node('neato_test')
    rostest.rosrun('hidwa_tracker_tests', 'neato_test', NeatoTest, sys.argv)
