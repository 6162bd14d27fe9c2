# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import io
import os
import tempfile
import unittest
from unittest import mock

from hidwa_tools.options import parse


class Options(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.map = os.path.join(self.folder.name, 'map.yaml')
        with open(self.map, 'w', encoding='utf-8') as out:
            out.write('image: map.pgm\n')

    def refused(self, *arguments):
        """What is said when it exits."""
        with contextlib.redirect_stderr(io.StringIO()) as said, self.assertRaises(SystemExit) as left:
            parse(arguments)
        self.assertEqual(left.exception.code, 2)
        return said.getvalue()

    def test_nothing_given(self):
        options = parse([])
        self.assertEqual((options.operator, options.rate, options.map, options.gui), ('avoid', 1.0, None, False))
        self.assertEqual(options.report, os.path.abspath('report'))
        self.assertEqual((options.people, options.people_seed), (4, 1))

    def test_people(self):
        self.assertEqual(parse(['--people', '0']).people, 0)
        self.assertIn("'-1' is no whole number from 0", self.refused('--people=-1'))
        self.assertIn("'some' is no whole number", self.refused('--people', 'some'))

    def test_negative_coordinates(self):
        options = parse(['--map', self.map, '--start', '-7.05,-12.35,3.14', '--goal', '-16.65,32.85,1.57'])
        self.assertEqual((options.start, options.goal), ([-7.05, -12.35, 3.14], [-16.65, 32.85, 1.57]))

    def test_another_map_has_no_regions_so_nobody_steers_round_them(self):
        place = ['--start', '0,0,0', '--goal', '1,1,0']
        self.assertEqual(parse(['--map', self.map, *place]).operator, 'none')
        self.assertEqual(parse(['--map', self.map, *place, '--regions', self.map]).operator, 'avoid')

    def test_faults_are_named(self):
        self.assertIn("'1,2'", self.refused('--goal', '1,2'))
        self.assertIn("'a,b,c'", self.refused('--start', 'a,b,c'))
        self.assertIn("no file 'absent.yaml'", self.refused('--map', 'absent.yaml'))
        self.assertIn('needs --start and --goal', self.refused('--map', self.map))
        self.assertIn("'absent.yaml' is neither avoid, none", self.refused('--operator', 'absent.yaml'))
        self.assertIn("'0' is no positive number", self.refused('--rate', '0'))
        self.assertIn("'inf' is no positive number", self.refused('--rate', 'inf'))
        self.assertIn('expected one argument', self.refused('--start'))

    def test_gui_needs_a_display(self):
        with mock.patch.dict(os.environ):
            os.environ.pop('DISPLAY', None)
            self.assertIn('DISPLAY', self.refused('--gui'))
            os.environ['DISPLAY'] = ':0'
            self.assertTrue(parse(['--gui']).gui)


if __name__ == '__main__':
    unittest.main()
