# SPDX-License-Identifier: BSD-3-Clause
"""Binary messages to the page, as docs/understand/console_protocol.md lays them out."""
import struct

import numpy as np

GRID, CHANGE, SCAN, PATH, CANDIDATES = 1, 2, 3, 4, 5
MAP, COSTMAP = 0, 1
PLAN, WINDOW, LOCAL_PLAN, PREDICTED = 0, 1, 2, 3
NONE = 0xffffffff
POINTS = 8  # of a candidate


def runs(cells):
    """Pairs of a value and a LEB128 length, of an array of bytes."""
    if not len(cells):
        return b''
    starts = np.concatenate([[0], np.flatnonzero(cells[1:] != cells[:-1]) + 1])
    lengths = np.diff(np.append(starts, len(cells))).astype(np.uint64)
    columns, used = [cells[starts]], [np.ones(len(starts), bool)]
    while lengths.any():
        more = lengths > 127
        columns.append((lengths & np.uint64(127)).astype(np.uint8) | (more.astype(np.uint8) << 7))
        used.append(lengths > 0)
        lengths = lengths >> np.uint64(7)
    return np.stack(columns, 1)[np.stack(used, 1)].tobytes()


def shifted(cells, dx, dy):
    """cells[j + dy, i + dx] at (j, i), 255 where there is none; cells: rows of bytes."""
    height, width = cells.shape
    moved = np.full_like(cells, 255)
    if abs(dx) < width and abs(dy) < height:
        moved[max(0, -dy):height - max(0, dy), max(0, -dx):width - max(0, dx)] = \
            cells[max(0, dy):height - max(0, -dy), max(0, dx):width - max(0, -dx)]
    return moved


def whole_grid(which, version, cells, resolution, pose):
    """A grid; cells: rows of bytes, pose: x, y, yaw of the corner of cell 0 in the map."""
    height, width = cells.shape
    return struct.pack('<B3xB3xIIIf3d', GRID, which, version, width, height, resolution, *pose) + runs(cells.ravel())


def grid_change(which, version, cells, base, before, shift, pose):
    """The same as a difference to the cells `before`, which the page has as version `base`; shift: dx, dy in cells."""
    difference = (cells - shifted(before, *shift)).ravel()  # bytes: modulo 256
    return struct.pack('<B3xB3xIIii3d', CHANGE, which, version, base, *shift, *pose) + runs(difference)


def scan(pose, angle_min, angle_increment, ranges, range_min, range_max):
    """Ranges [m]; those that meet nothing, or are none, are 0."""
    with np.errstate(invalid='ignore'):
        good = np.isfinite(ranges) & (ranges >= range_min) & (ranges < range_max) & (ranges < 65.0)
    millimetres = np.where(good, np.round(np.where(good, ranges, 0.0) * 1000.0), 0).astype('<u2')
    return struct.pack('<B3x3dffI', SCAN, *pose, angle_min, angle_increment, len(ranges)) + millimetres.tobytes()


def path(which, rows):
    """rows: x, y, t."""
    return struct.pack('<B3xB3xI', PATH, which, len(rows)) + np.asarray(rows, '<f4').tobytes()


def candidates(pose, found, best):
    """found: wire.Candidate, in the frame of `pose`; best: an index or None."""
    x, y, yaw = pose
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    head = struct.pack('<B3x3dIII', CANDIDATES, x, y, yaw, len(found), POINTS, NONE if best is None else best)
    record = np.zeros(len(found), np.dtype([('total', '<f4'), ('v', '<f4'), ('omega', '<f4'), ('points', '<i2', (POINTS, 2))]))
    for i, candidate in enumerate(found):
        record[i]['total'], record[i]['v'], record[i]['omega'] = candidate.total, candidate.v, candidate.omega
        if len(candidate.poses):
            chosen = candidate.poses[np.linspace(0, len(candidate.poses) - 1, POINTS).round().astype(int), :2]
            record[i]['points'] = np.clip(np.round(1000.0 * (chosen - (x, y)) @ turn), -32767, 32767)
    return head + record.tobytes()
