# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test: which suites run one after the other, beside others, and side by side."""
import unittest
from unittest import mock

from hidwa_tools import suites
from hidwa_tools.counting import Counts


def suite(name):
    def run():
        """What it does."""
    run.__name__ = name
    return run


class Order(unittest.TestCase):

    def setUp(self):
        self.done, self.failing = [], ()
        self.plain, self.build, self.ros, self.page = suite('plain'), suite('build'), suite('ros'), suite('page')
        self.lint, self.one, self.two = suite('lint'), suite('one'), suite('two')
        for name, value in {'build': self.build, 'ALONE': (self.plain, self.build, self.lint), 'BESIDE': (self.lint,),
                            'PACED': (self.one, self.two), 'run_suite': self.run_suite, 'run_paced': self.run_paced,
                            'start_beside': self.start_beside, 'end_beside': self.end_beside}.items():
            patch = mock.patch.object(suites, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def run_suite(self, one, built):
        self.done.append(one.__name__ if built or one in suites.ALONE else one.__name__ + ' not built')
        failed = one.__name__ in self.failing
        return Counts(passed=0 if failed else 1, failed=1 if failed else 0)

    def run_paced(self, some):
        self.done.append('+'.join(one.__name__ for one in some))
        return Counts(passed=len(some))

    def start_beside(self, some):
        self.done.append('begin ' + '+'.join(one.__name__ for one in some))
        return mock.Mock(), 'path'

    def end_beside(self, started):
        if started is None:
            return Counts()
        self.done.append('end')
        return Counts(passed=1)

    def test_what_reads_runs_beside_what_waits(self):
        counts = suites.run_all([self.plain, self.build, self.ros, self.page, self.lint, self.one, self.two])
        self.assertEqual(self.done, ['plain', 'build', 'begin lint', 'ros', 'page', 'end', 'one+two'])
        self.assertEqual((counts.passed, counts.failed), (7, 0))

    def test_without_paced_ones_it_is_waited_for_at_the_end(self):
        counts = suites.run_all([self.build, self.ros, self.lint])
        self.assertEqual(self.done, ['build', 'begin lint', 'ros', 'end'])
        self.assertEqual(counts.passed, 3)

    def test_alone_each_runs_as_it_is(self):
        suites.run_all([self.lint])
        suites.run_all([self.one])
        self.assertEqual(self.done, ['lint', 'one'])

    def test_where_the_build_fails_nothing_that_needs_it_counts_as_done(self):
        self.failing = ('build',)
        counts = suites.run_all([self.plain, self.build, self.ros, self.lint, self.one, self.two])
        self.assertEqual(self.done, ['plain', 'build', 'ros not built', 'lint', 'one not built', 'two not built'])
        self.assertEqual(counts.failed, 1)


if __name__ == '__main__':
    unittest.main()
