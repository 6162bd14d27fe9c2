# SPDX-License-Identifier: BSD-3-Clause
"""What a test or a soak needs of a running move_base: goals, a person's stick, what is logged, and whether the robot drives."""
import threading
import time

import rospy
from actionlib_msgs.msg import GoalID, GoalStatus
from geometry_msgs.msg import PoseStamped
from hidwa_local_planner.msg import OperatorState
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import Joy
from std_msgs.msg import UInt32

from command_watch import PLANNER
from hidwa_tools.waiting import wait_for

PREEMPTED = GoalStatus.PREEMPTED
STICK_RATE = 20.0  # [Hz]


class Journal:
    """What all nodes log."""

    def __init__(self):
        self._lock = threading.Lock()
        self.lines = []
        rospy.Subscriber('/rosout', Log, self._take, queue_size=None)

    def begin(self):
        with self._lock:
            self.lines = []

    def _take(self, message):
        with self._lock:
            self.lines.append(message.msg)

    def said(self, part):
        """Whether a line holds this text."""
        with self._lock:
            return any(part in line for line in self.lines)


class Stick:
    """A stick that repeats itself, in wall time: it knows nothing of the robot's clock."""

    def __init__(self, topic='/joy'):
        self.left, self.ahead, self.sends = 0.0, 0.0, True
        self._publisher = rospy.Publisher(topic, Joy, queue_size=1, tcp_nodelay=True)
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self):
        while not rospy.is_shutdown():
            if self.sends:
                message = Joy(axes=[self.left, self.ahead, 0.0], buttons=[0, 0, 0, 0])
                try:
                    self._publisher.publish(message)
                except rospy.ROSException:
                    return
            time.sleep(1.0 / STICK_RATE)


class RunningHost:
    """move_base as somebody sees it who sends goals."""

    def __init__(self, places):
        self._places, self._next = places, 0
        self.state, self.result, self.contacts = None, None, 0
        self.pose, self.velocity = None, (0.0, 0.0)
        self._goal = rospy.Publisher('/move_base_simple/goal', PoseStamped, queue_size=1)
        self._cancel = rospy.Publisher('/move_base/cancel', GoalID, queue_size=1)
        self._topics = [
            self._goal, self._cancel,
            rospy.Subscriber(PLANNER + '/operator_state', OperatorState, lambda m: setattr(self, 'state', m), queue_size=10),
            rospy.Subscriber('/move_base/result', MoveBaseActionResult, self._take_result, queue_size=10),
            rospy.Subscriber('/contacts', UInt32, lambda m: setattr(self, 'contacts', m.data), queue_size=10),
            rospy.Subscriber('/ground_truth', Odometry, self._take_truth, queue_size=10)]
        self._driving = False  # a goal is in hand

    def _take_result(self, message):
        self.result = message.status.status
        if self.result != PREEMPTED:  # the place of that one was taken by a newer one, or it was cancelled here
            self._driving = False

    def _take_truth(self, message):
        at, twist = message.pose.pose.position, message.twist.twist
        self.pose, self.velocity = (at.x, at.y), (twist.linear.x, twist.angular.z)

    def wait_until_ready(self):
        """False where move_base has not come up."""
        return wait_for(lambda: all(topic.get_num_connections() for topic in self._topics) and self.pose)

    def state_name(self):
        return self.state.state_name if self.state else ''

    def send_goal(self, x, y):
        goal = PoseStamped()
        goal.header.frame_id = 'map'
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = x, y, 1.0
        self._driving = True
        self._goal.publish(goal)

    def has_goal(self):
        """A goal was sent and has no result yet."""
        return self._driving

    def go_on(self):
        """Sends the next place where no goal is in hand."""
        if not self._driving:
            self.send_goal(*self._places[self._next % len(self._places)])
            self._next += 1

    def cancel(self):
        self._driving = False
        self._cancel.publish(GoalID())

    def drives(self, speed=0.3):
        """Whether the robot comes to drive by itself, a new goal given where the last one is done with."""
        def fast():
            self.go_on()
            return self.velocity[0] > speed
        return wait_for(fast)

    def account(self, what):
        """That, and what the robot does instead: for the message of a test that fails."""
        return (f'{what}: at {self.pose}, velocity {self.velocity}, state {self.state_name()}, '
                f'goal in hand {self._driving}, last result {self.result}')

    def stands(self):
        return wait_for(lambda: abs(self.velocity[0]) < 1e-3 and abs(self.velocity[1]) < 1e-3)
