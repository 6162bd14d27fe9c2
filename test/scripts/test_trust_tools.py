# SPDX-License-Identifier: BSD-3-Clause
"""The tools that judge the tests: deliberate faults, coverage, fuzzing."""
import os
import re
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(ROOT, 'scripts', 'lib'))

from hidwa_tools import coverage, mutation, mutate, sanitize  # noqa: E402


def faults(line, path='src/core/a.cpp'):
    """What a line can become."""
    return [m.after.strip() for m in mutation.mutants_of_line(path, 1, line)]


class Faults(unittest.TestCase):
    def test_operators_and_constants_are_changed_one_at_a_time(self):
        self.assertEqual(faults('  if (a <= b) {'), ['if (a < b) {', 'if (a > b) {'])
        self.assertEqual(faults('  x = a + 2;'), ['x = a - 2;', 'x = a + 3;'])
        self.assertEqual(faults('  x = 0.5 * y;'), ['x = 0.5 / y;', 'x = 0.75 * y;', 'x = 0.25 * y;'])
        self.assertEqual(faults('  if (!done && ready) return true;'),
                         ['if (!done || ready) return true;', 'if (done && ready) return true;', 'if (!done && ready) return false;'])
        self.assertEqual(faults('  return std::min(a, b);'), ['return std::max(a, b);'])

    def test_templates_texts_and_comments_stay(self):
        self.assertEqual(faults('  std::vector<int> a;  // a < b + 1'), [])
        self.assertEqual(faults('  say("1 + 1 <= 3");'), [])
        self.assertEqual(faults('#include <vector>'), [])
        self.assertEqual(faults('// a < b'), [])
        self.assertEqual(faults('  double width_ = 0.0;'), [])
        self.assertEqual(faults('  values.reserve(count + 1);'), [])

    def test_the_seed_alone_decides_the_order(self):
        some = [m for line in ('x = a + 2;', 'x = a - 3;', 'x = a * 4;') for m in mutation.mutants_of_line('src/core/a.cpp', 1, line)]
        self.assertEqual(mutation.shuffled(some, 1), mutation.shuffled(list(reversed(some)), 1))
        self.assertNotEqual(mutation.shuffled(some, 1), mutation.shuffled(some, 2))

    def test_every_fault_that_is_left_out_exists_and_has_a_reason(self):
        keys = {m.key() for path in mutation.sources(ROOT, mutate.FOLDERS) for m in mutation.mutants_of_file(ROOT, path)}
        for key, reason in mutation.read_equivalents(mutate.EQUIVALENT).items():
            self.assertTrue(key in keys, f'test/mutation/equivalent.txt names a fault that is none of the sources any more: {key}')
            self.assertGreater(len(reason), 10, key)

    def test_a_fault_without_a_reason_is_refused(self):
        with tempfile.NamedTemporaryFile('w', suffix='.txt') as file:
            file.write('src/a.cpp: a -> b\n    a reason\nsrc/a.cpp: c -> d\n')
            file.flush()
            with self.assertRaisesRegex(ValueError, 'no reason is given for src/a.cpp: c -> d'):
                mutation.read_equivalents(file.name)


class SlowCases(unittest.TestCase):
    REPORT = '''<testsuites>
        <testsuite name="Way"><testcase name="Long" time="3.5" classname="Way"/><testcase name="Brief" time="0.1"
        classname="Way"/></testsuite>
        <testsuite name="All/Way"><testcase name="Long/1" time="9" classname="All/Way"/></testsuite></testsuites>'''

    def test_they_are_named_as_the_program_names_them(self):
        with tempfile.NamedTemporaryFile('w', suffix='.xml') as file:
            file.write(self.REPORT)
            file.flush()
            self.assertEqual(mutate.slow_cases(['program', '--gtest_output=xml:' + file.name]), {'Way.Long': 3.5, 'All/Way.Long/1': 9.0})

    def test_a_program_that_writes_no_report_has_none(self):
        self.assertEqual(mutate.slow_cases(['/usr/bin/python3', 'test.py']), {})


def row(name, lines, lines_run, branches=10, branches_run=10):
    return {'filename': name, 'line_total': str(lines), 'line_covered': str(lines_run), 'branch_total': str(branches),
            'branch_covered': str(branches_run)}


class Findings(unittest.TestCase):
    """What sanitized programs of a rostest leave in files."""

    def read(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                with open(os.path.join(folder, name), 'w', encoding='utf-8') as file:
                    file.write(text)
            return sanitize.findings(folder)

    def test_each_is_a_line(self):
        race = 'WARNING: ThreadSanitizer: data race (pid=1)\n  #0 f\nSUMMARY: ThreadSanitizer: data race a.cpp:3 in f\n'
        undefined = 'a.cpp:7:3: runtime error: division by zero\n    #0 g\n'
        self.assertEqual(self.read(tsan_1=race + race, ubsa_2=undefined),
                         ['tsan_1: ThreadSanitizer: data race a.cpp:3 in f'] * 2 + ['ubsa_2: a.cpp:7:3: runtime error: division by zero'])

    def test_what_is_not_understood_counts_too_and_nothing_does_not(self):
        self.assertEqual(self.read(tsan_1='FATAL: something\n', tsan_2='\n'), ['tsan_1: FATAL: something\n'])
        self.assertEqual(self.read(), [])

    def test_programs_are_told_where_to(self):
        told = sanitize.with_ros(sanitize.environment('/root'), '/found')
        for name, file in {'ASAN_OPTIONS': 'asan', 'UBSAN_OPTIONS': 'ubsa', 'TSAN_OPTIONS': 'tsan'}.items():
            self.assertIn(f':log_path=/found/{file}', told[name])
        self.assertEqual(told['LSAN_OPTIONS'], sanitize.environment('/root')['LSAN_OPTIONS'])


class Threads(unittest.TestCase):
    """What the thread sanitizer is not given has no threads."""

    def test_only_these_libraries_start_one(self):
        starts = re.compile(r'\bstd::(jthread|thread|async)\s*[({]|\bstd::(jthread|thread)\s+\w+|<std::thread>|pthread_create')
        found = set()
        for top in ('src', 'lab', os.path.join('include', 'hidwa_local_planner')):
            for folder, _, names in os.walk(os.path.join(ROOT, top)):
                for name in names:
                    with open(os.path.join(folder, name), encoding='utf-8') as text:
                        if starts.search(text.read()):
                            found.add(os.path.relpath(folder, os.path.join(ROOT, top)).split(os.sep)[0])
        self.assertEqual(found, {'study'}, 'THREAD_SUITES of sanitize.py are the tests of these')


class Coverage(unittest.TestCase):
    GOOD = [row('src/core/motion/a.cpp', 60, 60), row('include/hidwa_local_planner/core/a.hpp', 40, 36), row('src/critics/a.cpp', 100, 95),
            row('src/input/a.cpp', 100, 95, 10, 9), row('src/control/a.cpp', 1, 1, 0, 0), row('lab/sim/a.cpp', 1000, 0)]

    def test_headers_count_to_their_part_and_other_folders_do_not(self):
        found = coverage.shares(self.GOOD)
        self.assertEqual(found['core'], coverage.Share(100, 96, 20, 20))
        self.assertEqual(coverage.table(found)[1], [])

    def test_a_part_below_the_bar_is_named(self):
        self.assertEqual(coverage.table(coverage.shares(self.GOOD + [row('src/critics/b.cpp', 1, 0)]))[1], ['critics'])
        self.assertEqual(coverage.table(coverage.shares(self.GOOD + [row('src/input/b.cpp', 0, 0, 10, 8)]))[1], ['input'])
        self.assertEqual(coverage.table(coverage.shares(self.GOOD[:3]))[1], ['input', 'control'])  # nothing was counted


if __name__ == '__main__':
    unittest.main()
