# SPDX-License-Identifier: BSD-3-Clause
"""test/support/program_test.py: how a program went, as catkin and scripts/test read it."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(ROOT, 'scripts', 'lib'))

from hidwa_tools.counting import Counts, count_xml


class ProgramTest(unittest.TestCase):
    def run_program(self, script):
        """(exit status, Counts of the result file) of a shell script."""
        with tempfile.TemporaryDirectory() as folder:
            results = os.path.join(folder, 'results.xml')
            done = subprocess.run([os.path.join(ROOT, 'test', 'support', 'program_test.py'), results, 'a_test', 'sh', '-c', script],
                                  stdout=subprocess.PIPE, text=True, check=False)
            self.assertIn('it says <why>', done.stdout)
            return done.returncode, count_xml(results)

    def test_its_exit_status_is_the_programs_and_stands_in_the_results(self):
        self.assertEqual(self.run_program('echo "it says <why>"'), (0, Counts(passed=1)))
        self.assertEqual(self.run_program('echo "it says <why>"; exit 3'), (3, Counts(failed=1)))
        self.assertEqual(self.run_program('echo "it says <why>"; exit 77'), (77, Counts(skipped=1)))


if __name__ == '__main__':
    unittest.main()
