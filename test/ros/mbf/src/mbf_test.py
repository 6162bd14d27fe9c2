#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The planner as a controller of Move Base Flex: arrives at rest, brakes when cancelled, names what goes wrong."""
import math
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, Twist
from mbf_msgs.msg import ExePathAction, ExePathGoal, ExePathResult, GetPathAction, GetPathGoal, GetPathResult
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry, Path
from std_msgs.msg import UInt32

NAME = '/move_base_flex/'
BEYOND = (6.5, 1.5)  # through the door [m]
BACK = (2.0, 1.5)    # [m]
PERIOD = 0.05        # [s]
PATIENCE = 300.0     # [s] of simulated time
# With launch/params/telepresence_base.yaml.
ACC_X, ACC_THETA = 2.5, 3.2  # [m/s^2, rad/s^2]


def pose_at(x, y, yaw=0.0):
    pose = PoseStamped()
    pose.header.frame_id = 'map'
    pose.pose.position.x, pose.pose.position.y = x, y
    pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return pose


class MoveBaseFlexTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lock, cls.commands, cls.truth, cls.contacts = threading.Lock(), [], None, None
        rospy.Subscriber('cmd_vel', Twist, cls.command)
        rospy.Subscriber('ground_truth', Odometry, lambda message: setattr(cls, 'truth', message))
        rospy.Subscriber('contacts', UInt32, lambda message: setattr(cls, 'contacts', message.data))
        cls.paths = cls.client(NAME + 'get_path', GetPathAction)
        cls.controller = cls.client(NAME + 'exe_path', ExePathAction)

    @staticmethod
    def client(name, action):
        client = actionlib.SimpleActionClient(name, action)
        if not client.wait_for_server(rospy.Duration(PATIENCE)):
            raise AssertionError(f'no action server {name}')
        return client

    @classmethod
    def command(cls, message):
        with cls.lock:
            cls.commands.append((message.linear.x, message.angular.z))

    def wait(self, what, condition):
        end = rospy.get_time() + PATIENCE
        while not condition():
            self.assertLess(rospy.get_time(), end, f'{what}: not within {PATIENCE:.0f} s')
            rospy.sleep(0.02)

    def speed(self):
        return abs(self.truth.twist.twist.linear.x) + abs(self.truth.twist.twist.angular.z)

    def path_to(self, x, y):
        self.paths.send_goal(GetPathGoal(target_pose=pose_at(x, y), use_start_pose=False))
        self.assertTrue(self.paths.wait_for_result(rospy.Duration(PATIENCE)))
        result = self.paths.get_result()
        self.assertEqual(result.outcome, GetPathResult.SUCCESS, result.message)
        return result.path

    def follow(self, path):
        self.controller.send_goal(ExePathGoal(path=path, controller='HIDWAPlannerROS'))

    def result(self):
        self.assertTrue(self.controller.wait_for_result(rospy.Duration(PATIENCE)), f'no result in {PATIENCE:.0f} s')
        return self.controller.get_result()

    def assert_rest(self):
        """Nobody but the planner stops the robot: the last command must be zero."""
        with self.lock:
            self.assertEqual(self.commands[-1], (0.0, 0.0))
        self.wait('the robot stands', lambda: self.speed() < 0.01)
        self.assertEqual(self.contacts, 0)

    def test_1_cancelled_in_full_drive_it_brakes_within_the_limits(self):
        self.follow(self.path_to(*BEYOND))
        self.wait('it drives', lambda: self.truth and self.truth.twist.twist.linear.x > 0.45)
        self.controller.cancel_goal()
        with self.lock:
            before = len(self.commands)
        result = self.result()
        self.assertEqual(self.controller.get_state(), GoalStatus.PREEMPTED)
        self.assertEqual(result.outcome, ExePathResult.CANCELED)
        with self.lock:
            braking = self.commands[max(0, before - 1):]
        # 0.45 m/s at 2.5 m/s^2 are 0.18 s: at least three commands on the way.
        self.assertGreaterEqual(len([v for v, _ in braking if v > 0.0]), 3, braking)
        for (v0, w0), (v1, w1) in zip(braking, braking[1:]):
            self.assertLessEqual(abs(v1 - v0), ACC_X * PERIOD + 1e-6, braking)
            self.assertLessEqual(abs(w1 - w0), ACC_THETA * PERIOD + 1e-6, braking)
        self.assert_rest()

    def test_2_arrives_within_the_tolerance_of_the_host(self):
        self.follow(self.path_to(*BEYOND))
        result = self.result()
        self.assertEqual(result.outcome, ExePathResult.SUCCESS, result.message)
        self.assertLess(result.dist_to_goal, 0.12 + 0.03)  # and what the last braking may add
        self.assertLess(abs(result.angle_to_goal), 0.15 + 0.05)
        self.assert_rest()

    def test_3_move_bases_own_action_is_relayed(self):
        client = self.client('/move_base', MoveBaseAction)
        goal = MoveBaseGoal()
        goal.target_pose = pose_at(*BACK, yaw=math.pi)
        client.send_goal(goal)
        self.assertTrue(client.wait_for_result(rospy.Duration(PATIENCE)))
        self.assertEqual(client.get_state(), GoalStatus.SUCCEEDED, client.get_goal_status_text())
        self.assert_rest()

    def test_4_a_path_that_is_not_a_number_is_an_invalid_path(self):
        path = Path(poses=[pose_at(2.0, 1.5), pose_at(math.nan, 1.5), pose_at(1.0, 1.5)])
        self.follow(path)
        result = self.result()
        self.assertEqual(result.outcome, ExePathResult.INVALID_PATH, result.message)
        self.assertIn('not a number', result.message)

    def test_5_a_path_through_the_wall_is_blocked(self):
        x, y = self.truth.pose.pose.position.x, self.truth.pose.pose.position.y
        steps = 100
        self.follow(Path(poses=[pose_at(x + (7.0 - x) * i / steps, y) for i in range(steps + 1)]))
        result = self.result()
        self.assertEqual(self.controller.get_state(), GoalStatus.ABORTED)
        self.assertEqual(result.outcome, ExePathResult.BLOCKED_PATH, result.message)
        self.assertIn('stuck', result.message)
        self.assert_rest()


if __name__ == '__main__':
    rospy.init_node('mbf_test')
    rostest.rosrun('hidwa_mbf_tests', 'mbf_test', MoveBaseFlexTest, sys.argv)
