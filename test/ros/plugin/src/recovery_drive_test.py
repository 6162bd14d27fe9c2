#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A goal inside a wall: move_base recovers twice, without a move, and not while somebody holds the robot."""
import os
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *4 * ('..',)))
sys.path[0:0] = [os.path.join(ROOT, 'test', 'support'), os.path.join(ROOT, 'scripts', 'lib')]
import rospy  # noqa: E402
import rostest  # noqa: E402
from actionlib_msgs.msg import GoalStatus  # noqa: E402
from geometry_msgs.msg import Twist  # noqa: E402
from move_base_msgs.msg import RecoveryStatus  # noqa: E402
from std_msgs.msg import Bool  # noqa: E402

from command_watch import PLANNER  # noqa: E402
from hidwa_tools.waiting import wait_for  # noqa: E402
from running_host import RunningHost  # noqa: E402

WALL = (0.0, 2.5)  # the room's edge [m]


class RecoveryDriveTest(unittest.TestCase):
    def test_recovers_without_a_move_and_yields(self):
        tried, commands, host = [], [], RunningHost((WALL,))
        rospy.Subscriber('/move_base/recovery_status', RecoveryStatus, tried.append, queue_size=None)
        rospy.Subscriber('/cmd_vel', Twist, commands.append, queue_size=None)
        stop = rospy.Publisher(PLANNER + '/stop', Bool, queue_size=1)
        self.assertTrue(host.wait_until_ready(), 'move_base does not come up')
        self.assertTrue(wait_for(stop.get_num_connections), 'nobody listens to stop')
        stop.publish(True)
        host.send_goal(*WALL)
        self.assertTrue(wait_for(lambda: tried), 'nothing recovers')
        self.assertTrue(wait_for(lambda: host.state_name() == 'STOPPED'), 'the recovery does not hear the person')
        # planner_patience is 1 s: without the person the second one would have begun.
        end = rospy.get_time() + 4.0
        self.assertTrue(wait_for(lambda: rospy.get_time() > end), 'the clock stands still')
        self.assertEqual(len(tried), 1, 'the recovery does not wait')
        self.assertEqual(host.state_name(), 'STOPPED')

        stop.publish(False)
        self.assertTrue(wait_for(lambda: host.result is not None), 'no result')
        self.assertEqual(host.result, GoalStatus.ABORTED)
        self.assertEqual([status.recovery_behavior_name for status in tried], ['clear_far', 'clear_near'])
        self.assertEqual([c for c in commands if c.linear.x or c.angular.z], [])


if __name__ == '__main__':
    rospy.init_node('recovery_drive_test')
    rostest.rosrun('hidwa_plugin_tests', 'recovery_drive_test', RecoveryDriveTest, sys.argv)
