# SPDX-License-Identifier: BSD-3-Clause
"""What a robot saw on its way: laser hits and local costmaps of a bag."""
import numpy as np
from geometry_msgs.msg import Quaternion, Transform, Vector3

from . import geometry
from .poses import clean, composed

SCANS_DRAWN = 250   # of a drive
AT_CENTRE = Transform(Vector3(), Quaternion(w=1.0))  # where nothing says how a laser is mounted
LETHAL = 100        # of nav_msgs/OccupancyGrid, as costmap_2d publishes it: an obstacle's own cells


class Seen:
    """Laser and local costmap over time."""

    def __init__(self, messages, scan, costmap, frames, base, frame, truth):
        self._scans, self._costmaps = messages.get(scan), messages.get(costmap)
        self._frames, self._base, self._frame, self._truth = frames, base, frame, truth
        self._mounted = {}

    def _hits(self, scan):
        """Hits (n, 2) of a scan in the robot's frame."""
        frame = clean(scan.header.frame_id)
        if frame not in self._mounted:
            joined = self._base and self._frames.connected(self._base, frame)
            self._mounted[frame] = self._frames.transform(self._base, frame, scan.header.stamp.to_sec()) if joined else None
        mounted = self._mounted[frame] or AT_CENTRE
        return geometry.scan_hits(scan, mounted.translation, mounted.rotation)

    def mounting_unknown(self):
        """Frames of scans that nothing joins to the robot: they are taken to lie at its centre."""
        return sorted(frame for frame, pose in self._mounted.items() if pose is None)

    def clearance(self, outline, begin, end):
        """(smallest distance [m] from the outline to a hit beyond it, scans, hits inside it) between two times; the distance
        is None where there was no hit."""
        nearest, scans, inside = np.inf, 0, 0
        for time, scan in self._scans:
            if begin <= time <= end:
                hits = self._hits(scan)
                scans += 1
                if len(hits):
                    own = geometry.contains(outline, hits)
                    inside += int(own.sum())
                    if not own.all():
                        nearest = min(nearest, float(geometry.distances(outline, hits[~own]).min()))
        return (nearest if np.isfinite(nearest) else None), scans, inside

    def floor(self, begin, end):
        """Points (n, 2) of what was seen between two times, in the frame of the poses: laser hits, else the occupied cells of
        local costmaps."""
        scans = [row for row in self._scans if begin <= row[0] <= end]
        points = [np.zeros((0, 2))]
        for time, scan in scans[::max(1, len(scans) // SCANS_DRAWN)]:
            points.append(geometry.placed(self._hits(scan), *self._pose(time)))
        if not scans:
            maps = [row for row in self._costmaps if begin <= row[0] <= end]
            for _, grid in maps[::max(1, len(maps) // SCANS_DRAWN)]:
                points.append(self._cells(grid))
        return np.vstack(points)

    def _pose(self, time):
        rows = self._truth
        return [np.interp(time, rows[:, 0], values) for values in (rows[:, 1], rows[:, 2], np.unwrap(rows[:, 3]))]

    def _cells(self, grid):
        """Centres of the lethal cells of a local costmap in the frame of the poses; none where nothing joins the frames."""
        frame, info = clean(grid.header.frame_id), grid.info
        joined = frame == self._frame or self._frames.connected(self._frame, frame)
        pose = (0.0, 0.0, 0.0) if frame == self._frame else joined and \
            self._frames.pose(self._frame, frame, grid.header.stamp.to_sec())
        if not pose:
            return np.zeros((0, 2))
        cells = np.argwhere(np.array(grid.data, np.int16).reshape(info.height, info.width) >= LETHAL)[:, ::-1]
        corner = composed(pose, (info.origin.position.x, info.origin.position.y, 0.0))
        return geometry.placed((cells + 0.5) * info.resolution, *corner)
