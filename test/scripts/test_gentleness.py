#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How gently autonomy turned, by hand."""
import math
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir, 'scripts', 'lib'))

from hidwa_tools.gentleness import gentleness

AUTONOMY, SHARED = 0, 1


class GentlenessTest(unittest.TestCase):
    def test_only_what_autonomy_sent_counts(self):
        # 20 Hz. Into AUTONOMY: 0.20 -> 0.04, -3.2 rad/s^2; then none; then 0.04 -> 0.06, 0.4 rad/s^2.
        commands = np.array([[0.00, 0.5, 0.0], [0.05, 0.5, 0.2], [0.10, 0.5, 0.04], [0.15, 0.5, 0.04], [0.20, 0.5, 0.06]])
        states = np.array([[0.0, SHARED], [0.09, AUTONOMY]])
        figures = gentleness(commands, states, 3.2)
        self.assertAlmostEqual(figures['acc_rms'], math.sqrt((3.2 ** 2 + 0.4 ** 2) / 3), places=3)
        self.assertAlmostEqual(figures['acc_p99'], 3.2, places=3)  # the third of three
        self.assertEqual(figures['bend_acc_rms'], figures['acc_rms'])  # all of them are bends
        self.assertAlmostEqual(figures['at_limit'], 1 / 3, places=4)
        # From +4 to -3.2, to 0, to 0.4 rad/s^2, each in 0.05 s.
        self.assertAlmostEqual(figures['jerk_rms'], math.sqrt((144.0 ** 2 + 64.0 ** 2 + 8.0 ** 2) / 3), places=2)

    def test_too_little_says_nothing(self):
        figures = gentleness(np.zeros((2, 3)), np.zeros((0, 4)), 3.2)
        self.assertEqual(set(figures.values()), {None})


if __name__ == '__main__':
    unittest.main()
