# SPDX-License-Identifier: BSD-3-Clause
"""The table of scripts/platforms, from rows made up for the purpose."""
import os
import tempfile
import unittest

from hidwa_tools.platforms import ERROR, WARNING, complaints, faults, first_number, table

WELL = {'compiler': 'GCC 12.2.0', 'CMake': '3.25.1', 'Python': '3.11.2', 'urdfdom': '3.1.1', 'roscpp': '1.15.15',
        'warnings': [], 'errors': [], 'passed': 1200, 'failed': 0, 'failed_tests': [],
        'demo': {'arrived': True, 'path_length_m': 54.26, 'contacts': 0}}


class Platforms(unittest.TestCase):
    def test_a_row_without_a_fault(self):
        text, well = table({'debian12': (WELL, '31')}, 'abc1234', '2026-11-28')
        self.assertTrue(well)
        first, _, heads, rule, row = text.splitlines()
        self.assertEqual(first, '2026-11-28, abc1234:')
        self.assertEqual(row, '| debian12 | GCC 12.2.0 | 3.25.1 | 3.11.2 | 3.1.1 | 1.15.15 | 0 | 1200 | 0 | 54.3 m, contacts: 0 | 31 |')
        self.assertEqual({line.count('|') for line in (heads, rule, row)}, {12})  # eleven columns

    def test_each_fault_of_a_supported_system_counts_and_is_told(self):
        driven = WELL['demo']
        for change, told in (({'warnings': ['a.cpp:1: warning: b']}, 'warning: `a.cpp:1: warning: b`'),
                             ({'errors': ['a.cpp:1: error: b']}, 'error: `a.cpp:1: error: b`'),
                             ({'failed': 1, 'failed_tests': ['one_test']}, 'failed test: `one_test`'),
                             ({'failed': 1}, '1200 tests passed, 1 failed'),
                             ({'passed': 0}, '0 tests passed, 0 failed'),
                             ({'demo': None}, 'the demo left no report'),
                             ({'demo': {**driven, 'arrived': False}}, 'the demo did not arrive without a contact'),
                             ({'demo': {**driven, 'contacts': 1}}, 'the demo did not arrive without a contact'),
                             ({'demo': {**driven, 'contacts': None}}, 'the demo did not arrive without a contact')):
            with self.subTest(change):
                self.assertEqual(faults({**WELL, **change}), [told])
                text, well = table({'debian13': ({**WELL, **change}, '31'), 'debian12': (WELL, '30')}, 'abc1234', '2026-11-28')
                self.assertFalse(well)
                self.assertTrue(text.endswith(f'\n\n- debian13: {told}'), text)

    def test_a_system_that_is_only_tried_does_not_count_and_is_told(self):
        text, well = table({'debian-next': ({**WELL, 'demo': None}, '9'), 'debian12': (WELL, '31')}, 'abc1234', '2026-11-28')
        self.assertTrue(well)
        self.assertIn('- debian-next: the demo left no report', text)

    def test_a_system_without_a_row_has_failed(self):
        text, well = table({'debian11': (None, '2')}, 'abc1234', '2026-11-28')
        self.assertFalse(well)
        self.assertIn('| debian11 | – | – | – | – | – | – | – | – | – | 2 |', text)
        self.assertIn('- debian11: it did not come to its end', text)

    def test_of_many_faults_few_are_told(self):
        told = faults({**WELL, 'warnings': [f'{i}.cpp: warning: w' for i in range(7)]})
        self.assertEqual(told[0], 'warning: `0.cpp: warning: w`')
        self.assertEqual((len(told), told[-1]), (6, '2 more warnings'))  # five, and how many are left

    def test_a_complaint_of_two_builds_counts_once(self):
        log = ('cc -Wall a.cpp -o warning:\n/a/a.cpp:3:5: warning: it may dangle [-Wx]\n/a/b.cpp:1:1: error: no\n'
               'CMake Error at CMakeLists.txt:7 (find_package):\n  Could not find b.\n\n[ 10%] Building error.cpp\n')
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ('first.log', 'second.log')]
            for path in paths:
                with open(path, 'w', encoding='utf-8') as out:
                    out.write(log)
            self.assertEqual(complaints(paths, WARNING), ['/a/a.cpp:3:5: warning: it may dangle [-Wx]'])
            self.assertEqual(complaints(paths, ERROR), ['/a/b.cpp:1:1: error: no',
                                                        'CMake Error at CMakeLists.txt:7 (find_package): Could not find b.'])

    def test_version_numbers(self):
        for text, number in (('cmake version 3.25.1\n', '3.25.1'), ('1:1.0.4+ds-3', '1.0.4'), ('16.1', '16.1'), ('no packages', '?')):
            self.assertEqual(first_number(text), number)


if __name__ == '__main__':
    unittest.main()
