# SPDX-License-Identifier: BSD-3-Clause
"""Reports of bags that a real robot's recorder writes, and of bags that lack nearly everything or are broken."""
import contextlib
import hashlib
import io
import json
import os
import tempfile
import unittest

import numpy as np

from hidwa_tools import geometry, report
from hidwa_tools.bag import read_drives
from hidwa_tools.poses import composed
from synthetic_bag import RealDrive, SyntheticDrive


class RealBags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.bag = os.path.join(self.folder, 'drive.bag')

    def reported(self, *options):
        """(exit status, report or None, complaint)"""
        with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(io.StringIO()) as complaint:
            status = report.main([self.bag, '--out', os.path.join(self.folder, 'out'), *options])
        return status, json.loads(said.getvalue()) if status == 0 else None, complaint.getvalue()

    def test_the_way_comes_from_tf_in_the_map(self):
        RealDrive().write(self.bag)
        status, figures, _ = self.reported('--footprint', '[[0.2, 0.15], [-0.2, 0.15], [-0.2, -0.15], [0.2, -0.15]]')
        self.assertEqual(status, 0)
        self.assertEqual((figures['arrived'], figures['pose_from'], figures['contacts']), (True, 'tf map -> base_link', None))
        self.assertIn('not known', figures['contacts_note'])
        # 9.99 s at 0.5 m/s, poses 0.05 s apart: the last one in time is 9.95 s after the goal, at 4.975 m.
        self.assertAlmostEqual(figures['path_length_m'], 4.975, places=3)
        self.assertEqual((figures['start'], figures['goal']), ([0.0, 0.0, 0.0], [5.0, 0.0, 0.0]))
        # The wall at y = 1.0 is seen abeam; the outline's side is at 0.15.
        self.assertAlmostEqual(figures['clearance_estimate']['smallest_m'], 0.85, places=3)
        self.assertIn('estimated', figures['clearance_estimate']['note'])
        for lack in ('no map', 'no commands', 'no stick', 'no operator_state', 'no cycle', 'no plan'):
            self.assertTrue(any(text.startswith(lack) for text in figures['lacking']), lack)
        self.assertFalse(any(text.startswith(('no footprint', 'no goal', 'no laser', 'no odometry')) for text in figures['lacking']))
        drive, = read_drives(self.bag)
        np.testing.assert_allclose(drive.driven()[:, 2:4], 0.0, atol=1e-9)
        hits = drive.seen.floor(drive.goal_time, drive.result_time)
        np.testing.assert_allclose(hits[:, 1], RealDrive.WALL, atol=1e-6)  # ranges are float32
        self.assertTrue(os.path.getsize(os.path.join(self.folder, 'out', 'report.png')) > 1000)

    def test_a_laser_upside_down_sees_the_wall_where_it_is(self):
        real = RealDrive()
        real.upside_down = True
        real.write(self.bag)
        status, figures, _ = self.reported('--footprint', '[[0.2, 0.3], [-0.2, 0.3], [-0.2, -0.15], [0.2, -0.15]]')
        self.assertEqual(status, 0)
        # The wall at y = 1.0 is to the left, where the outline's side is at 0.3.
        self.assertAlmostEqual(figures['clearance_estimate']['smallest_m'], 0.7, places=3)
        drive, = read_drives(self.bag)
        hits = drive.seen.floor(drive.goal_time, drive.result_time)
        np.testing.assert_allclose(hits[:, 1], RealDrive.WALL, atol=1e-6)

    def test_without_a_map_frame_the_way_is_odometry(self):
        drive = RealDrive()
        drive.leave_out = {'map', 'scan', 'move_base/result'}
        drive.write(self.bag)
        status, figures, _ = self.reported()
        self.assertEqual((status, figures['pose_from'], figures['clearance_estimate']), (0, '/odom', None))
        self.assertEqual((figures['arrived'], figures['outcome']), (None, 'the host gave no result while recording'))
        self.assertAlmostEqual(figures['path_length_m'], 5.0, places=3)
        self.assertIsNone(figures['goal'])  # it was given in the map
        self.assertTrue(any('odometry, which drifts' in text for text in figures['lacking']))

    def test_tf_alone_is_a_drive(self):
        drive = RealDrive()
        drive.leave_out = {'odom', 'scan', 'move_base/goal', 'move_base/result'}
        drive.write(self.bag)
        status, figures, _ = self.reported()
        self.assertEqual((status, figures['arrived'], figures['pose_from']), (0, None, 'tf map -> base_link'))
        self.assertAlmostEqual(figures['path_length_m'], 5.0, places=3)
        self.assertAlmostEqual(figures['mean_speed_m_s'], 5.0 / 11.5, delta=0.01)  # 5 m in the bag's 11.5 s

    def test_names_are_found_by_type_and_in_a_namespace(self):
        drive = RealDrive(namespace='/robot1', base='robot1/base', odom='robot1/odom')
        drive.footprint = '[[0.3, 0.3], [-0.3, 0.3], [-0.3, -0.3], [0.3, -0.3]]'
        drive.write(self.bag)
        _, figures, _ = self.reported()
        self.assertEqual((figures['arrived'], figures['pose_from']), (True, 'tf map -> robot1/base'))
        self.assertAlmostEqual(figures['clearance_estimate']['smallest_m'], 0.7, places=3)  # the parameters' outline
        _, figures, _ = self.reported('--map-frame', 'robot1/odom')
        self.assertEqual(figures['pose_from'], '/robot1/odom')
        status, _, complaint = self.reported('--odom-topic', '/wheels')
        self.assertEqual(status, 2)
        self.assertIn('/wheels is not in the bag as nav_msgs/Odometry; there is /robot1/odom', complaint)
        status, _, complaint = self.reported('--base-frame', 'torso')
        self.assertIn('--base-frame torso is in no transform', complaint)

    def test_a_frame_with_two_parents_is_named(self):
        drive = RealDrive()
        drive.fixed = [('base_footprint', 'base_link')]
        drive.write(self.bag)
        _, figures, _ = self.reported()
        self.assertTrue(any('frame base_link has 2 parents, odom (in /tf) and base_footprint (in /tf_static)' in text
                            for text in figures['lacking']), figures['lacking'])
        self.assertAlmostEqual(figures['path_length_m'], 5.0, delta=0.03)  # odometry's

    def test_a_section_for_each_goal(self):
        RealDrive(goals=2).write(self.bag)
        _, figures, _ = self.reported()
        self.assertEqual([(g['goal_number'], g['arrived'], g['goal'][0]) for g in figures['goals']],
                         [(1, True, 5.0), (2, True, 10.0)])
        self.assertEqual({name for name in os.listdir(os.path.join(self.folder, 'out')) if name.endswith('.png')},
                         {'report_1.png', 'report_2.png'})
        _, second, _ = self.reported('--goal', '2')
        self.assertEqual(second, {k: v for k, v in figures['goals'][1].items() if k != 'goal_number'})
        status, _, complaint = self.reported('--goal', '3')
        self.assertEqual(status, 2)
        self.assertIn('no goal 3: it holds 2', complaint)

    def test_no_motion_is_an_error_with_a_remedy(self):
        drive = RealDrive()
        drive.leave_out = {'odom', '/tf'}
        drive.write(self.bag)
        status, _, complaint = self.reported()
        self.assertEqual(status, 2)
        self.assertIn('holds no motion: neither odometry', complaint)
        self.assertIn('record with record:=FILE', complaint)

    def test_a_bag_cut_short_is_read_as_far_as_it_goes_and_left_alone(self):
        whole = SyntheticDrive(length=20.0).write(os.path.join(self.folder, 'whole.bag'))
        with open(whole, 'rb') as data:
            content = data.read()
        for share in (0.5, 0.999):
            with open(self.bag, 'wb') as out:
                out.write(content[:int(share * len(content))])
            before = hashlib.sha256(open(self.bag, 'rb').read()).digest()
            drive, = read_drives(self.bag)
            self.assertEqual(hashlib.sha256(open(self.bag, 'rb').read()).digest(), before)
            self.assertIn('cut short', drive.notes[0])
            # Whole chunks of 768 KiB are intact.
            self.assertGreater(geometry.path_length(drive.driven()[:, 1:3]), 3.0 if share == 0.5 else 15.0)
            self.assertEqual(sorted(os.listdir(self.folder)), ['drive.bag', 'whole.bag'])

    def test_what_is_no_bag_is_named(self):
        for content, said in ((b'no bag', 'is no bag'), (b'', 'is no bag'), (None, 'there is no bag')):
            if content is None:
                os.remove(self.bag)
            else:
                with open(self.bag, 'wb') as out:
                    out.write(content)
            status, _, complaint = self.reported()
            self.assertEqual(status, 2)
            self.assertRegex(complaint, f'^scripts/report: .*{said}')


class Geometry(unittest.TestCase):
    def test_distances_equal_a_slow_twin(self):
        random = np.random.default_rng(5)
        polygon, points = geometry.circle(0.7, 5) + [0.2, -0.1], random.uniform(-2, 2, (40, 2))
        share = np.linspace(0.0, 1.0, 20001)[:, None]
        edges = np.vstack([a + share * (b - a) for a, b in zip(polygon, np.roll(polygon, -1, axis=0))])
        twin = [np.hypot(*(edges - point).T).min() for point in points]
        np.testing.assert_allclose(geometry.distances(polygon, points), twin, atol=1e-4)  # edges of 0.82 m in 20000 steps

    def test_composed(self):
        # 2 m ahead of a robot at (1, 1) that looks left is (1, 3); turned by a right angle more it looks back.
        np.testing.assert_allclose(composed((1.0, 1.0, np.pi / 2), (2.0, 0.0, np.pi / 2)), (1.0, 3.0, np.pi), atol=1e-12)


if __name__ == '__main__':
    unittest.main()
