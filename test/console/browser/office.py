# SPDX-License-Identifier: BSD-3-Clause
"""A drive through the office that stands still: what the page shows in the tests of its views."""
import math
import os

import numpy
import yaml
from PIL import Image

import scene_bytes

MAPS = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'maps')
ROBOT = (20.8, 8.3, 0.25)  # [m, m, rad] in front of the first region, with free floor behind
RADIUS = 0.27  # [m] of the outline


def office_cells():
    """The office as occupancies, the row of the lowest y first, and its resolution [m] and origin."""
    with open(os.path.join(MAPS, 'office.yaml'), encoding='utf-8') as file:
        facts = yaml.safe_load(file)
    pixels = numpy.asarray(Image.open(os.path.join(MAPS, facts['image'])))[::-1]
    dark = (255.0 - pixels) / 255.0
    cells = numpy.full(pixels.shape, 255, numpy.uint8)
    cells[dark > facts['occupied_thresh']] = 100
    cells[dark < facts['free_thresh']] = 0
    return cells, facts['resolution'], facts['origin']


def regions():
    with open(os.path.join(MAPS, 'office_regions.yaml'), encoding='utf-8') as file:
        return [dict(region, crossed=False) for region in yaml.safe_load(file)['regions']]


def disc(radius, corners=16):
    return [[radius * math.cos(2 * math.pi * k / corners), radius * math.sin(2 * math.pi * k / corners)] for k in range(corners)]


def way(pose, v, omega, seconds, pieces):
    """Poses (x, y, t) of a constant velocity, by small straight steps."""
    x, y, yaw = pose
    result = []
    steps = 20
    for k in range(pieces):
        result.append((x, y, seconds * k / pieces))
        for _ in range(steps):
            dt = seconds / pieces / steps
            x, y, yaw = x + v * math.cos(yaw) * dt, y + v * math.sin(yaw) * dt, yaw + omega * dt
    return result


def state(name='SHARED', **fields):
    result = {'id': 1, 'name': name, 'mode': 'joystick', 'without_goal': False, 'active': name in ('SHARED', 'BLOCKED', 'MANUAL'),
              'wanted': [0.5, 0.6], 'command': [0.45, 0.3], 'agreement': 0.7, 'refused_by': '', 'input_age': 0.02, 'dropped': 0,
              'next': 'left', 'next_reason': '', 'age': 0.01}
    result.update(fields)
    return result


def local_costmap(cells, resolution, origin, pose, size=120):
    """A window of the map around the robot with a box in it that the map does not know, and what inflation adds, coarsely."""
    column = int((pose[0] - origin[0]) / resolution) - size // 2
    row = int((pose[1] - origin[1]) / resolution) - size // 2
    window = numpy.where(cells[row:row + size, column:column + size] == 100, 100, 0).astype(numpy.uint8)
    window[48:56, 92:100] = 100
    lethal = window == 100
    near = lethal.copy()
    for _ in range(10):
        grown = near.copy()
        grown[1:] |= near[:-1]
        grown[:-1] |= near[1:]
        grown[:, 1:] |= near[:, :-1]
        grown[:, :-1] |= near[:, 1:]
        window[grown & ~near] = 70
        near = grown
    window[lethal] = 100
    return window, (origin[0] + column * resolution, origin[1] + row * resolution, 0.0)


def fan(pose):
    """Candidates: arcs of every turn rate, some of them rejected."""
    ways = []
    for k in range(-10, 11):
        omega = k / 10.0
        points = [(x, y) for x, y, _ in way((0.0, 0.0, 0.0), 0.45, omega, 1.7, 12)]
        ways.append((-1.0 if k < -7 else 20.0 + 90.0 * abs(omega - 0.3), 0.45, omega, points))
    return scene_bytes.candidates(pose, 13, ways)


def show(server, pose=ROBOT):
    """Shows the whole office with the robot at a pose."""
    cells, resolution, origin = office_cells()
    window, corner = local_costmap(cells, resolution, origin, pose)
    ranges = [3.0 + 0.4 * math.sin(9 * k / 180.0) for k in range(180)]
    plan = way(pose, 0.5, 0.02, 20.0, 80)
    server.show(
        binary={
            'map': scene_bytes.grid(0, 1, cells, resolution, origin),
            'costmap': scene_bytes.grid(1, 1, window, resolution, corner),
            'scan': scene_bytes.scan(pose, -math.pi / 2, math.pi / 180, ranges),
            'plan': scene_bytes.path(0, plan),
            'predicted': scene_bytes.path(3, way(pose, 0.45, 0.3, 3.0, 30)),
            'candidates': fan(pose),
        },
        time=1.0, pose=list(pose), velocity=[0.45, 0.3], state=state(), mode='joystick', footprint=disc(RADIUS), regions=regions(),
        limits={'max_vel_x': 0.5, 'min_vel_x': 0.0, 'max_vel_theta': 1.0, 'acc_lim_x': 2.5, 'acc_lim_theta': 3.2,
                'input_timeout': 0.5, 'gesture_range': 0.3},
        obstacles=[{'id': 1, 'x': pose[0] + 3.2, 'y': pose[1] + 2.3, 'vx': -0.5, 'vy': -0.3, 'r': 0.3},
                   {'id': 2, 'x': pose[0] + 5.6, 'y': pose[1] - 0.6, 'vx': 0.0, 'vy': 0.8, 'r': 0.3}],
        goals={'active': [plan[-1][0], plan[-1][1], 1.5], 'waiting': [[30.0, 18.0, 0.0]],
               'start': [5.5, 2.5, 1.57], 'outcome': '', 'text': ''},
        progress={'driven': 12.0, 'to_go': 31.4, 'elapsed': 30.0, 'time_left': 74.0})
