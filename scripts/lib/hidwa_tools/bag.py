# SPDX-License-Identifier: BSD-3-Clause
"""A recorded drive, read out of its bag. Times [s] are simulated ones; poses are in the map frame."""
import json
from dataclasses import dataclass, field

import numpy as np
import rosbag

from .errors import BagError

# actionlib_msgs/GoalStatus
OUTCOMES = {2: 'cancelled', 3: 'reached', 4: 'given up', 5: 'refused', 8: 'cancelled'}
SUCCEEDED = 3

INFO_TOPIC = '/demo_info'
PLANNER = '/move_base/HIDWAPlannerROS/'
# What a bag must hold to be reported on.
NEEDED = (INFO_TOPIC, '/map', '/ground_truth', '/move_base/goal')


@dataclass
class Grid:
    """The true map."""
    occupied: np.ndarray  # bool (rows, columns), row 0 at the bottom
    free: np.ndarray      # bool; what is neither is unknown
    resolution: float     # [m]
    origin: np.ndarray    # (2,), lower left corner of cell (0, 0) [m]


@dataclass
class Drive:
    """One drive to one goal."""
    info: dict
    grid: Grid
    truth: np.ndarray                            # (n, 6): time, x, y, yaw, v, omega
    goal_time: float
    result_time: float                           # of the bag's end where the host gave no result
    arrived: bool
    result_text: str
    regions: list = field(default_factory=list)  # polygons (n, 2)
    plans: list = field(default_factory=list)    # (time, (n, 2)), oldest first
    commands: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))  # time, v, omega
    sticks: list = field(default_factory=list)                              # (time, axes)
    states: np.ndarray = field(default_factory=lambda: np.zeros((0, 4)))    # time, state, active, omega wanted
    cycles: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))    # time, duration
    simulator: dict = field(default_factory=dict)                           # its own counts, for comparison

    @property
    def footprint(self):
        """The unpadded outline (n, 2) in the robot's frame."""
        return np.array(self.info['footprint'], float)

    def driven(self):
        """The ground truth between goal and result."""
        time = self.truth[:, 0]
        return self.truth[(time >= self.goal_time) & (time <= self.result_time)]


def _yaw(q):
    return np.arctan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))


def _grid(message):
    if abs(_yaw(message.info.origin.orientation)) > 1e-6:
        raise BagError('the map is turned against its frame (origin yaw); give one with yaw 0')
    cells = np.array(message.data, np.int16).reshape(message.info.height, message.info.width)
    # The message holds 0.05 as a float32, 0.0500000007: a thousand cells further that is 1.5e-5 m.
    resolution = float(f'{message.info.resolution:.7g}')
    origin = message.info.origin.position
    return Grid(cells >= 65, (cells >= 0) & (cells < 65), resolution, np.array([origin.x, origin.y]))


def _truth(message, _):
    pose, twist = message.pose.pose, message.twist.twist
    return (message.header.stamp.to_sec(), pose.position.x, pose.position.y, _yaw(pose.orientation), twist.linear.x,
            twist.angular.z)


def _region(marker):
    points = np.array([[p.x, p.y] for p in marker.points])
    if len(points) > 1 and np.allclose(points[0], points[-1]):
        points = points[:-1]
    c, s = np.cos(_yaw(marker.pose.orientation)), np.sin(_yaw(marker.pose.orientation))
    return points @ np.array([[c, s], [-s, c]]) + [marker.pose.position.x, marker.pose.position.y]


def _regions(array):
    return [_region(marker) for marker in array.markers if marker.type == marker.LINE_STRIP and len(marker.points) > 2]


def _points(path):
    return np.array([[p.pose.position.x, p.pose.position.y] for p in path.poses])


def _rows(messages, topic, row, width):
    rows = [row(message, time) for time, message in messages.get(topic, [])]
    return np.array(rows, float) if rows else np.zeros((0, width))


def _outcome(messages, end):
    """Time, success and text of the host's first result after the goal."""
    for time, message in messages.get('/move_base/result', []):
        status = message.status
        outcome = OUTCOMES.get(status.status, f'status {status.status}')
        return time, status.status == SUCCEEDED, f'{outcome}: {status.text}' if status.text else outcome
    return end, False, 'the host gave no result while recording'


def read_drive(path):
    """Reads a Drive; BagError where the bag cannot be read or lacks something."""
    messages = {}
    try:
        with rosbag.Bag(path) as bag:
            end = bag.get_end_time() if bag.get_message_count() else 0.0
            for topic, message, time in bag.read_messages():
                messages.setdefault(topic, []).append((time.to_sec(), message))
    except (OSError, rosbag.ROSBagException) as fault:
        raise BagError(f'{path}: {fault}') from fault
    missing = [topic for topic in NEEDED if topic not in messages]
    if missing:
        raise BagError(f'{path} holds no {", ".join(missing)}: record it with scripts/demo')
    result_time, arrived, text = _outcome(messages, end)
    plans = [(time, _points(message)) for topic, rows in messages.items() if topic.endswith('/plan')
             for time, message in rows if len(message.poses) > 1]
    counts = {topic: messages['/' + topic][-1][1].data for topic in ('contacts', 'regions_crossed')
              if '/' + topic in messages}
    return Drive(
        info=json.loads(messages[INFO_TOPIC][-1][1].data), grid=_grid(messages['/map'][-1][1]),
        truth=_rows(messages, '/ground_truth', _truth, 6), goal_time=messages['/move_base/goal'][0][0],
        result_time=result_time, arrived=arrived, result_text=text,
        regions=_regions(messages['/regions'][-1][1]) if '/regions' in messages else [],
        plans=sorted(plans, key=lambda plan: plan[0]),
        commands=_rows(messages, '/cmd_vel', lambda m, t: (t, m.linear.x, m.angular.z), 3),
        sticks=[(time, message.axes) for time, message in messages.get('/joy', [])],
        states=_rows(messages, PLANNER + 'operator_state', lambda m, t: (t, m.state, m.active, m.wanted.angular.z), 4),
        cycles=_rows(messages, PLANNER + 'cycle', lambda m, t: (t, m.duration), 2), simulator=counts)
