# SPDX-License-Identifier: BSD-3-Clause
"""Plays a recording to the planner, no faster than the planner keeps up, and hears what it answers."""
import collections
import copy
import math
import threading
import time

import rospy
from hidwa_local_planner.msg import Cycle, OperatorState
from nav_msgs.msg import Path
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool

from .errors import BagTestError
from .recording import shift

PLANNER = '/move_base/HIDWAPlannerROS/'
STEP = 0.01        # [s] of the clock
FIRST = 1000.0     # [s] of the clock, so that there is room before what is played
PATIENCE = 90.0    # [s], wall time, for the nodes to start and for an answer; a slow machine takes long


class Answers:
    """What the planner said, in the order of its cycles."""

    def __init__(self):
        self.cycles, self.states, self.reached = [], [], False
        self._heard = threading.Condition()
        self._subscribers = [rospy.Subscriber(PLANNER + 'cycle', Cycle, self._cycle, tcp_nodelay=True),
                             rospy.Subscriber(PLANNER + 'operator_state', OperatorState, self.states.append),
                             rospy.Subscriber('/bag_test/goal_reached', Bool, self._reached)]

    def connected(self):
        return all(subscriber.get_num_connections() for subscriber in self._subscribers)

    def _cycle(self, message):
        with self._heard:
            self.cycles.append(message)
            self._heard.notify()

    def _reached(self, message):
        with self._heard:
            self.reached = message.data
            self._heard.notify()

    def wait_for_cycle(self, since):
        """Until there is a cycle at or after `since` [s], or the goal is reached."""
        with self._heard:
            if not self._heard.wait_for(lambda: self.reached or (self.cycles and self.newest() >= since), PATIENCE):
                raise BagTestError(f'the planner has not answered for {PATIENCE:.0f} s: see its log')

    def newest(self):
        return self.cycles[-1].header.stamp.to_sec()


class Player:
    """Topics of a recording, plans and the clock."""

    def __init__(self, recording, description, plans, period):
        self._recording, self._description, self._period = recording, description, period
        self._topics = {name: played for name, played in description.topics.items() if recording.of(name)}
        self._publishers = {name: rospy.Publisher(played, type(recording.of(name)[0][1]), queue_size=100,
                                                  latch=name == '/tf_static') for name, played in self._topics.items()}
        self._clock = rospy.Publisher('/clock', Clock, queue_size=1)
        self._plan = rospy.Publisher('/bag_test/plan', Path, queue_size=10)
        self._plans = plans
        self._first = self._first_messages()
        self._answers = Answers()

    def run(self):
        """Plays everything; the Answers, in the bag's time."""
        now = self._wait_until_ready()
        offset = int(math.ceil(now - self._recording.start))
        while now < self._recording.start + offset - 0.05:
            now = self._pass_time(now)
        self._play(offset)
        for message in self._answers.cycles + self._answers.states:
            shift(message, -offset)
        return self._answers

    def _play(self, offset):
        events = self._events(offset)
        now, end = self._recording.start + offset, self._recording.end + offset
        due, planned = time.monotonic(), None
        while now < end:
            while events and events[0][0] <= now:
                _, publisher, message = events.popleft()
                if publisher is self._plan:  # before it is sent: a goal may be reached at once
                    planned, self._answers.reached = now, False
                publisher.publish(message)
            self._tick(now)
            due = max(due + STEP / self._description.rate, time.monotonic())
            time.sleep(max(0.0, due - time.monotonic()))
            if planned is not None and now - planned > 3.0 * self._period:
                self._answers.wait_for_cycle(now - 2.0 * self._period)
            now += STEP

    def _events(self, offset):
        """[(time, publisher, message)] in order, of the time that is played."""
        events = [(t, self._publishers[name], message) for t, name, message in self._recording.events
                  if name in self._publishers] + [(t, self._plan, plan) for t, plan in self._plans]
        played = collections.deque()
        for t, publisher, message in sorted(events, key=lambda event: event[0]):
            message = copy.deepcopy(message)
            shift(message, offset)
            played.append((t + offset, publisher, message))
        return played

    def _tick(self, now):
        self._clock.publish(Clock(rospy.Time.from_sec(now)))

    def _wait_until_ready(self):
        """Time passes, with the robot where it begins, until everybody listens; the time [s] then."""
        deadline, now = time.monotonic() + PATIENCE, FIRST
        while True:
            deaf = [self._topics[name] for name, publisher in self._publishers.items()
                    if not publisher.get_num_connections() and name != '/tf_static']
            if not deaf and self._plan.get_num_connections() and self._answers.connected():
                return now
            if rospy.is_shutdown() or time.monotonic() > deadline:
                names = ', '.join(deaf) or '/bag_test/plan'
                raise BagTestError(f'after {PATIENCE:.0f} s nobody listens to {names}: does the test include bag_test.launch, '
                                   'and are the topics and the mode right?')
            now = self._pass_time(now)

    def _pass_time(self, now):
        """A twentieth of a second in which the robot stands where it begins; the time [s] after it."""
        for publisher, message in self._first:
            publisher.publish(_stamped(message, now))
        for _ in range(5):
            now += STEP
            self._tick(now)
            time.sleep(STEP)
        return now

    def _first_messages(self):
        """The first odometry and scan, and the first of each transform; the person waits."""
        first, known = [], set()
        for _, name, message in self._recording.events:
            if name not in self._publishers:
                continue
            if name in ('/tf', '/tf_static'):
                new = [t for t in message.transforms if t.child_frame_id not in known]
                known.update(t.child_frame_id for t in new)
                if new:
                    first.append((self._publishers[name], type(message)(new)))
            elif name in (self._description.odom, self._description.scan) and name not in known:
                known.add(name)
                first.append((self._publishers[name], message))
        return first


def _stamped(message, now):
    """A copy of the message, of now."""
    message = copy.deepcopy(message)
    for part in getattr(message, 'transforms', [message]):
        part.header.stamp = rospy.Time.from_sec(now)
    return message
