#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A stalled move_base brakes nobody: the base must stop by itself when commands cease. The simulated one does, 0.5 s after the
last command."""
import math
import os
import signal
import sys
import threading
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
import rostest
from geometry_msgs.msg import Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry

COMMAND_TIMEOUT = 0.5  # of the base [s]
LATENCY = 0.1          # from a command to its effect, at most [s]
DECELERATION = 2.5     # [m/s^2]
SLACK = 1.0            # rate of the messages, and a busy machine; a base that does not stop drives on for ever [s]
PATIENCE = 300.0       # [s]


class BaseStopsTest(unittest.TestCase):
    def setUp(self):
        self.changed = threading.Condition()
        self.poses, self.last_command = [], None
        rospy.Subscriber('ground_truth', Odometry, self.take_pose)
        rospy.Subscriber('cmd_vel', Twist, self.take_command)

    def take_pose(self, message):
        with self.changed:
            pose, twist = message.pose.pose.position, message.twist.twist
            self.poses.append((message.header.stamp.to_sec(), pose.x, pose.y, abs(twist.linear.x), abs(twist.angular.z)))
            self.changed.notify_all()

    def take_command(self, _):
        with self.changed:
            self.last_command = rospy.get_time()

    def wait_for(self, condition, what):
        with self.changed:
            self.assertTrue(self.changed.wait_for(lambda: self.poses and condition(self.poses[-1]), PATIENCE), what)

    def test_a_stalled_host_leaves_a_robot_that_stops(self):
        client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(PATIENCE)))
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = 6.5, 1.5
        goal.target_pose.pose.orientation.w = 1.0
        client.send_goal(goal)
        self.wait_for(lambda pose: pose[3] > 0.4, 'the robot does not drive')
        node = xmlrpc.client.ServerProxy(rosgraph.Master('/test').lookupNode('/move_base'))
        host = node.getPid('/test')[2]
        os.kill(host, signal.SIGSTOP)
        try:
            with self.changed:
                stalled, speed = self.poses[-1], self.poses[-1][3]
            self.wait_for(lambda pose: pose[3] < 1e-3 and pose[4] < 1e-3, 'the robot does not stop')
            with self.changed:
                rest, ceased = self.poses[-1], self.last_command
            # From the last command on: the timeout, the latency, braking.
            self.assertLess(rest[0] - ceased, COMMAND_TIMEOUT + LATENCY + speed / DECELERATION + SLACK)
            way = math.hypot(rest[1] - stalled[1], rest[2] - stalled[2])
            # At 0.5 m/s until it brakes, then v^2 / 2a.
            self.assertLess(way, 0.5 * (COMMAND_TIMEOUT + LATENCY + SLACK) + 0.5 * 0.5 / (2 * DECELERATION))
            print(f'at rest {rest[0] - ceased:.2f} s after the last command, {way:.2f} m on')
        finally:
            os.kill(host, signal.SIGCONT)


if __name__ == '__main__':
    rospy.init_node('base_stops_test')
    rostest.rosrun('hidwa_plugin_tests', 'base_stops_test', BaseStopsTest, sys.argv)
