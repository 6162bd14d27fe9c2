# SPDX-License-Identifier: BSD-3-Clause
"""Child processes that end with their parent, and with them everything they started themselves."""
import ctypes
import os
import re
import signal
import socket
import subprocess
import time

PR_SET_PDEATHSIG = 1
FAULT = re.compile(r'RLException|FATAL|ERROR|[A-Za-z]*Error\b|has died|cannot launch')


def free_port():
    """A TCP port that nothing listens on now."""
    with socket.socket() as probe:
        probe.bind(('localhost', 0))
        return probe.getsockname()[1]


def sourced(setup, *command):
    """The command in a shell that has sourced a setup file."""
    return ['bash', '-c', 'setup=$1; shift; . "$setup" && exec "$@"', 'sourced', setup, *command]


def _end_with_parent():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ignored where the parent was started in the background
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGINT)


def end_on_signals():
    """Turns every polite request to end into KeyboardInterrupt, in the background too."""
    def interrupt(*_):
        raise KeyboardInterrupt
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, interrupt)


class Child:
    """A command in a session of its own, so that whatever it starts can be found and ended."""

    def __init__(self, command, log_path, environment):
        self._log_path = log_path
        self._log = open(log_path, 'ab') if log_path else None  # None: where the parent writes
        self._process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self._log, stderr=subprocess.STDOUT,
                                         env=environment, start_new_session=True, preexec_fn=_end_with_parent)

    @property
    def running(self):
        return self._process.poll() is None

    @property
    def pid(self):
        """Of the command itself."""
        return self._process.pid

    def complaint(self):
        """The first line in its log that tells of a fault, or the last line; where there is none, its exit status."""
        lines = []
        if self._log_path:
            with open(self._log_path, encoding='utf-8', errors='replace') as text:
                lines = [line.strip() for line in text if line.strip()]
        status = self._process.poll()
        silence = 'it said nothing' if status is None else f'it said nothing, exit status {status}'
        return next((line for line in lines if FAULT.search(line)), lines[-1] if lines else silence)

    def interrupt(self):
        """Asks the command to end, without waiting."""
        if self.running:
            self._process.send_signal(signal.SIGINT)

    def stop(self, patience=20.0):
        """Asks the command to end; whatever of its session is left after `patience` [s] is killed."""
        if self.running:
            self._process.send_signal(signal.SIGINT)
            try:
                self._process.wait(patience)
            except subprocess.TimeoutExpired:
                pass
        for number in (signal.SIGTERM, signal.SIGKILL):
            deadline = time.monotonic() + 3.0
            while self._left() and time.monotonic() < deadline:
                for pid in self._left():
                    try:
                        os.kill(pid, number)
                    except ProcessLookupError:
                        pass
                time.sleep(0.1)
                self._process.poll()
        if self._log:
            self._log.close()

    def _left(self):
        """Processes of the child's session that still run."""
        left = []
        for name in os.listdir('/proc'):
            if not name.isdigit():
                continue
            try:
                with open(f'/proc/{name}/stat', encoding='utf-8', errors='replace') as stat:
                    state, _, _, session = stat.read().rsplit(')', 1)[1].split()[:4]
            except OSError:
                continue
            if int(session) == self._process.pid and state != 'Z':
                left.append(int(name))
        return left
