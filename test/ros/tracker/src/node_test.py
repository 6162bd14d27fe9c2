#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""hidwa_tracker: what comes out when somebody walks past, and what it says of scans that it cannot use."""
import math
import subprocess
import sys
import threading
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import TransformStamped
from hidwa_local_planner.msg import MovingObstacles
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

RATE = 20.0       # of the laser [Hz]
WALL = 6.0        # radius of the round room about the laser [m]
BODY = 0.25       # radius of the person [m]
LASER = (2.0, 1.0, math.pi / 2)  # in odom: the laser looks along y
PATIENCE = 180.0  # [s]


def scan_of(person, frame, stamp, mirrored=False):
    """What the laser sees of a person at (x, y) in odom, None: nobody, in a round room."""
    scan = LaserScan()
    scan.header.frame_id, scan.header.stamp = frame, stamp
    scan.angle_min, scan.angle_increment = -2.0, 4.0 / 399
    scan.angle_max, scan.range_min, scan.range_max = 2.0, 0.05, 10.0
    for beam in range(400):
        bearing = scan.angle_min + beam * scan.angle_increment
        angle = LASER[2] + (-bearing if mirrored else bearing)
        length = WALL
        if person is not None:
            to_x, to_y = person[0] - LASER[0], person[1] - LASER[1]
            along = to_x * math.cos(angle) + to_y * math.sin(angle)
            inside = BODY ** 2 - (to_x ** 2 + to_y ** 2 - along ** 2)
            if along > 0 and inside > 0:
                length = along - math.sqrt(inside)
        scan.ranges.append(length)
    return scan


def transform(frame, quaternion, place=LASER):
    t = TransformStamped()
    t.header.frame_id, t.child_frame_id = 'odom', frame
    t.transform.translation.x, t.transform.translation.y = place[0], place[1]
    t.transform.rotation.x, t.transform.rotation.y, t.transform.rotation.z, t.transform.rotation.w = quaternion
    return t


class NodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.changed = threading.Condition()
        cls.told, cls.markers, cls.status = [], [], []
        cls.fixed = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        half = LASER[2] / 2
        # Upside down: turned about x by pi, then about z.
        cls.fixed.publish(TFMessage([transform('laser', (0, 0, math.sin(half), math.cos(half))),
                                     transform('laser_below', (math.cos(half), math.sin(half), 0, 0)),
                                     transform('laser_aslant', (math.sin(0.3), 0, 0, math.cos(0.3))),
                                     transform('laser_rear', (0, 0, 0, 1), (-2.0, 1.0))]))
        cls.scans = rospy.Publisher('scan', LaserScan, queue_size=10)
        rospy.Subscriber('moving_obstacles', MovingObstacles, cls.keep(cls.told))
        rospy.Subscriber('moving_obstacle_markers', MarkerArray, cls.keep(cls.markers))
        rospy.Subscriber('diagnostics', DiagnosticArray, cls.keep(cls.status))

    @classmethod
    def keep(cls, where):
        def take(message):
            with cls.changed:
                where.append(message)
                cls.changed.notify_all()
        return take

    def wait_for(self, condition, what):
        deadline = time.monotonic() + PATIENCE
        with self.changed:
            while not condition():
                self.assertGreater(deadline - time.monotonic(), 0, f'no {what} within {PATIENCE} s')
                self.changed.wait(0.1)

    def setUp(self):
        deadline = time.monotonic() + PATIENCE
        while self.scans.get_num_connections() == 0:
            self.assertGreater(deadline - time.monotonic(), 0, 'hidwa_tracker does not listen to scan')
            time.sleep(0.05)

    def send(self, make, count):
        """Scans at the laser's rate; make(seconds, stamp) makes one."""
        begin = rospy.Time.now()
        for i in range(count):
            stamp = begin + rospy.Duration(i / RATE)
            while rospy.Time.now() < stamp:
                time.sleep(0.002)
            self.scans.publish(make(i / RATE, stamp))
        return begin

    def walk(self, frame, mirrored=False):
        """Somebody crosses 3 m ahead of the laser from x = 0.5, at 1 m/s, for 2.5 s; before that nobody."""
        with self.changed:
            del self.told[:]
        while not self.told:  # until this laser counts
            self.send(lambda t, stamp: scan_of(None, frame, stamp, mirrored), 10)
        begin = self.send(lambda t, stamp: scan_of((0.5 + t, 4.0), frame, stamp, mirrored), 50)
        last = begin + rospy.Duration(49 / RATE)
        self.wait_for(lambda: self.told and self.told[-1].header.stamp >= last - rospy.Duration(0.001), 'message of the last scan')
        return begin

    def expect_walker(self, begin):
        message = self.told[-1]
        self.assertEqual(message.header.frame_id, 'odom')
        self.assertEqual(len(message.obstacles), 1)
        walker = message.obstacles[0]
        passed = (message.header.stamp - begin).to_sec()
        self.assertAlmostEqual(walker.position.x, 0.5 + passed, delta=0.15)
        self.assertAlmostEqual(walker.position.y, 4.0, delta=0.1)
        self.assertAlmostEqual(walker.velocity.x, 1.0, delta=0.2)
        self.assertAlmostEqual(walker.velocity.y, 0.0, delta=0.2)
        self.assertGreaterEqual(walker.radius, BODY)
        self.assertGreater(walker.position_deviation, 0.0)
        self.assertGreater(walker.velocity_deviation, 0.0)
        self.assertGreater(len(walker.points), 5)
        for point in walker.points:
            self.assertLess(math.hypot(point.x - 0.5 - passed, point.y - 4.0), BODY + 0.05)
        return walker

    def test_1_nobody_is_told_too(self):
        self.send(lambda t, stamp: scan_of(None, 'laser', stamp), 10)
        self.wait_for(lambda: self.told, 'message')
        self.assertEqual(self.told[-1].obstacles, [])
        self.assertEqual(self.told[-1].header.frame_id, 'odom')

    def test_2_somebody_walks_past(self):
        walker = self.expect_walker(self.walk('laser'))
        shapes = {m.ns: m for array in self.markers for m in array.markers if m.id == walker.id}
        self.assertEqual(sorted(shapes), ['disc', 'id', 'velocity'])
        self.assertEqual(shapes['disc'].type, Marker.CYLINDER)
        self.assertAlmostEqual(shapes['disc'].scale.x, 2 * walker.radius, places=6)
        self.assertEqual(shapes['velocity'].header.frame_id, 'odom')
        ids = {o.id for message in self.told for o in message.obstacles}
        self.assertEqual(ids, {walker.id})

    def test_2b_a_slash_before_the_frame_does_not_count(self):
        self.expect_walker(self.walk('/laser'))

    def test_3_under_a_laser_upside_down(self):
        self.expect_walker(self.walk('laser_below', mirrored=True))

    def diagnosis(self, level, words):
        def is_there():
            return any(s.name.endswith('tracker') and s.level == level and words in s.message for a in self.status for s in a.status)
        return is_there

    def test_4_bad_scans_are_told(self):
        for words, spoil in (('angle_increment', lambda s: setattr(s, 'angle_increment', 0.0)),
                             ('no ranges', lambda s: setattr(s, 'ranges', [])),
                             ('no range says anything', lambda s: setattr(s, 'ranges', [0.0] * 200 + [float('nan')] * 200)),
                             ('have no stamp', lambda s: setattr(s.header, 'stamp', rospy.Time())),
                             ('tilted', lambda s: setattr(s.header, 'frame_id', 'laser_aslant')),
                             ('no transform from odom to nowhere', lambda s: setattr(s.header, 'frame_id', 'nowhere'))):
            def bad(_, stamp):
                scan = scan_of(None, 'laser', stamp)
                spoil(scan)
                return scan
            self.send(bad, 3)
            self.wait_for(self.diagnosis(DiagnosticStatus.ERROR, words), f'diagnosis with "{words}"')
        self.wait_for(self.diagnosis(DiagnosticStatus.WARN, 'no scan on /scan'), 'diagnosis of silence')
        self.expect_walker(self.walk('laser'))  # and it goes on

    def test_5_of_two_lasers_on_one_topic_one_is_tracked_and_the_other_named(self):
        # The rear one is 4 m away, and sees nothing but a room of its own.
        def both(person):
            def one(t, stamp):
                self.scans.publish(scan_of(None, 'laser_rear', stamp - rospy.Duration(0.01)))
                return scan_of(person(t), 'laser', stamp)
            return one
        with self.changed:
            del self.told[:]
        while not self.told:
            self.send(lambda t, stamp: scan_of(None, 'laser', stamp), 10)
        self.send(both(lambda t: None), 10)
        begin = self.send(both(lambda t: (0.5 + t, 4.0)), 50)
        last = begin + rospy.Duration(49 / RATE)
        self.wait_for(lambda: self.told[-1].header.stamp >= last - rospy.Duration(0.001), 'message of the last scan')
        self.expect_walker(begin)
        self.wait_for(self.diagnosis(DiagnosticStatus.ERROR, 'those in laser are used, those in laser_rear are not'), 'name of the other')

    def test_6_a_stamp_that_stands_still_is_told(self):
        stamp = rospy.Time.now()
        self.send(lambda t, _: scan_of(None, 'laser', stamp), 60)
        self.wait_for(self.diagnosis(DiagnosticStatus.ERROR, 'has the stamp of the one before'), 'diagnosis')

    def test_7_wrong_parameters_are_named(self):
        for argument, words in (('_reach:=far', 'reach must be a number'), ('_reach:=0.1', 'reach is 0.1: it must be from 1 to 30 m'),
                                ('_no_return_is_free:=3', 'no_return_is_free must be true or false'),
                                ('_fixed_frame:=7', 'fixed_frame must be a text'),
                                ('_transform_timeout:=-1', 'transform_timeout must be from 0 to 10 s')):
            run = subprocess.run(['rosrun', 'hidwa_local_planner', 'hidwa_tracker', '__name:=spoilt', argument],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, check=False)
            self.assertEqual(run.returncode, 1, run.stdout)
            self.assertIn(words, run.stdout)
            subprocess.run(['rosparam', 'delete', '/spoilt'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)


if __name__ == '__main__':
    rospy.init_node('node_test')
    rostest.rosrun('hidwa_tracker_tests', 'node_test', NodeTest, sys.argv)
