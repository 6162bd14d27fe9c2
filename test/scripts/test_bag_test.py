# SPDX-License-Identifier: BSD-3-Clause
"""Bag tests: what their YAML files may say, and their judgements against obvious twins."""
import math
import os
import tempfile
import unittest

import numpy as np

from hidwa_bag_test import judge, plans
from hidwa_bag_test.description import read_description
from hidwa_bag_test.errors import BagTestError
from hidwa_bag_test.recording import Absent, Recording, placed_points, shift
from hidwa_bag_test.robot import footprint_of
from synthetic_bag import RealDrive

LIMITS = {'max_vel_x': 0.5, 'min_vel_x': -0.1, 'max_vel_theta': 1.0, 'acc_lim_x': 2.0, 'acc_lim_theta': 4.0,
          'decel_lim_x': -1.0, 'decel_lim_theta': 0.0}
SQUARE = np.array([[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]])


class DescriptionTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, 'test.yaml')

    def read(self, text, **more):
        with open(self.path, 'w', encoding='utf-8') as out:
            out.write(text)
        return read_description(self.path, **more)

    def fault(self, text):
        with self.assertRaises(BagTestError) as raised:
            self.read(text)
        self.assertNotIn('\n', str(raised.exception))
        self.assertTrue(str(raised.exception).startswith(self.path), raised.exception)
        return str(raised.exception)

    def test_a_whole_file(self):
        d = self.read('''
bag: corridor.bag
start: 2
duration: 10.5
plan: {topic: /plan}
topics: {/robot/odom: /odom, /scan: /scan}
odom: /robot/odom
expect: {arrived: true, contacts: 0, failures: 3, deviation: {v: 0.1}, states: [{at: 1.5, is: SHARED}],
         limits: {max_vel_x: 0.3}, collision_free: false}
''')
        self.assertEqual(d.bag, os.path.join(os.path.dirname(self.path), 'corridor.bag'))
        self.assertEqual((d.start, d.duration, d.plan, d.odom), (2.0, 10.5, {'topic': '/plan'}, '/robot/odom'))
        self.assertEqual(d.topics, {'/robot/odom': '/odom', '/scan': '/scan'})
        self.assertEqual(d.expect.given(), ['arrived', 'contacts', 'finite', 'limits', 'failures', 'deviation', 'states'])

    def test_what_must_be_there_and_what_holds_without_being_said(self):
        d = self.read('{bag: a.bag, plan: {driven: true}}')
        self.assertEqual(d.expect.given(), ['finite', 'limits', 'collision_free'])
        self.assertIn('bag is missing', self.fault('plan: {driven: true}'))
        self.assertIn('plan is missing', self.fault('bag: a.bag'))

    def test_another_bag_stands_in(self):
        self.assertEqual(self.read('{bag: a.bag, plan: {free: 2}}', bag='/data/b.bag').bag, '/data/b.bag')

    def test_faults_name_the_entry_and_the_remedy(self):
        good = 'bag: a.bag\nplan: {driven: true}\n'
        for text, words in {
                good + 'expcet: {}': 'unknown key expcet: did you mean expect?',
                good + 'expect: {arived: true}': 'unknown key expect.arived: did you mean arrived?',
                good + 'expect: {deviation: {w: 1}}': 'unknown key expect.deviation.w: there are v, omega',
                good + 'rate: fast': "rate = 'fast': give a number from 0.1 to 100",
                good + 'rate: 0': 'rate = 0: give a number from 0.1 to 100',
                good + 'start: true': 'start = True: give a number',
                good + 'expect: {contacts: -1}': 'expect.contacts = -1: give a whole number, 0 or more',
                good + 'expect: {arrived: 1}': 'expect.arrived = 1: give true or false',
                good + 'expect: {states: [{at: 1, is: shared}]}': "expect.states.is = 'shared': give one of AUTONOMY, SHARED",
                good + 'expect: {states: [{at: 1}]}': 'expect.states.is is missing: give it',
                good + 'expect: [arrived]': 'expect must hold "key: value" lines',
                good + 'if_absent: ignore': "if_absent = 'ignore': give one of fail, skip",
                'bag: a.bag\nplan: straight': "plan = 'straight': give {topic: NAME}, {driven: true} or {free: METRES}",
                'bag: a.bag\nplan: {free: -1}': 'give a number from 0.2 to 100',
                '- bag': 'the file must hold "key: value" lines',
                'bag: [a': 'line'}.items():
            with self.subTest(text=text):
                self.assertIn(words, self.fault(text))

    def test_a_file_or_a_bag_that_is_not_there(self):
        with self.assertRaisesRegex(BagTestError, 'nowhere.yaml cannot be read .*--test'):
            read_description('/nowhere.yaml')
        with self.assertRaisesRegex(Absent, 'a.bag does not exist: correct bag in'):
            Recording(self.read('{bag: a.bag, plan: {driven: true}}'))

    def test_a_bag_that_lacks_a_topic(self):
        bag = os.path.join(os.path.dirname(__file__), '..', 'ros', 'bags', 'bags', 'arrival.bag')
        with self.assertRaisesRegex(BagTestError, 'arrival.bag holds no /hand_pose, /plan: record them, or name'):
            Recording(self.read('{plan: {topic: /plan}, topics: [/odom, /scan, /tf, /hand_pose], bag: ' + bag + '}'))
        with self.assertRaisesRegex(BagTestError, 'less than 0.5 s of .* is left from start = 99 on'):
            Recording(self.read('{plan: {driven: true}, start: 99, bag: ' + bag + '}'))

    def test_a_frame_with_two_parents_is_named_with_both(self):
        bag = os.path.join(os.path.dirname(self.path), 'two.bag')

        def recording(drive, more=''):
            drive.write(bag)
            return Recording(self.read('{plan: {driven: true}, ' + more + 'bag: two.bag}'))
        self.assertTrue(recording(RealDrive()).events)
        drive = RealDrive()
        drive.fixed = [('base_footprint', 'base_link')]
        with self.assertRaisesRegex(BagTestError, r'two.bag: frame base_link has 2 parents, base_footprint \(in /tf_static\) and odom '
                                    r'\(in /tf\): .*leave /tf_static out of topics in .*test.yaml'):
            recording(drive)
        # The remedy works, and what does not concern the robot is nobody's fault.
        self.assertTrue(recording(drive, 'topics: [/odom, /scan, /tf], ').of('/tf'))
        drive.fixed = [('world', 'odom'), ('table', 'cup'), ('gripper', 'cup')]
        self.assertTrue(recording(drive).events)  # odom, in which the robot is followed, is looked no further up from
        drive.fixed = [('mast', 'laser')]
        with self.assertRaisesRegex(BagTestError, 'frame laser has 2 parents, base_link .* and mast'):
            recording(drive)

    def test_a_file_that_is_no_bag(self):
        with self.assertRaisesRegex(BagTestError, 'test.yaml'):
            Recording(self.read('{bag: test.yaml, plan: {driven: true}}'))


class JudgeTest(unittest.TestCase):
    def fault(self, command, previous=(0.0, 0.0), measured=(), passed=0.05):
        return judge.limit_fault(command, previous, list(measured), 0.05, passed, LIMITS)

    def test_limits(self):
        # Up by 2.0 x 0.05 = 0.1 m/s and 4.0 x 0.05 = 0.2 rad/s, down by 1.0 x 0.05 = 0.05 m/s.
        self.assertEqual(self.fault((0.1, 0.2)), '')
        self.assertIn('v = 0.110 m/s cannot be reached in 0.050 s: -0.100 to 0.100', self.fault((0.11, 0.2)))
        self.assertIn('omega = 0.210', self.fault((0.1, 0.21)))
        self.assertEqual(self.fault((0.35, 0.0), (0.4, 0.0)), '')
        self.assertIn('0.350 to 0.500', self.fault((0.34, 0.0), (0.4, 0.0)))
        # What odometry measures may be the start, too.
        self.assertEqual(self.fault((0.34, 0.0), (0.4, 0.0), [(0.3, 0.0)]), '')
        self.assertIn('v = 0.510 m/s is not within -0.100 and 0.500', self.fault((0.51, 0.0), (0.5, 0.0)))
        self.assertIn('omega = -1.100', self.fault((0.0, -1.1), (0.0, -1.0)))
        self.assertNotEqual(self.fault((math.nan, 0.0)), '')
        # More time, more change; but who is beyond the limits need not brake for longer than a period.
        self.assertEqual(self.fault((0.12, 0.0), passed=0.06), '')
        self.assertEqual(self.fault((0.75, 0.0), (0.8, 0.0), passed=0.06), '')

    def test_a_robot_beyond_the_limits_may_be_braked_to_them(self):
        self.assertEqual(self.fault((0.75, 0.0), (0.5, 0.0), [(0.8, 0.0)]), '')      # 0.8 - 0.05
        self.assertIn('0.750', self.fault((0.76, 0.0), (0.5, 0.0), [(0.8, 0.0)]))

    def test_braking_poses_come_to_rest_where_the_formula_says(self):
        # 0.5 m/s for 0.2 s, then v^2 / 2a = 0.25 / 2 = 0.125 m; 1.0 rad/s for 0.2 s, then 1 / 8 = 0.125 rad.
        straight = judge.braking_poses((1.0, 2.0, 0.0), (0.5, 0.0), 0.2, (1.0, 4.0))
        self.assertAlmostEqual(straight[-1][0], 1.0 + 0.1 + 0.125, delta=0.003)
        self.assertAlmostEqual(straight[-1][1], 2.0)
        turn = judge.braking_poses((0.0, 0.0, 0.0), (0.0, -1.0), 0.2, (1.0, 4.0))
        self.assertAlmostEqual(turn[-1][2], -0.2 - 0.125, delta=0.01)

    def test_braking_poses_against_small_steps(self):
        pose, (v, omega), hold, decel, dt = (0.3, -0.2, 0.7), (0.4, -0.9), 0.15, (0.8, 2.0), 1e-4
        x, y, yaw = pose
        for k in range(int((hold + max(v / decel[0], -omega / decel[1])) / dt)):
            over = max(0.0, k * dt - hold)
            vk, wk = max(0.0, v - decel[0] * over), min(0.0, omega + decel[1] * over)
            x, y, yaw = x + vk * math.cos(yaw) * dt, y + vk * math.sin(yaw) * dt, yaw + wk * dt
        np.testing.assert_allclose(judge.braking_poses(pose, (v, omega), hold, decel)[-1], (x, y, yaw), atol=0.005)

    def test_swept_points_against_every_pose_and_point(self):
        random = np.random.RandomState(3)
        points = random.uniform(-1.0, 1.0, (1000, 2))
        for command in ((0.5, 0.0), (0.3, 1.0), (0.0, -1.0)):
            poses = judge.braking_poses((0.0, 0.0, 0.3), command, 0.15, (1.0, 2.0))
            count = 0
            for px, py in points:
                inside = []
                for x, y, yaw in poses:
                    along = math.cos(yaw) * (px - x) + math.sin(yaw) * (py - y)
                    across = -math.sin(yaw) * (px - x) + math.cos(yaw) * (py - y)
                    inside.append(abs(along) < 0.2 and abs(across) < 0.2)
                count += any(inside) and not inside[0]
            self.assertEqual(judge.swept_points(SQUARE, (0.0, 0.0, 0.3), command, 0.15, (1.0, 2.0), points), count)
            self.assertGreater(count, 0)

    def test_a_point_ahead_counts_only_where_the_way_to_rest_reaches_it(self):
        # 0.5 m/s for 0.1 s, then 0.125 m, and 0.2 m of the robot: 0.375 m.
        def met(x):
            return judge.swept_points(SQUARE, (0.0, 0.0, 0.0), (0.5, 0.0), 0.1, (1.0, 1.0), np.array([[x, 0.0]]))
        self.assertEqual([met(x) for x in (0.1, 0.3, 0.365, 0.385)], [0, 1, 1, 0])

    def test_braking_fully(self):
        # 0.6 - 1.0 x 0.05 = 0.55 m/s; 0.3 - 2.0 x 0.05 = 0.2 rad/s.
        def fully(command, measured=()):
            return judge.brakes_fully(command, (0.6, -0.3), list(measured), 0.05, (1.0, 2.0))
        self.assertTrue(fully((0.55, -0.2)))
        self.assertTrue(fully((0.0, 0.0)))
        self.assertFalse(fully((0.56, -0.2)))
        self.assertFalse(fully((0.55, -0.21)))
        self.assertTrue(fully((0.65, -0.2), [(0.7, 0.0)]))  # the robot is faster than it was told

    def test_mean_deviation(self):
        # Each command is held against what was recorded last: 0.1 - 0.2, 0.3 - 0.2, 0.3 - 0.5.
        v, omega = judge.mean_deviation(np.array([0.5, 1.0, 1.5, 2.0]), np.array([[9.0, 9.0], [0.1, 0], [0.3, 0], [0.3, 0.3]]),
                                        np.array([0.9, 1.9]), np.array([[0.2, 0.0], [0.5, 0.0]]))
        self.assertAlmostEqual(v, (0.1 + 0.1 + 0.2) / 3)
        self.assertAlmostEqual(omega, 0.1)
        self.assertIsNone(judge.mean_deviation(np.array([0.5]), np.zeros((1, 2)), np.array([0.9]), np.zeros((1, 2))))

    def test_footprints(self):
        self.assertAlmostEqual(np.hypot(*footprint_of({'robot_radius': 0.3}).T).min(), 0.3)
        np.testing.assert_array_equal(footprint_of({'footprint': SQUARE.tolist()}), SQUARE)
        np.testing.assert_array_equal(footprint_of({'footprint': str(SQUARE.tolist())}), SQUARE)
        with self.assertRaisesRegex(BagTestError, 'neither footprint nor robot_radius'):
            footprint_of({})


class PlansTest(unittest.TestCase):
    def test_a_free_way_is_straight_ahead_where_that_is_free(self):
        way = plans.free_way((1.0, 1.0, 0.0), np.array([[0.0, 1.0]]), 0.2, 2.0)
        np.testing.assert_allclose(way[[0, -1]], [[1.0, 1.0, 0.0], [3.0, 1.0, 0.0]], atol=1e-9)

    def test_it_keeps_clear_of_what_is_ahead_and_of_the_sides(self):
        wall = np.column_stack([np.full(401, 1.0), np.linspace(-20.0, 20.0, 401)])
        way = plans.free_way((0.0, 0.0, 0.0), wall, 0.2, 5.0)
        # Beside the wall it is free for as long as is asked for.
        self.assertAlmostEqual(math.hypot(*way[-1][:2]), 5.0)
        half = 0.2 + plans.MARGIN
        for x, y, _ in way:
            self.assertGreater(np.hypot(wall[:, 0] - x, wall[:, 1] - y).min(), half)

    def test_walled_in_there_is_none(self):
        angles = np.linspace(-math.pi, math.pi, 360)
        self.assertIsNone(plans.free_way((0.0, 0.0, 0.0), 0.5 * np.column_stack([np.cos(angles), np.sin(angles)]), 0.2, 2.0))

    def test_free_length(self):
        points = np.array([[2.0, 0.1], [1.0, 0.5], [-1.0, 0.0]])
        self.assertAlmostEqual(plans.free_length(points, 0.0, 0.3, 9.0), 1.7)
        self.assertEqual(plans.free_length(points, -math.pi / 2, 0.3, 9.0), 9.0)

    def test_the_driven_way_keeps_its_ends(self):
        poses = [(0.01 * i, 0.0, 0.0) for i in range(13)]
        np.testing.assert_allclose(plans.driven_way(poses)[:, 0], [0.0, 0.05, 0.10, 0.12])


class RecordingTest(unittest.TestCase):
    def test_placed_points_leave_out_beams_without_an_echo(self):
        from sensor_msgs.msg import LaserScan
        scan = LaserScan(angle_min=0.0, angle_increment=math.pi / 2, range_min=0.1, range_max=5.0,
                         ranges=[1.0, 0.0, math.inf, 2.0, math.nan, 5.0])
        np.testing.assert_allclose(placed_points(scan, (1.0, 1.0, math.pi / 2)), [[1.0, 2.0], [3.0, 1.0]], atol=1e-7)

    def test_shift_reaches_every_stamp_that_is_set(self):
        import rospy
        from geometry_msgs.msg import PoseStamped
        from nav_msgs.msg import Path
        path = Path(poses=[PoseStamped(), PoseStamped()])
        path.header.stamp = rospy.Time(10, 5)
        path.poses[1].header.stamp = rospy.Time(3, 0)
        shift(path, -5)
        self.assertEqual(path.header.stamp, rospy.Time(5, 5))
        self.assertTrue(path.poses[0].header.stamp.is_zero())  # was not set
        self.assertTrue(path.poses[1].header.stamp.is_zero())  # would lie before 0


if __name__ == '__main__':
    unittest.main()
