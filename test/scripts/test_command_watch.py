# SPDX-License-Identifier: BSD-3-Clause
"""The watcher of commands sees what it is to see. Limits: 0.5 m/s, 2.5 m/s^2 faster, 1.0 m/s^2 slower; 20 Hz."""
import math
import os
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(ROOT, 'test', 'support'))
from command_watch import Limits, Step, changes_beyond, values_beyond, zeros_at_once  # noqa: E402

LIMITS = Limits(0.0, 0.5, 2.5, 1.0)
PERIOD = 0.05


def beyond(*steps):
    """How many changes between these (time, velocity[, reference]) are too large."""
    return len(changes_beyond([Step(s[0], s[1], s[2] if len(s) > 2 else 0.0, '') for s in steps], LIMITS, PERIOD))


class Changes(unittest.TestCase):
    def test_within_a_period(self):
        # 2.5 * 0.05 = 0.125 m/s faster, 1.0 * 0.05 = 0.05 m/s slower.
        self.assertEqual(beyond((0.0, 0.1), (0.05, 0.225)), 0)
        self.assertEqual(beyond((0.0, 0.1), (0.05, 0.226)), 1)
        self.assertEqual(beyond((0.0, 0.3), (0.05, 0.25)), 0)
        self.assertEqual(beyond((0.0, 0.3), (0.05, 0.249)), 1)

    def test_an_abrupt_stop(self):
        self.assertEqual(beyond((0.0, 0.5), (0.05, 0.0)), 1)

    def test_to_the_other_side_counts_as_speeding_up(self):
        self.assertEqual(beyond((0.0, 0.05), (0.05, -0.05)), 0)  # 0.1 m/s

    def test_a_late_cycle_may_change_more(self):
        self.assertEqual(beyond((0.0, 0.5), (0.15, 0.35)), 0)  # 1.0 * 0.15
        self.assertEqual(beyond((0.0, 0.5), (0.15, 0.34)), 1)

    def test_an_early_one_a_period(self):
        self.assertEqual(beyond((0.0, 0.1), (0.01, 0.225)), 0)

    def test_after_a_pause_or_a_clock_that_was_set_the_reference_counts_too(self):
        self.assertEqual(beyond((0.0, 0.5), (1.0, 0.125, 0.0)), 0)
        self.assertEqual(beyond((5.0, 0.5), (0.0, 0.125, 0.0)), 0)
        self.assertEqual(beyond((5.0, 0.5), (0.0, 0.2, 0.0)), 1)  # 0.075 m/s beyond 0 + 0.125, 0.3 m/s below 0.5

    def test_without_a_pause_it_does_not(self):
        self.assertEqual(beyond((0.0, 0.5), (0.05, 0.1, 0.0)), 1)


class Zeros(unittest.TestCase):
    def test_out_of_more_than_either_axis_may_brake_by(self):
        rest = (0.0, 0.0)
        self.assertEqual(zeros_at_once([(0.5, 0.0), rest, (0.1, 0.9), rest], (0.15, 0.5)), 2)
        self.assertEqual(zeros_at_once([(0.1, 0.4), rest, rest, (0.5, 0.0), (0.1, 0.0)], (0.15, 0.5)), 0)


class Values(unittest.TestCase):
    def test_limits_and_numbers(self):
        self.assertEqual(values_beyond([0.0, 0.25, 0.5], LIMITS), [])
        self.assertEqual(len(values_beyond([-0.01, 0.51, math.nan, math.inf, -math.inf], LIMITS)), 5)


if __name__ == '__main__':
    unittest.main()
