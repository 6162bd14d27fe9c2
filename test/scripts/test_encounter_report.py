# SPDX-License-Identifier: BSD-3-Clause
"""The reports of dynabarn and crowd, from runs made up here."""
import contextlib
import csv
import io
import json
import os
import tempfile
import unittest

import numpy as np

from hidwa_tools import encounter_report, study_report

COLUMNS = [*encounter_report.WORDS, *encounter_report.NUMBERS]
WORLDS = '# head\n1 easy | a 0:0:0 1:2:0 3:2:4\n2 hard | b 0:1:1 5:2:2\n'


class EncounterReport(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.makedirs(os.path.join(self.folder, 'paths'))
        self.worlds = os.path.join(self.folder, 'worlds.txt')
        with open(self.worlds, 'w', encoding='utf-8') as text:
            text.write(WORLDS)

    def write(self, study, successes):
        """successes: {world: one of 0 and 1 for each seed}"""
        with open(os.path.join(self.folder, 'study.json'), 'w', encoding='utf-8') as text:
            json.dump(study, text)
        with open(os.path.join(self.folder, 'runs.csv'), 'w', encoding='utf-8', newline='') as text:
            table = csv.DictWriter(text, COLUMNS)
            table.writeheader()
            for world, results in successes.items():
                for seed, success in enumerate(results):
                    row = dict.fromkeys(COLUMNS, 0)
                    row.update({'id': f'r{world}{seed}', 'world': world, 'class': 'easy', 'mode': 'AUTONOMY', 'setting': 'default',
                                'success': success, 'touched_moving': 1 - success, 'time': 10 + seed, 'encounters': 3})
                    table.writerow(row)
                    with open(os.path.join(self.folder, 'paths', row['id'] + '.csv'), 'w', encoding='utf-8') as way:
                        way.write('t,x,y,theta,v,omega,state\n0,11,0,3.14,0,0,AUTONOMY\n1,9,0,3.14,2,0,SHARED\n')

    def report(self, *more):
        said, complaints = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complaints):
            status = study_report.main([self.folder, *more])
        return status, said.getvalue(), complaints.getvalue()

    def test_page_of_dynabarn(self):
        self.write({'experiment': 'dynabarn', 'motion': 'linear', 'speed': 2.0, 'tracking': 'truth'}, {1: (1, 1), 2: (0, 1)})
        status, said, complaints = self.report(self.worlds)
        self.assertEqual(status, 0, complaints)
        # Worlds 1 and 0.5; times 10, 11 and 11 s; of four drives one touched.
        self.assertIn('easy, AUTONOMY: 4 drives, success 0.750 (0.500 to 1.000), touched moving 0.250', said)
        self.assertIn('10.7 s; 12 encounters, 1 touches moving', said)
        with open(os.path.join(self.folder, 'report.html'), encoding='utf-8') as page:
            self.assertEqual(page.read().count('data:image/png'), 1)

    def test_page_of_a_crowd(self):
        self.write({'experiment': 'crowd', 'people': 20, 'yielding': 0.5, 'tracking': 'none'}, {'office': (1, 0, 1, 1)})
        status, said, _ = self.report('some_map.yaml')
        self.assertEqual(status, 0)
        # Each drive counts for itself: the interval has a width.
        self.assertRegex(said, r'success 0\.750 \(0\.[0-5]\d\d to 1\.000\)')

    def test_the_interval_is_over_worlds(self):
        rows = [{'world': w, 'id': f'{w}{k}', 'success': s} for w, s in (('a', 1.0), ('b', 0.0)) for k in range(50)]
        self.assertEqual(encounter_report.interval(rows, 'success'), (0.5, 0.0, 1.0))
        _, low, high = encounter_report.interval(rows, 'success', 'id')
        # 100 independent drives: 0.5 +- 1.96 * 0.05.
        self.assertAlmostEqual(low, 0.40, delta=0.02)
        self.assertAlmostEqual(high, 0.60, delta=0.02)

    def test_places_on_a_track(self):
        track = encounter_report.load_tracks(self.worlds)['1'][0]
        np.testing.assert_allclose(encounter_report.place(track, 0.5, 'linear'), (1.0, 0.0))
        np.testing.assert_allclose(encounter_report.place(track, 3.5, 'linear'), (1.0, 0.0))  # again
        # As in the simulator's test: (p0 + p1)/2 + (m0 - m1)/8 with m0 = (1, 0), m1 = (1, 2).
        np.testing.assert_allclose(encounter_report.place(track, 0.5, 'spline'), (1.0, -0.25))
        np.testing.assert_allclose(encounter_report.place(track, 2.0, 'spline'), (2.125, 2.0))

    def test_faults(self):
        self.write({'experiment': 'dynabarn', 'motion': 'linear', 'speed': 2.0, 'tracking': 'truth'}, {1: (1, 1)})
        with open(self.worlds, 'w', encoding='utf-8') as text:
            text.write('1 easy | a 0:x:0\n')
        status, _, complaints = self.report(self.worlds)
        self.assertEqual(status, 2)
        self.assertIn('cannot be read as DynaBARN worlds', complaints)


if __name__ == '__main__':
    unittest.main()
