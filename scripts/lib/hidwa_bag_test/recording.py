# SPDX-License-Identifier: BSD-3-Clause
"""A bag as a bag test plays it and looks at it."""
import os

import genpy
import numpy as np
import rosbag
import roslib.message
import rospy
import tf2_py
from std_msgs.msg import Header

from hidwa_tools.geometry import yaw_of
from hidwa_tools.poses import Parents, clean

from .errors import BagTestError


class Absent(BagTestError):
    """There is no such bag."""


def shift(message, seconds):
    """Adds whole seconds to every stamp in the message that is set. What would lie before 0, a plan or a static
    transform of long ago, gets no stamp: valid at any time."""
    if isinstance(message, Header):
        if not message.stamp.is_zero():
            shifted = message.stamp.secs + seconds
            message.stamp = rospy.Time(shifted, message.stamp.nsecs) if shifted >= 0 else rospy.Time()
        return
    if isinstance(message, (list, tuple)):
        if message and isinstance(message[0], genpy.Message):
            for entry in message:
                shift(entry, seconds)
        return
    for name in getattr(message, '__slots__', ()):
        content = getattr(message, name)
        if isinstance(content, (genpy.Message, list, tuple)):
            shift(content, seconds)


def _message(raw):
    """Of the system's own class, where it has the same; rosbag makes classes of its own."""
    name, data, md5, _, made = raw
    known = roslib.message.get_message_class(name)
    message = (known if known and known._md5sum == md5 else made)()
    message.deserialize(data)
    return message


class Recording:
    """A stretch of a bag.

    events: [(time, topic, message)] in order; what is latched comes first.
    """

    def __init__(self, description):
        d = description
        if not os.path.exists(d.bag):
            raise Absent(f'{d.bag} does not exist: correct bag in {d.path}')
        names = set(d.topics) | {d.odom, d.scan, d.commands, '/tf', d.plan.get('topic')} - {None}
        try:
            with rosbag.Bag(d.bag) as bag:
                begin, end = bag.get_start_time(), bag.get_end_time()
                rows = [(time.to_sec(), topic, _message(raw))
                        for topic, raw, time in bag.read_messages(topics=list(names), raw=True)]
        except (OSError, rosbag.ROSBagException) as fault:
            raise BagTestError(f'{d.bag}: {fault}') from fault
        held = {topic for _, topic, _ in rows}
        needed = {d.odom, d.scan, '/tf', d.plan.get('topic')} | set(d.topics)
        missing = sorted(needed - held - {None, '/tf_static'})
        if missing:
            raise BagTestError(f'{d.bag} holds no {", ".join(missing)}: record them, or name the right topics in {d.path}')
        self.start = begin + d.start
        self.end = min(end, self.start + (d.duration or np.inf))
        if self.end - self.start < 0.5:
            raise BagTestError(f'{d.path}: less than 0.5 s of {d.bag} ({end - begin:.1f} s) is left from start = {d.start:g} '
                               'on: begin earlier')
        self.events = self._stretch(rows)
        self._description = d
        self._require_one_parent()

    def _stretch(self, rows):
        """What lies in the stretch; static transforms and the newest plan of before it at its start."""
        latched, events = {}, []
        for time, topic, message in rows:
            if time > self.end:
                break
            if time >= self.start:
                events.append((time, topic, message))
            elif topic == '/tf_static' or topic.endswith('plan'):
                latched.setdefault(topic, []).append(message)
        early = [(self.start, topic, message) for topic, messages in latched.items()
                 for message in (messages if topic == '/tf_static' else messages[-1:])]
        return early + events

    def _require_one_parent(self):
        """Where a frame that is needed has two, the costmap waits for its transform for ever."""
        d, parents, needed = self._description, Parents(), [self._description.base_frame]
        for _, topic, message in self.events:
            if topic in ('/tf', '/tf_static'):
                for transform in message.transforms:
                    parents.add(topic, transform)
            elif topic in (d.scan, d.plan.get('topic')):
                needed.append(message.header.frame_id)
        conflict = parents.conflict(dict.fromkeys(map(clean, needed)), clean(d.frame))
        if conflict:
            raise BagTestError(f'{d.bag}: {conflict}: play what only one node published; leave /tf_static out of topics in '
                               f'{d.path}, or take the wrong one out of the bag (rosbag filter)')

    def of(self, topic):
        """[(time, message)] of a topic."""
        return [(time, message) for time, name, message in self.events if name == topic]

    def follow(self):
        """A Follower at the start."""
        return Follower(self)


def _velocity(odometry):
    twist = odometry.twist.twist
    return twist.linear.x, twist.angular.z


class Follower:
    """What a robot could know at a time, as that time goes on: its newest pose and the scans so far."""

    def __init__(self, recording):
        self._d, self._events, self._next = recording._description, recording.events, 0
        self._tf = tf2_py.BufferCore(rospy.Duration(1e6))
        self._scans = []      # (time, message), not yet placed
        self.points = np.zeros((0, 2))  # of the newest scan that is known, in the frame [m]
        self.scan_time = None
        # The newest two (v, omega); until there are any, what the player begins with.
        self.measured = [_velocity(message) for _, message in recording.of(self._d.odom)[:1]]

    def advance(self, time):
        while self._next < len(self._events) and self._events[self._next][0] <= time:
            at, topic, message = self._events[self._next]
            self._next += 1
            if topic in ('/tf', '/tf_static'):
                put = self._tf.set_transform_static if topic == '/tf_static' else self._tf.set_transform
                for transform in message.transforms:
                    put(transform, 'bag')
            elif topic == self._d.scan:
                self._scans.append((at, message))
            elif topic == self._d.odom:
                self.measured = self.measured[-1:] + [_velocity(message)]
        self._place(time - self._d.scan_age)

    def pose(self):
        """The newest (x, y, yaw) of the robot, or None."""
        found = self._lookup(self._d.base_frame, rospy.Time(0))
        return found and (found[0], found[1], found[2])

    def _lookup(self, source, stamp):
        try:
            found = self._tf.lookup_transform_core(self._d.frame, source, stamp).transform
        except tf2_py.TransformException:
            return None
        return found.translation.x, found.translation.y, float(yaw_of(found.rotation))

    def _place(self, until):
        """Places the newest scan up to `until` whose transform is there."""
        known = [(at, scan) for at, scan in self._scans if at <= until]
        for at, scan in reversed(known):
            place = self._lookup(scan.header.frame_id, scan.header.stamp)
            if place:
                self.points, self.scan_time = placed_points(scan, place), at
                self._scans = [entry for entry in self._scans if entry[0] > at]
                return


def placed_points(scan, place):
    """Where the beams of a scan end (n, 2), its frame at `place` (x, y, yaw); beams without an echo are left out."""
    ranges = np.array(scan.ranges, float)
    angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    with np.errstate(invalid='ignore'):
        met = np.isfinite(ranges) & (ranges >= scan.range_min) & (ranges < scan.range_max)
    x, y, yaw = place
    return np.column_stack([x + ranges[met] * np.cos(angles[met] + yaw), y + ranges[met] * np.sin(angles[met] + yaw)])
