# SPDX-License-Identifier: BSD-3-Clause
"""Stands between a simulated robot and its planner: passes clock, odometry, scans and transforms on, disturbed as a test asks."""
import copy

import rospy
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

KINDS = {'clock': Clock, 'odom': Odometry, 'scan': LaserScan, 'tf': TFMessage}


class Gate:
    """`disturb(name, function)`: what comes on sim/<name> is sent as function(message), None: nothing. `heal()` ends all of it."""

    def __init__(self):
        self._disturbances = {}
        self.shift = 0.0  # [s], of all stamps
        for name, kind in KINDS.items():
            publisher = rospy.Publisher('/' + name, kind, queue_size=100, tcp_nodelay=True)
            rospy.Subscriber('/sim/' + name, kind, self._pass, (name, publisher), queue_size=100, tcp_nodelay=True)

    def disturb(self, name, function):
        self._disturbances[name] = function

    def drop(self, *names):
        """Nothing comes on these topics any more."""
        for name in names:
            self.disturb(name, lambda message: None)

    def heal(self):
        self._disturbances = {}

    def _pass(self, message, to):
        name, publisher = to
        disturbance = self._disturbances.get(name)
        if self.shift:
            shift(message, self.shift)
        message = disturbance(message) if disturbance else message
        if message is not None:
            try:
                publisher.publish(message)
            except rospy.ROSException:
                pass  # the test ends


def shift(message, seconds):
    """Moves the stamps of a message, in place."""
    by = rospy.Duration(seconds)
    if isinstance(message, Clock):
        message.clock += by
    elif isinstance(message, TFMessage):
        for transform in message.transforms:
            transform.header.stamp += by
    else:
        message.header.stamp += by
    return message


def transforms_with(child, change):
    """A disturbance of tf: `change` is applied to the transforms to this frame; None drops them."""
    def disturb(message):
        changed = []
        for transform in message.transforms:
            if transform.child_frame_id == child:
                transform = change(copy.deepcopy(transform))
            if transform is not None:
                changed.append(transform)
        return TFMessage(changed)
    return disturb
