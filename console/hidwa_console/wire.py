# SPDX-License-Identifier: BSD-3-Clause
"""ROS messages as roscpp and rospy serialise them, read straight into arrays: rospy makes Python objects of every pose and
cell, which takes most of a core at 20 Hz. Each function has its slow twin in the generated message classes."""
import collections
import struct

import numpy as np

Header = collections.namedtuple('Header', 'stamp frame')  # [s]
Grid = collections.namedtuple('Grid', 'header resolution width height origin cells')  # origin: x, y, yaw of cell 0's corner
GridUpdate = collections.namedtuple('GridUpdate', 'header x y width height cells')
Scan = collections.namedtuple('Scan', 'header angle_min angle_increment range_min range_max ranges')
Candidate = collections.namedtuple('Candidate', 'total v omega poses')  # poses: an array of x, y, theta
UNIT_POSE = struct.Struct('<7d')
WIDEST = 1 << 26  # cells of the largest grid that is taken


class Broken(Exception):
    """Bytes that are no message of that kind."""


class _Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def get(self, form):
        try:
            values = struct.unpack_from('<' + form, self.data, self.at)
        except struct.error as fault:
            raise Broken(str(fault)) from fault
        self.at += struct.calcsize('<' + form)
        return values

    def text(self):
        (length,) = self.get('I')
        self.at += length
        if self.at > len(self.data):
            raise Broken('a text is longer than the message')
        return self.data[self.at - length:self.at].decode('utf-8', 'replace')

    def array(self, kind, count):
        size = count * np.dtype(kind).itemsize
        if self.at + size > len(self.data):
            raise Broken('an array is longer than the message')
        values = np.frombuffer(self.data, kind, count, self.at)
        self.at += size
        return values

    def header(self):
        _, seconds, nanoseconds = self.get('III')
        return Header(seconds + 1e-9 * nanoseconds, self.text())


def yaw_of(x, y, z, w):
    """Yaw of a quaternion, or of arrays of them."""
    return np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def path(data):
    """nav_msgs/Path as (Header, array of rows x, y, yaw, stamp)."""
    reader = _Reader(data)
    header = reader.header()
    (count,) = reader.get('I')
    if not count:
        return header, np.empty((0, 4))
    (length,) = struct.unpack_from('<I', data, reader.at + 12) if len(data) >= reader.at + 16 else (0,)
    size = 16 + length + UNIT_POSE.size
    if len(data) - reader.at == count * size:  # all poses name frames of one length
        names = ['sec', 'nsec', 'length', 'x', 'y', 'qx', 'qy', 'qz', 'qw']
        pose = 16 + length
        record = np.dtype({'names': names, 'formats': ['<u4'] * 3 + ['<f8'] * 6,
                           'offsets': [4, 8, 12, pose, pose + 8, pose + 24, pose + 32, pose + 40, pose + 48], 'itemsize': size})
        r = reader.array(record, count)
        if (r['length'] == length).all():
            return header, np.column_stack([r['x'], r['y'], yaw_of(r['qx'], r['qy'], r['qz'], r['qw']), r['sec'] + 1e-9 * r['nsec']])
    rows = []
    for _ in range(count):
        stamp = reader.header().stamp
        x, y, _, *q = reader.get('7d')
        rows.append((x, y, yaw_of(*q), stamp))
    return header, np.array(rows)


def grid(data):
    """nav_msgs/OccupancyGrid as a Grid; cells are bytes, 255 unknown."""
    reader = _Reader(data)
    header = reader.header()
    _, _, resolution, width, height = reader.get('IIfII')
    x, y, _, *q = reader.get('7d')
    (count,) = reader.get('I')
    if count != width * height or count > WIDEST or not resolution > 0.0:
        raise Broken(f'a grid of {width} x {height} cells of {resolution} m with {count} values')
    return Grid(header, resolution, width, height, (x, y, float(yaw_of(*q))), reader.array(np.uint8, count))


def grid_update(data):
    """map_msgs/OccupancyGridUpdate as a GridUpdate."""
    reader = _Reader(data)
    header = reader.header()
    x, y, width, height, count = reader.get('iiIII')
    if count != width * height:
        raise Broken(f'a change of {width} x {height} cells with {count} values')
    return GridUpdate(header, x, y, width, height, reader.array(np.uint8, count))


def scan(data):
    """sensor_msgs/LaserScan as a Scan."""
    reader = _Reader(data)
    header = reader.header()
    angle_min, _, increment, _, _, range_min, range_max, count = reader.get('7fI')
    return Scan(header, angle_min, increment, range_min, range_max, reader.array('<f4', count))


def compressed_image(data):
    """sensor_msgs/CompressedImage as (Header, format, bytes)."""
    reader = _Reader(data)
    header, form = reader.header(), reader.text()
    (count,) = reader.get('I')
    return header, form, reader.array(np.uint8, count).tobytes()


def evaluation(data, every=1):
    """hidwa_local_planner/Evaluation as (Header, [Candidate], index of the best or None); of the candidates each `every`-th and
    the best."""
    reader = _Reader(data)
    header = reader.header()
    (count,) = reader.get('I')
    (best, _) = struct.unpack_from('<II', data, len(data) - 8) if len(data) >= 8 else (0, 0)
    kept, chosen = [], None
    for i in range(count):
        if i == best:
            chosen = len(kept)
        wanted = i == best or i % every == 0
        candidate = _candidate(reader, wanted)
        if wanted:
            kept.append(candidate)
    return header, kept, chosen


def _candidate(reader, wanted):
    v, _, _, _, _, omega, poses = reader.get('6dI')
    values = reader.array('<f8', 3 * poses)
    (times,) = reader.get('I')
    reader.at += 8 * times
    (scores,) = reader.get('I')
    for _ in range(scores):
        (length,) = reader.get('I')
        reader.at += length + 16
    (total,) = reader.get('d')
    for _ in range(2):
        (length,) = reader.get('I')
        reader.at += length
    return Candidate(total, v, omega, values.reshape(-1, 3)) if wanted else None
