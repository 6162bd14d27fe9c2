# SPDX-License-Identifier: BSD-3-Clause
"""The binary messages of /view (docs/understand/console_protocol.md), written in the plainest way. Frame map; [m, rad]."""
import struct

import numpy


def runs(cells):
    """Cells (0..255) as runs of a value and a LEB128 length."""
    result = bytearray()
    cells = numpy.asarray(cells, dtype=numpy.uint8).ravel()
    starts = [0] + (numpy.nonzero(numpy.diff(cells))[0] + 1).tolist() + [cells.size]
    for first, last in zip(starts, starts[1:]):
        result.append(int(cells[first]))
        count = last - first
        while count > 127:
            result.append(128 | (count & 127))
            count >>= 7
        result.append(count)
    return bytes(result)


def grid(which, version, cells, resolution, origin):
    """A whole grid; cells: rows from the corner of cell 0."""
    height, width = cells.shape
    head = struct.pack('<B3xB3xIIIf3d', 1, which, version, width, height, resolution, *origin)
    return head + runs(cells)


def changed_grid(which, version, base, shift, origin, difference):
    """What changed since the version `base`; shift: (dx, dy) in cells; difference: new minus moved old, modulo 256."""
    return struct.pack('<B3xB3xIIii3d', 2, which, version, base, *shift, *origin) + runs(difference)


def scan(pose, first, step, ranges):
    """A scan; ranges in m, 0 where nothing is in range."""
    return struct.pack('<B3x3dffI', 3, *pose, first, step, len(ranges)) + struct.pack(
        '<%dH' % len(ranges), *(int(round(1000 * value)) for value in ranges))


def path(which, points):
    """A path of (x, y, t)."""
    return struct.pack('<B3xB3xI', 4, which, len(points)) + b''.join(struct.pack('<3f', *point) for point in points)


def candidates(pose, best, ways):
    """Candidates: ways of (total, v, omega, [(forward, left), ...]), all with the same number of points."""
    body = b''.join(
        struct.pack('<3f', total, v, omega) + b''.join(struct.pack('<2h', int(1000 * x), int(1000 * y)) for x, y in way)
        for total, v, omega, way in ways)
    return struct.pack('<B3x3dIII', 5, *pose, len(ways), len(ways[0][3]), best) + body
