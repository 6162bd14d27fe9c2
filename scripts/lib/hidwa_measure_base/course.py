# SPDX-License-Identifier: BSD-3-Clause
"""What a guided measurement commands, and when it is to end. Knows no ROS: time [s] and a Track come in, commands go out."""
import random
from dataclasses import dataclass

import numpy as np

from .findings import FINEST, STILL
from .track import driven

FASTEST, FASTEST_TURN = 0.3, 0.6  # [m/s], [rad/s]
TIMES = 10             # steps of each kind
SHORTEST, LONGEST = 1.2, 3.0  # [s]; how long a step is driven: until the velocity stays, within these
LOOK_BACK = 0.3        # [s]; window in which a velocity is measured
SETTLED = 0.05         # of the command; a velocity that changes by less has settled
REST = 0.6             # [s]; rest before the next step
REST_LIMIT = 6.0       # [s]; by then it does
SILENCE = 2.0          # [s] without commands, at most
STAIR_TIME = 0.5       # [s] of each command that looks for the dead band
STAIRS = (0.15, 0.6)   # [m/s], [rad/s]; where that ends
FREE = 1.5             # [m]; the robot never goes farther from where it began
MISSING = 0.5          # [s]; odometry is missing if it is older than this, and older than
INTERVALS = 3.0        # this many of its intervals
JUMP, JUMP_TURN = 0.05, 0.15  # [m], [rad]; from message to message, beyond what the fastest drive explains
TOO_FAST = 1.5         # of FASTEST


class Doubt(Exception):
    """Something is not as it should be: the measurement ends. The text says what, and the remedy."""


@dataclass
class Phase:
    """`kind`: 'step': drive until the velocity stays; 'stair': a moment; 'silence': send nothing until rest; 'rest': stand."""
    kind: str
    v: float = 0.0
    omega: float = 0.0


def phases(speed, turn, times=TIMES):
    """All that is driven: to and fro and left and right `times` times, slowly growing commands, and two times without commands."""
    found = [Phase('rest')]
    for v, omega in ((speed, 0.0), (0.0, turn)):
        for _ in range(times):
            for sign in (1.0, -1.0):
                found += [Phase('step', sign * v, sign * omega), Phase('rest')]
    for axis in (0, 1):
        finest = FINEST[axis] * 0.5 // 0.005 * 0.005  # [m/s], [rad/s]
        for i in range(1, int(STAIRS[axis] / finest + 1.5)):
            found.append(Phase('stair', *((finest * i, 0.0) if axis == 0 else (0.0, finest * i))))
        found.append(Phase('rest'))
    for sign in (1.0, -1.0):
        found += [Phase('step', sign * speed), Phase('silence', sign * speed), Phase('rest')]
    return found


class Course:
    """Which command is due."""

    def __init__(self, track, all_, seed=1):
        self._track, self._left, self._random = track, list(all_), random.Random(seed)
        self._phase, self._since, self._pause = None, 0.0, 0.0
        self._base = None

    @property
    def phase(self):
        return self._phase

    @property
    def left(self):
        return len(self._left)

    def command(self, now):
        """(v, omega) to send; None: nothing is to be sent. StopIteration at the end; Doubt where the robot does not answer."""
        while self._phase is None or self._over(now):
            if not self._left:
                raise StopIteration
            before, self._phase = self._phase, self._left.pop(0)
            if before and before.kind == 'stair' and self._phase.kind == 'stair' and self._moved():
                while self._left and self._phase.kind == 'stair':  # what comes next would only be faster
                    self._phase = self._left.pop(0)
            self._since, self._pause = now, self._random.uniform(0.0, 0.2)  # steps fall anywhere between odometry's messages
            if self._phase.kind != 'stair' or not before or before.kind != 'stair':
                self._base = self._ways(now)
        phase = self._phase
        if phase.kind == 'rest':
            return 0.0, 0.0
        return None if phase.kind == 'silence' else (phase.v, phase.omega)

    def _ways(self, now):
        """(driven, turned) so far."""
        rows = self._rows(now, np.inf)
        return tuple(float(driven(rows, axis)[1][-1]) if len(rows) > 1 else 0.0 for axis in (0, 1))

    def _rows(self, now, span):
        """Odometry of the last `span` [s]."""
        found = []
        for row in reversed(self._track.odometry):
            if row[0] < now - span:
                break
            found.append(row)
        return np.array(found[::-1], float).reshape(-1, 7)

    def _speed(self, begin, end, axis):
        """Mean velocity between two times."""
        time, way = driven(self._rows(end, end - begin + 1.0), axis)
        if len(time) < 2:
            return 0.0
        return float(np.interp(end, time, way) - np.interp(begin, time, way)) / (end - begin)

    def _moved(self):
        ways = self._ways(self._track.odometry[-1][0])
        return any(abs(way - base) > STILL[axis] for axis, (way, base) in enumerate(zip(ways, self._base)))

    def _stands(self, now):
        """Whether it stood for REST. Means are compared, since single poses may be noisy."""
        rows, middle = self._rows(now, REST), now - 0.5 * REST
        early = rows[:, 0] <= middle
        if early.all() or not early.any():
            return False
        for axis in (0, 1):
            time, way = driven(rows, axis)
            if abs(way[time > middle].mean() - way[time <= middle].mean()) > 0.3 * STILL[axis]:
                return False
        return True

    def _over(self, now):
        phase, passed = self._phase, now - self._since
        if phase.kind == 'rest':
            if passed > REST_LIMIT and not self._stands(now):
                raise Doubt('the robot does not come to rest when 0 is commanded, or odometry says so: does something else drive it?')
            return passed >= REST + self._pause and self._stands(now)
        if phase.kind == 'stair':
            return passed >= STAIR_TIME
        if phase.kind == 'silence':
            return passed >= SILENCE or (passed > REST and self._stands(now))
        axis = 0 if phase.v else 1
        if passed < SHORTEST + self._pause:
            return False
        wanted = (phase.v, phase.omega)[axis]
        newest = self._track.odometry[-1][0]
        late, early = self._speed(newest - LOOK_BACK, newest, axis), self._speed(newest - 2.0 * LOOK_BACK, newest - LOOK_BACK, axis)
        if late * wanted < 0.0 and abs(late) > 0.2 * abs(wanted):
            raise Doubt(f'odometry moves the other way ({late:.2f} where {wanted:.2f} is commanded): check the signs of cmd_vel and odom')
        if passed >= LONGEST and not self._moved():
            raise Doubt(f'the robot does not move at a command of {wanted:.2f} {("m/s", "rad/s")[axis]}: are its motors on, is its stop '
                        'released, is this the topic that its driver hears?')
        return passed >= LONGEST or abs(late - early) < SETTLED * abs(wanted) and abs(late) >= 0.1 * abs(wanted)


class Watch:
    """Ends the measurement on every doubt."""

    def __init__(self, track, lifted):
        self._track, self._lifted, self._seen = track, lifted, 0

    def check(self, now):
        """Doubt where odometry is missing or cannot be, or the robot is where it should not be."""
        rows = self._track.odometry
        if not rows:
            raise Doubt('no odometry comes: check --odom-topic')
        usual = float(np.median(np.diff([row[0] for row in rows[-20:]]))) if len(rows) > 1 else 0.0
        if now - rows[-1][0] > max(MISSING, INTERVALS * usual):
            raise Doubt(f'odometry is missing: the last message is {now - rows[-1][0]:.2f} s old')
        begin, self._seen = max(1, self._seen), len(rows)
        for before, after in zip(rows[begin - 1:], rows[begin:]):
            self._compare(before, after)

    def _compare(self, before, after):
        numbers = after[:6]
        if not np.isfinite(numbers).all():
            raise Doubt('odometry holds what is no number')
        if after[0] < before[0] or (after[6] < before[6] and after[6] > 0.0):
            raise Doubt('odometry goes back in time: do two nodes publish it, or was a clock set?')
        passed = max(after[0] - before[0], after[6] - before[6], 0.0)
        way = np.hypot(after[1] - before[1], after[2] - before[2])
        angle = abs((after[3] - before[3] + np.pi) % (2.0 * np.pi) - np.pi)
        if way > JUMP + TOO_FAST * FASTEST * passed or angle > JUMP_TURN + 2.0 * FASTEST_TURN * passed:
            raise Doubt(f'odometry jumped by {way:.2f} m and {angle:.2f} rad within {passed:.2f} s: do two nodes publish it?')
        first = self._track.odometry[0]
        away = np.hypot(after[1] - first[1], after[2] - first[2])
        if away > FREE and not self._lifted:
            raise Doubt(f'the robot is {away:.2f} m from where it began, farther than the measurement needs')
