# SPDX-License-Identifier: BSD-3-Clause
"""scripts/attack and scripts/ways: what their programs are asked for, and how they end."""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scripts', 'lib'))
from hidwa_tools import campaign


class Run(unittest.TestCase):
    """With a program that says what it was called with."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.space = folder.name
        patch = mock.patch.object(campaign, 'SPACE', self.space)
        patch.start()
        self.addCleanup(patch.stop)

    def called(self, name, status, *arguments):
        """(exit status, the program's arguments)."""
        program = os.path.join(self.space, 'build', name, campaign.PROGRAMS[name].path)
        os.makedirs(os.path.dirname(program), exist_ok=True)
        with open(program, 'w', encoding='utf-8') as out:
            out.write(f'#!/bin/sh\necho "$@" > "{self.space}/called"\nexit {status}\n')
        os.chmod(program, 0o755)
        ended = campaign.main(name, ['--no-build', *arguments])
        with open(os.path.join(self.space, 'called'), encoding='utf-8') as text:
            return ended, text.read().split()

    def test_an_attack_has_a_folder_of_its_own(self):
        folder = os.path.join(self.space, 'build', 'attack', 'drives')
        with mock.patch.object(campaign.time, 'strftime', side_effect=['first', 'second']):
            self.assertEqual(self.called('attack', 0), (0, ['attack', '--out', os.path.join(folder, 'first')]))
            self.assertEqual(self.called('attack', 0), (0, ['attack', '--out', os.path.join(folder, 'second')]))
        _, given = self.called('attack', 0, '--out', 'mine')
        self.assertEqual(given[-2:], ['--out', 'mine'])

    def test_ways_have_the_office_among_their_maps(self):
        _, given = self.called('ways', 0, '--map', 'mine.yaml')
        self.assertEqual(given[0], '--map')
        self.assertEqual(given[-2:], ['--map', 'mine.yaml'])
        self.assertTrue(os.path.isfile(given[1]))

    def test_what_it_found_is_its_exit_status(self):
        self.assertEqual(self.called('ways', 1, '--kinds', 'posts')[0], 1)

    def test_help_builds_nothing(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(campaign.main('attack', ['--help']), 0)
        self.assertIn('--no-build', said.getvalue())
        self.assertFalse(os.path.exists(os.path.join(self.space, 'build')))

    def test_nothing_built(self):
        with contextlib.redirect_stderr(io.StringIO()) as complaints:
            self.assertEqual(campaign.main('attack', ['--no-build']), 2)
        self.assertIn('hidwa_study', complaints.getvalue())


if __name__ == '__main__':
    unittest.main()
