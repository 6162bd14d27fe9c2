# SPDX-License-Identifier: BSD-3-Clause
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from hidwa_tools.processes import Child, free_port


def running(pid):
    """Whether a process runs (a zombie does not)."""
    try:
        with open(f'/proc/{pid}/stat', encoding='utf-8') as stat:
            return stat.read().rsplit(')', 1)[1].split()[0] != 'Z'
    except OSError:
        return False


class Processes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.log = os.path.join(self.folder.name, 'log')

    def wait_for(self, condition, patience=20.0):
        end = time.monotonic() + patience
        while not condition():
            self.assertLess(time.monotonic(), end, 'waited in vain')
            time.sleep(0.02)

    def pids_in_log(self, count):
        def read():
            with open(self.log, encoding='utf-8') as text:
                return [int(line) for line in text.read().split()]
        self.wait_for(lambda: len(read()) >= count)
        return read()

    def test_ends_on_interrupt_with_all_it_started(self):
        # A grandchild in a process group of its own that ignores the interrupt, as a stubborn node would.
        script = 'trap "exit 0" INT; setsid true; (trap "" INT; echo $BASHPID; exec sleep 300) & echo $$; wait'
        child = Child(['bash', '-c', f'set -m; {script}'], self.log, dict(os.environ))
        pids = self.pids_in_log(2)
        self.assertTrue(child.running)
        child.stop(patience=5.0)
        self.assertFalse(child.running)
        self.assertEqual([pid for pid in pids if running(pid)], [])

    def test_a_child_that_ignores_everything_is_killed(self):
        child = Child(['bash', '-c', 'trap "" INT TERM; echo $$; while :; do sleep 0.1; done'], self.log, dict(os.environ))
        pids = self.pids_in_log(1)
        child.stop(patience=0.5)
        self.wait_for(lambda: not running(pids[0]))

    def test_ends_with_its_parent_even_if_that_is_killed(self):
        program = ('import os, sys, time; from hidwa_tools.processes import Child; '
                   'Child(["bash", "-c", "echo $$; exec sleep 300"], sys.argv[1], dict(os.environ)); time.sleep(300)')
        parent = subprocess.Popen([sys.executable, '-c', program, self.log])
        self.wait_for(lambda: os.path.exists(self.log))
        pids = self.pids_in_log(1)
        parent.send_signal(signal.SIGKILL)
        parent.wait()
        self.wait_for(lambda: not running(pids[0]))

    def test_free_port(self):
        self.assertGreater(free_port(), 1023)


if __name__ == '__main__':
    unittest.main()
