# SPDX-License-Identifier: BSD-3-Clause
"""One drive in a running ROS graph: waits for it to be ready, gives the goal, shows progress, waits for the end."""
import json
import math
import sys
import time
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
from actionlib_msgs.msg import GoalID, GoalStatusArray
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult
from nav_msgs.msg import Odometry, Path
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy, LaserScan
from std_msgs.msg import String, UInt32

from .bag import INFO_TOPIC, SUCCEEDED
from .drawing import STATE_NAMES
from .errors import DemoError
from .geometry import circle
from .pose_goal import goal_message
from .recording import plugin_name, stick_of
from .waiting import PATIENCE, wait_for
from .wheels import Wheels

MAP_AND_HOST = 'move_base, or the map that it needs'
ASKS_ANEW = 15.0  # [s], wall time, and each time twice as long as before


class Latest:
    """The last message of a topic."""

    def __init__(self, topic, kind):
        self.message, self.count = None, 0
        self._topic, self._kind, self._subscriber = topic, kind, None
        self.ask()

    def ask(self):
        """Subscribes, if need be anew: while nodes start on a busy machine a connection may get lost."""
        if self._subscriber:
            self._subscriber.unregister()
        self._subscriber = rospy.Subscriber(self._topic, self._kind, self._receive, queue_size=1)

    def _receive(self, message):
        self.message, self.count = message, self.count + 1


def footprint_of(parameters):
    """The robot's own outline [[x, y], ...], as its parameters describe it."""
    outline = parameters.get('footprint')
    if isinstance(outline, str):
        outline = json.loads(outline)
    if outline:
        return outline
    return circle(parameters.get('radius', 0.30)).tolist()  # the simulation's default


def unconnected(node, topics):
    """Those of the topics that some publisher does not yet send to `node`. The publishers themselves are asked: a
    subscriber may call itself connected before its publisher knows of it."""
    master = rosgraph.Master('/demo')
    publishers = {topic: nodes for topic, nodes in master.getSystemState()[0] if topic in topics}
    sent = set()
    for name in set().union(*publishers.values()):
        try:
            with ServerProxy(master.lookupNode(name)) as publisher:
                bus = publisher.getBusInfo('/demo')[2]
        except (rosgraph.MasterError, OSError):
            continue
        sent.update((name, entry[4]) for entry in bus if entry[1] == node and entry[2] == 'o')
    return [topic for topic, nodes in publishers.items() if any((name, topic) not in sent for name in nodes)]


class Drive:
    """A drive with `options` (see options.py); `alive` says whether the launched nodes still run."""

    def __init__(self, options, alive):
        self._options, self._alive = options, alive
        rospy.init_node('demo', disable_signals=True)
        self._clock = Latest('/clock', Clock)
        self._truth = Latest('/ground_truth', Odometry)
        self._scan = Latest('/scan', LaserScan)
        self._contacts = Latest('/contacts', UInt32)
        self._stick = Latest('/joy', Joy)
        self._host = Latest('/move_base/status', GoalStatusArray)
        self._plan = Latest(f'/move_base/{plugin_name(options.global_planner)}/plan', Path)
        self._state = None
        self._watch_operator()
        self._wheels = Wheels() if options.gui else None
        self._info = rospy.Publisher(INFO_TOPIC, String, queue_size=1, latch=True)
        # The action's topics themselves: the goal and its end are what the bag holds too.
        self._goal = rospy.Publisher('/move_base/goal', MoveBaseActionGoal, queue_size=1)
        self._cancel = rospy.Publisher('/move_base/cancel', GoalID, queue_size=1)
        self._result = Latest('/move_base/result', MoveBaseActionResult)
        self._driven, self._last = 0.0, None
        self._ticks, self._ticked_at = 0, time.monotonic()

    def _watch_operator(self):
        # Read as any message, by its own definition: the first byte after the header is the state.
        def receive(message):
            length = int.from_bytes(message._buff[12:16], 'little')
            self._state = STATE_NAMES[message._buff[16 + length]]
        rospy.Subscriber('/move_base/HIDWAPlannerROS/operator_state', rospy.AnyMsg, receive, queue_size=1)

    def wait_until_ready(self):
        """Until robot, laser, person and move_base are there, which itself waits for the map. DemoError names what is missing.

        Nothing here may wait in simulated time: without a simulator it stands still."""
        topics = {'the clock': self._clock, 'the robot': self._truth, 'the laser': self._scan, MAP_AND_HOST: self._host}
        if self._options.operator not in ('none', 'page'):
            topics['the person (/joy)'] = self._stick
        began, asks = time.monotonic(), ASKS_ANEW
        while True:
            missing = [name for name, topic in topics.items() if not topic.message]
            if not missing and self._goal.get_num_connections():
                return
            self._require_alive()
            now = time.monotonic()
            if now - began > PATIENCE:
                raise DemoError(f'after {PATIENCE:.0f} s still waiting for {", ".join(missing) or MAP_AND_HOST}')
            if now - began > asks:
                asks *= 2.0
                for name in missing:
                    print(f'{name}: nothing after {now - began:.0f} s, asked anew', flush=True)
                    topics[name].ask()
            time.sleep(0.1)

    def describe(self, host):
        """Publishes what a report has to know and no other topic says."""
        o = self._options
        name = plugin_name(o.planner)
        parameters = rospy.get_param('/move_base/' + name, {})
        self._info.publish(json.dumps({
            'map': o.map_name, 'mode': parameters.get('mode', 'off'), 'host': host, 'planner': name,
            'operator': o.operator_name, 'start': o.start, 'goal': o.goal, 'rate': o.rate,
            'footprint': footprint_of(rospy.get_param('/hidwa_sim')), 'acc_lim_theta': parameters.get('acc_lim_theta'),
            'stick': stick_of(parameters)}))

    def wait_for_recorder(self, node, topics, recorder):
        """Until `node`, run by the Child `recorder`, is connected to every publisher of the topics: what is said before that
        would be lost."""
        deadline = time.monotonic() + PATIENCE
        while True:
            missing = unconnected(node, topics)
            if not missing:
                return
            self._require_alive()
            if not recorder.running:
                raise DemoError(f'rosbag record ended: {recorder.complaint()}')
            if time.monotonic() > deadline:
                raise DemoError(f'rosbag record does not get {", ".join(missing)}; recorder.log may say why')
            time.sleep(0.1)

    def go(self):
        """Gives the goal and waits for the host's answer: (arrived, text)."""
        goal = goal_message(self._options.goal, 'demo')
        self._goal.publish(goal)
        begin, progress = rospy.get_time(), Progress()
        while not self._result.message:
            time.sleep(0.1)
            self._require_alive()
            self._require_clock()
            self._measure()
            elapsed = rospy.get_time() - begin
            progress.show(self._status(elapsed), last=self._result.message or elapsed > self._options.timeout)
            if elapsed > self._options.timeout:
                self._cancel.publish(goal.goal_id)
                self._settle()
                return False, f'not there after {elapsed:.0f} s of simulated time (--timeout)'
        self._settle()
        status = self._result.message.status
        return status.status == SUCCEEDED, status.text

    def _settle(self):
        """Half a second of simulated time more for the record."""
        end = rospy.get_time() + 0.5
        wait_for(lambda: rospy.get_time() >= end or not self._alive())

    def _require_alive(self):
        if not self._alive():
            raise DemoError('a node ended, or could not be started')

    def _require_clock(self):
        now = time.monotonic()
        if self._ticks != self._clock.count:
            self._ticks, self._ticked_at = self._clock.count, now
        elif now - self._ticked_at > PATIENCE:
            raise DemoError(f'the simulated clock stood still for {PATIENCE:.0f} s')

    def _measure(self):
        p = self._truth.message.pose.pose.position
        if self._last is not None:
            self._driven += math.hypot(p.x - self._last[0], p.y - self._last[1])
        self._last = (p.x, p.y)

    def _status(self, elapsed):
        plan = self._plan.message.poses if self._plan.message else []
        points = [(p.pose.position.x, p.pose.position.y) for p in plan]
        remaining = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
        contacts = self._contacts.message.data if self._contacts.message else 0
        return (f'{elapsed:6.1f} s  driven {self._driven:5.1f} m  to go {remaining:5.1f} m  '
                f'{self._truth.message.twist.twist.linear.x:4.2f} m/s  contacts {contacts}  {self._state or ""}')


class Progress:
    """One line that is written anew on a terminal; elsewhere a line every few seconds."""

    def __init__(self, out=sys.stdout):
        self._out, self._terminal, self._due = out, out.isatty(), 0.0

    def show(self, line, last=False):
        now = time.monotonic()
        if now < self._due and not last:
            return
        self._due = now + (0.5 if self._terminal else 5.0)
        self._out.write(f'\r{line}\033[K' if self._terminal else f'{line}\n')
        if last:
            self.end()
        self._out.flush()

    def end(self):
        if self._terminal:
            self._out.write('\n')
