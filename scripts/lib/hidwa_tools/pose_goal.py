# SPDX-License-Identifier: BSD-3-Clause
"""A goal of move_base's action."""
import math

import rospy
from move_base_msgs.msg import MoveBaseActionGoal


def goal_message(goal, name, frame='map'):
    """A move_base goal [x, y, yaw] [m, m, rad]; `name` is its id."""
    message = MoveBaseActionGoal()
    target = message.goal.target_pose
    message.header.stamp = message.goal_id.stamp = target.header.stamp = rospy.Time.now()
    message.goal_id.id, target.header.frame_id = name, frame
    target.pose.position.x, target.pose.position.y = goal[:2]
    target.pose.orientation.z, target.pose.orientation.w = math.sin(goal[2] / 2), math.cos(goal[2] / 2)
    return message
