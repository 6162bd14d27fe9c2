# SPDX-License-Identifier: BSD-3-Clause
"""How far the robot has come on its way to a goal, and how long the rest will take."""
import math

import numpy as np

MEMORY = 20.0  # [s] over which the speed is averaged
USUAL = 0.8    # share of the largest speed that a drive usually has
SLOWEST = 0.1  # [m/s]; a robot that stands will not stand for ever


class Progress:
    """Positions in the map [m], times monotonic [s]."""

    def __init__(self):
        self._points, self._to_go, self._position, self._at = np.empty((0, 2)), np.empty(0), None, None
        self._began, self._driven, self._speed = None, 0.0, None

    def begin(self, now):
        """A goal was given."""
        self._began, self._driven = now, 0.0

    def end(self):
        """There is no goal any more."""
        self._began = None

    def plan(self, points):
        """The host's path, rows x, y."""
        self._points = np.asarray(points)
        steps = np.hypot(*np.diff(self._points, axis=0).T) if len(self._points) > 1 else np.empty(0)
        self._to_go = np.append(np.cumsum(steps[::-1])[::-1], 0.0)

    def move(self, pose, velocity, now):
        """Where the robot is, and how fast by odometry."""
        if pose is None:
            return
        if self._position is not None:
            step = math.dist(self._position, pose[:2])
            self._driven += step if step < 1.0 else 0.0  # localisation may jump
        if velocity and abs(velocity[0]) > SLOWEST and self._at is not None:
            share = min(1.0, (now - self._at) / MEMORY)
            self._speed = abs(velocity[0]) if self._speed is None else self._speed + share * (abs(velocity[0]) - self._speed)
        self._position, self._at = pose[:2], now

    def remaining(self):
        """Length of the plan from the pose on it nearest to the robot [m]; None without both."""
        if self._position is None or not len(self._points):
            return None
        apart = np.hypot(*(self._points - self._position).T)
        nearest = int(np.argmin(apart))
        return float(apart[nearest] + self._to_go[nearest])

    def report(self, max_speed, now):
        """The page's `progress`; None without a goal. max_speed [m/s] or None."""
        to_go = self.remaining()
        if self._began is None or to_go is None:
            return None
        speed = max(SLOWEST, self._speed if self._speed is not None else USUAL * (max_speed or 0.5))
        return {'driven': round(self._driven, 1), 'to_go': round(to_go, 1), 'elapsed': round(now - self._began),
                'time_left': round(to_go / speed)}
