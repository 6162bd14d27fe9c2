# SPDX-License-Identifier: BSD-3-Clause
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from hidwa_tools import demo
from hidwa_tools.errors import DemoError
from hidwa_tools.processes import Child, free_port
from hidwa_tools.waiting import wait_for


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

    def wait_for(self, condition):
        self.assertTrue(wait_for(condition), 'waited in vain')

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
        child.stop()
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

    def ended(self, script):
        child = Child(['bash', '-c', script], self.log, dict(os.environ))
        self.addCleanup(child.stop)
        self.wait_for(lambda: not child.running)
        return child

    def test_the_cause_of_a_failure_is_told(self):
        self.assertEqual(self.ended('echo hello; echo "[ERROR] [1.0]: no such map"; echo "a node died"; echo bye').complaint(),
                         '[ERROR] [1.0]: no such map')
        os.remove(self.log)
        self.assertEqual(self.ended('echo "ImportError: No module named rospkg"; echo').complaint(),
                         'ImportError: No module named rospkg')
        os.remove(self.log)
        self.assertEqual(self.ended('echo one; echo two; echo').complaint(), 'two')
        os.remove(self.log)
        self.assertEqual(self.ended('exit 3').complaint(), 'it said nothing, exit status 3')

    def test_a_launch_that_fails_says_why(self):
        with mock.patch.dict(os.environ, ROS_MASTER_URI=f'http://localhost:{free_port()}'):  # where no master is
            with self.assertRaisesRegex(DemoError, 'roslaunch ended before anything ran: RLException: no such file'):
                demo.wait_for_master(self.ended('echo checking; echo "RLException: no such file"'))
            os.remove(self.log)
            slow = Child(['bash', '-c', 'echo checking log usage; exec sleep 300'], self.log, dict(os.environ))
            self.addCleanup(slow.stop)
            with open(self.log, encoding='utf-8') as text:
                self.wait_for(lambda: 'usage' in text.read())
            with self.assertRaisesRegex(DemoError, 'has not started the nodes after 0 s: checking log usage; .*machine is too busy'):
                demo.wait_for_master(slow, patience=0.2)

    def test_free_port(self):
        self.assertGreater(free_port(), 1023)


if __name__ == '__main__':
    unittest.main()
