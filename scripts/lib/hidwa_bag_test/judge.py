# SPDX-License-Identifier: BSD-3-Clause
"""Judgements about commands, of plain numbers. Written apart from the planner's own checks."""
import math

import numpy as np

from hidwa_tools import geometry

ROUNDING = 1e-4  # [m/s, rad/s]
STEP = 0.02      # [s] of a sweep


def reachable(previous, measured, up, down, period):
    """(lowest, highest) velocity that one period reaches from the previous command or any measured velocity, which
    grows by at most `up` and falls by at most `down` [1/s^2]."""
    low, high = min([previous, *measured]), max([previous, *measured])
    return low - (down if low > 0.0 else up) * period, high + (up if high >= 0.0 else down) * period


def allowed(lowest, highest, previous, measured, down, period):
    """(lowest, highest) velocity within limits. A robot that is beyond them, driven by somebody else, is braked: each
    period takes it nearer to them by `down` [1/s^2]."""
    slower = down * period
    return min(lowest, min([previous, *measured]) + slower), max(highest, max([previous, *measured]) - slower)


def limit_fault(command, previous, measured, period, passed, limits):
    """What a command (v, omega) violates, in words; empty where it keeps the limits. `measured`: [(v, omega)]; `passed`
    [s] since the previous command, `period` [s] or more: by a coarse clock, or where the machine was slow."""
    ranges = {'x': (limits['min_vel_x'], limits['max_vel_x']), 'theta': (-limits['max_vel_theta'], limits['max_vel_theta'])}
    for i, (name, unit, axis) in enumerate((('v', 'm/s', 'x'), ('omega', 'rad/s', 'theta'))):
        up = limits['acc_lim_' + axis]
        down = abs(limits['decel_lim_' + axis]) or up
        before = [m[i] for m in measured]
        low, high = allowed(*ranges[axis], previous[i], before, down, period)
        if not low - ROUNDING <= command[i] <= high + ROUNDING:
            return f'{name} = {command[i]:.3f} {unit} is not within {low:.3f} and {high:.3f} {unit}'
        low, high = reachable(previous[i], before, up, down, passed)
        if not low - ROUNDING <= command[i] <= high + ROUNDING:
            return (f'{name} = {command[i]:.3f} {unit} cannot be reached in {passed:.3f} s: '
                    f'{low:.3f} to {high:.3f} {unit} can')
    return ''


def brakes_fully(command, previous, measured, period, decel):
    """Whether a command (v, omega) is as near to rest as `decel` (x, theta) [m/s^2, rad/s^2] lets a robot come that was
    commanded `previous` or measured one of `measured`."""
    return all(abs(command[i]) <= max(0.0, max(abs(u[i]) for u in [previous, *measured]) - decel[i] * period) + ROUNDING
               for i in (0, 1))


def braking_poses(pose, command, hold, decel):
    """Poses (n, 3) of a robot that keeps a command (v, omega) for `hold` [s] and then brakes each axis by `decel`
    (x, theta) [m/s^2, rad/s^2] to rest; from `pose` on, STEP apart."""
    to_rest = max(abs(command[0]) / decel[0], abs(command[1]) / decel[1])
    times = STEP * np.arange(int(math.ceil((hold + to_rest) / STEP)) + 1)
    middle = np.maximum(times[:-1] + 0.5 * STEP - hold, 0.0)
    v, omega = (np.sign(u) * np.maximum(abs(u) - a * middle, 0.0) for u, a in zip(command, decel))
    yaw = pose[2] + np.concatenate([[0.0], np.cumsum(omega * STEP)])
    along = 0.5 * (yaw[:-1] + yaw[1:])
    x = pose[0] + np.concatenate([[0.0], np.cumsum(v * STEP * np.cos(along))])
    y = pose[1] + np.concatenate([[0.0], np.cumsum(v * STEP * np.sin(along))])
    return np.column_stack([x, y, yaw])


def covered(footprint, poses, points):
    """Which of the points (m, 2) the footprint (n, 2) covers at any of the poses."""
    reach = np.hypot(footprint[:, 0], footprint[:, 1]).max()
    hit = np.zeros(len(points), bool)
    for pose in poses:
        near = ~hit & (np.hypot(points[:, 0] - pose[0], points[:, 1] - pose[1]) <= reach)
        hit[near] = geometry.contains(geometry.placed(footprint, *pose), points[near])
    return hit


def swept_points(footprint, pose, command, hold, decel, points):
    """How many points the footprint meets on its way to rest, without those that it covers where it stands: no
    command can be blamed for them."""
    if not len(points):
        return 0
    poses = braking_poses(pose, command, hold, decel)
    return int(np.count_nonzero(covered(footprint, poses, points) & ~covered(footprint, poses[:1], points)))


def mean_deviation(times, commands, recorded_times, recorded):
    """Mean absolute difference (v, omega) of commands (n, 2) from what was recorded last (m, 2) at their times; None
    where nothing was recorded before any of them."""
    index = np.searchsorted(recorded_times, times, side='right') - 1
    known = index >= 0
    if not known.any():
        return None
    return np.abs(np.asarray(commands)[known] - np.asarray(recorded)[index[known]]).mean(axis=0)
