# SPDX-License-Identifier: BSD-3-Clause
"""BARN-2D's report, from runs made up here."""
import contextlib
import csv
import io
import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir, 'scripts', 'lib'))

from hidwa_tools import study_report

COLUMNS = ['id', 'world', 'mode', 'setting', 'success', 'collision', 'timeout', 'time', 'metric', 'path_clearance', 'contacts',
           'clearance', 'operator_active']


def run(*arguments):
    """(exit status, what was said, complaints)"""
    said, complaints = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complaints):
        status = study_report.main(list(arguments))
    return status, said.getvalue(), complaints.getvalue()


class TestBarnReport(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = self._folder.name
        os.makedirs(os.path.join(self.folder, 'paths'))
        with open(os.path.join(self.folder, 'study.json'), 'w', encoding='utf-8') as text:
            json.dump({'experiment': 'barn'}, text)
        with open(os.path.join(self.folder, 'runs.csv'), 'w', encoding='utf-8', newline='') as text:
            table = csv.DictWriter(text, COLUMNS)
            table.writeheader()
            for mode, times in {'AUTONOMY': (20, 30, 100, 20), 'HOSTILE': (100, 100, 50, 100)}.items():
                for world, time in enumerate(times):
                    success = int(time < 100)
                    contact = int(mode == 'HOSTILE' and world == 0)
                    row = {'id': f'{mode}{world}', 'world': world, 'mode': mode, 'setting': 'default', 'success': success,
                           'collision': contact, 'timeout': 1 - success - contact, 'time': time, 'metric': 0.25 * success,
                           'path_clearance': 0.4 + 0.1 * world, 'contacts': contact, 'clearance': 0.05, 'operator_active': 0}
                    table.writerow(row)
                    with open(os.path.join(self.folder, 'paths', row['id'] + '.csv'), 'w', encoding='utf-8') as way:
                        way.write('t,x,y,theta,v,omega,state\n0,-2.25,3,0,0,0,AUTONOMY\n1,-2.25,5,0,0,0,SHARED\n')
        self.worlds = os.path.join(self.folder, 'worlds.txt')
        with open(self.worlds, 'w', encoding='utf-8') as text:
            text.write('# head\n' + ''.join(f'{world} | 0:0 2:3 | 1:1\n' for world in range(4)))

    def tearDown(self):
        self._folder.cleanup()

    def test_page(self):
        status, said, _ = run(self.folder, self.worlds)
        self.assertEqual(status, 0)
        # 3 of 4 arrive, in (20 + 30 + 20) / 3 s; 3 * 0.25 / 4.
        self.assertIn('AUTONOMY: 4 worlds, success 0.750, collision 0.000, timeout 0.250, 23.3 s, metric 0.188, 0 contacts', said)
        self.assertIn('HOSTILE: 4 worlds, success 0.250, collision 0.250, timeout 0.500, 50.0 s, metric 0.062, 1 contacts', said)
        with open(os.path.join(self.folder, 'report.html'), encoding='utf-8') as text:
            page = text.read()
        self.assertEqual(page.count('data:image/png;base64,'), 2)  # over difficulty, and the ways
        self.assertIn('0.850', page)  # as published
        self.assertNotIn('http', page)  # self-contained

    def test_without_worlds_or_ways(self):
        self.assertEqual(run(self.folder)[0], 0)
        os.remove(os.path.join(self.folder, 'ways.png'))
        for name in os.listdir(os.path.join(self.folder, 'paths')):
            os.remove(os.path.join(self.folder, 'paths', name))
        self.assertEqual(run(self.folder, self.worlds)[0], 0)
        self.assertFalse(os.path.exists(os.path.join(self.folder, 'ways.png')))

    def test_faults(self):
        with open(self.worlds, 'a', encoding='utf-8') as text:
            text.write('5 | 0:x | 1:1\n')
        status, _, complaint = run(self.folder, self.worlds)
        self.assertEqual(status, 2)
        self.assertIn('cannot be read as BARN worlds', complaint)
        os.remove(os.path.join(self.folder, 'runs.csv'))
        status, _, complaint = run(self.folder, self.worlds)
        self.assertEqual(status, 2)
        self.assertIn('runs.csv is missing', complaint)


if __name__ == '__main__':
    unittest.main()
