# SPDX-License-Identifier: BSD-3-Clause
"""Figures about people whose ways are known by construction, and a slow twin."""
import math
import unittest

import numpy as np

from hidwa_tools import people
from hidwa_tools.people import Person, gaps, measure_people

BOX = np.array([[0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]])  # [m]


def way(poses, v=0.0, omega=0.0, step=0.1):
    """A truth of these poses, `step` [s] apart."""
    return np.array([(k * step, *pose, v, omega) for k, pose in enumerate(poses)], float)


def walking(points, radius=0.3, step=0.1):
    return Person(np.array([(k * step, *point) for k, point in enumerate(points)], float), radius)


class People(unittest.TestCase):
    def test_nobody(self):
        self.assertEqual(measure_people([], BOX, way([(0, 0, 0)] * 3)),
                         {'people': 0, 'contacts_moving': 0, 'contacts_at_rest': 0, 'closest_person_m': None, 'personal_space_s': 0.0})

    def test_touches_are_told_apart_and_count_once_each(self):
        # Gaps: x - 0.5 - 0.3.
        comes = walking([(x, 0.0) for x in (1.2, 0.9, 0.75, 0.7, 0.9, 0.75)])
        moving = measure_people([comes], BOX, way([(0, 0, 0)] * 6, v=0.2))
        self.assertEqual((moving['contacts_moving'], moving['contacts_at_rest'], moving['closest_person_m']), (2, 0, 0.0))
        standing = measure_people([comes], BOX, way([(0, 0, 0)] * 6))
        self.assertEqual((standing['contacts_moving'], standing['contacts_at_rest']), (0, 2))
        # The outermost point is 0.707 m away: 0.02 rad/s move it at 14 mm/s.
        turning = measure_people([comes], BOX, way([(0, 0, 0)] * 6, omega=0.02))
        self.assertEqual(turning['contacts_moving'], 2)

    def test_personal_space_counts_only_while_moving(self):
        near = walking([(1.2, 0.0)] * 5)  # 0.4 m
        self.assertEqual(measure_people([near], BOX, way([(0, 0, 0)] * 5, v=0.2))['personal_space_s'], 0.4)
        self.assertEqual(measure_people([near], BOX, way([(0, 0, 0)] * 5))['personal_space_s'], 0.0)
        beyond = walking([(1.31, 0.0)] * 5)
        self.assertEqual(measure_people([beyond], BOX, way([(0, 0, 0)] * 5, v=0.2))['personal_space_s'], 0.0)

    def test_positions_between_messages_lie_on_the_line(self):
        person = Person(np.array([[0.0, 0.0, 0.0], [1.0, 2.0, -4.0]]), 0.3)
        np.testing.assert_allclose(person.at(np.array([0.25])), [[0.5, -1.0]])

    def test_gaps_equal_a_slow_twin(self):
        random = np.random.default_rng(4)
        truth = way(random.uniform(-1.0, 1.0, (50, 3)))
        person = walking(random.uniform(-2.0, 2.0, (50, 2)), 0.25)
        for row, gap in zip(truth, gaps(BOX, truth, person)):
            centre = person.at(row[:1])[0]
            # Of many points of the square the one nearest to the centre.
            side = np.linspace(-0.5, 0.5, 101)
            grid = np.array([(x, y) for x in side for y in side])
            c, s = math.cos(row[3]), math.sin(row[3])
            placed = grid @ np.array([[c, s], [-s, c]]) + row[1:3]
            slow = max(0.0, np.hypot(*(placed - centre).T).min() - 0.25)
            self.assertAlmostEqual(gap, slow, delta=0.008)  # the points are 0.01 m apart

    def test_limits_are_those_of_the_simulator(self):
        self.assertEqual((people.MOVES, people.PERSONAL_SPACE), (0.01, 0.5))


if __name__ == '__main__':
    unittest.main()
