# SPDX-License-Identifier: BSD-3-Clause
"""What the page shows, made of what the robot said: each part once however many pages watch, and only where it changed."""
import math
import time

import numpy as np
import rospy
from geometry_msgs.msg import PolygonStamped, Quaternion
from hidwa_local_planner.msg import MovingObstacles, OperatorState
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JoyFeedbackArray
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

from hidwa_tools.geometry import turn_of, yaw_of

from . import layouts, wire
from .planar import composed, inverse, moved, rounded
from .progress import Progress
from .robot import Newest

NO_CYCLE = 1.0            # [s] after which a state is none any more
STALE_PATH = 1.0          # [s] after which a rollout is none any more
CANDIDATES_PERIOD = 0.5   # [s]
MOST_CANDIDATES = 600
MOST_POINTS = 800          # of a path
RUMBLE_ENDS = 0.3         # [s] after the last message
LIMITS = ('max_vel_x', 'min_vel_x', 'max_vel_theta', 'acc_lim_x', 'acc_lim_theta', 'input_timeout', 'gesture_range',
          'drive_without_goal')
CIRCLE = [[round(0.3 * math.cos(a), 3), round(0.3 * math.sin(a), 3)] for a in np.linspace(0, 2 * math.pi, 17)[:-1]]  # [m]


class GridPart:
    """A grid in its versions: the newest whole, and the step from the one before."""

    def __init__(self, which):
        self._which, self._cells, self._before, self._shift = which, None, None, None
        self._corner, self._resolution, self._pose = None, None, None
        self.version, self._made = 0, {}

    def put(self, grid, pose):
        """A wire.Grid; pose: of its corner in the map."""
        cells = grid.cells.reshape(grid.height, grid.width)
        shift = self._shift_to(cells, grid)
        if shift == (0, 0) and np.array_equal(cells, self._cells) and self._pose and math.dist(pose, self._pose) < 1e-4:
            return
        self._before, self._shift = self._cells, shift
        self._cells, self._corner, self._resolution, self._pose = cells, grid.origin, grid.resolution, pose
        self.version += 1
        self._made = {}

    def _shift_to(self, cells, grid):
        """dx, dy [cells] from the old corner to the new one; None where they do not fit."""
        if self._cells is None or cells.shape != self._cells.shape or grid.resolution != self._resolution:
            return None
        if grid.origin[2] != self._corner[2]:
            return None
        x, y, _ = composed(inverse(self._corner), grid.origin)
        dx, dy = round(x / grid.resolution), round(y / grid.resolution)
        return (dx, dy) if max(abs(x - dx * grid.resolution), abs(y - dy * grid.resolution)) < 0.01 * grid.resolution else None

    def since(self, seen):
        """The message for a page that has the version `seen` (0: none); None where there is nothing new."""
        if self.version == seen:
            return None
        step = seen == self.version - 1 and seen > 0 and self._shift is not None
        if step not in self._made:
            self._made[step] = layouts.grid_change(self._which, self.version, self._cells, seen, self._before, self._shift, self._pose) \
                if step else layouts.whole_grid(self._which, self.version, self._cells, self._resolution, self._pose)
        return self._made[step]


class Part:
    """A value in its versions."""

    def __init__(self):
        self.version, self.value = 0, None

    def put(self, value):
        if value != self.value or self.version == 0:
            self.version, self.value = self.version + 1, value

    def since(self, seen):
        return None if self.version == seen else self.value


class Scene:
    """`parameters()` gives the planner's parameters in force; `others` {name: function that gives a JSON value} are further
    parts. Everything here runs in one thread."""

    def __init__(self, robot, parameters, others, regions=()):
        self._robot, self._parameters, self._others, self._own_regions = robot, parameters, others, list(regions)
        self._taken, self._frames = {}, {}
        self.binary = {'map': GridPart(layouts.MAP), 'costmap': GridPart(layouts.COSTMAP)}
        for name in ('scan', 'plan', 'window', 'local_plan', 'predicted', 'candidates'):
            self.binary[name] = Part()
        self.json = {name: Part() for name in ('mode', 'limits', 'footprint', 'regions', 'obstacles', 'progress', 'rumble', *others)}
        self.pose, self.velocity, self.state, self.state_name, self.mode = None, None, None, '', None
        self.progress = Progress()
        self._grid, self._evaluation, self._evaluated_at, self._rumble, self._slow_at = None, None, 0.0, None, 0.0

    # -- once a tick

    def refresh(self, candidates_wanted=False):
        """Takes what came since the last call."""
        robot = self._robot
        self._frames = {}
        self.pose = robot.pose_of(robot.names.base_frame)
        self._take('odom', robot.odom, self._on_odometry)
        self._take('mode', robot.mode, self._on_mode)
        self._refresh_state()
        self._take('map', robot.map, self._on_map)
        self._take('costmap', robot.costmap, self._on_costmap)
        self._take_updates()
        self._take('scan', robot.scan, self._on_scan)
        for name, which, topic in (('plan', layouts.PLAN, robot.plan), ('window', layouts.WINDOW, robot.window),
                                   ('local_plan', layouts.LOCAL_PLAN, robot.local_plan), ('predicted', layouts.PREDICTED, robot.predicted)):
            self._refresh_path(name, which, topic)
        self._take('obstacles', robot.obstacles, self._on_obstacles)
        self._take('regions', robot.regions, self._on_regions)
        self._refresh_candidates(candidates_wanted)
        self._refresh_slow()

    def tick(self, seen):
        """(binary messages, JSON fields) that a page with the versions `seen` does not have; `seen` has them from now on."""
        binary, fields = [], {'time': round(rospy.get_time(), 3), 'pose': self.pose and rounded(self.pose, 4),
                              'velocity': self.velocity, 'state': self.state}
        for name, part in self.binary.items():
            message = part.since(seen.get(name, 0))
            seen[name] = part.version
            if message is not None:
                binary.append(message)
        for name, part in self.json.items():
            if part.version != seen.get(name, 0):
                seen[name] = part.version
                fields[name] = part.value
        return binary, fields

    # -- its parts

    def _take(self, name, newest, use):
        """Uses a message that is new; one whose frame tf does not know yet is tried again."""
        if newest.version == self._taken.get(name, 0):
            return
        version = newest.version
        try:
            if use(newest) is False:
                return
        except wire.Broken as fault:
            rospy.logwarn_throttle(10.0, f'{newest.topic} carries what cannot be read: {fault}')
        self._taken[name] = version

    def _frame(self, name):
        """The pose of a frame in the map; asked of tf once a tick."""
        if name not in self._frames:
            self._frames[name] = self._robot.pose_of(name) if name else None
        return self._frames[name]

    def _on_odometry(self, newest):
        message = newest.message(Odometry)
        if message:
            self.velocity = rounded((message.twist.twist.linear.x, message.twist.twist.angular.z))
        return True

    def _on_mode(self, newest):
        message = newest.message(String)
        if message:
            self.mode = message.data
            self.json['mode'].put(message.data)
        return True

    def _refresh_state(self):
        newest = self._robot.state
        age = newest.age()
        if age > NO_CYCLE:
            self.state, self.state_name = None, ''
            return
        if newest.version != self._taken.get('state', 0):
            self._taken['state'] = newest.version
            m = newest.message(OperatorState)
            if m is None:
                return
            self.state_name = m.state_name
            self.state = {'id': m.state, 'name': m.state_name, 'mode': m.mode_name, 'without_goal': m.without_goal,
                          'active': m.active,
                          'wanted': rounded((m.wanted.linear.x, m.wanted.angular.z)),
                          'command': rounded((m.command.linear.x, m.command.angular.z)), 'agreement': round(m.agreement, 3),
                          'refused_by': m.refused_by, 'input_age': round(m.input_age, 3), 'dropped': m.dropped,
                          'next': m.next_name, 'next_reason': m.next_reason}
        if self.state:
            self.state['age'] = round(age, 2)

    def _on_map(self, newest):
        grid = wire.grid(newest.data)
        frame = self._frame(grid.header.frame or self._robot.names.map_frame)
        if frame is None and grid.header.frame.lstrip('/') != self._robot.names.map_frame:
            return False
        self.binary['map'].put(grid, composed(frame or (0.0, 0.0, 0.0), grid.origin))
        return True

    def _on_costmap(self, newest):
        self._grid = wire.grid(newest.data)
        return self._show_costmap()

    def _show_costmap(self):
        frame = self._frame(self._grid.header.frame)
        if frame is None:
            return False
        self.binary['costmap'].put(self._grid, composed(frame, self._grid.origin))
        return True

    def _take_updates(self):
        updates = self._robot.take_updates()
        if not updates or self._grid is None:
            return
        cells = self._grid.cells.reshape(self._grid.height, self._grid.width).copy()
        for data in updates:
            try:
                u = wire.grid_update(data)
            except wire.Broken:
                continue
            if u.x >= 0 and u.y >= 0 and u.x + u.width <= self._grid.width and u.y + u.height <= self._grid.height:
                cells[u.y:u.y + u.height, u.x:u.x + u.width] = u.cells.reshape(u.height, u.width)
        self._grid = self._grid._replace(cells=cells.ravel())
        self._show_costmap()

    def _on_scan(self, newest):
        scan = wire.scan(newest.data)
        mounted = self._robot.pose_of(scan.header.frame, full=True)
        if mounted is None:
            return False
        rotation = Quaternion(*mounted[3:])
        pose, turn = (*mounted[:2], float(yaw_of(rotation))), turn_of(rotation)
        self.binary['scan'].put(layouts.scan(pose, turn * scan.angle_min, turn * scan.angle_increment, scan.ranges, scan.range_min,
                                             scan.range_max))
        return True

    def _refresh_path(self, name, which, newest):
        if which != layouts.PLAN and newest.age() > STALE_PATH:
            if self.binary[name].value:
                self.binary[name].put(layouts.path(which, np.empty((0, 3))))
            return
        self._take(name, newest, lambda topic: self._on_path(name, which, topic))

    def _on_path(self, name, which, newest):
        header, rows = wire.path(newest.data)
        frame = self._frame(header.frame)
        if len(rows) and frame is None:
            return False
        points = moved(frame, rows[:, :2]) if len(rows) else np.empty((0, 2))
        if which == layouts.PLAN:
            self.progress.plan(points)
        times = rows[:, 3] - header.stamp
        timed = len(rows) > 1 and rows[-1, 3] > rows[0, 3]
        if len(rows) > MOST_POINTS:
            kept = np.linspace(0, len(rows) - 1, MOST_POINTS).round().astype(int)
            points, times, rows = points[kept], times[kept], rows[kept]
        self.binary[name].put(layouts.path(which, np.column_stack([points, times if timed else np.full(len(rows), np.nan)])))
        return True

    def _on_obstacles(self, newest):
        message = newest.message(MovingObstacles)
        frame = self._frame(message.header.frame_id) if message else None
        if message is None or (message.obstacles and frame is None):
            return message is None
        found = []
        for o in message.obstacles:
            x, y, yaw = composed(frame, (o.position.x, o.position.y, 0.0))
            vx, vy, _ = composed((0.0, 0.0, yaw), (o.velocity.x, o.velocity.y, 0.0))
            found.append({'id': o.id, **dict(zip(('x', 'y', 'vx', 'vy', 'r'), rounded((x, y, vx, vy, o.radius))))})
        self.json['obstacles'].put(found)
        return True

    def _on_regions(self, newest):
        message = newest.message(MarkerArray)
        names = {m.id: m.text for m in message.markers if m.ns == 'name'} if message else {}
        found = list(self._own_regions)
        for m in message.markers if message else ():
            if m.ns == 'outline' and len(m.points) > 3:
                found.append({'name': names.get(m.id, ''), 'polygon': [rounded((p.x, p.y)) for p in m.points[:-1]],
                              'crossed': m.color.g < 0.3})
        self.json['regions'].put(found)
        return True

    def _refresh_candidates(self, wanted):
        """One message at a time: while somebody listens the planner checks every candidate."""
        if self._evaluation and (self._evaluation.version or not wanted or self._evaluation.age() > 2.0):
            if self._evaluation.version:
                self._show_candidates(self._evaluation.data)
                self._evaluation.end()
                self._evaluation = None
            elif not wanted:
                self._evaluation.end()
                self._evaluation = None
        if wanted and self._evaluation is None and time.monotonic() - self._evaluated_at > CANDIDATES_PERIOD:
            self._evaluated_at = time.monotonic()
            self._evaluation = Newest(self._robot.names.of_planner('evaluation'))
        if not wanted and self.binary['candidates'].value is not None:
            self.binary['candidates'].put(layouts.candidates((0.0, 0.0, 0.0), [], None))

    def _show_candidates(self, data):
        try:
            header, found, best = wire.evaluation(data)
        except wire.Broken as fault:
            rospy.logwarn_throttle(10.0, f'the candidates cannot be read: {fault}')
            return
        frame = self._frame(header.frame)
        if frame is None or self.pose is None or not found:
            return
        every = -(-len(found) // MOST_CANDIDATES)
        kept = [c for i, c in enumerate(found) if i % every == 0 or i == best]
        place = next((i for i, c in enumerate(kept) if best is not None and c is found[best]), None)
        at = composed(inverse(frame), self.pose)
        message = layouts.candidates(at, kept, place)
        self.binary['candidates'].put(message[:4] + np.array(self.pose, '<f8').tobytes() + message[28:])

    def _refresh_slow(self):
        """What need not be looked at twenty times a second."""
        now = time.monotonic()
        self.progress.move(self.pose, self.velocity, now)
        if now - self._slow_at < 0.25:
            return
        self._slow_at = now
        p = self._parameters()
        self.json['limits'].put({name: p.get(name) for name in LIMITS})
        self._take('footprint', self._robot.footprint, self._on_footprint)
        if self.json['footprint'].version == 0:
            self.json['footprint'].put(CIRCLE)
        if self.json['regions'].version == 0:
            self.json['regions'].put(self._own_regions)
        self.json['progress'].put(self.progress.report(self.mode and p.get('max_vel_x'), now))
        self._refresh_rumble(p.get('rumble_topic') or '')
        for name, value in self._others.items():
            self.json[name].put(value())

    def _on_footprint(self, newest):
        message = newest.message(PolygonStamped)
        if message is None or self.pose is None or not message.polygon.points:
            return message is None
        base = self._robot.pose_of(self._robot.names.base_frame, target=message.header.frame_id)
        if base is None:
            return False
        points = moved(inverse(base), [(p.x, p.y) for p in message.polygon.points])
        if self.json['footprint'].version == 0 or self.json['footprint'].value is CIRCLE or \
                np.shape(self.json['footprint'].value) != points.shape:
            self.json['footprint'].put([rounded(point) for point in points])
        return True

    def _refresh_rumble(self, topic):
        if self._rumble is None or self._rumble.topic != (rospy.resolve_name(topic) if topic else ''):
            if self._rumble:
                self._rumble.end()
            self._rumble = Newest(topic) if topic else None
        strength = 0.0
        if self._rumble and self._rumble.age() < RUMBLE_ENDS:
            message = self._rumble.message(JoyFeedbackArray)
            strength = max([f.intensity for f in message.array if f.type == 1] or [0.0]) if message else 0.0
        self.json['rumble'].put(round(min(1.0, max(0.0, strength)), 2))
