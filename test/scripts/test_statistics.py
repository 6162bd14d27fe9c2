# SPDX-License-Identifier: BSD-3-Clause
"""The statistics against examples by hand, the paper's own figures, and a slow way."""
import itertools
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir, 'scripts', 'lib'))

from hidwa_tools.statistics import normality, proportion, signed_ranks


class TestSignedRanks(unittest.TestCase):
    def test_by_hand(self):
        # Differences 1, -2, 3, 4, 5: ranks as the sizes; above = 1 + 3 + 4 + 5 = 13 of 15.
        result = signed_ranks([1, 0, 3, 4, 5], [0, 2, 0, 0, 0])
        self.assertEqual((result.pairs, result.changed, result.above), (5, 5, 13.0))
        # Mean 5 * 6 / 4 = 7.5, variance 5 * 6 * 11 / 24 = 13.75: z = 5.5 / 3.7081 = 1.4832; r = z / sqrt(5).
        self.assertAlmostEqual(result.z, 1.4832, 4)
        self.assertAlmostEqual(result.r, 0.6633, 4)
        # Sums of 13 or more: {15}, {14}, {13}: without nothing, 1, 2. 3 of 32, twice that for both sides.
        self.assertAlmostEqual(result.p, 6.0 / 32.0)
        self.assertAlmostEqual(signed_ranks([1, 0, 3, 4, 5], [0, 2, 0, 0, 0], 'greater').p, 3.0 / 32.0)

    def test_ties_and_equal_pairs(self):
        # Differences 1, 1, -1, 0: the zero is left out, all ranks are 2; above = 4, mean 3.
        result = signed_ranks([1, 1, 0, 5], [0, 0, 1, 5])
        self.assertEqual((result.pairs, result.changed, result.above), (4, 3, 4.0))
        # Variance 3 * 4 * 7 / 24 - (27 - 3) / 48 = 3.0.
        self.assertAlmostEqual(result.z, 1.0 / math.sqrt(3.0))
        # Two or three of three positive: (3 + 1) / 8, and both sides are certain.
        self.assertEqual(result.p, 1.0)
        self.assertAlmostEqual(signed_ranks([1, 1, 0, 5], [0, 0, 1, 5], 'greater').p, 0.5)

    def test_nothing_differs(self):
        result = signed_ranks([1, 2], [1, 2])
        self.assertTrue(math.isnan(result.z))
        self.assertEqual((result.p, result.r), (1.0, 0.0))

    def test_against_all_signs(self):
        generator = random.Random(20220731)
        for _ in range(40):
            n = generator.randint(1, 9)
            differences = [generator.choice([-3, -2, -1, 1, 2, 3]) for _ in range(n)]
            sizes = sorted(abs(d) for d in differences)
            rank = {s: sum(i + 1 for i, x in enumerate(sizes) if x == s) / sizes.count(s) for s in sizes}
            own = sum(rank[abs(d)] for d in differences if d > 0)
            sums = [sum(rank[abs(d)] for d, sign in zip(differences, signs) if sign)
                    for signs in itertools.product((0, 1), repeat=n)]
            less = sum(s <= own for s in sums) / len(sums)
            self.assertAlmostEqual(signed_ranks(differences, [0] * n, 'less').p, less)
            more = sum(s >= own for s in sums) / len(sums)
            self.assertAlmostEqual(signed_ranks(differences, [0] * n).p, min(1.0, 2.0 * min(less, more)))

    def test_the_papers_effect_size(self):
        # Z = -2.381 and r = 0.421 of 32 people: 2.381 / sqrt(32) = 0.4209.
        self.assertAlmostEqual(2.381 / math.sqrt(32), 0.421, 3)

    def test_pairs_are_needed(self):
        with self.assertRaisesRegex(ValueError, '2 values against 1'):
            signed_ranks([1, 2], [1])


class TestProportion(unittest.TestCase):
    def test_the_papers_case(self):
        # 22 of 32 found SJ easier: p = 0.0251 one-sided (printed as 0.026), interval 50.0 % to 83.9 %.
        result = proportion(22, 32)
        self.assertAlmostEqual(result.p_one_sided, 0.0251, 4)
        self.assertAlmostEqual(result.p_two_sided, 2.0 * result.p_one_sided)  # symmetric at chance 1/2
        self.assertEqual((round(100.0 * result.low, 1), round(100.0 * result.high, 1)), (50.0, 83.9))

    def test_half(self):
        # 16 of 32 preferred either: p = 1.000 and 31.9 % to 68.1 %, as the paper has it.
        result = proportion(16, 32)
        self.assertEqual(result.p_two_sided, 1.0)
        self.assertEqual((round(100.0 * result.low, 1), round(100.0 * result.high, 1)), (31.9, 68.1))

    def test_by_hand(self):
        # 3 of 3 at 1/2: 1/8, both sides 1/4; the interval's lower end is 0.025^(1/3) = 0.2924.
        result = proportion(3, 3)
        self.assertAlmostEqual(result.p_one_sided, 0.125)
        self.assertAlmostEqual(result.p_two_sided, 0.25)
        self.assertAlmostEqual(result.low, 0.025 ** (1.0 / 3.0))
        self.assertEqual(result.high, 1.0)
        self.assertEqual(proportion(0, 3).low, 0.0)

    def test_no_proportion(self):
        for successes, trials in ((4, 3), (-1, 3), (0, 0)):
            with self.assertRaisesRegex(ValueError, 'no proportion'):
                proportion(successes, trials)


class TestNormality(unittest.TestCase):
    def test_a_skewed_sample_is_none(self):
        w, p = normality([1, 1, 1, 1, 1, 1, 1, 2, 3, 30])
        self.assertLess(w, 0.6)
        self.assertLess(p, 0.001)

    def test_nothing_to_go_by(self):
        self.assertTrue(math.isnan(normality([1.0, 1.0, 1.0])[0]))
        self.assertTrue(math.isnan(normality([1.0, 2.0])[0]))


if __name__ == '__main__':
    unittest.main()
