#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Through the door of maps/room.yaml to the goal: arrives, touches nothing, tells of every cycle."""
import math
import os
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *4 * ('..',)))
sys.path[0:0] = [os.path.join(ROOT, 'test', 'support'), os.path.join(ROOT, 'scripts', 'lib')]
import rospy  # noqa: E402
import rostest  # noqa: E402
from actionlib_msgs.msg import GoalStatus  # noqa: E402
from hidwa_local_planner.msg import Cycle  # noqa: E402

from command_watch import PLANNER  # noqa: E402
from hidwa_tools.waiting import wait_for  # noqa: E402
from running_host import RunningHost  # noqa: E402

GOAL = (6.5, 1.5)  # beyond the wall [m]


class DriveTest(unittest.TestCase):
    def test_drives_to_the_goal(self):
        cycles, host = [], RunningHost((GOAL,))
        rospy.Subscriber(PLANNER + '/cycle', Cycle, cycles.append, queue_size=None)
        self.assertTrue(host.wait_until_ready(), 'move_base does not come up')
        host.send_goal(*GOAL)
        self.assertTrue(wait_for(lambda: host.result is not None), 'no result')
        self.assertEqual(host.result, GoalStatus.SUCCEEDED)
        self.assertLess(math.dist(host.pose, GOAL), 0.35)
        self.assertEqual(host.contacts, 0)
        seen = list(cycles)
        self.assertEqual(len(seen), 1 + seen[-1].header.seq - seen[0].header.seq)  # none was left out
        driven = [c for c in seen if c.outcome == Cycle.DRIVE]
        self.assertGreater(len(driven), 0.9 * len(seen))
        self.assertTrue(all(c.candidates >= 419 for c in driven))


if __name__ == '__main__':
    rospy.init_node('drive_test')
    rostest.rosrun('hidwa_plugin_tests', 'drive_test', DriveTest, sys.argv)
