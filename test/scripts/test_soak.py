# SPDX-License-Identifier: BSD-3-Clause
"""What a soak is judged by."""
import math
import os
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(ROOT, 'scripts', 'lib'))
from hidwa_tools.soak_figures import Minute, lateness, lost, quantile, summary, verdict  # noqa: E402


def minute(number, memory=45.0, p99=3.0, lost_cycles=0, load=0.5, faults=()):
    return Minute(minute=number, memory=memory, cycles=1200, p99=p99, late=0, lost=lost_cycles, goals=1, disturbances=6, abrupt=0,
                  contacts=0, load=load, faults=list(faults))


def minutes(count, **series):
    return [minute(i + 1, **{name: values[i] for name, values in series.items()}) for i in range(count)]


class Figures(unittest.TestCase):
    def test_quantiles(self):
        self.assertEqual(quantile(range(100), 0.99), 99)
        self.assertEqual(quantile([3.0, 1.0, 2.0], 0.5), 2.0)
        self.assertTrue(math.isnan(quantile([], 0.5)))

    def test_late_cycles(self):
        # Gaps of 0.05, 0.10 (late), 0.5 (the host's pause), -5 (the clock), 0.05 s.
        self.assertEqual(lateness([1.0, 1.05, 1.15, 1.65, -3.35, -3.30], 0.05, 0.3), 1)

    def test_lost_cycles(self):
        self.assertEqual(lost([4, 5, 6, 9, 10]), 2)
        self.assertEqual(lost([]), 0)


class Verdict(unittest.TestCase):
    def test_flat_is_well(self):
        self.assertEqual(verdict(minutes(10)), [])
        self.assertEqual(summary(minutes(10))['cycles'], 12000)

    def test_a_minute_without_a_cycle_is_found(self):
        asleep = [*minutes(3), minute(4)._replace(cycles=0)]
        self.assertEqual(verdict(asleep), ['minute 4: the planner was not called once'])

    def test_the_first_minute_may_grow(self):
        self.assertEqual(verdict(minutes(10, memory=[20.0] + 9 * [45.0])), [])

    def test_a_leak(self):
        leak = verdict(minutes(10, memory=[45.0 + i for i in range(10)]))  # from 50 to 54 MB
        self.assertEqual(leak, ['the host grew by 4.0 MB in the second half (2 MB is allowed)'])

    def test_a_step_is_no_leak_but_it_has_its_limit(self):
        self.assertEqual(verdict(minutes(10, memory=3 * [45.0] + 7 * [60.0])), [])
        self.assertEqual(verdict(minutes(10, memory=3 * [45.0] + 7 * [62.0])),
                         ['the host grew by 17.0 MB after its first minute (16 MB is allowed)'])

    def test_cycles_that_get_slower(self):
        slow = verdict(minutes(10, p99=[3.0] * 5 + [6.0] * 5))
        self.assertEqual(slow, ['p99 of the cycle time rose from 3.0 to 6.0 ms'])
        self.assertEqual(verdict(minutes(10, p99=[3.0] * 5 + [4.9] * 5)), [])  # within 2 ms

    def test_times_of_a_busy_machine_are_not_judged(self):
        self.assertEqual(verdict(minutes(10, p99=[3.0] * 5 + [60.0] * 5, load=[0.5] * 5 + [4.0] * 5)), [])

    def test_commands_beyond_the_limits(self):
        self.assertEqual(verdict([minute(1, faults=['v 0.7'])]), ['minute 1: v 0.7'])

    def test_lost_ones(self):
        self.assertEqual(verdict([minute(1, lost_cycles=2)]), ['2 cycles of which nobody heard'])


if __name__ == '__main__':
    unittest.main()
