# SPDX-License-Identifier: BSD-3-Clause
"""The simulated robot with move_base and the console, on a roscore of its own, and what the tests see of it through ROS alone."""
import math
import os
import shutil
import tempfile
import threading
import time

from hidwa_tools.processes import Child, free_port
from hidwa_tools.waiting import PATIENCE

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..'))


class Robot:
    """start: (x, y, yaw) in the map [m, m, rad]; options: of the console; arguments: more of demo.launch. Needs the environment of
    scripts/env."""

    def __init__(self, start=(21.5, 8.7, 0.0), options='', arguments=()):
        self.folder = tempfile.mkdtemp(prefix='console_robot_')
        self.port, self.ros_port = free_port(), free_port()
        environment = dict(os.environ, ROS_MASTER_URI='http://localhost:%d' % self.ros_port, ROS_HOSTNAME='localhost',
                           ROS_LOG_DIR=self.folder, ROS_HOME=self.folder)
        os.environ.update({name: environment[name] for name in ('ROS_MASTER_URI', 'ROS_HOSTNAME', 'ROS_LOG_DIR', 'ROS_HOME')})
        self.log = os.path.join(self.folder, 'robot.log')
        page = os.path.join(ROOT, 'console', 'page')
        self.child = Child(['roslaunch', '-p', str(self.ros_port), 'hidwa_local_planner', 'demo.launch', 'operator:=page',
                            'x:=%g' % start[0], 'y:=%g' % start[1], 'yaw:=%g' % start[2], 'console_port:=%d' % self.port,
                            'console_options:=--page %s --recordings %s %s' % (page, self.folder, options), *arguments],
                           self.log, environment)
        self.lock = threading.Lock()
        self.joys, self.commands, self.states, self.hands, self.contacts = [], [], [], [], 0
        self.pose, self.has_goal, self._before = None, False, 0
        try:
            self._connect()
        except Exception:
            self.end()
            raise

    def _connect(self):
        deadline = time.monotonic() + PATIENCE
        while not self._printed('console: http'):
            if not self.child.running or time.monotonic() > deadline:
                raise AssertionError('the console did not start: ' + self.child.complaint())
            time.sleep(0.1)
        import rospy
        from actionlib_msgs.msg import GoalStatus, GoalStatusArray
        from geometry_msgs.msg import PoseStamped, Twist
        from hidwa_local_planner.msg import OperatorState
        from nav_msgs.msg import Odometry
        from sensor_msgs.msg import Joy
        from std_msgs.msg import UInt32
        rospy.init_node('console_browser_test', disable_signals=True)
        self.subscribers = [
            rospy.Subscriber('/joy', Joy, lambda m: self._keep(self.joys, m), queue_size=1000, tcp_nodelay=True),
            rospy.Subscriber('/cmd_vel', Twist, lambda m: self._keep(self.commands, (m.linear.x, m.angular.z)), queue_size=1000),
            rospy.Subscriber('/hand_pose', PoseStamped, lambda m: self._keep(self.hands, m), queue_size=1000),
            rospy.Subscriber('/ground_truth', Odometry, self._place, queue_size=1),
            rospy.Subscriber('/contacts', UInt32, self._touch, queue_size=1),
            rospy.Subscriber('/move_base/status', GoalStatusArray, self._goals,
                             (GoalStatus.PENDING, GoalStatus.ACTIVE, GoalStatus.PREEMPTING)),
            rospy.Subscriber('/move_base/HIDWAPlannerROS/operator_state', OperatorState,
                             lambda m: self._keep(self.states, m.state_name), queue_size=1000)]
        # The planner must be there to see the page's first centred stick.
        while self.pose is None or self.subscribers[-1].get_num_connections() == 0:
            if time.monotonic() > deadline:
                raise AssertionError('no robot: ' + self.child.complaint())
            time.sleep(0.05)

    def _printed(self, text):
        with open(self.log, encoding='utf-8', errors='replace') as lines:
            return text in lines.read()

    def _keep(self, where, value):
        with self.lock:
            where.append((time.monotonic(), value))

    def _place(self, message):
        p, q = message.pose.pose.position, message.pose.pose.orientation
        self.pose = (p.x, p.y, math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z)))
        self.speed = (message.twist.twist.linear.x, message.twist.twist.angular.z)

    def _touch(self, message):
        self.contacts = message.data

    def _goals(self, message, in_hand):
        has_goal = any(goal.status in in_hand for goal in message.status_list)
        with self.lock:
            if has_goal and not self.has_goal:
                self._before = len(self.states)
            self.has_goal = has_goal

    def since(self, where, began):
        """What came at or after a time of time.monotonic()."""
        with self.lock:
            return [value for at, value in where if at >= began]

    def steered(self, began):
        """Joy messages with a deflection since a time."""
        return [joy for joy in self.since(self.joys, began) if any(abs(axis) > 0.05 for axis in joy.axes[:2])]

    @property
    def state(self):
        """The state of the newest cycle towards the goal that the host has in hand, or empty."""
        with self.lock:
            return self.states[-1][1] if self.has_goal and len(self.states) > self._before else ''

    def end(self):
        """Ends everything that was started here."""
        self.child.stop()
        shutil.rmtree(self.folder, ignore_errors=True)
