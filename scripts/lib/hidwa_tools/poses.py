# SPDX-License-Identifier: BSD-3-Clause
"""Where the robot was, by what a bag holds of tf and odometry. Rows are time [s] as recorded, x, y [m], yaw, v [m/s] and
omega [rad/s]; frames are named as in tf, without a slash in front."""
import numpy as np
import genpy
import tf2_py
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from std_msgs.msg import Header

from .geometry import yaw_of

TF = 'tf2_msgs/TFMessage'


def clean(frame):
    """A frame as tf2 names it."""
    return frame.lstrip('/')


class Parents:
    """Who is said to be whose parent. A frame has one; with two, tf takes now the one and now the other, and what lies below
    is nowhere."""

    def __init__(self):
        self._topics = {}  # {child: {parent: topic}}

    def add(self, topic, transform):
        parent, child = clean(transform.header.frame_id), clean(transform.child_frame_id)
        if parent and parent != child:
            self._topics.setdefault(child, {}).setdefault(parent, topic)

    def conflict(self, frames, root=None):
        """In words the first frame with several parents among `frames` and what they hang on, up to `root`; '' where each
        has one."""
        waiting, seen = list(frames), {root}
        while waiting:
            frame = waiting.pop(0)
            if frame in seen:
                continue
            seen.add(frame)
            parents = self._topics.get(frame, {})
            if len(parents) > 1:
                return f'frame {frame} has {len(parents)} parents, ' + ' and '.join(
                    f'{parent} (in {topic})' for parent, topic in parents.items())
            waiting += parents
        return ''


class Frames:
    """All transforms of a bag."""

    def __init__(self, messages):
        self._buffer = tf2_py.BufferCore(genpy.Duration(1000000000))
        self._stamps, self._parents, self._said = {}, {}, Parents()
        self._recorded, self._static = [], []  # (time, transform), transforms
        for topic in sorted(t for t, kind in messages.kinds.items() if kind == TF):
            static = topic.endswith('tf_static')
            for time, message in messages.get(topic):
                for transform in message.transforms:
                    self._said.add(topic, transform)
                    self._take(time, transform, static)

    def _take(self, time, recorded, static):
        parent, child = clean(recorded.header.frame_id), clean(recorded.child_frame_id)
        if not parent or parent == child:
            return
        self._parents[child] = parent
        # The bag's classes are made from its own definitions; tf2 wants geometry_msgs' own.
        t, q = recorded.transform.translation, recorded.transform.rotation
        transform = TransformStamped(Header(0, recorded.header.stamp, parent), child,
                                     Transform(Vector3(t.x, t.y, t.z), Quaternion(q.x, q.y, q.z, q.w)))
        if static:
            self._buffer.set_transform_static(transform, 'bag')
            self._static.append(transform)
            return
        self._buffer.set_transform(transform, 'bag')
        stamp = recorded.header.stamp.to_sec()
        first, last = self._stamps.get(child, (stamp, stamp))
        self._stamps[child] = (min(first, stamp), max(last, stamp))
        self._recorded.append((time, transform))

    def __contains__(self, frame):
        return frame in self._parents or frame in self._parents.values()

    def chain(self, frame):
        """The frame and its ancestors."""
        result = [frame]
        while result[-1] in self._parents and self._parents[result[-1]] not in result:
            result.append(self._parents[result[-1]])
        return result

    def connected(self, one, other):
        """Whether a way of transforms leads from one frame to the other."""
        return one == other or (one in self and other in self and self.chain(one)[-1] == self.chain(other)[-1])

    def conflict(self, frame):
        """See Parents.conflict, of the frame and what it hangs on."""
        return self._said.conflict([frame])

    def moving(self, frame):
        """The first link from the frame upwards that is not static, as its child's name, or None."""
        return next((name for name in self.chain(frame) if name in self._stamps), None)

    def pose(self, target, source, stamp):
        """(x, y, yaw) of the source frame in the target frame at a stamp [s], or None."""
        found = self.transform(target, source, stamp)
        return _planar(found) if found else None

    def transform(self, target, source, stamp):
        """The geometry_msgs/Transform of the same, or None. Links are held where they end before or begin after the stamp."""
        links = [self._stamps[name] for frame in (source, target) for name in self.chain(frame) if name in self._stamps]
        for at in [stamp] + ([min(max(stamp, max(a for a, _ in links)), min(b for _, b in links))] if links else []):
            try:
                return self._buffer.lookup_transform_core(target, source, genpy.Time.from_sec(max(at, 0.0))).transform
            except tf2_py.TransformException:
                continue
        return None

    def drive(self, fixed, odometry, base):
        """Rows (n, 4) of time, x, y, yaw of the base in the fixed frame, at each movement of the base in the odometry's
        frame; what is above that is held until it is said anew."""
        # Replayed, and asked for the newest each time: to look up old ones would take a walk through all later ones.
        buffer, link, inner, outer = tf2_py.BufferCore(genpy.Duration(10)), self.moving(base), [], []
        for transform in self._static:
            buffer.set_transform_static(transform, 'bag')
        for time, transform in self._recorded:
            buffer.set_transform(transform, 'bag')
            if transform.child_frame_id != link:
                continue
            try:
                pose = _planar(buffer.lookup_transform_core(odometry, base, genpy.Time()).transform)
            except tf2_py.TransformException:
                continue
            inner.append((time, pose))
            try:
                outer.append(_planar(buffer.lookup_transform_core(fixed, odometry, genpy.Time()).transform))
            except tf2_py.TransformException:
                outer.append(outer[-1] if outer else None)
        first = next((pose for pose in outer if pose), None)
        rows = [(time, *composed(above or first, pose)) for (time, pose), above in zip(inner, outer) if first]
        return np.array(rows, float).reshape(-1, 4)


def _planar(transform):
    """(x, y, yaw)"""
    return transform.translation.x, transform.translation.y, float(yaw_of(transform.rotation))


def composed(outer, inner):
    """The pose `inner`, given in the frame at `outer`, in that one's frame."""
    c, s = np.cos(outer[2]), np.sin(outer[2])
    return outer[0] + c * inner[0] - s * inner[1], outer[1] + s * inner[0] + c * inner[1], outer[2] + inner[2]


def odometry_rows(messages, topic, by_stamp=False):
    """Rows (n, 6) of a nav_msgs/Odometry topic, by when they were recorded or by their stamps."""
    rows = []
    for time, message in messages.get(topic):
        pose, twist = message.pose.pose, message.twist.twist
        rows.append((message.header.stamp.to_sec() if by_stamp else time, pose.position.x, pose.position.y,
                     yaw_of(pose.orientation), twist.linear.x, twist.angular.z))
    return np.array(rows, float).reshape(-1, 6)


def with_speed(rows, odometry):
    """Rows (n, 6) of rows (n, 4): with the odometry's speeds, or by differences where there is none."""
    time = rows[:, 0]
    if len(odometry):
        return np.column_stack([rows, *(np.interp(time, odometry[:, 0], odometry[:, i]) for i in (4, 5))])
    rows = rows[np.r_[True, np.diff(time) > 1e-6]] if len(rows) else rows
    if len(rows) < 2:
        return np.column_stack([rows, np.zeros((len(rows), 2))])
    time, yaw = rows[:, 0], np.unwrap(rows[:, 3])
    dx, dy = np.gradient(rows[:, 1], time), np.gradient(rows[:, 2], time)
    return np.column_stack([rows, dx * np.cos(yaw) + dy * np.sin(yaw), np.gradient(yaw, time)])
