# SPDX-License-Identifier: BSD-3-Clause
"""Recorded drives, read out of their bag: the demo's, or a real robot's. Times [s] are those of recording (simulated in a
simulation); poses are in the map frame, or in the odometry's where the bag has no map frame."""
import json
from dataclasses import dataclass, field

import numpy as np

from . import geometry
from .bagfile import choose, read_messages
from .errors import BagError
from .people import read_people
from .poses import TF, Frames, clean, odometry_rows, with_speed
from .recording import plugin_name, stick_of
from .seen import Seen

# actionlib_msgs/GoalStatus
OUTCOMES = {2: 'cancelled', 3: 'reached', 4: 'given up', 5: 'refused', 8: 'cancelled'}
SUCCEEDED = 3

INFO_TOPIC = '/demo_info'
# What makes a bag the demo's.
DEMO = (INFO_TOPIC, '/map', '/ground_truth', '/move_base/goal')
ODOMETRY, SCAN, GRID = 'nav_msgs/Odometry', 'sensor_msgs/LaserScan', 'nav_msgs/OccupancyGrid'
CONFIG, TEXT = 'dynamic_reconfigure/Config', 'std_msgs/String'
# What is looked for: its types and usual name.
TOPICS = {'goal': ({'move_base_msgs/MoveBaseActionGoal'}, '/move_base/goal'),
          'result': ({'move_base_msgs/MoveBaseActionResult'}, '/move_base/result'),
          'map': ({GRID}, '/map'), 'truth': ({ODOMETRY}, '/ground_truth'), 'odom': ({ODOMETRY}, '/odom'),
          'amcl': ({'geometry_msgs/PoseWithCovarianceStamped'}, '/amcl_pose'), 'scan': ({SCAN}, '/scan'),
          'costmap': ({GRID}, '/local_costmap/costmap'), 'cmd_vel': ({'geometry_msgs/Twist'}, '/cmd_vel'),
          'joy': ({'sensor_msgs/Joy'}, '/joy'), 'state': ({'hidwa_local_planner/OperatorState'}, '/operator_state'),
          'cycle': ({'hidwa_local_planner/Cycle'}, '/cycle'), 'mode': ({TEXT}, '/mode'), 'info': ({TEXT}, INFO_TOPIC),
          'parameters': ({TEXT}, '/record_drive/parameters'), 'config': ({CONFIG}, '/local_costmap/parameter_updates'),
          'regions': ({'visualization_msgs/MarkerArray'}, '/regions'),
          'people': ({'hidwa_local_planner/MovingObstacles'}, '/moving_obstacles_truth')}
# These are what their whole name says: another topic of the type is something else.
EXACT = ('truth', 'costmap', 'mode', 'info', 'parameters', 'config', 'regions', 'map', 'amcl', 'people')
# What the simulator counts itself.
COUNTS = ('contacts', 'contacts_moving', 'contacts_at_rest', 'regions_crossed')
# What a bag without something cannot say, and the remedy.
LACKS = {'goal': 'no goal (move_base/goal): the whole bag counts as one drive, and whether it arrived is not known',
         'map': 'no map: the floor is drawn from what the laser or the local costmap saw',
         'odom': 'no odometry (name it with --odom-topic): speeds are differences of poses',
         'scan': 'no laser scans (name them with --scan-topic): no clearance can be estimated',
         'cmd_vel': 'no commands (name them with --cmd-vel-topic)', 'joy': 'no stick (name it with --joy-topic): no shift by the person',
         'state': "no operator_state of the planner: what the person did is not known",
         'cycle': "no cycle of the planner: no times of its cycles", 'plan': 'no plan of a global planner'}


@dataclass
class Names:
    """What the user says of a bag; None: found by usual names and types."""
    topics: dict = field(default_factory=dict)  # of TOPICS
    namespace: str = ''
    base_frame: str = None
    map_frame: str = None
    footprint: list = None                      # [[x, y], ...] in the robot's frame [m]


@dataclass
class Grid:
    """The true map."""
    occupied: np.ndarray  # bool (rows, columns), row 0 at the bottom
    free: np.ndarray      # bool; what is neither is unknown
    resolution: float     # [m]
    origin: np.ndarray    # (2,), lower left corner of cell (0, 0) [m]


@dataclass
class Drive:
    """One drive to one goal. Of a bag that is not the demo's much may be absent: None, or empty."""
    info: dict
    grid: Grid
    truth: np.ndarray                            # (n, 6): time, x, y, yaw, v, omega
    goal_time: float
    result_time: float                           # of the bag's end where the host gave no result
    arrived: bool                                # None: nothing in the bag says so
    result_text: str
    regions: list = field(default_factory=list)  # polygons (n, 2)
    plans: list = field(default_factory=list)    # (time, (n, 2)), oldest first
    commands: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))  # time, v, omega
    sticks: list = field(default_factory=list)                              # (time, axes)
    # time, state, active, omega wanted, without a goal
    states: np.ndarray = field(default_factory=lambda: np.zeros((0, 5)))
    cycles: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))    # time, duration
    simulator: dict = field(default_factory=dict)                           # its own counts, for comparison
    people: list = field(default_factory=list)                              # who truly was around: people.Person
    outcomes: list = field(default_factory=list)                            # (time, outcome of the cycle)
    agreements: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))  # time, agreement
    demo: bool = True                            # the truth is known
    pose_from: str = 'ground truth'
    lacking: list = field(default_factory=list)  # what the bag does not hold, in words
    notes: list = field(default_factory=list)    # what was wrong with the file
    used: dict = field(default_factory=dict)     # the topics taken
    seen: Seen = None                            # laser and local costmap

    @property
    def footprint(self):
        """The unpadded outline (n, 2) in the robot's frame, or None."""
        outline = self.info.get('footprint')
        return np.array(outline, float) if outline is not None else None

    @property
    def contacts_known(self):
        """Whether the bag can say what the robot touched."""
        return self.pose_from == 'ground truth' and self.grid is not None and self.footprint is not None

    def during(self, rows):
        """Those rows, time first, between goal and result."""
        return rows[(rows[:, 0] >= self.goal_time) & (rows[:, 0] <= self.result_time)]

    def driven(self):
        """The ground truth between goal and result."""
        return self.during(self.truth)


def _grid(message):
    if abs(geometry.yaw_of(message.info.origin.orientation)) > 1e-6:
        raise BagError('the map is rotated (its origin has a yaw); give one with yaw 0')
    cells = np.array(message.data, np.int16).reshape(message.info.height, message.info.width)
    # The message holds 0.05 as a float32, 0.0500000007: a thousand cells further that is 1.5e-5 m.
    resolution = float(f'{message.info.resolution:.7g}')
    origin = message.info.origin.position
    return Grid(cells >= 65, (cells >= 0) & (cells < 65), resolution, np.array([origin.x, origin.y]))


def _region(marker):
    points = np.array([[p.x, p.y] for p in marker.points])
    if len(points) > 1 and np.allclose(points[0], points[-1]):
        points = points[:-1]
    return geometry.placed(points, marker.pose.position.x, marker.pose.position.y, geometry.yaw_of(marker.pose.orientation))


def _is_plan(topic, kind):
    """Whether a topic has a global planner's paths; the local planner's are many and long."""
    return kind == 'nav_msgs/Path' and topic.endswith('/plan')


def _regions(array):
    return [_region(marker) for marker in array.markers if marker.type == marker.LINE_STRIP and len(marker.points) > 2]


def _points(path):
    return np.array([[p.pose.position.x, p.pose.position.y] for p in path.poses])


def _without_goal(state):
    return getattr(state, 'without_goal', False)  # older bags do not know it


def _rows(messages, topic, row, width):
    rows = [row(message, time) for time, message in messages.get(topic)]
    return np.array(rows, float).reshape(-1, width)


def _outcome(messages, topic, goal_time, goal, end, without):
    """Time, success and text of the host's first result for the goal; `without` is the success where there is none."""
    name = goal.goal_id.id
    for time, message in messages.get(topic):
        status = message.status
        if time < goal_time or (name and status.goal_id.id and status.goal_id.id != name):
            continue
        outcome = OUTCOMES.get(status.status, f'status {status.status}')
        return time, status.status == SUCCEEDED, f'{outcome}: {status.text}' if status.text else outcome
    return end, without, 'the host gave no result while recording'


class Reader:
    """What the drives of one bag have in common."""

    def __init__(self, path, names):
        self.path, self.names = path, names
        kinds = set().union(*(types for types, _ in TOPICS.values()), {TF, 'std_msgs/UInt32'})
        self.messages = read_messages(path, lambda topic, kind: kind in kinds or _is_plan(topic, kind))
        self.topics, self.lacking = {}, []
        self.demo = all(self.messages.get(topic) for topic in DEMO) and names == Names()
        for key, (types, usual) in TOPICS.items():
            self.topics[key] = self._choose(key, types, usual)
        self.frames = None if self.demo else Frames(self.messages)
        self.info = self._info()
        self.parameters = self._parameters()
        self.odometry = odometry_rows(self.messages, self.topics['odom'])
        self.base, self.frame, self.pose_from, self.truth = self._poses()
        self.grid = self._map()
        self.plans = self._plans()
        for key, text in LACKS.items():
            if not (self.plans if key == 'plan' else self._has(key)):
                self.lacking.append(text)

    def _choose(self, key, types, usual):
        given, namespace = self.names.topics.get(key), self.names.namespace
        topic, doubt = choose(self.messages, types, usual, given, namespace)
        if key in EXACT and topic and not given and not topic.endswith(usual):
            topic, doubt = None, ''
        if key == 'odom' and topic and not given and topic == self.topics.get('truth'):
            topic = None
        if key == 'truth' and topic and self.names.topics.get('odom') == topic:
            topic = None
        if doubt and key in ('odom', 'scan', 'cmd_vel', 'joy'):
            self.lacking.append(f'--{key.replace("_", "-")}-topic: {doubt}')
        return topic

    def _has(self, key):
        return bool(self.messages.get(self.topics[key]))

    def _last(self, key):
        return self.messages.last(self.topics[key])

    def _info(self):
        text = self._last('info')
        return json.loads(text.data) if text else {}

    def _parameters(self):
        """move_base's parameters as they were at the end, or an empty dict."""
        text = self._last('parameters')
        return next(iter(json.loads(text.data).values()), {}) if text else {}

    def _poses(self):
        """(base frame, frame of the poses, where they come from, rows (n, 6))."""
        if self._has('truth'):
            frame = clean(self._last('truth').header.frame_id) or 'map'
            return 'base_link', frame, 'ground truth', odometry_rows(self.messages, self.topics['truth'], by_stamp=True)
        of_odometry = self._last('odom')
        base = self._base(clean(of_odometry.child_frame_id) if of_odometry else '')
        conflict = self.frames.conflict(base)
        if conflict:
            self.lacking.append(f'no way by tf that can be relied on: {conflict}; only one node may publish it')
        odometry = clean(of_odometry.header.frame_id) if of_odometry else ''
        if base and not (odometry and self.frames.connected(base, odometry)):
            link = self.frames.moving(base)
            odometry = self.frames.chain(link)[1] if link else ''
        fixed = self.names.map_frame or 'map'
        if base and odometry:
            for frame in (fixed, odometry):
                if frame == odometry and of_odometry:
                    break  # the same poses as in the messages
                if self.frames.connected(base, frame):
                    rows = self.frames.drive(frame, odometry, base)
                    if len(rows) > 1:
                        return base, frame, f'tf {frame} -> {base}', with_speed(rows, self.odometry)
        if len(self.odometry) > 1:
            self.lacking.append(f'no tf {fixed} -> {base or "base"}: the way is odometry, which drifts')
            return base, odometry or 'odom', self.topics['odom'], self.odometry
        amcl = [(time, m.pose.pose.position.x, m.pose.pose.position.y, geometry.yaw_of(m.pose.pose.orientation))
                for time, m in self.messages.get(self.topics['amcl'])]
        if len(amcl) > 1:
            return base, fixed, self.topics['amcl'], with_speed(np.array(amcl, float), self.odometry)
        raise BagError(f'{self.path} holds no motion: neither odometry (nav_msgs/Odometry), nor tf to base_link, nor '
                       'amcl_pose, nor ground_truth; record with record:=FILE, or name what is there with --odom-topic, --base-frame '
                       f'(topics: {", ".join(sorted(self.messages.kinds)) or "none"})')

    def _base(self, child):
        """The robot's own frame, or ''."""
        if self.names.base_frame:
            if clean(self.names.base_frame) not in self.frames:
                raise BagError(f'--base-frame {self.names.base_frame} is in no transform of {self.path}')
            return clean(self.names.base_frame)
        of_costmap = clean(str(self.parameters.get('local_costmap', {}).get('robot_base_frame', '')))
        there = [name for name in (of_costmap, child, 'base_link', 'base_footprint') if name and name in self.frames]
        return there[0] if there else child

    def _map(self):
        message = self._last('map')
        if message is None:
            return None
        frame = clean(message.header.frame_id)
        if self.pose_from != 'ground truth' and frame and frame != self.frame:
            self.lacking.append(f'the map is in {frame}, the poses are in {self.frame} and nothing joins them: no floor is drawn')
            return None
        return _grid(message)

    def _moved(self, header, points):
        """Points (n, 2) of a message in the frame of the poses, or None where nothing joins the frames."""
        frame = clean(header.frame_id)
        if self.demo or not frame or frame == self.frame:
            return points
        pose = self.frames.pose(self.frame, frame, header.stamp.to_sec()) if self.frames.connected(self.frame, frame) else None
        return geometry.placed(points, *pose) if pose else None

    def _plans(self):
        plans = []
        for topic, kind in self.messages.kinds.items():
            if not _is_plan(topic, kind) or not topic.startswith(self.names.namespace):
                continue
            for time, message in self.messages.get(topic):
                points = self._moved(message.header, _points(message)) if len(message.poses) > 1 else None
                if points is not None and (self.demo or geometry.path_length(points) > 0.0):
                    plans.append((time, points))
        return sorted(plans, key=lambda plan: plan[0])

    def _outline(self):
        """The footprint [[x, y], ...] by option, demo_info, parameters; None where nothing says."""
        if self.names.footprint:
            return self.names.footprint
        if self.info.get('footprint'):
            return self.info['footprint']
        costmap, config = self.parameters.get('local_costmap', {}), self._last('config')
        text, radius = costmap.get('footprint'), costmap.get('robot_radius')
        if config:
            text = next((p.value for p in config.strs if p.name == 'footprint'), text)
            radius = next((p.value for p in config.doubles if p.name == 'robot_radius'), radius)
        outline = json.loads(text) if isinstance(text, str) and text.strip() else text
        if outline and len(outline) > 2:
            return outline
        if radius:
            return geometry.circle(radius, 64).tolist()
        self.lacking.append('no footprint: give it with --footprint "[[x, y], ...]" or --radius')
        return None

    def drives(self):
        """A Drive for each goal, or one for the whole bag."""
        m, topics = self.messages, self.topics
        planner = self.parameters.get('HIDWAPlannerROS', {})
        outline = self._outline()
        states, mode = m.get(topics['state']), self._last('mode')
        info = dict(self.info) if self.demo else {
            'map': None, 'host': None, 'operator': None, 'rate': None, 'start': None, 'goal': None,
            'planner': plugin_name(str(self.parameters.get('base_local_planner', ''))) or None, **self.info,
            'mode': states[-1][1].mode_name if states else mode.data if mode else None, 'footprint': outline}
        info.setdefault('stick', stick_of(planner))
        info.setdefault('acc_lim_theta', planner.get('acc_lim_theta'))
        common = dict(
            grid=self.grid, truth=self.truth, plans=self.plans, demo=self.demo, pose_from=self.pose_from,
            regions=_regions(self._last('regions')) if self._has('regions') else [],
            commands=_rows(m, topics['cmd_vel'], lambda c, t: (t, c.linear.x, c.angular.z), 3),
            sticks=[(time, message.axes) for time, message in m.get(topics['joy'])],
            states=_rows(m, topics['state'], lambda s, t: (t, s.state, s.active, s.wanted.angular.z, _without_goal(s)), 5),
            cycles=_rows(m, topics['cycle'], lambda c, t: (t, c.duration), 2),
            outcomes=[(time, message.outcome) for time, message in m.get(topics['cycle'])],
            agreements=_rows(m, topics['state'], lambda s, t: (t, s.agreement), 2),
            simulator={name: m.last('/' + name).data for name in COUNTS if m.last('/' + name)},
            people=read_people(m.get(topics['people'])),
            lacking=self.lacking, notes=m.notes, used={key: topic for key, topic in topics.items() if topic},
            seen=Seen(m, topics['scan'], topics['costmap'], self.frames, self.base, self.frame, self.truth)
            if not self.demo else None)
        if not self._has('goal'):
            begin, end = self.truth[0, 0], self.truth[-1, 0]
            return [Drive(info=info, goal_time=begin, result_time=end, arrived=None, result_text='no goal was recorded', **common)]
        found, goals = [], m.get(topics['goal'])
        for i, (time, goal) in enumerate(goals):
            end = goals[i + 1][0] if i + 1 < len(goals) else m.end
            result_time, arrived, text = _outcome(m, topics['result'], time, goal, m.end, False if self.demo else None)
            if i + 1 < len(goals) and result_time > end:
                result_time, arrived, text = end, False, 'replaced by the next goal'
            found.append(Drive(info={**info, **self._ends(info, goal, time)}, goal_time=time, result_time=result_time,
                               arrived=arrived, result_text=text, **common))
        return found

    def _ends(self, info, goal, time):
        """Where the drive began and was to end, as far as info does not say."""
        if self.demo or info.get('goal'):
            return {}
        target = goal.goal.target_pose
        point = self._moved(target.header, np.array([[target.pose.position.x, target.pose.position.y]]))
        after = self.truth[self.truth[:, 0] >= time]
        return {'start': [round(float(v), 3) for v in after[0, 1:4]] if len(after) else None,
                'goal': None if point is None else [*(round(float(v), 3) for v in point[0]),
                                                    round(float(geometry.yaw_of(target.pose.orientation)), 3)]}


def read_drives(path, names=None):
    """The Drives of a bag, one for each goal; BagError where the bag cannot be read or holds no motion."""
    return Reader(path, names or Names()).drives()


def read_drive(path):
    """The Drive to a bag's first goal."""
    return read_drives(path)[0]
