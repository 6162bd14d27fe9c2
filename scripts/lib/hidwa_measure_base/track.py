# SPDX-License-Identifier: BSD-3-Clause
"""What was commanded and what odometry said, as numbers over time. Times [s] are those of sending and of arrival: what a planner
sees. Axis 0 is x [m], axis 1 is theta [rad]."""
from dataclasses import dataclass, field

import numpy as np

AXES = ('x', 'theta')


@dataclass
class Run:
    """Commands that are the same, one after the other."""
    begin: float      # the first one was sent [s]
    end: float        # time of the last one; where commands are sent once, of the next command [s]
    next: float       # another one is sent, or the track ends [s]
    command: tuple    # v [m/s], omega [rad/s]


@dataclass
class Track:
    """Commands and odometry in the order in which they came."""
    commands: list = field(default_factory=list)   # (time, v [m/s], omega [rad/s])
    odometry: list = field(default_factory=list)   # (time, x [m], y [m], yaw [rad], v [m/s], omega [rad/s], stamp [s])

    def command(self, time, v, omega):
        self.commands.append((time, v, omega))

    def receive(self, time, x, y, yaw, v, omega, stamp):
        self.odometry.append((time, x, y, yaw, v, omega, stamp))

    def end(self):
        """The time of the last message [s]."""
        return max([row[0] for row in (*self.commands[-1:], *self.odometry[-1:])], default=0.0)

    def runs(self):
        """The Runs of all commands."""
        found = []
        for time, *command in self.commands:
            if found and found[-1].command == tuple(command):
                found[-1].end = time
            else:
                found.append(Run(time, time, time, tuple(command)))
        for run, after in zip(found, [run.begin for run in found[1:]] + [self.end()]):
            run.next = after
            if run.end == run.begin:
                run.end = after
        return found

    def sent(self, axis):
        """Times (n,) and commands (n,) of an axis."""
        rows = np.array(self.commands, float).reshape(-1, 3)
        return rows[:, 0], rows[:, 1 + axis]

    def driven(self, axis):
        """Times (n,) and how far the robot had driven (signed, along its heading) or turned by then (n,)."""
        return driven(np.array(self.odometry, float).reshape(-1, 7), axis)

    def age(self):
        """How old odometry is by its stamp when it arrives [s], the median; None where it has no stamps."""
        rows = np.array(self.odometry, float).reshape(-1, 7)
        stamped = rows[:, 6] > 0.0
        return float(np.median((rows[:, 0] - rows[:, 6])[stamped])) if stamped.any() else None

    def interval(self):
        """Between two odometry messages [s], the median; None where there are not two."""
        times = np.array([row[0] for row in self.odometry])
        return float(np.median(np.diff(times))) if len(times) > 1 else None


def driven(rows, axis):
    """Track.driven of rows (n, 7). Poses count, since they hold what was driven between two messages. Where they stand still
    although the velocity does not (a driver that fills the twist alone), the velocity is added up."""
    rows = rows[np.r_[True, np.diff(rows[:, 0]) > 0.0]] if len(rows) else rows
    if len(rows) < 2:
        return rows[:, 0], np.zeros(len(rows))
    time, yaw = rows[:, 0], np.unwrap(rows[:, 3])
    if np.ptp(rows[:, 1]) == 0.0 and np.ptp(rows[:, 2]) == 0.0 and np.ptp(yaw) == 0.0:
        speed = rows[:, 4 + axis]
        return time, np.r_[0.0, np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(time))]
    if axis == 1:
        return time, yaw - yaw[0]
    middle = 0.5 * (yaw[1:] + yaw[:-1])
    steps = np.diff(rows[:, 1]) * np.cos(middle) + np.diff(rows[:, 2]) * np.sin(middle)
    return time, np.r_[0.0, np.cumsum(steps)]
