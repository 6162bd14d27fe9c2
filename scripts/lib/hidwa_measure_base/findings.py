# SPDX-License-Identifier: BSD-3-Clause
"""From a Track to what the planner's parameters take."""
import math
from dataclasses import dataclass, field

import numpy as np

from . import response
from .track import AXES

UNITS = (('m/s', 'm/s^2'), ('rad/s', 'rad/s^2'))
STILL = (0.003, 0.01)       # [m], [rad]; who moves less than this stands
FINEST = (0.031, 0.061)     # [m/s], [rad/s]; commands that grow by no more than this show a dead band
ENOUGH = 10                 # step responses
CAREFUL = 0.95              # share of a measured rate that is printed; the rest is for its error
OLD_ODOMETRY, SLOW_ODOMETRY = 0.1, 0.07  # [s]


@dataclass
class Findings:
    """What was found; None: the measurement does not show it."""
    latency: float = None               # [s], the longest
    latencies: list = field(default_factory=list)  # [s], of each step
    by_shift: bool = False              # the latency is that of a whole drive
    acceleration: list = field(default_factory=lambda: [None, None])  # [m/s^2], [rad/s^2]
    deceleration: list = field(default_factory=lambda: [None, None])
    dead_band: list = field(default_factory=lambda: [None, None])     # (commands that did not move it, the first that did)
    stop_time: float = None             # [s] from the last command to rest
    stop_way: str = ''                  # how far it went on meanwhile
    never_stopped: float = None         # [s] after the last command it still moved
    answers: list = field(default_factory=list)    # (axis, response.Answers)
    interval: float = None              # of odometry [s]
    age: float = None                   # of odometry by its stamps [s]
    remarks: list = field(default_factory=list)


def find(track):
    """Findings of a Track."""
    found = Findings(interval=track.interval(), age=track.age())
    for axis in (0, 1):
        time, way = track.driven(axis)
        if len(time) < 4:
            continue
        steps = response.steps(track, axis)
        for slows, rates in ((False, found.acceleration), (True, found.deceleration)):
            answers = response.answers([step for step in steps if step.slows == slows], time, way, axis)
            if answers:
                rates[axis] = answers.rate
                found.answers.append((axis, answers))
                found.latencies += [answer.latency for answer in answers.each]
        found.dead_band[axis] = _dead_band(track, axis, time, way)
    if found.latencies:
        found.latency = max(found.latencies)
    else:
        _by_shift(track, found)
    _cease(track, found)
    _remark(found)
    return found


def _by_shift(track, found):
    for axis in (0, 1):
        shift = response.shift(*track.sent(axis), *track.driven(axis), axis)
        if shift is not None and (found.latency is None or shift > found.latency):
            found.latency, found.by_shift = shift, True


def _dead_band(track, axis, time, way):
    """(the largest command in which the robot stood, the first one in which it moved) of commands that grow slowly from rest, the
    largest of several; None where there are none."""
    result, base, stood = None, None, 0.0
    for run in track.runs():
        value = abs(run.command[axis])
        if not any(run.command):
            base, stood = float(np.interp(run.next, time, way)), 0.0
        elif base is not None and run.command[1 - axis] == 0.0 and 0.0 < value - stood <= FINEST[axis]:
            there = way[(time > run.begin) & (time <= run.next)]
            if not len(there) or np.abs(there - base).max() <= STILL[axis]:
                stood = value
            else:
                result, base = max(result or (0.0, 0.0), (stood, value), key=lambda band: band[1]), None
        else:
            base = None  # no slow growth: until the next rest
    return result


def _cease(track, found):
    """Where commands cease while the robot moves: how long it takes to rest."""
    times, _ = track.sent(0)
    if len(times) < 3 or np.median(np.diff(times)) > 0.5 * response.SILENCE:
        return  # whoever sends does not repeat: each command would be short for a base that stops by itself
    for run in track.runs():
        at, end = run.end, run.next
        if end - at < response.SILENCE or not any(run.command):
            continue
        for axis in (0, 1):
            time, way = track.driven(axis)
            during = (time >= at) & (time <= end)
            if abs(run.command[axis]) < response.SMALLEST[axis] or np.count_nonzero(during) < 3:
                continue
            time, way = time[during], way[during]
            if abs(way[-1] - way[0]) < STILL[axis]:
                continue  # it stood all the time
            moving = np.flatnonzero(np.abs(way - way[-1]) > 0.5 * STILL[axis])
            rest = time[min(moving[-1] + 1, len(time) - 1)]
            if end - rest < 0.2:  # it may not be at rest
                found.never_stopped = max(found.never_stopped or 0.0, end - at)
            elif found.stop_time is None or rest - at > found.stop_time:
                found.stop_time = rest - at
                found.stop_way = f'{abs(way[-1] - way[0]):.2f} {("m", "rad")[axis]}'


def _remark(found):
    add = found.remarks.append
    if found.interval and found.interval > SLOW_ODOMETRY:
        add(f'Odometry comes only every {found.interval:.2f} s: what is measured is that coarse, and the planner wants 20 Hz or more.')
    if found.age is not None and found.age > OLD_ODOMETRY:
        add(f'Odometry is {found.age:.2f} s old by its stamps when it arrives. This is part of control_latency here.')
    if found.age is not None and found.age < -0.01:
        add(f"Odometry's stamps are {-found.age:.2f} s ahead of this machine's clock: set the clocks alike.")
    if 0 < len(found.latencies) < ENOUGH:
        add(f'There are only {len(found.latencies)} steps: the longest latency of ten or more is wanted.')
    if found.by_shift:
        add('The commands have no steps: control_latency holds the time in which the base speeds up, too, and is that of the whole '
            'drive, not the longest. Accelerations are not known.')
    if found.never_stopped:
        add(f'THE BASE DOES NOT STOP BY ITSELF: it still moved {found.never_stopped:.1f} s after the last command. Set the '
            "timeout of its driver (cmd_vel_timeout, watchdog) to 0.5 s or less.")
    elif found.stop_time and found.stop_time > 1.0:
        add(f'The base goes on for {found.stop_time:.2f} s when commands cease. Set the timeout of its driver (cmd_vel_timeout, '
            'watchdog) to 0.5 s or less.')


def _down(value):
    """Rounded down to two digits."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f'{math.floor(value / unit + 1e-9) * unit:.6g}')


def _up(value, unit):
    return round(math.ceil(value / unit - 1e-9) * unit, 6)


def parameters(found):
    """{name: (value, what it rests on)} of the planner's parameters that were measured."""
    result = {}
    if found.latency is not None:
        rests = f'longest of {len(found.latencies)}; median {np.median(found.latencies):.3f} s' if found.latencies else 'of the whole drive'
        result['control_latency'] = (_up(found.latency, 0.01), rests)
    for axis, name in enumerate(AXES):
        for kind, rates in (('acc', found.acceleration), ('decel', found.deceleration)):
            if rates[axis] is not None:
                result[f'{kind}_lim_{name}'] = (_down(CAREFUL * rates[axis]), 'what the base does; less is gentler')
    band = found.dead_band[1]
    if band and band[0] > 0.8 * FINEST[1]:  # one command is soon over, before a slow answer shows
        result['min_in_place_vel_theta'] = (_up(band[1], 0.01), f'it stood at {band[0]:.2f} rad/s')
    return result


def text(found):
    """The YAML file that move_base.launch takes as robot_params, with what no parameter takes as comments."""
    lines = ['# Measured by measure_base. Give this file as robot_params:=FILE, or add the lines to your own.']
    lines += [f'# {remark}' for remark in found.remarks]
    if found.stop_time is not None:
        lines.append(f'# When commands cease the base rests after {found.stop_time:.2f} s, {found.stop_way} further on.')
    elif not found.never_stopped:
        lines.append('# Whether the base stops by itself when commands cease was not measured.')
    for axis, what in ((0, 'driving'), (1, 'turning on the spot')):
        band = found.dead_band[axis]
        if band:
            stood = f'; it stood at {band[0]:.2f}' if band[0] > 0.0 else ''
            lines.append(f'# It begins {what} at a command of {band[1]:.2f} {UNITS[axis][0]}{stood}.')
    values = parameters(found)
    if not values:
        return '\n'.join([*lines, '# No parameter could be measured.', ''])
    width = max(len(f'{name}: {value:g}') for name, (value, _) in values.items())
    lines.append('HIDWAPlannerROS:')
    for name, (value, rests) in values.items():
        lines.append(f"  {f'{name}: {value:g}':<{width}}  # {rests}")
    return '\n'.join([*lines, ''])
