#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An operator drives while the host has no goal; goals come and go, the stick is held, let go, stopped and lost, at random. Never
two senders beyond one command, no jump beyond the limits, and after a release only braking. Shares no code with the planner."""
import collections
import os
import random
import sys
import threading
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *4 * ('..',)))
sys.path[0:0] = [os.path.join(ROOT, 'test', 'support'), os.path.join(ROOT, 'scripts', 'lib')]
import rospy  # noqa: E402
import rostest  # noqa: E402
from actionlib_msgs.msg import GoalStatusArray  # noqa: E402
from geometry_msgs.msg import Twist  # noqa: E402
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from std_msgs.msg import Bool  # noqa: E402

from command_watch import PLANNER, axis_limits, within  # noqa: E402
from hidwa_tools.waiting import wait_for  # noqa: E402
from running_host import RunningHost, Stick  # noqa: E402

PLACES = ((6.5, 1.5), (1.5, 1.5), (6.5, 3.5), (1.5, 3.5))
EVENTS = int(os.environ.get('HIDWA_GOALLESS_EVENTS', '40'))
SEED = 47
LATE = 3  # periods that a command may come late, on a busy machine

Sent = collections.namedtuple('Sent', 'time who command velocity')  # velocity: the robot's own [m/s, rad/s]
Told = collections.namedtuple('Told', 'time what')                   # what the host and the operator did


class Exchange:
    """Sends on the commands of the host and of the planner, and keeps all that happened in its order."""

    def __init__(self):
        self.lock = threading.Lock()
        self.log = []
        self.velocity = (0.0, 0.0)
        self.out = rospy.Publisher('/cmd_vel', Twist, queue_size=10, tcp_nodelay=True)
        for who in ('host', 'own'):
            rospy.Subscriber(f'/{who}_cmd_vel', Twist, self.take, who, queue_size=None, tcp_nodelay=True)
        rospy.Subscriber('/ground_truth', Odometry, self.take_truth, queue_size=10, tcp_nodelay=True)
        rospy.Subscriber('/move_base/goal', MoveBaseActionGoal, lambda _: self.note('goal'), queue_size=None, tcp_nodelay=True)
        rospy.Subscriber('/move_base/result', MoveBaseActionResult, lambda _: self.note('result'), queue_size=None, tcp_nodelay=True)

    def take(self, message, who):
        with self.lock:
            self.out.publish(message)
            self.log.append(Sent(rospy.get_time(), who, (message.linear.x, message.angular.z), self.velocity))

    def take_truth(self, message):
        self.velocity = (message.twist.twist.linear.x, message.twist.twist.angular.z)

    def note(self, what):
        with self.lock:
            self.log.append(Told(rospy.get_time(), what))

    def since(self, mark):
        with self.lock:
            return self.log[mark:]

    def mark(self):
        with self.lock:
            return len(self.log)


def overlaps(log):
    """For each goal, how many commands the planner sent of its own from its first sign to its result, beyond one."""
    found, goals, own = [], 0, 0
    for entry in log:
        if isinstance(entry, Told) and entry.what == 'goal':
            goals, own = goals + 1, 0
        elif isinstance(entry, Told) and entry.what == 'result':
            goals = max(0, goals - 1)
        elif isinstance(entry, Sent) and entry.who == 'own' and goals:
            own += 1
            if own > 1:
                found.append(f'at {entry.time:.2f} s: {own} commands without a goal after a goal came')
    return found


def jumps(log, limits, period):
    """Each command of ours that changes by more than the limits allow, from the command before and from the robot's velocity."""
    found, before = [], None
    for entry in log:
        if not isinstance(entry, Sent):
            continue
        if before and entry.command != (0.0, 0.0):
            span = max(entry.time - before.time, period) * LATE
            for axis, name in ((0, 'v'), (1, 'omega')):
                starts = (before.command[axis], entry.velocity[axis], before.velocity[axis])
                if not any(within(start, entry.command[axis], limits[axis], span) for start in starts):
                    found.append(f'at {entry.time:.2f} s: {name} {starts} -> {entry.command[axis]:.3f} by {entry.who}')
        before = entry
    return found


class GoallessTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.exchange, cls.stick, cls.host = Exchange(), Stick(), RunningHost(PLACES)
        cls.stop = rospy.Publisher(PLANNER + '/stop', Bool, queue_size=1)
        assert cls.host.wait_until_ready(), 'move_base does not come up'
        assert wait_for(lambda: cls.stop.get_num_connections()), 'nobody listens to stop'
        statuses = []
        rospy.Subscriber('/move_base/status', GoalStatusArray, statuses.append, queue_size=1)
        assert wait_for(lambda: statuses), 'move_base tells no status'
        cls.limits = (axis_limits('x', 0.0), axis_limits('theta'))
        cls.period = 1.0 / rospy.get_param('/move_base/controller_frequency', 20.0)

    def push(self, ahead, left=0.0):
        self.stick.ahead, self.stick.left, self.stick.sends = ahead, left, True

    def rests(self):
        self.assertTrue(self.host.stands(), 'the robot does not come to rest')

    def pass_time(self, seconds):
        end = rospy.get_time() + seconds
        self.assertTrue(wait_for(lambda: rospy.get_time() > end), 'the clock stands still')

    def no_goal(self):
        """The robot rests without a goal, and the operator's stick is centred."""
        self.push(0.0)
        self.host.cancel()
        self.stop.publish(False)
        self.rests()
        self.pass_time(1.5)

    def test_a_the_stick_drives_and_its_release_brakes(self):
        self.no_goal()
        mark = self.exchange.mark()
        self.push(1.0)
        self.assertTrue(wait_for(lambda: self.host.velocity[0] > 0.4), 'the stick drives nothing')
        self.assertEqual(self.host.state_name(), 'MANUAL')
        self.assertTrue(self.host.state.without_goal)
        released = self.exchange.mark()
        self.push(0.0)
        self.rests()
        self.pass_time(1.0)
        commands = [e.command for e in self.exchange.since(released)]
        self.assertEqual({e.who for e in self.exchange.since(mark)}, {'own'})
        falling = [v for v, _ in commands]
        last_drive = max((i for i, (v, _) in enumerate(commands) if v >= 0.5 - 1e-6), default=0)
        self.assertEqual(falling[last_drive:], sorted(falling[last_drive:], reverse=True), 'after a release the robot brakes')
        self.assertEqual(commands[-1], (0.0, 0.0))
        self.assertEqual(commands.count((0.0, 0.0)), 1, 'zero is sent once')
        self.assertEqual(self.host.contacts, 0)

    def test_b_a_stick_held_beyond_a_goal_must_be_neutral_first(self):
        self.no_goal()
        self.host.send_goal(*PLACES[0])
        self.assertTrue(wait_for(lambda: self.host.velocity[0] > 0.3), 'the robot does not drive to its goal')
        self.push(1.0, 0.3)
        self.assertTrue(wait_for(lambda: self.host.state_name() == 'SHARED'), self.host.state_name())
        self.host.cancel()
        self.rests()
        mark = self.exchange.mark()
        self.pass_time(2.0)
        self.assertEqual([e for e in self.exchange.since(mark) if isinstance(e, Sent) and e.command != (0.0, 0.0)], [])
        self.push(0.0)
        self.pass_time(0.3)
        self.push(-0.0, 0.8)
        self.assertTrue(wait_for(lambda: abs(self.host.velocity[1]) > 0.2), 'after neutral the stick does not drive')
        self.no_goal()

    def test_c_goals_cancels_releases_stops_and_losses_at_random(self):
        self.no_goal()
        draw = random.Random(SEED)
        mark = self.exchange.mark()
        for _ in range(EVENTS):
            event = draw.choice(('goal', 'cancel', 'cancel', 'push', 'push', 'push', 'push', 'release', 'stop', 'silence'))
            self.stop.publish(event == 'stop')
            if event == 'goal':
                self.host.send_goal(*draw.choice(PLACES))
            elif event == 'cancel':
                self.host.cancel()
            elif event == 'push':
                if draw.random() < 0.7:
                    self.push(0.0)
                    self.pass_time(0.2)
                self.push(draw.uniform(0.2, 1.0), draw.uniform(-1.0, 1.0))
            elif event == 'release':
                self.push(0.0)
            elif event == 'silence':
                self.stick.sends = False
            self.pass_time(draw.uniform(0.1, 1.5))
        self.no_goal()
        log = self.exchange.since(mark)
        sent = [e for e in log if isinstance(e, Sent)]
        own = sum(e.who == 'own' for e in sent)
        zeros = sum(e.who == 'host' and e.command == (0.0, 0.0) for e in sent)
        print(f'{EVENTS} events: {len(sent)} commands, {own} of them without a goal, {zeros} zeros of the host')
        moved = {who: sum(e.who == who and e.command != (0.0, 0.0) for e in sent) for who in ('own', 'host')}
        self.assertGreater(moved['own'], 3 * EVENTS, 'the operator hardly drove without a goal')
        self.assertGreater(moved['host'], EVENTS, 'the robot hardly drove to goals')
        self.assertEqual(overlaps(log), [])
        self.assertEqual(jumps(log, self.limits, self.period), [])
        self.assertEqual(self.host.contacts, 0)


if __name__ == '__main__':
    rospy.init_node('goalless_test')
    rostest.rosrun('hidwa_plugin_tests', 'goalless_test', GoallessTest, sys.argv)
