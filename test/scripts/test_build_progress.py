# SPDX-License-Identifier: BSD-3-Clause
"""The progress that a build shows."""
import unittest

from hidwa_tools.build_progress import Progress

BUILD = ['Starting >>> nav_core', '-- Configuring done', '[ 50%] Building CXX object a.o', '[100%] Built target nav_core',
         'Finished <<< nav_core [2.0s]', 'Starting >>> planner', '[  4%] Building CXX object b.o', '[ 12%] Building CXX object c.o',
         '[ 19%] Building CXX object d.o', '[ 23%] Linking CXX shared library e.so', '-- Installing: /f',
         'Failed   <<< planner [3.0s, exited with code 2]', '', 'Summary: 1 package finished [5s]', '  1 package failed: planner']


class ABuild(unittest.TestCase):
    def shown(self, terminal):
        said = []
        progress = Progress(said.append, terminal)
        for line in BUILD:
            progress.line(line)
        return ''.join(said)

    def test_each_tenth_is_a_line_of_a_log(self):
        self.assertEqual(self.shown(False).splitlines(), [
            'Starting >>> nav_core', '    nav_core: 50 %', '    nav_core: 100 %', 'Finished <<< nav_core [2.0s]',
            'Starting >>> planner', '    planner: 10 %', '    planner: 20 %',
            'Failed   <<< planner [3.0s, exited with code 2]', 'Summary: 1 package finished [5s]', '  1 package failed: planner'])

    def test_catkin_names_its_packages_otherwise(self):
        said = []
        progress = Progress(said.append, False)
        for line in ("==> Processing catkin package: 'nav_core'", '==> make -j2', '[ 50%] Building CXX object a.o'):
            progress.line(line)
        self.assertEqual(''.join(said).splitlines(), ["==> Processing catkin package: 'nav_core'", '    nav_core: 50 %'])

    def test_on_a_terminal_one_line_is_written_over(self):
        self.assertIn('\r    planner:   4 %\r    planner:  12 %\r    planner:  19 %\r    planner:  23 %\nFailed', self.shown(True))


if __name__ == '__main__':
    unittest.main()
