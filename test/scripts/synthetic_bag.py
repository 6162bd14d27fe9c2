# SPDX-License-Identifier: BSD-3-Clause
"""Writes bags like the demo's, of drives whose figures are known by construction."""
import json
import math
import os

import genpy
import rosbag
from actionlib_msgs.msg import GoalStatus
from genpy.dynamic import generate_dynamic
from dynamic_reconfigure.msg import Config, StrParameter
from geometry_msgs.msg import Point, Point32, PoseStamped, Quaternion, Transform, TransformStamped, Twist, Vector3
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import Joy, LaserScan
from std_msgs.msg import Header, String, UInt32
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
PLANNER = '/move_base/HIDWAPlannerROS/'
RATE = 50              # [Hz], ground truth
SPEED = 0.5            # [m/s]
RESOLUTION = 0.05      # [m]
ORIGIN = (-2.0, -3.0)  # [m]
SIZE = (400, 120)      # cells: x from -2 to 18 m, y from -3 to 3 m
FOOTPRINT = [[0.2, 0.15], [-0.2, 0.15], [-0.2, -0.15], [0.2, -0.15]]


def own_message(name, of=None, without=()):
    """The class of one of our messages, out of msg/ (no built workspace needed), or of another one that it is made `of`. `without`:
    fields that it lacks, as in an older release."""
    with open(os.path.join(ROOT, 'msg', name + '.msg'), encoding='utf-8') as text:
        definition = ''.join(line for line in text if line.split()[1:2] not in [[field] for field in without])
    parts = [definition]
    for package, cls in (('std_msgs/Header', Header), ('geometry_msgs/Twist', Twist), ('geometry_msgs/Point32', Point32),
                         ('geometry_msgs/Point', Point), ('geometry_msgs/Vector3', Vector3)):
        parts.append(f'MSG: {package}\n{cls._full_text}')
    if name == 'MovingObstacles':
        for part in ('MovingObstacle', 'ObservedSector'):
            with open(os.path.join(ROOT, 'msg', part + '.msg'), encoding='utf-8') as text:
                parts.append(f'MSG: hidwa_local_planner/{part}\n' + text.read())
    full = ('\n' + '=' * 80 + '\n').join(parts)
    return generate_dynamic('hidwa_local_planner/' + name, full)['hidwa_local_planner/' + (of or name)]


class SyntheticDrive:
    """A drive along y = lateral(x) at constant forward speed from x = 0 to x = length."""

    def __init__(self, length=10.0, lateral=lambda x: 0.0, blocks=(), regions=(), stick=lambda t: 0.0, arrived=True, people=(),
                 without_goal=lambda t: False):
        """people: {id: [(time, x, y), ...]}, discs of 0.3 m. blocks: occupied rectangles (x0, y0, x1, y1) on multiples
        of 0.05 m; stick: deflection over time; without_goal: whether the person drives without a goal, over time."""
        self.length, self.lateral, self.blocks, self.regions = length, lateral, blocks, regions
        self.stick, self.arrived, self.without_goal = stick, arrived, without_goal
        self.info = {'map': 'synthetic', 'mode': 'joystick', 'host': 'compat', 'planner': 'HIDWAPlannerROS',
                     'operator': 'script', 'start': [0, 0, 0], 'goal': [length, 0, 0], 'rate': 1.0,
                     'footprint': FOOTPRINT, 'stick': {'axis': 0, 'sign': 1, 'dead_zone': 0.1}}
        self.omit = ()  # topics left out
        self.unknown = ()  # fields of the state that this release does not know
        self.people = dict(people)

    def write(self, path):
        """Writes the bag; the goal comes 1 s after its begin."""
        self._cycle, self._state = own_message('Cycle'), own_message('OperatorState', without=self.unknown)
        with rosbag.Bag(path, 'w') as bag:
            self._bag = bag
            self._put('/demo_info', 0.1, String(json.dumps(self.info)))
            self._put('/map', 0.1, self._map())
            self._put('/regions', 0.1, self._markers())
            self._people()
            goal = MoveBaseActionGoal()
            goal.goal.target_pose.pose.position.x = self.length
            self._put('/move_base/goal', 1.0, goal)
            self._put('/move_base/NavfnROS/plan', 1.1, self._plan())
            end = 1.0 + math.ceil(self.length / SPEED * RATE - 1e-9) / RATE
            for i in range(int(round((end + 0.5) * RATE)) + 1):
                self._moment(i / RATE)
            result = MoveBaseActionResult()
            result.status.status = GoalStatus.SUCCEEDED if self.arrived else GoalStatus.ABORTED
            self._put('/move_base/result', end, result)
        return path

    def _put(self, topic, time, message):
        if topic not in self.omit:
            self._bag.write(topic, message, genpy.Time.from_sec(time))

    def _map(self):
        grid = OccupancyGrid()
        grid.info.resolution, grid.info.width, grid.info.height = RESOLUTION, *SIZE
        grid.info.origin.position.x, grid.info.origin.position.y = ORIGIN
        grid.info.origin.orientation.w = 1.0
        data = [0] * (SIZE[0] * SIZE[1])
        for x0, y0, x1, y1 in self.blocks:
            columns = range(round((x0 - ORIGIN[0]) / RESOLUTION), round((x1 - ORIGIN[0]) / RESOLUTION))
            for row in range(round((y0 - ORIGIN[1]) / RESOLUTION), round((y1 - ORIGIN[1]) / RESOLUTION)):
                for column in columns:
                    data[row * SIZE[0] + column] = 100
        grid.data = data
        return grid

    def _markers(self):
        array = MarkerArray()
        for i, polygon in enumerate(self.regions):
            marker = Marker(id=i, type=Marker.LINE_STRIP)
            marker.pose.orientation.w = 1.0
            marker.points = [Point(x, y, 0.0) for x, y in [*polygon, polygon[0]]]
            array.markers.append(marker)
        return array

    def _people(self):
        kind, part = own_message('MovingObstacles'), own_message('MovingObstacles', 'MovingObstacle')
        for key, track in self.people.items():
            for time, x, y in track:
                message = kind()
                message.header.stamp, message.header.frame_id = genpy.Time.from_sec(time), 'map'
                obstacle = part()
                obstacle.id, obstacle.position.x, obstacle.position.y, obstacle.radius = key, x, y, 0.3
                message.obstacles = [obstacle]
                self._put('/moving_obstacles_truth', time, message)

    def _plan(self):
        path = Path()
        for i in range(int(round(self.length / RESOLUTION)) + 1):
            pose = PoseStamped()
            pose.pose.position.x = i * RESOLUTION
            path.poses.append(pose)
        return path

    def _moment(self, time):
        x = min(max(time - 1.0, 0.0) * SPEED, self.length)
        yaw = math.atan2(self.lateral(x + 1e-3) - self.lateral(x - 1e-3), 2e-3)
        truth = Odometry()
        truth.header.stamp = genpy.Time.from_sec(time)
        truth.pose.pose.position.x, truth.pose.pose.position.y = x, self.lateral(x)
        truth.pose.pose.orientation.z, truth.pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        truth.twist.twist.linear.x = SPEED
        self._put('/ground_truth', time, truth)
        self._put('/contacts', time, UInt32(0))
        deflection = self.stick(time)
        self._put('/joy', time, Joy(axes=[deflection, 0.0]))
        state = self._state()
        state.state, state.active = (1, True) if abs(deflection) > 0.1 else (0, False)
        state.wanted.angular.z = deflection
        if self.without_goal(time):
            state.state, state.active, state.without_goal = 3, True, True
        self._put(PLANNER + 'operator_state', time, state)
        cycle = self._cycle()
        cycle.duration = 0.002 if round(time * RATE) % 50 else 0.006
        self._put(PLANNER + 'cycle', time, cycle)
        command = Twist()
        command.linear.x, command.angular.z = SPEED, 0.01 * (round(time * RATE) % 2)
        self._put('/cmd_vel', time, command)


class RealDrive:
    """What a real robot's recorder writes of a drive along y = 0 in the map, at SPEED from x = 0, without any ground truth.

    The odometry began elsewhere: map -> odom is the pose OFFSET. The laser stands MOUNTED ahead of the robot's centre and
    sees a wall to its left, at y = WALL. Each goal takes 10 s: 5 m."""
    OFFSET = (3.0, -2.0, 0.5)  # [m, m, rad]
    MOUNTED, WALL, RATE = 0.1, 1.0, 20

    def __init__(self, goals=1, namespace='', base='base_link', odom='odom'):
        self.goals, self.namespace, self.base, self.odom = goals, namespace, base, odom
        self.footprint = None        # of the local costmap's parameter_updates, as text
        self.leave_out = set()       # names of topics without the namespace
        self.fixed = []              # (parent, child) of more static transforms
        self.upside_down = False     # the laser hangs so: it counts the same beams clockwise

    def write(self, path):
        """Writes the bag and returns its path."""
        with rosbag.Bag(path, 'w') as bag:
            self._bag = bag
            laser = self._link(0.0, self.base, 'laser', self.MOUNTED, 0.0, 0.0)
            if self.upside_down:
                laser.transform.rotation = Quaternion(1.0, 0.0, 0.0, 0.0)  # turned about x by pi
            self._put('/tf_static', 0.0, TFMessage(
                [laser,
                 *(self._link(0.0, parent, child, 0.0, 0.0, 0.0) for parent, child in self.fixed)]))
            if self.footprint:
                self._put('move_base/local_costmap/parameter_updates', 0.0, Config(strs=[StrParameter('footprint', self.footprint)]))
            for i in range(self.goals):
                begin = 1.0 + 10.0 * i
                goal, result = MoveBaseActionGoal(), MoveBaseActionResult()
                goal.goal_id.id = result.status.goal_id.id = f'goal {i}'
                goal.goal.target_pose.header.frame_id = 'map'
                goal.goal.target_pose.pose.position.x = 5.0 * (i + 1)
                goal.goal.target_pose.pose.orientation.w = 1.0
                result.status.status = GoalStatus.SUCCEEDED
                self._put('move_base/goal', begin, goal)
                self._put('move_base/result', begin + 9.99, result)
            for i in range(int((1.5 + 10.0 * self.goals) * self.RATE) + 1):
                self._moment(i / self.RATE)
        return path

    def _put(self, topic, time, message):
        if topic not in self.leave_out:
            self._bag.write(topic if topic.startswith('/') else f'{self.namespace}/{topic}', message, genpy.Time.from_sec(100.0 + time))

    def _header(self, time, frame):
        return Header(stamp=genpy.Time.from_sec(100.0 + time), frame_id=frame)

    def _link(self, time, parent, child, x, y, yaw):
        turn = Quaternion(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
        return TransformStamped(self._header(time, parent), child, Transform(Vector3(x, y, 0.0), turn))

    def _moment(self, time):
        x0, y0, turn = self.OFFSET
        x = min(max(time - 1.0, 0.0) * SPEED, 5.0 * self.goals)
        # The map's (x, 0) in the odometry's frame: turned back by its yaw.
        ox = math.cos(turn) * (x - x0) + math.sin(turn) * (0.0 - y0)
        oy = -math.sin(turn) * (x - x0) + math.cos(turn) * (0.0 - y0)
        links = [self._link(time, self.odom, self.base, ox, oy, -turn)]
        if 'map' not in self.leave_out:
            links.append(self._link(time, 'map', self.odom, x0, y0, turn))
        self._put('/tf', time, TFMessage(links))
        odometry = Odometry(header=self._header(time, self.odom), child_frame_id=self.base)
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = ox, oy
        odometry.pose.pose.orientation = links[0].transform.rotation
        odometry.twist.twist.linear.x = SPEED if 0.0 < x < 5.0 * self.goals else 0.0
        self._put('odom', time, odometry)
        # Three beams: ahead nothing, 45 degrees to the left and square to it the wall.
        ranges = [float('inf'), self.WALL * math.sqrt(2.0), self.WALL]
        turn = -1.0 if self.upside_down else 1.0
        self._put('scan', time, LaserScan(header=self._header(time, 'laser'), angle_min=0.0, angle_increment=turn * math.pi / 4,
                                          range_min=0.05, range_max=10.0, ranges=ranges))
