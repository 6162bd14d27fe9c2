# SPDX-License-Identifier: BSD-3-Clause
"""Turns the wheels of the robot's picture in rviz: joint_states out of the ground truth."""
import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState

RADIUS, SEPARATION = 0.0985, 0.4044  # [m], urdf/telepresence_base.urdf
PERIOD = 0.1                         # [s], simulated time


class Wheels:
    """Publishes joint_states while it lives."""

    def __init__(self):
        self._angles, self._last = [0.0, 0.0], None
        self._joints = rospy.Publisher('/joint_states', JointState, queue_size=1)
        self._truth = rospy.Subscriber('/ground_truth', Odometry, self._roll, queue_size=10)

    def _roll(self, truth):
        now = truth.header.stamp
        elapsed = (now - self._last).to_sec() if self._last else PERIOD
        if elapsed < PERIOD:
            return
        self._last = now
        v, omega = truth.twist.twist.linear.x, truth.twist.twist.angular.z
        for i, side in enumerate((1.0, -1.0)):
            self._angles[i] += (v - side * 0.5 * SEPARATION * omega) / RADIUS * elapsed
        joints = JointState(name=['left_wheel_joint', 'right_wheel_joint'], position=self._angles)
        joints.header.stamp = now
        self._joints.publish(joints)
