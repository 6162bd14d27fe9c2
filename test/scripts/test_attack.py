# SPDX-License-Identifier: BSD-3-Clause
"""scripts/attack: what hidwa_attack is asked for, and how it ends."""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scripts', 'lib'))
from hidwa_tools import attack


class Run(unittest.TestCase):
    """With a program that says what it was called with."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        patch = mock.patch.object(attack, 'PROGRAM', os.path.join(self.folder, 'hidwa_attack'))
        patch.start()
        self.addCleanup(patch.stop)

    def run_attack(self, status, *arguments):
        """(exit status, the program's arguments) of scripts/attack --no-build."""
        with open(attack.PROGRAM, 'w', encoding='utf-8') as out:
            out.write(f'#!/bin/sh\necho "$@" > "{self.folder}/called"\nexit {status}\n')
        os.chmod(attack.PROGRAM, 0o755)
        ended = attack.main(['--no-build', '--out', os.path.join(self.folder, 'figures'), *arguments])
        with open(os.path.join(self.folder, 'called'), encoding='utf-8') as text:
            return ended, text.read().split()

    def test_the_whole_campaign(self):
        ended, called = self.run_attack(0, '--jobs', '2')
        self.assertEqual(ended, 0)
        self.assertEqual(called, ['--seconds', '20', '--drives', '300', '--first-seed', '1', '--jobs', '2', '--out',
                                  os.path.join(self.folder, 'figures')])
        self.assertTrue(os.path.isdir(os.path.join(self.folder, 'figures')))

    def test_what_it_found_is_its_exit_status(self):
        self.assertEqual(self.run_attack(1, '--condition', 'late')[0], 1)

    def test_one_drive_alone(self):
        _, called = self.run_attack(0, '--condition', 'late', '--seed', '7', '--trace', 'x.csv')
        self.assertEqual(called, ['--seconds', '20', '--condition', 'late', '--seed', '7', '--trace', 'x.csv'])

    def test_a_seed_of_no_condition(self):
        with contextlib.redirect_stderr(io.StringIO()) as complaints, self.assertRaises(SystemExit) as end:
            attack.main(['--no-build', '--seed', '7'])
        self.assertEqual(end.exception.code, 2)
        self.assertIn('--seed needs a --condition', complaints.getvalue())

    def test_nothing_built(self):
        with contextlib.redirect_stderr(io.StringIO()) as complaints:
            self.assertEqual(attack.main(['--no-build', '--out', self.folder]), 2)
        self.assertIn('hidwa_attack', complaints.getvalue())


if __name__ == '__main__':
    unittest.main()
