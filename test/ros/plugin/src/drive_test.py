#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Through the door of maps/room.yaml to the goal: arrives, touches nothing, tells of every cycle."""
import math
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from hidwa_local_planner.msg import Cycle
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry
from std_msgs.msg import UInt32

GOAL = (6.5, 1.5)  # beyond the wall [m]
PATIENCE = rospy.Duration(300)  # of simulated time


class DriveTest(unittest.TestCase):
    def test_drives_to_the_goal(self):
        lock = threading.Lock()
        seen = {'contacts': None, 'cycles': [], 'pose': None}

        def keep(key):
            def callback(message):
                with lock:
                    if key == 'cycles':
                        seen[key].append(message)
                    else:
                        seen[key] = message
            return callback

        rospy.Subscriber('contacts', UInt32, keep('contacts'))
        rospy.Subscriber('ground_truth', Odometry, keep('pose'))
        rospy.Subscriber('/move_base/HIDWAPlannerROS/cycle', Cycle, keep('cycles'))
        client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(client.wait_for_server(PATIENCE))
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = GOAL
        goal.target_pose.pose.orientation.w = 1.0
        client.send_goal(goal)
        self.assertTrue(client.wait_for_result(PATIENCE), 'no result')
        self.assertEqual(client.get_state(), GoalStatus.SUCCEEDED, client.get_goal_status_text())

        with lock:
            pose = seen['pose'].pose.pose.position
            self.assertLess(math.hypot(pose.x - GOAL[0], pose.y - GOAL[1]), 0.35)
            self.assertEqual(seen['contacts'].data, 0)
            cycles = seen['cycles']
        self.assertEqual(len(cycles), 1 + cycles[-1].header.seq - cycles[0].header.seq)  # none was left out
        driven = [c for c in cycles if c.outcome == Cycle.DRIVE]
        self.assertGreater(len(driven), 0.9 * len(cycles))
        self.assertTrue(all(c.candidates >= 419 for c in driven))


if __name__ == '__main__':
    rospy.init_node('drive_test')
    rostest.rosrun('hidwa_plugin_tests', 'drive_test', DriveTest, sys.argv)
