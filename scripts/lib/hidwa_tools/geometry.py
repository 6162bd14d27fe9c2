# SPDX-License-Identifier: BSD-3-Clause
"""Plane geometry of a drive: polygons, occupied cells, paths. Metres and radians; arrays of points are (n, 2).

Written apart from both the planner's and the simulator's checks, so that each can be held against the others.
"""
import numpy as np


def yaw_of(q):
    """Yaw [rad] of a quaternion."""
    return np.arctan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))


def axes_of(q):
    """The rotation matrix (3, 3) of a quaternion: its columns are the frame's axes."""
    x, y, z, w = np.array([q.x, q.y, q.z, q.w]) / np.sqrt(q.x ** 2 + q.y ** 2 + q.z ** 2 + q.w ** 2)
    return np.array([[1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                     [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
                     [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)]])


def turn_of(rotation):
    """1 where a laser's angles grow counter-clockwise as seen from above, -1 where it hangs upside down."""
    return -1.0 if axes_of(rotation)[2, 2] < 0.0 else 1.0


def scan_hits(scan, translation, rotation):
    """Where the beams of a sensor_msgs/LaserScan met something, seen from above: (n, 2) in the frame in which the laser has that
    translation and rotation. It may hang upside down or be tilted."""
    ranges = np.asarray(scan.ranges, float)
    with np.errstate(invalid='ignore'):
        hit = np.isfinite(ranges) & (ranges >= scan.range_min) & (ranges < scan.range_max) & (ranges > 0.0)
    angles = (scan.angle_min + scan.angle_increment * np.arange(len(ranges)))[hit]
    ends = ranges[hit, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    return ends @ axes_of(rotation)[:2, :2].T + np.array([translation.x, translation.y])


def placed(polygon, x, y, yaw):
    """The polygon (n, 2) of the robot frame at a pose."""
    c, s = np.cos(yaw), np.sin(yaw)
    return polygon @ np.array([[c, s], [-s, c]]) + np.array([x, y])


def contains(polygon, points):
    """Which of the points (m, 2) lie inside the polygon (even-odd rule)."""
    px, py = points[:, 0, None], points[:, 1, None]
    ax, ay = polygon[:, 0], polygon[:, 1]
    bx, by = np.roll(ax, -1), np.roll(ay, -1)
    crosses = (ay > py) != (by > py)
    with np.errstate(divide='ignore', invalid='ignore'):
        x_there = ax + (py - ay) * (bx - ax) / (by - ay)
    return np.count_nonzero(crosses & (px < x_there), axis=1) % 2 == 1


def meets_squares(polygon, centres, size):
    """Which axis-aligned squares (centres (m, 2), side `size`) the polygon overlaps or touches.

    A segment and a square are apart exactly if one of three lines separates them: along x, along y, or along
    the segment. Where no edge meets a square, the square lies wholly inside or wholly outside the polygon.
    """
    if len(centres) == 0:
        return np.zeros(0, bool)
    half = 0.5 * size
    start = polygon[None, :, :] - centres[:, None, :]
    end = np.roll(polygon, -1, axis=0)[None, :, :] - centres[:, None, :]
    along = end - start
    apart = (np.minimum(start, end) > half).any(axis=2) | (np.maximum(start, end) < -half).any(axis=2)
    across = np.abs(along[..., 0] * start[..., 1] - along[..., 1] * start[..., 0])
    apart |= across > half * (np.abs(along[..., 0]) + np.abs(along[..., 1]))
    return ~apart.all(axis=1) | contains(polygon, centres)


def gap_to_squares(polygon, centres, size):
    """Distance [m] between the polygon and the nearest of axis-aligned squares (centres (m, 2), side `size`); 0 where they
    meet, infinite where there are none. Of two shapes apart, a corner of one is nearest to the other."""
    if len(centres) == 0:
        return np.inf
    if meets_squares(polygon, centres, size).any():
        return 0.0
    half = 0.5 * size
    corners = (centres[:, None, :] + half * np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]])).reshape(-1, 2)
    beyond = np.maximum(np.abs(polygon[:, None, :] - centres[None, :, :]) - half, 0.0)
    return min(float(distances(polygon, corners).min()), float(np.hypot(beyond[..., 0], beyond[..., 1]).min()))


def _segments_meet(a, b, c, d):
    """Whether segments a[i]b[i] and c[j]d[j] meet, for every pair (i, j)."""
    def side(p, q, r):
        return (q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0])

    a, b, c, d = a[:, None, :], b[:, None, :], c[None, :, :], d[None, :, :]
    straddle = (side(a, b, c) * side(a, b, d) <= 0) & (side(c, d, a) * side(c, d, b) <= 0)
    boxes = ((np.minimum(a, b) <= np.maximum(c, d)) & (np.minimum(c, d) <= np.maximum(a, b))).all(axis=2)
    return straddle & boxes


def polygons_touch(one, other):
    """Whether two polygons share a point."""
    if _segments_meet(one, np.roll(one, -1, axis=0), other, np.roll(other, -1, axis=0)).any():
        return True
    return bool(contains(one, other[:1])[0] or contains(other, one[:1])[0])


def circle(radius, corners=16):
    """A regular polygon (corners, 2) in the circle of that radius [m] about the origin."""
    angles = np.arange(corners) * 2.0 * np.pi / corners
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def distances(polygon, points):
    """Distance (m,) [m] of each of the points (m, 2) from the polygon's outline."""
    start, along = polygon[None, :, :], (np.roll(polygon, -1, axis=0) - polygon)[None, :, :]
    to = points[:, None, :] - start
    length = np.maximum((along ** 2).sum(axis=2), 1e-18)
    away = to - np.clip((to * along).sum(axis=2) / length, 0.0, 1.0)[..., None] * along
    return np.hypot(away[..., 0], away[..., 1]).min(axis=1)


def path_length(points):
    """Length of a polyline (n, 2) [m]."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum()) if len(points) > 1 else 0.0


class PathOffset:
    """How far to the left of a path a robot is that drives along it."""

    def __init__(self, points, back=2.0, ahead=4.0):
        """points: (n, 2). The nearest place is looked for from `back` behind the last one to `ahead` of it [m], so
        that a path that comes back close to itself is not mistaken for itself."""
        step = np.hypot(*np.diff(points, axis=0).T)
        points = points[np.r_[True, step > 1e-9]]
        if len(points) < 2:
            raise ValueError('a path needs two different points')
        self._start, self._along = points[:-1], np.diff(points, axis=0)
        self._length = np.hypot(self._along[:, 0], self._along[:, 1])
        self._arc = np.r_[0.0, np.cumsum(self._length)]
        self._back, self._ahead = back, ahead

    def of(self, positions):
        """Signed distance (n,) [m] of each position (n, 2), left positive, in the order they were driven."""
        offsets, here = [], 0.0
        for position in positions:
            first = np.searchsorted(self._arc, here - self._back, side='right') - 1
            last = np.searchsorted(self._arc, here + self._ahead, side='left')
            window = slice(max(first, 0), max(min(last, len(self._length)), 1))
            offset, here = self._nearest(position, window)
            offsets.append(offset)
        return np.array(offsets)

    def _nearest(self, position, window):
        start, along, length = self._start[window], self._along[window], self._length[window]
        to = position - start
        share = np.clip((to * along).sum(axis=1) / length**2, 0.0, 1.0)
        away = to - share[:, None] * along
        distance = np.hypot(away[:, 0], away[:, 1])
        i = int(np.argmin(distance))
        left = along[i, 0] * to[i, 1] - along[i, 1] * to[i, 0]
        return float(np.copysign(distance[i], left)), float(self._arc[window.start + i] + share[i] * length[i])
