# SPDX-License-Identifier: BSD-3-Clause
"""A standing robot in a small square map, and what the host says about it."""

import threading

import actionlib
import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionFeedback, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

SIZE = 120           # [cells]
RESOLUTION = 0.05    # [m]
ORIGIN = -3.0        # [m]
ROBOT = (-1.0, -1.0)
BLOCKED = (1.25, 1.25)  # centre of a block of half a metre
PLANNER = "/move_base/ProbePlannerROS"
PATIENCE = 120.0     # [s], for what must come; a slow machine takes long


def make_map():
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.width = grid.info.height = SIZE
    grid.info.resolution = RESOLUTION
    grid.info.origin.position.x = grid.info.origin.position.y = ORIGIN
    grid.info.origin.orientation.w = 1.0

    def occupied(x, y):
        edge = min(x, y, SIZE - 1 - x, SIZE - 1 - y) == 0
        in_block = all(abs(ORIGIN + (c + 0.5) * RESOLUTION - b) < 0.25 for c, b in zip((x, y), BLOCKED))
        return edge or in_block

    grid.data = [100 if occupied(x, y) else 0 for y in range(SIZE) for x in range(SIZE)]
    return grid


def make_transform(parent, child, x=0.0, y=0.0, z=0.0):
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = parent, child
    transform.header.stamp = rospy.Time.now()
    transform.transform.translation.x = x
    transform.transform.translation.y = y
    transform.transform.translation.z = z
    transform.transform.rotation.w = 1.0
    return transform


def make_pose(x, y, w=1.0):
    pose = PoseStamped()
    pose.header.frame_id = "map"
    pose.pose.position.x, pose.pose.position.y = x, y
    pose.pose.orientation.w = w
    return pose


class World:
    """Publishes map, transforms and scans; gathers the host's commands and the probe's events."""

    def __init__(self):
        self.lock = threading.Lock()
        self.events, self.commands, self.goals, self.feedback = [], [], [], 0
        self.scanning = True
        self.map_publisher = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        self.map_publisher.publish(make_map())
        self.transforms = tf2_ros.StaticTransformBroadcaster()
        self.transforms.sendTransform([make_transform("map", "odom"),
                                       make_transform("odom", "base_link", *ROBOT),
                                       make_transform("base_link", "laser", z=0.2)])
        self.scan_publisher = rospy.Publisher("scan", LaserScan, queue_size=5)
        self.timer = rospy.Timer(rospy.Duration(0.1), self._scan)
        self.answer_publisher = rospy.Publisher(PLANNER + "/answer", String, queue_size=10)
        self.simple_goal_publisher = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        rospy.Subscriber(PLANNER + "/event", String, self._event, queue_size=None)
        rospy.Subscriber("cmd_vel", Twist, self._command, queue_size=None)
        rospy.Subscriber("move_base/current_goal", PoseStamped, self._goal, queue_size=None)
        # Not the client's callback: it says nothing of feedback that arrives after the result.
        rospy.Subscriber("move_base/feedback", MoveBaseActionFeedback, self._feedback, queue_size=None)
        self.client = None

    def connect(self):
        """Waits for the host's action server; False when it does not come."""
        self.client = actionlib.ActionClient("move_base", MoveBaseAction)
        return self.client.wait_for_server(rospy.Duration(60.0))

    def send(self, x, y, w=1.0):
        return self.client.send_goal(MoveBaseGoal(target_pose=make_pose(x, y, w)))

    def answer(self, how):
        """Tells the probe how to answer and waits until it heard."""
        heard = self.count("callback")
        self.answer_publisher.publish(how)
        return self.wait(lambda: self.count("callback") > heard)

    def count(self, start):
        with self.lock:
            return sum(event.startswith(start) for event in self.events)

    def wait(self, condition):
        end = rospy.Time.now() + rospy.Duration(PATIENCE)
        while not condition():
            if rospy.is_shutdown() or rospy.Time.now() > end:
                return False
            rospy.sleep(0.01)
        return True

    def wait_calm(self, seconds=0.5):
        """Waits until neither the probe nor the robot has heard anything for a while."""
        state = {"seen": -1, "since": rospy.Time.now()}

        def calm():
            with self.lock:
                seen = len(self.events) + len(self.commands)
            if seen != state["seen"]:
                state.update(seen=seen, since=rospy.Time.now())
            return rospy.Time.now() - state["since"] > rospy.Duration(seconds)
        return self.wait(calm)

    def take(self):
        """What was gathered since the last call."""
        with self.lock:
            taken = (self.events, self.commands, self.goals, self.feedback)
            self.events, self.commands, self.goals, self.feedback = [], [], [], 0
        return taken

    def _event(self, message):
        with self.lock:
            self.events.append(message.data)

    def _scan(self, _event):
        if not self.scanning:
            return
        scan = LaserScan()
        scan.header.frame_id, scan.header.stamp = "laser", rospy.Time.now()
        scan.angle_min, scan.angle_max, scan.angle_increment = -3.1, 3.1, 0.1
        scan.range_min, scan.range_max = 0.05, 10.0
        scan.ranges = [5.0] * 63
        self.scan_publisher.publish(scan)

    def _command(self, twist):
        moving = any((twist.linear.x, twist.linear.y, twist.angular.z))
        with self.lock:
            self.commands.append("moving" if moving else "zero")

    def _goal(self, pose):
        point = pose.pose.position
        with self.lock:
            self.goals.append("(%g, %g) in %s" % (point.x, point.y, pose.header.frame_id))

    def _feedback(self, _message):
        with self.lock:
            self.feedback += 1


def status_name(handle):
    known = ("PENDING", "ACTIVE", "PREEMPTED", "SUCCEEDED", "ABORTED", "REJECTED")
    names = {getattr(GoalStatus, name): name for name in known}
    return names.get(handle.get_goal_status(), str(handle.get_goal_status()))
