# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot with move_base and consoles, for the tests; everything ends with them."""
import os
import re
import tempfile

import paths  # noqa: F401
from hidwa_tools import demo
from hidwa_tools.processes import Child, free_port
from hidwa_tools.waiting import wait_for

ADDRESS = re.compile(r'console: (\S+)')


class World:
    """roslaunch of the demo on a master of its own, and consoles beside it."""

    def __init__(self, *arguments):
        self._folder = tempfile.TemporaryDirectory(prefix='hidwa_console_test_')
        self.folder = self._folder.name
        self._children, self._consoles = [], 0
        port = free_port()
        self.environment = demo.environment(self.folder, port)
        launch = os.path.join(paths.ROOT, 'launch', 'demo.launch')
        self._launched = self._start('demo', ['roslaunch', '-p', str(port), launch, 'operator:=page', 'console:=false', *arguments])
        demo.wait_for_master(self._launched)

    def _start(self, name, command):
        child = Child(command, os.path.join(self.folder, name + '.log'), self.environment)
        self._children.append(child)
        return child

    def console(self, *options, page=None):
        """Starts a console; (its process, port, token or '')."""
        self._consoles += 1
        name = f'console_{self._consoles}'
        page = page or self.plain_page()
        child = self._start(name, ['/usr/bin/python3', os.path.join(paths.ROOT, 'console', 'console'), '--port', '0', '--page', page,
                                   '--recordings', os.path.join(self.folder, 'recordings'), f'__name:={name}', *options])
        text = self.wait_for(name, ADDRESS, child)
        port = int(re.search(r':(\d+)/', text).group(1))
        return child, port, text.partition('#token=')[2]

    def plain_page(self):
        """The page, or where it is not there an empty one."""
        real = os.path.join(paths.ROOT, 'console', 'page')
        if os.path.isfile(os.path.join(real, 'index.html')):
            return real
        with open(os.path.join(self.folder, 'index.html'), 'w', encoding='utf-8') as out:
            out.write('<!doctype html><title>empty</title>')
        return self.folder

    def wait_for(self, name, pattern, child):
        """The first group of a pattern in a child's log."""
        wait_for(lambda: pattern.search(self.log(name)) or not child.running)
        found = pattern.search(self.log(name))
        if not found:
            raise AssertionError(f'{name} does not say {pattern.pattern}:\n{self.log(name)[-2000:]}')
        return found.group(1)

    def log(self, name):
        """What a child has said."""
        path = os.path.join(self.folder, name + '.log')
        if not os.path.exists(path):
            return ''
        with open(path, encoding='utf-8', errors='replace') as text:
            return text.read()

    def newest_log(self):
        """What the console that was started last has said."""
        return self.log(f'console_{self._consoles}')

    def end(self):
        for child in reversed(self._children):
            child.stop()
        self._folder.cleanup()
