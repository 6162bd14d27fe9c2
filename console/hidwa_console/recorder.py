# SPDX-License-Identifier: BSD-3-Clause
"""The recording button: a bag as the launch files' argument record:= makes it, then its report."""
import os
import sys
import time

from hidwa_tools.processes import Child

START_PATIENCE = 3.0  # [s] in which a recorder that cannot begin has ended


class Recorder:
    """`command(path)`: the command line of record_drive for a bag. `cycles(on)`: asks the planner for the records that a replay needs.
    folder: where bags and report go."""

    def __init__(self, command, folder, cycles):
        self._command, self._folder, self._cycles = command, folder, cycles
        self._child, self._making, self._began = None, None, 0.0
        self._ending, self._path, self._report, self._text = False, '', 'none', ''

    @property
    def report_folder(self):
        """Where the last report is."""
        return os.path.join(self._folder, 'report')

    def record(self, on):
        """Begins or ends; may block for a moment. (ok, text)"""
        if on == self.on:
            return True, ''
        return self._begin() if on else self._end()

    @property
    def on(self):
        """Whether it records."""
        return self._child is not None and not self._ending

    def _begin(self):
        if self._child:
            return False, 'the last recording is being finished'
        try:
            os.makedirs(self._folder, exist_ok=True)
        except OSError as fault:
            return False, f'{self._folder} cannot be made: {fault.strerror}'
        name = time.strftime('drive_%Y-%m-%d_%H-%M-%S.bag')
        self._path, self._text = os.path.join(self._folder, name), ''
        self._cycles(True)
        self._child = Child(self._command(self._path), os.path.join(self._folder, 'recorder.log'), dict(os.environ))
        self._began, self._ending = time.monotonic(), False
        return True, f'recording to {self._path}'

    def _end(self):
        self._ending = True
        self._child.interrupt()
        return True, f'{self._path} is being finished'

    def tick(self):
        """Once a second or so: notices what ended."""
        if self._child and not self._child.running:
            said = self._child.complaint()
            self._child.stop()
            self._child = None
            self._cycles(False)
            if os.path.exists(self._path):
                self._make_report()
            else:
                self._text = f'the recording ended without a bag: {said}'
            self._ending = False
        if self._making and not self._making.running:
            said = self._making.complaint()
            self._making.stop()
            self._making = None
            done = os.path.exists(os.path.join(self.report_folder, 'report.json'))
            self._report, self._text = ('ready', '') if done else ('failed', said)

    def _make_report(self):
        os.makedirs(self.report_folder, exist_ok=True)
        for name in os.listdir(self.report_folder):
            if name.startswith('report'):
                os.remove(os.path.join(self.report_folder, name))
        library = os.path.dirname(os.path.dirname(os.path.abspath(sys.modules[Child.__module__].__file__)))
        environment = {**os.environ, 'PYTHONPATH': os.pathsep.join([library, os.environ.get('PYTHONPATH', '')]).rstrip(os.pathsep)}
        self._making = Child([sys.executable, '-m', 'hidwa_tools.report', self._path, '--out', self.report_folder],
                             os.path.join(self._folder, 'report.log'), environment)
        self._report = 'making'

    def close(self):
        """The console ends: a recording is finished first."""
        for child, patience in ((self._child, 60.0), (self._making, 0.1)):
            if child:
                child.stop(patience)

    def report(self):
        """The page's `record`."""
        seconds = round(time.monotonic() - self._began) if self.on else 0
        return {'on': self.on, 'file': self._path, 'seconds': seconds, 'report': self._report, 'text': self._text}
