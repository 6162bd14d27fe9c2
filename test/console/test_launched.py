# SPDX-License-Identifier: BSD-3-Clause
"""The ways in which a person starts the console: scripts/demo --console, and robot.launch console:=true."""
import os
import subprocess
import sys
import tempfile
import unittest

import paths
from hidwa_tools.processes import Child

from page_twin import Page, View, port_of, until


class Demo(unittest.IsolatedAsyncioTestCase):
    async def test_it_prints_the_address_drives_and_ends_on_ctrl_c(self):
        with tempfile.TemporaryDirectory(prefix='hidwa_demo_test_') as folder:
            log = os.path.join(folder, 'log')
            page = os.path.join(paths.ROOT, 'console', 'page')
            library = os.path.join(paths.ROOT, 'scripts', 'lib')
            environment = {**os.environ, 'PYTHONPATH': os.pathsep.join([library, os.environ.get('PYTHONPATH', '')])}
            child = Child([sys.executable, '-m', 'hidwa_tools.demo', '--no-build', '--console', '--report', os.path.join(folder, 'report'),
                           '--goal', '5.5,3.7,1.57', f'--console-options=--port 0 --page {page}'], log, environment)
            self.addCleanup(child.stop)
            port = await port_of(child, log)
            visitor = await Page(port, 'a' * 32).open()
            view = await View(visitor).open()
            await until(lambda: (view.fields.get('goals') or {}).get('active'), 'a goal')
            self.assertEqual(view.fields['goals']['active'][:2], [5.5, 3.7])
            await until(lambda: view.fields['velocity'][0] > 0.2, 'a robot that drives')
            view.close()
            child.interrupt()
            await until(lambda: not child.running, 'the end')
            with open(log, encoding='utf-8') as text:
                said = text.read()
            self.assertFalse(child.running, said)
            self.assertIn('ended; recordings', said)
            self.assertNotIn('Traceback', said)


class Robot(unittest.TestCase):
    def nodes(self, *arguments):
        launch = os.path.join(paths.ROOT, 'launch', 'robot.launch')
        done = subprocess.run(['roslaunch', '--nodes', launch, 'map:=floor.yaml', 'joystick:=none', *arguments], check=True,
                              stdout=subprocess.PIPE, text=True)
        return done.stdout.split()

    def test_console_true_starts_it(self):
        self.assertIn('/console', self.nodes('console:=true', 'console_options:=--camera /eye'))
        self.assertNotIn('/console', self.nodes())


if __name__ == '__main__':
    unittest.main()
