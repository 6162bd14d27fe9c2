# SPDX-License-Identifier: BSD-3-Clause
import os
import sys
import tempfile
import unittest

from hidwa_tools.side_by_side import side_by_side

# Says that it is there and waits until the other one is.
MEET = '''
import os, sys, time
mine, other = sys.argv[1:]
open(mine, 'w').close()
while not os.path.exists(other):
    time.sleep(0.02)
print('met', os.path.basename(other))
'''
SLEEP = 'import time; print("begun", flush=True); time.sleep(600)'


class SideBySide(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_two_run_at_once(self):
        jobs = [(a, [sys.executable, '-c', MEET, self.path(a), self.path(b)]) for a, b in (('one', 'two'), ('two', 'one'))]
        self.assertEqual(dict(side_by_side(jobs, 2, self.folder.name)), {'one': 'met two\n', 'two': 'met one\n'})

    def test_no_more_than_wanted(self):
        # Alone, each leaves its mark and takes it away; nobody must see another's.
        script = 'import os, sys; os.mkdir(sys.argv[1]); os.rmdir(sys.argv[1]); print("alone")'
        jobs = [(str(k), [sys.executable, '-c', script, self.path('mark')]) for k in range(5)]
        self.assertEqual([output for _, output in side_by_side(jobs, 1, self.folder.name)], ['alone\n'] * 5)

    def test_errors_are_part_of_the_output(self):
        (name, output), = side_by_side([('fails', [sys.executable, '-c', 'raise SystemExit("why")'])], 2, self.folder.name)
        self.assertEqual((name, output), ('fails', 'why\n'))

    def test_what_still_runs_ends_with_the_loop(self):
        quick = [sys.executable, '-c', f'''
import os, time
while not os.path.exists({self.path("slow.out")!r}) or not os.path.getsize({self.path("slow.out")!r}):
    time.sleep(0.02)
''']
        for name, _ in side_by_side([('slow', [sys.executable, '-c', SLEEP]), ('quick', quick)], 2, self.folder.name):
            self.assertEqual(name, 'quick')
            break


if __name__ == '__main__':
    unittest.main()
