# SPDX-License-Identifier: BSD-3-Clause
"""Watches every command that a host sends, and what the planner says of it: finite, within the limits, and no faster changed than
the acceleration limits allow. Shares no code with the planner."""
import collections
import math
import threading

import rospy
from geometry_msgs.msg import Twist
from hidwa_local_planner.msg import Cycle

PLANNER = '/move_base/HIDWAPlannerROS'
EPSILON = 1e-6    # rounding [m/s, rad/s]
PAUSE = 0.3       # [s]; after a longer silence of the host the robot's own velocity is where a command starts

Limits = collections.namedtuple('Limits', 'low high acceleration deceleration')  # of one axis, SI
Step = collections.namedtuple('Step', 'time velocity reference outcome')


def axis_limits(name, low=None):
    """Limits of an axis as the parameter server has them; `name` is x or theta."""
    def value(key):
        return abs(rospy.get_param(f'{PLANNER}/{key}_{name}'))
    acceleration = value('acc_lim')
    return Limits(-value('max_vel') if low is None else low, value('max_vel'), acceleration, value('decel_lim') or acceleration)


def within(start, end, limits, span):
    """Whether a velocity may change so within `span` [s]. Nearer to zero is braking; beyond it the axis speeds up."""
    brakes = abs(end) <= abs(start) and end * start >= 0.0
    most = limits.deceleration if brakes else max(limits.acceleration, limits.deceleration)
    return abs(end - start) <= most * span + EPSILON


def changes_beyond(steps, limits, period):
    """Each change of one axis' command that the limits do not allow, in words.

    From one cycle to the next a command may change by limit x the time between them, at least a period. After a pause, or where
    time went back, it may also start from the reference.
    """
    found = []
    for before, now in zip(steps, steps[1:]):
        gap = now.time - before.time
        span = min(max(period, gap), PAUSE)
        starts = [before.velocity]
        if gap < 0.0 or gap > PAUSE:
            starts.append(now.reference)
        if not any(within(start, now.velocity, limits, span) for start in starts):
            found.append(f'at {now.time:.3f} s: {before.velocity:.4f} -> {now.velocity:.4f} within {gap:.3f} s ({now.outcome})')
    return found


def values_beyond(values, limits):
    """Each value that is not finite or beyond the limits, in words."""
    return [f'{value}' for value in values
            if not (math.isfinite(value) and limits.low - EPSILON <= value <= limits.high + EPSILON)]


def zeros_at_once(commands, most):
    """How often zero follows a command of which one axis, (v, omega), is beyond `most`."""
    return sum(after == (0.0, 0.0) and any(abs(value) > bound for value, bound in zip(before, most))
               for before, after in zip(commands, commands[1:]))


class CommandWatch:
    """Use begin() before a fault and faults() after it."""

    def __init__(self, min_vel_x=0.0):
        self._lock = threading.Lock()
        self.x, self.theta = axis_limits('x', min_vel_x), axis_limits('theta')
        self.period = 1.0 / rospy.get_param('/move_base/controller_frequency', 20.0)
        self.sent_in_all = self.cycles_in_all = 0
        self.begin()
        rospy.Subscriber('/cmd_vel', Twist, self._take_command, queue_size=None, tcp_nodelay=True)
        rospy.Subscriber(PLANNER + '/cycle', Cycle, self._take_cycle, queue_size=None, tcp_nodelay=True)

    def begin(self):
        """Forgets what was before."""
        with self._lock:
            self._commands, self._cycles = [], []
            self.command, self.cycle = None, None  # the newest

    def _take_command(self, message):
        with self._lock:
            self._commands.append((message.linear.x, message.angular.z, message.linear.y))
            self.command = message
            self.sent_in_all += 1

    def _take_cycle(self, message):
        with self._lock:
            self._cycles.append(message)
            self.cycle = message
            self.cycles_in_all += 1

    def count(self):
        """How many commands came since begin()."""
        with self._lock:
            return len(self._commands)

    def cycles(self):
        """What the planner said of its cycles since begin()."""
        with self._lock:
            return list(self._cycles)

    def speed(self):
        """Of the newest command [m/s]; 0 where there is none."""
        with self._lock:
            return self.command.linear.x if self.command else 0.0

    def outcomes(self):
        """The names of what the cycles came to, since begin()."""
        with self._lock:
            return {cycle.outcome_name for cycle in self._cycles}

    def said(self, part):
        """Whether a cycle named a fault with these words, since begin()."""
        with self._lock:
            return any(part in cycle.fault for cycle in self._cycles)

    def abrupt_stops(self):
        """Zeros out of more speed than a cycle may brake by, but for the planner's own after a late cycle: those of the host."""
        with self._lock:
            sent = [command[:2] for command in self._commands]
            own = [(cycle.command.linear.x, cycle.command.angular.z) for cycle in self._cycles]
        most = [3.0 * self.period * axis.deceleration for axis in (self.x, self.theta)]
        return max(0, zeros_at_once(sent, most) - zeros_at_once(own, most))

    def faults(self):
        """All that is wrong with what was sent since begin(), in words."""
        with self._lock:
            commands, cycles = list(self._commands), list(self._cycles)
        found = ['v ' + text for text in values_beyond([c[0] for c in commands], self.x)]
        found += ['omega ' + text for text in values_beyond([c[1] for c in commands], self.theta)]
        found += [f'sideways {c[2]}' for c in commands if c[2] != 0.0]
        for name, limits, part in (('v', self.x, lambda t: t.linear.x), ('omega', self.theta, lambda t: t.angular.z)):
            steps = [Step(c.header.stamp.to_sec(), part(c.command), part(c.reference), c.outcome_name) for c in cycles]
            found += [f'{name} {text}' for text in changes_beyond(steps, limits, self.period)]
        own = {(c.command.linear.x, c.command.angular.z) for c in cycles} | {(0.0, 0.0)}
        # The first ones may belong to a cycle before begin().
        found += [f'{c} is no command of the planner' for c in commands[2:-2] if c[:2] not in own]
        return found
