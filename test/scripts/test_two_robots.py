# SPDX-License-Identifier: BSD-3-Clause
"""Two robots with prefixed frames in namespaces of their own, by launch/two_robots.launch: each gets to its goal past the other.
Needs what scripts/build built."""
import math
import os
import tempfile
import unittest

import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from hidwa_local_planner.msg import MovingObstacles
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import Odometry
from std_msgs.msg import UInt32

from hidwa_tools import demo
from hidwa_tools.places import ROOT
from hidwa_tools.processes import Child
from hidwa_tools.waiting import wait_for

GOALS = {'robot1': (12.5, 19.5), 'robot2': (12.5, 13.5)}  # [m]; each lies beyond where the other one begins, in a corridor of 2.06 m


class Seen:
    """What a robot says."""

    def __init__(self, name):
        self.pose, self.result, self.contacts, self.touched, self.told, self.frames = None, None, 0, 0, 0, set()
        rospy.Subscriber(f'/{name}/ground_truth', Odometry, self.take_pose, queue_size=10)
        rospy.Subscriber(f'/{name}/move_base/result', MoveBaseActionResult, lambda m: setattr(self, 'result', m.status.status))
        rospy.Subscriber(f'/{name}/contacts', UInt32, lambda m: setattr(self, 'contacts', m.data))
        rospy.Subscriber(f'/{name}/contacts_moving', UInt32, lambda m: setattr(self, 'touched', m.data))
        rospy.Subscriber(f'/{name}/moving_obstacles', MovingObstacles, self.take_obstacles, queue_size=10)
        self.goal = rospy.Publisher(f'/{name}/move_base_simple/goal', PoseStamped, queue_size=1)

    def take_pose(self, message):
        self.pose = message.pose.pose.position.x, message.pose.pose.position.y

    def take_obstacles(self, message):
        self.frames.add(message.header.frame_id)
        self.told += bool(message.obstacles)


class TwoRobots(unittest.TestCase):
    def test_each_gets_to_its_goal_past_the_other(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = demo.environment(folder)
            port = environment['ROS_MASTER_URI'].rsplit(':', 1)[1]
            launched = Child(['roslaunch', '-p', port, os.path.join(ROOT, 'launch', 'two_robots.launch')],
                             os.path.join(folder, 'launch.log'), environment)
            self.addCleanup(launched.stop)
            demo.wait_for_master(launched)
            rospy.init_node('two_robots', disable_signals=True)
            robots = {name: Seen(name) for name in GOALS}
            for robot in robots.values():
                self.assertTrue(wait_for(lambda: robot.pose and robot.goal.get_num_connections()), launched.complaint())
            for name, (x, y) in GOALS.items():
                goal = PoseStamped()
                goal.header.frame_id = 'map'
                goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = x, y, 1.0
                robots[name].goal.publish(goal)
            for name, robot in robots.items():
                self.assertTrue(wait_for(lambda: robot.result is not None), f'{name} at {robot.pose}: {launched.complaint()}')
        for name, robot in robots.items():
            self.assertEqual(robot.result, GoalStatus.SUCCEEDED, name)
            self.assertLess(math.dist(robot.pose, GOALS[name]), 0.3)  # xy_goal_tolerance is 0.25 m
            self.assertEqual((robot.contacts, robot.touched), (0, 0), name)
            self.assertEqual(robot.frames, {f'{name}/odom'})
            self.assertGreater(robot.told, 0, f'{name} was never told of the other one')


if __name__ == '__main__':
    unittest.main()
