# SPDX-License-Identifier: BSD-3-Clause
"""The report of drives whose figures are known by construction."""
import contextlib
import io
import json
import math
import os
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

from hidwa_tools import geometry, measure, report
from hidwa_tools.bag import read_drive
from synthetic_bag import FOOTPRINT, SyntheticDrive
from test_geometry import clipped_area


def bump(height, begin, end):
    """0 before `begin`, rises to `height` over 1 m, 0 again 1 m after `end`; smooth."""
    def lateral(x):
        rise = min(max(x - begin, 0.0), 1.0) - min(max(x - end, 0.0), 1.0)
        return height * 0.5 * (1.0 - math.cos(math.pi * rise))
    return lateral


class Report(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def measured(self, drive):
        return measure.measure(read_drive(drive.write(os.path.join(self.folder.name, 'drive.bag'))))

    def test_straight_drive(self):
        figures = self.measured(SyntheticDrive(length=10.0))
        self.assertTrue(figures['arrived'])
        self.assertAlmostEqual(figures['duration_s'], 20.0, places=2)  # 10 m at 0.5 m/s
        self.assertAlmostEqual(figures['path_length_m'], 10.0, places=3)
        self.assertAlmostEqual(figures['planned_length_m'], 10.0, places=3)
        self.assertEqual((figures['contacts'], figures['regions_crossed'], figures['operator_active_s']), (0, 0, 0.0))
        self.assertEqual((figures['operator_shift_left_m'], figures['operator_shift_right_m']), (0.0, 0.0))
        self.assertEqual(figures['cycles'], 1076)  # 21.5 s at 50 Hz, both ends
        # 2 ms each, every fiftieth 6 ms
        self.assertEqual(figures['cycle_us'], {'p50': 2000.0, 'p99': 6000.0, 'max': 6000.0})
        self.assertAlmostEqual(figures['longest_gap_s'], 0.02, places=3)  # 50 Hz
        self.assertAlmostEqual(figures['mean_omega_change'], 0.01)
        # omega goes to and fro by 0.01 rad/s every 0.02 s: 0.5 rad/s^2, and a change of 1 rad/s^2 in 0.02 s.
        turns = figures['turns']
        self.assertAlmostEqual(turns['acc_rms'], 0.5, places=3)
        self.assertAlmostEqual(turns['acc_p99'], 0.5, places=3)
        self.assertAlmostEqual(turns['jerk_rms'], 50.0, delta=0.1)
        self.assertEqual((turns['bend_acc_rms'], turns['at_limit']), (None, None))  # no bends; no limit known
        self.assertEqual(figures['mean_clearance_m'], 1.0)  # nothing stands there
        self.assertEqual((figures['map'], figures['mode'], figures['host']), ('synthetic', 'joystick', 'compat'))

    def test_mean_clearance_ends_with_the_drive(self):
        drive = read_drive(SyntheticDrive().write(os.path.join(self.folder.name, 'drive.bag')))
        truth = drive.truth[[0, -1]].copy()
        truth[:, 0] = 15.96, 22.26  # in steps of 0.1 s the last one is 9e-14 s late
        self.assertEqual(measure.mean_clearance(drive.grid, drive.footprint, truth), 1.0)

    def test_each_uninterrupted_overlap_is_one_contact(self):
        # The footprint's sides run along y = +-0.15: the first block reaches 0.05 m into them, the second twice,
        # the third stands 0.05 m clear of them.
        blocks = [(2, 0.1, 3, 0.5), (5, -0.5, 5.5, -0.1), (6.5, -0.5, 7, -0.1), (8, 0.2, 9, 0.5)]
        self.assertEqual(self.measured(SyntheticDrive(blocks=blocks))['contacts'], 3)
        # Two blocks closer together than the robot is long (0.4 m) are one overlap.
        self.assertEqual(self.measured(SyntheticDrive(blocks=[(2, 0.1, 3, 0.5), (3.3, 0.1, 4, 0.5)]))['contacts'], 1)

    def test_overlap_at_the_goal_and_micrometres_deep(self):
        # The front comes to rest at x = 10.2, where a wall begins.
        drive = SyntheticDrive(length=10.000002, blocks=[(10.2, -1, 10.4, 1)])
        self.assertEqual(self.measured(drive)['contacts'], 1)
        drive = SyntheticDrive(length=9.999998, blocks=[(10.2, -1, 10.4, 1)])
        self.assertEqual(self.measured(drive)['contacts'], 0)

    def test_contacts_equal_a_slow_twin(self):
        random = np.random.default_rng(3)
        blocks = [(0.05 * i, y, 0.05 * i + 0.05, y + 0.05) for i, y in
                  zip(random.integers(10, 190, 60), 0.05 * random.integers(-12, 12, 60))]
        path = SyntheticDrive(blocks=blocks, lateral=bump(0.5, 3, 6)).write(os.path.join(self.folder.name, 'twin.bag'))
        drive = read_drive(path)
        truth = drive.driven()[::20]
        cells = drive.grid.origin + np.argwhere(drive.grid.occupied)[:, ::-1] * drive.grid.resolution
        areas = []
        for pose in truth[:, 1:4]:
            outline = geometry.placed(drive.footprint, *pose)
            areas.append(max(clipped_area(outline, cell, cell + drive.grid.resolution) for cell in cells))
        areas = np.array(areas)
        clear = (areas == 0) | (areas > 1e-9)  # rounding decides where they only touch
        np.testing.assert_array_equal(measure.overlaps(drive.grid, drive.footprint, truth[:, 1:4])[clear], areas[clear] > 0)
        self.assertGreater(np.count_nonzero(areas > 1e-9), 5)
        self.assertGreater(np.count_nonzero(areas == 0), 5)

    def test_regions_count_once_each(self):
        regions = [[(2, 0.1), (3, 0.1), (3, 1), (2, 1)],     # touched by the left side
                   [(5, 0.2), (6, 0.2), (6, 1), (5, 1)],     # 0.05 m beyond it
                   [(7.1, -0.02), (7.14, -0.02), (7.12, 0.02)]]  # inside the footprint's path
        figures = self.measured(SyntheticDrive(regions=regions))
        self.assertEqual((figures['regions_crossed'], figures['regions']), (2, 3))

    def test_shift_is_to_the_side_of_the_deflection_and_relative_to_its_begin(self):
        # The stick is held left from 5 s to 8 s, robot at x = 2.0 to 3.5; the path rises to 0.6 m between 2.5 and
        # 3.5 and returns only after x = 6: 4 s after release the robot is at x = 5.5.
        held = {'lateral': bump(0.6, 2.5, 6.0), 'stick': lambda t: 1.0 if 5.0 <= t < 8.0 else 0.0}
        figures = self.measured(SyntheticDrive(**held))
        self.assertAlmostEqual(figures['operator_shift_left_m'], 0.6, places=3)
        self.assertEqual(figures['operator_shift_right_m'], 0.0)
        self.assertAlmostEqual(figures['operator_active_s'], 3.0, places=2)
        # The same path under a right deflection is no shift to the right; mirrored it is.
        held['stick'] = lambda t: -1.0 if 5.0 <= t < 8.0 else 0.0
        figures = self.measured(SyntheticDrive(**held))
        self.assertEqual((figures['operator_shift_left_m'], figures['operator_shift_right_m']), (0.0, 0.0))
        held['lateral'] = bump(-0.6, 2.5, 6.0)
        self.assertAlmostEqual(self.measured(SyntheticDrive(**held))['operator_shift_right_m'], 0.6, places=3)

    def test_shift_counts_from_the_offset_at_deflection_and_ends_four_seconds_after_release(self):
        # Already 0.6 m left when the stick moves at x = 4 (9 s): no further shift.
        figures = self.measured(SyntheticDrive(lateral=bump(0.6, 2.5, 6.0), stick=lambda t: 1.0 if 9.0 <= t < 10.0 else 0.0))
        self.assertLess(figures['operator_shift_left_m'], 1e-6)
        # Released at 3 s, x = 1: 4 s later the robot is at x = 3, half way up: 0.3 m.
        figures = self.measured(SyntheticDrive(lateral=bump(0.6, 2.5, 6.0), stick=lambda t: 1.0 if 2.0 <= t < 3.0 else 0.0))
        self.assertAlmostEqual(figures['operator_shift_left_m'], 0.3, delta=0.01)

    def test_deflections(self):
        sticks = [(0.0, [0.05]), (1.0, [0.5]), (2.0, [0.9]), (3.0, [-0.5]), (4.0, [0.0]), (5.0, [0.2])]
        self.assertEqual(measure.deflections(sticks, 0, 1, 0.1), [(1.0, 3.0, 1), (3.0, 4.0, -1), (5.0, 5.0, 1)])
        self.assertEqual(measure.deflections(sticks, 0, -1, 0.1)[0], (1.0, 3.0, -1))
        self.assertEqual(measure.deflections(sticks, 3, 1, 0.1), [])

    def test_people_are_counted_and_drawn(self):
        # The robot drives at 0.5 m/s from x = 0, 1 s after the bag's begin; it is 0.4 m long and 0.3 m wide.
        beside = [(t, 5.0, 1.0) for t in np.arange(0.0, 22.0, 0.05)]              # 1.0 - 0.15 - 0.3 = 0.55 m at the least
        # Stands at x = 8; the front touches when the robot is at 8 - 0.3 - 0.2 = 7.5, the back leaves it at 8.5.
        ahead = [(t, 8.0, 0.0) for t in np.arange(0.0, 22.0, 0.05)]
        figures = self.measured(SyntheticDrive(people={3: beside}))
        self.assertEqual((figures['people'], figures['contacts_moving'], figures['contacts_at_rest']), (1, 0, 0))
        self.assertAlmostEqual(figures['closest_person_m'], 0.55, places=3)
        self.assertEqual(figures['personal_space_s'], 0.0)
        figures = self.measured(SyntheticDrive(people={3: beside, 4: ahead}))
        self.assertEqual((figures['people'], figures['contacts_moving'], figures['closest_person_m']), (2, 1, 0.0))
        # From x = 7.0 to 9.0: 2 m at 0.5 m/s.
        self.assertAlmostEqual(figures['personal_space_s'], 4.0, delta=0.05)
        path = SyntheticDrive(people={3: beside}).write(os.path.join(self.folder.name, 'people.bag'))
        self.assertEqual(report.main([path, '--out', self.folder.name]), 0)
        self.assertGreater(os.path.getsize(os.path.join(self.folder.name, 'report.png')), 10000)

    def test_time_driven_without_a_goal(self):
        path = os.path.join(self.folder.name, 'drive.bag')

        def figures(omit=(), unknown=(), **drive):
            synthetic = SyntheticDrive(**drive)
            synthetic.omit, synthetic.unknown = omit, unknown
            return report.write_report(synthetic.write(path), self.folder.name)
        # The goal comes after 1 s. Before it the person drives for 0.6 s, which is no part of the way to the goal.
        before = {'without_goal': lambda t: 0.2 <= t < 0.8}
        written = figures(**before)
        self.assertAlmostEqual(written['driven_without_goal_s'], 0.6, places=3)
        self.assertEqual((written['state_s']['MANUAL'], written['operator_active_s']), (0.0, 0.0))
        # A bag without any goal is one drive.
        written = figures(omit=('/move_base/goal', '/move_base/result', '/move_base/NavfnROS/plan'), **before)
        self.assertAlmostEqual(written['driven_without_goal_s'], 0.6, places=3)
        self.assertAlmostEqual(written['state_s']['MANUAL'], 0.6, places=3)
        self.assertIsNone(written['arrived'])
        # Nobody does; an older release; no states.
        self.assertEqual(figures()['driven_without_goal_s'], 0.0)
        self.assertEqual(figures(unknown=('without_goal',))['driven_without_goal_s'], 0.0)
        self.assertIsNone(figures(omit=('/move_base/HIDWAPlannerROS/operator_state',))['driven_without_goal_s'])

    def test_no_arrival(self):
        self.assertFalse(self.measured(SyntheticDrive(arrived=False))['arrived'])
        drive = SyntheticDrive()
        drive.omit = ('/move_base/result',)
        figures = self.measured(drive)
        self.assertFalse(figures['arrived'])
        self.assertIn('no result', figures['outcome'])

    def test_a_bag_without_planner_topics_still_reports(self):
        drive = SyntheticDrive()
        drive.omit = ('/joy', '/cmd_vel', '/regions', '/move_base/NavfnROS/plan', '/move_base/HIDWAPlannerROS/cycle',
                      '/move_base/HIDWAPlannerROS/operator_state')
        figures = self.measured(drive)
        self.assertEqual((figures['cycles'], figures['cycle_us']['p50'], figures['mean_omega_change']), (0, None, None))

    def test_without_the_map_contacts_are_not_known(self):
        drive = SyntheticDrive()
        drive.omit = ('/map',)
        figures = self.measured(drive)
        self.assertEqual((figures['contacts'], figures['path_length_m']), (None, 10.0))
        self.assertTrue(any(text.startswith('no map') for text in figures['lacking']))

    def test_command_writes_both_files(self):
        drive = SyntheticDrive(lateral=bump(0.6, 2.5, 6.0), stick=lambda t: 1.0 if 5.0 <= t < 8.0 else 0.0,
                               regions=[[(2, 0.1), (3, 0.1), (3, 1), (2, 1)]], blocks=[(0, 1.2, 12, 1.3), (0, -1.3, 12, -1.2)])
        path = drive.write(os.path.join(self.folder.name, 'drive.bag'))
        out = os.path.join(self.folder.name, 'out')
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            self.assertEqual(report.main([path, '--out', out]), 0)
        with open(os.path.join(out, 'report.json'), encoding='utf-8') as text:
            written = json.load(text)
        self.assertEqual(written, json.loads(printed.getvalue()))
        self.assertEqual(written['regions_crossed'], 1)
        with open(os.path.join(out, 'report.png'), 'rb') as picture:
            self.assertEqual(picture.read(8), b'\x89PNG\r\n\x1a\n')
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(report.main([os.path.join(self.folder.name, 'absent.bag')]), 2)
        self.assertIn('absent.bag', said.getvalue())

    def test_without_matplotlib_the_figures_come_and_say_what_is_missing(self):
        path = SyntheticDrive().write(os.path.join(self.folder.name, 'drive.bag'))
        whole = report.write_report(path, self.folder.name)
        os.remove(os.path.join(self.folder.name, 'report.png'))
        with mock.patch.dict(sys.modules, {'matplotlib': None}):
            del sys.modules['hidwa_tools.figure']
            figures = report.write_report(path, self.folder.name)
        self.assertEqual(figures.pop('no_picture'), 'matplotlib is not installed: apt-get install python3-matplotlib')
        self.assertEqual(figures, whole)
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, 'report.png')))
        with open(os.path.join(self.folder.name, 'report.json'), encoding='utf-8') as text:
            self.assertIn('apt-get install python3-matplotlib', json.load(text)['no_picture'])

    def test_footprint_is_the_one_recorded(self):
        path = SyntheticDrive().write(os.path.join(self.folder.name, 'drive.bag'))
        np.testing.assert_array_equal(read_drive(path).footprint, FOOTPRINT)


if __name__ == '__main__':
    unittest.main()
