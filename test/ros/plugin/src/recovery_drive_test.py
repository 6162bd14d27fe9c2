#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A goal inside a wall: move_base recovers twice, without a move, and not while somebody holds the robot."""
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from hidwa_local_planner.msg import OperatorState
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal, RecoveryStatus
from std_msgs.msg import Bool

WALL = (0.0, 2.5)  # the room's edge [m]
PATIENCE = 300.0   # [s] of simulated time


class Seen:
    """Messages of the topics that matter, in order."""

    def __init__(self):
        self.lock = threading.Lock()
        self.messages = {}

    def listen(self, topic, kind):
        self.messages[topic] = []
        rospy.Subscriber(topic, kind, self._keep, topic, queue_size=None)

    def _keep(self, message, topic):
        with self.lock:
            self.messages[topic].append(message)

    def of(self, topic):
        with self.lock:
            return list(self.messages[topic])


def wait_for(condition, seconds=PATIENCE):
    """Until `condition` holds; False after so many seconds of simulated time."""
    end = rospy.Time.now() + rospy.Duration(seconds)
    while not condition():
        if rospy.is_shutdown() or rospy.Time.now() > end:
            return False
        rospy.sleep(0.05)
    return True


class RecoveryDriveTest(unittest.TestCase):
    def test_recovers_without_a_move_and_yields(self):
        seen = Seen()
        seen.listen('/cmd_vel', Twist)
        seen.listen('/move_base/recovery_status', RecoveryStatus)
        seen.listen('/move_base/HIDWAPlannerROS/operator_state', OperatorState)
        stop = rospy.Publisher('/move_base/HIDWAPlannerROS/stop', Bool, queue_size=1)
        client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(PATIENCE)))
        self.assertTrue(wait_for(lambda: stop.get_num_connections() > 0))
        stop.publish(True)

        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = WALL
        goal.target_pose.pose.orientation.w = 1.0
        client.send_goal(goal)

        def tried():
            return [status.recovery_behavior_name for status in seen.of('/move_base/recovery_status')]

        def held():
            states = seen.of('/move_base/HIDWAPlannerROS/operator_state')
            return bool(states) and states[-1].state_name == 'STOPPED'
        self.assertTrue(wait_for(tried), 'nothing recovers')
        self.assertTrue(wait_for(held), 'the recovery does not hear the person')
        # planner_patience is 1 s: without the person the second one would have begun.
        self.assertFalse(wait_for(lambda: len(tried()) > 1, 4), 'the recovery does not wait')
        self.assertTrue(held())

        stop.publish(False)
        self.assertTrue(client.wait_for_result(rospy.Duration(PATIENCE)), 'no result')
        self.assertEqual(client.get_state(), GoalStatus.ABORTED)
        self.assertEqual(tried(), ['clear_far', 'clear_near'])
        moves = [c for c in seen.of('/cmd_vel') if c.linear.x or c.angular.z]
        self.assertEqual(moves, [])


if __name__ == '__main__':
    rospy.init_node('recovery_drive_test')
    rostest.rosrun('hidwa_plugin_tests', 'recovery_drive_test', RecoveryDriveTest, sys.argv)
