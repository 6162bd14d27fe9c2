# SPDX-License-Identifier: BSD-3-Clause
"""scripts/ways: what hidwa_ways is asked for, and how it ends."""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scripts', 'lib'))
from hidwa_tools import ways


class Run(unittest.TestCase):
    """With a program that says what it was called with."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        patch = mock.patch.object(ways, 'PROGRAM', os.path.join(self.folder, 'hidwa_ways'))
        patch.start()
        self.addCleanup(patch.stop)

    def run_ways(self, status, *arguments):
        """(exit status, the program's arguments) of scripts/ways --no-build."""
        with open(ways.PROGRAM, 'w', encoding='utf-8') as out:
            out.write(f'#!/bin/sh\necho "$@" > "{self.folder}/called"\nexit {status}\n')
        os.chmod(ways.PROGRAM, 0o755)
        ended = ways.main(['--no-build', '--out', os.path.join(self.folder, 'figures'), *arguments])
        with open(os.path.join(self.folder, 'called'), encoding='utf-8') as text:
            return ended, text.read().split()

    def test_all_scenes(self):
        fields = os.path.join(self.folder, 'worlds.txt')
        with open(fields, 'w', encoding='utf-8'):
            pass
        ended, called = self.run_ways(0, '--jobs', '2', '--barn', fields, '--map', fields)
        self.assertEqual(ended, 0)
        self.assertEqual(called, ['--map', f'{ways.OFFICE},{fields}', '--barn', fields, '--scenes', '5000', '--first-seed', '1',
                                  '--jobs', '2', '--out', os.path.join(self.folder, 'figures')])
        self.assertTrue(os.path.isdir(os.path.join(self.folder, 'figures')))

    def test_a_missed_bar_is_its_exit_status(self):
        self.assertEqual(self.run_ways(1, '--kinds', 'posts')[0], 1)

    def test_one_scene_alone(self):
        _, called = self.run_ways(0, '--scene', 'posts', '--seed', '7', '--trace', 'x.csv', '--picture', 'x.svg')
        self.assertEqual(called, ['--map', ways.OFFICE, '--scene', 'posts', '--seed', '7', '--trace', 'x.csv', '--picture', 'x.svg'])

    def assert_wrong(self, complaint, *arguments):
        with contextlib.redirect_stderr(io.StringIO()) as complaints, self.assertRaises(SystemExit) as end:
            ways.main(['--no-build', *arguments])
        self.assertEqual(end.exception.code, 2)
        self.assertIn(complaint, complaints.getvalue())

    def test_wrong_arguments(self):
        self.assert_wrong('--scene and --seed belong together', '--seed', '7')
        self.assert_wrong('need a --scene', '--picture', 'x.svg')
        self.assert_wrong("there is no file 'nowhere'", '--barn', 'nowhere')

    def test_nothing_built(self):
        with contextlib.redirect_stderr(io.StringIO()) as complaints:
            self.assertEqual(ways.main(['--no-build', '--out', self.folder]), 2)
        self.assertIn('hidwa_ways', complaints.getvalue())


if __name__ == '__main__':
    unittest.main()
