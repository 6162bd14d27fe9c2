# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from geometry_msgs.msg import Quaternion, Vector3
from sensor_msgs.msg import LaserScan

from hidwa_tools import geometry


def clipped_area(polygon, low, high):
    """Area of a convex polygon inside the box, by clipping it at one side after another: slow and obvious."""
    points = [tuple(p) for p in polygon]
    for axis in (0, 1):
        for limit, sign in ((low[axis], 1.0), (high[axis], -1.0)):
            kept = []
            for a, b in zip(points, points[1:] + points[:1]):
                da, db = sign * (a[axis] - limit), sign * (b[axis] - limit)
                if da >= 0:
                    kept.append(a)
                if da * db < 0:
                    share = da / (da - db)
                    kept.append((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))
            points = kept
    return 0.5 * abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])))


class Squares(unittest.TestCase):
    L_SHAPE = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]], float)

    def test_concave_polygon_leaves_its_bay_free(self):
        centres = np.array([[2.0, 2.0], [2.0, 0.5], [0.5, 2.5], [1.4, 1.4], [3.6, 0.5]])
        # side 1: the second and third lie inside; the fourth reaches from 0.9 to 1.9 and so across the inner corner;
        # the fifth begins at 3.1, right of the polygon's end at 3
        self.assertEqual(list(geometry.meets_squares(self.L_SHAPE, centres, 1.0)), [False, True, True, True, False])

    def test_square_inside_and_around_the_polygon(self):
        triangle = np.array([[0, 0], [10, 0], [0, 10]], float)
        self.assertTrue(geometry.meets_squares(triangle, np.array([[2.0, 2.0]]), 0.1)[0])
        self.assertTrue(geometry.meets_squares(triangle, np.array([[3.0, 3.0]]), 100.0)[0])
        self.assertEqual(len(geometry.meets_squares(triangle, np.zeros((0, 2)), 0.1)), 0)

    def test_equals_clipping_on_random_convex_polygons(self):
        random = np.random.default_rng(7)
        met = 0
        for _ in range(3000):
            angles = np.sort(random.uniform(0, 2 * math.pi, random.integers(3, 9)))
            polygon = np.column_stack([np.cos(angles), np.sin(angles)]) * random.uniform(0.05, 0.5) + random.normal(0, 0.3, 2)
            centre = random.normal(0, 0.3, 2)
            area = clipped_area(polygon, centre - 0.05, centre + 0.05)
            if 0 < area < 1e-12:
                continue
            self.assertEqual(bool(geometry.meets_squares(polygon, centre[None], 0.1)[0]), area > 0)
            met += area > 0
        self.assertGreater(met, 300)


class Polygons(unittest.TestCase):
    SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)

    def test_apart_touching_crossing_and_inside(self):
        self.assertFalse(geometry.polygons_touch(self.SQUARE, self.SQUARE + [1.01, 0]))
        self.assertTrue(geometry.polygons_touch(self.SQUARE, self.SQUARE + [1.0, 0]))
        self.assertTrue(geometry.polygons_touch(self.SQUARE, self.SQUARE + [0.5, 0.5]))
        self.assertTrue(geometry.polygons_touch(self.SQUARE, 0.1 * self.SQUARE + [0.4, 0.4]))
        self.assertTrue(geometry.polygons_touch(0.1 * self.SQUARE + [0.4, 0.4], self.SQUARE))

    def test_edges_on_one_line_but_apart(self):
        self.assertFalse(geometry.polygons_touch(self.SQUARE, self.SQUARE + [5.0, 0.0]))

    def test_placed_turns_left_and_moves(self):
        # (1, 0) turned by a quarter to the left is (0, 1); moved by (2, 3) it is (2, 4)
        np.testing.assert_allclose(geometry.placed(np.array([[1.0, 0.0]]), 2.0, 3.0, math.pi / 2), [[2.0, 4.0]], atol=1e-12)


class Offset(unittest.TestCase):
    def test_left_is_positive(self):
        path = geometry.PathOffset(np.array([[0, 0], [5, 0], [10, 0]], float))
        np.testing.assert_allclose(path.of(np.array([[1.0, 0.3], [2.0, -0.4], [3.0, 0.0]])), [0.3, -0.4, 0.0], atol=1e-12)

    def test_a_path_that_comes_back_is_not_mistaken_for_itself(self):
        # Out along y = 0, back along y = 1: a robot 0.8 m left of the way out stands 0.2 m from the way back.
        path = geometry.PathOffset(np.array([[0, 0], [20, 0], [20, 1], [0, 1]], float))
        drive = np.column_stack([np.arange(0.0, 5.0, 0.1), np.full(50, 0.8)])
        np.testing.assert_allclose(path.of(drive), np.full(50, 0.8), atol=1e-12)

    def test_repeated_points_are_dropped_and_a_point_is_no_path(self):
        path = geometry.PathOffset(np.array([[0, 0], [0, 0], [1, 0]], float))
        self.assertAlmostEqual(path.of(np.array([[0.5, 0.25]]))[0], 0.25)
        with self.assertRaises(ValueError):
            geometry.PathOffset(np.array([[1, 1], [1, 1]], float))

    def test_length(self):
        self.assertAlmostEqual(geometry.path_length(np.array([[0, 0], [3, 4], [3, 5]], float)), 6.0)
        self.assertEqual(geometry.path_length(np.zeros((1, 2))), 0.0)


class Lasers(unittest.TestCase):
    def hits(self, rotation, angle_min=0.0, increment=math.pi / 2, ranges=(1.0, 2.0, math.inf, 0.0, math.nan)):
        scan = LaserScan(angle_min=angle_min, angle_increment=increment, range_min=0.05, range_max=10.0, ranges=ranges)
        return geometry.scan_hits(scan, Vector3(0.5, 0.0, 0.3), Quaternion(*rotation))

    def test_every_mounting(self):
        half = math.sqrt(0.5)
        # Ahead 1 m, and 2 m to the laser's own left; what is no hit is none.
        np.testing.assert_allclose(self.hits((0, 0, 0, 1)), [[1.5, 0.0], [0.5, 2.0]], atol=1e-12)
        np.testing.assert_allclose(self.hits((1, 0, 0, 0)), [[1.5, 0.0], [0.5, -2.0]], atol=1e-12)     # roll of pi: its left is our right
        np.testing.assert_allclose(self.hits((0, 1, 0, 0)), [[-0.5, 0.0], [0.5, 2.0]], atol=1e-12)     # pitch of pi: it looks back
        np.testing.assert_allclose(self.hits((0, 0, half, half)), [[0.5, 1.0], [-1.5, 0.0]], atol=1e-12)  # looks to the left
        # Pitched by 60 degrees: 1 m along the beam is 0.5 m over the floor.
        np.testing.assert_allclose(self.hits((0, math.sin(math.pi / 6), 0, math.cos(math.pi / 6))), [[1.0, 0.0], [0.5, 2.0]], atol=1e-12)
        np.testing.assert_allclose(self.hits((2, 0, 0, 0)), self.hits((1, 0, 0, 0)), atol=1e-12)       # of another length
        self.assertEqual(self.hits((0, 0, 0, 1), ranges=()).shape, (0, 2))

    def test_the_turn_and_the_heading_say_the_same_of_level_lasers(self):
        random = np.random.default_rng(11)
        for _ in range(50):
            yaw, over = random.uniform(-np.pi, np.pi), bool(random.integers(2))
            c, s = math.cos(yaw / 2), math.sin(yaw / 2)
            rotation = Quaternion(*((c, s, 0.0, 0.0) if over else (0.0, 0.0, s, c)))  # about x by pi, then about z
            turn, heading = geometry.turn_of(rotation), geometry.yaw_of(rotation)
            self.assertEqual(turn, -1.0 if over else 1.0)
            angle = heading + turn * 0.7
            np.testing.assert_allclose(self.hits((rotation.x, rotation.y, rotation.z, rotation.w), 0.7, 1.0, (3.0,)),
                                       [[0.5 + 3.0 * math.cos(angle), 3.0 * math.sin(angle)]], atol=1e-9)


if __name__ == '__main__':
    unittest.main()
