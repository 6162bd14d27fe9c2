# SPDX-License-Identifier: BSD-3-Clause
import json
import os
import tempfile
import unittest

from hidwa_tools.counting import Counts, count_ctest, count_xml, ctest_outcomes

GTEST = '''<?xml version="1.0"?>
<testsuites tests="4" failures="1" disabled="1" errors="0">
  <testsuite name="A">
    <testcase name="a" status="run" result="completed"/>
    <testcase name="b" status="run" result="completed"><failure message="x"/></testcase>
    <testcase name="c" status="run" result="skipped"><skipped message="no data"/></testcase>
    <testcase name="d" status="notrun" result="suppressed"/>
  </testsuite>
</testsuites>'''
ONE = '<testsuite tests="1" failures="0" errors="0"><testcase name="a" classname="A" time="1.0"/></testsuite>'

CTEST = '''Test project /somewhere
    Start 1: one
1/6 Test #1: one ..............................   Passed    0.01 sec
    Start 2: two
2/6 Test #2: two ..............................***Failed    0.02 sec
some output of the test: 100% sure
    Start 3: three
3/6 Test #3: three ............................***Timeout  60.03 sec
    Start 4: four
4/6 Test #4: four .............................***Skipped   0.00 sec
    Start 5: five
5/6 Test #5: five .............................***Not Run   0.00 sec
    Start 6: six
6/6 Test #6: six ..............................Subprocess aborted***Exception:   0.10 sec
'''


class Counting(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, 'w', encoding='utf-8') as out:
            out.write(text)
        return path

    def listing(self, **commands):
        return json.dumps({'tests': [{'name': name, 'command': command} for name, command in commands.items()]})

    def test_result_file(self):
        self.assertEqual(count_xml(self.file('a.xml', GTEST)), Counts(1, 1, 2))
        self.assertEqual(count_xml(self.file('b.xml', ONE)), Counts(1, 0, 0))
        self.assertIsNone(count_xml(self.file('c.xml', GTEST[:200])))
        self.assertIsNone(count_xml(os.path.join(self.folder.name, 'absent.xml')))

    def test_ctest_words(self):
        self.assertEqual(ctest_outcomes(CTEST), {'one': 'passed', 'two': 'failed', 'three': 'failed', 'four': 'skipped',
                                                 'five': 'failed', 'six': 'failed'})

    def test_ctest_counts_cases_where_there_are_files(self):
        one = self.file('one.xml', GTEST)
        listing = self.listing(one=['one', f'--gtest_output=xml:{one}'], two=['two'], three=['python3', 'run_tests.py', one])
        # one: 1 passed, 1 failed, 2 skipped; two: 1 failed; three ran out of time but its file holds a failure already
        self.assertEqual(count_ctest(CTEST, listing, 0.0), Counts(1, 1, 2) + Counts(0, 1, 0) + Counts(1, 1, 2))

    def test_a_crash_after_the_last_case_is_a_failure(self):
        file = self.file('six.xml', ONE)
        self.assertEqual(count_ctest(CTEST, self.listing(six=['six', file]), 0.0), Counts(1, 1, 0))

    def test_old_files_do_not_count(self):
        file = self.file('two.xml', ONE)
        os.utime(file, (1000.0, 1000.0))
        self.assertEqual(count_ctest(CTEST, self.listing(two=['two', file]), 2000.0), Counts(0, 1, 0))

    def test_what_did_not_run_has_failed(self):
        self.assertEqual(count_ctest('', self.listing(seven=['seven']), 0.0), Counts(0, 1, 0))
        self.assertEqual(count_ctest('No tests were found!!!', self.listing(), 0.0), Counts(0, 1, 0))

    def test_the_line_it_closes_with(self):
        self.assertEqual(str(Counts(12, 1, 3)), '12 passed, 1 failed, 3 skipped')

    def test_that_line_is_read(self):
        self.assertEqual(Counts.read('99 passed, 0 failed, 0 skipped\nand on\n12 passed, 1 failed, 3 skipped\n'), Counts(12, 1, 3))
        self.assertIsNone(Counts.read('12 passed, 1 failed, 3 skipped\nTraceback'))
        self.assertIsNone(Counts.read(''))


if __name__ == '__main__':
    unittest.main()
