# SPDX-License-Identifier: BSD-3-Clause
"""The study's report, from runs made up here."""
import contextlib
import csv
import io
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir, 'scripts', 'lib'))

from hidwa_tools import study_report  # noqa: E402

COLUMNS = ['id', 'experiment', 'participant', 'condition', 'order', 'setting', 'seed', 'ending', 'arrived', 'duration',
           'length', 'regions_crossed', 'contacts', 'operator_active', 'interventions', 'v_change', 'omega_change',
           'agreement', 'clearance', 'mode_errors', 'failures', 'brakes']


def write_runs(folder, durations):
    """durations: {condition: [s for participant 1, 2, ...]}"""
    os.makedirs(os.path.join(folder, 'paths'))
    with open(os.path.join(folder, 'runs.csv'), 'w', encoding='utf-8', newline='') as text:
        table = csv.DictWriter(text, COLUMNS)
        table.writeheader()
        for condition, values in durations.items():
            for i, value in enumerate(values):
                row = dict.fromkeys(COLUMNS, '0')
                row.update(id=f'{condition}{i}', participant=str(i + 1), condition=condition, setting='default', ending='arrived',
                           arrived='1', duration=str(value), length='10.0', clearance='0.2', agreement='1.0')
                table.writerow(row)
                with open(os.path.join(folder, 'paths', row['id'] + '.csv'), 'w', encoding='utf-8') as way:
                    way.write('t,x,y,theta,v,omega,state\n0,0,0,0,0,0,AUTONOMY\n1,1,0,0,0,0,SHARED\n2,2,0,0,0,0,AUTONOMY\n')


def run(*arguments):
    """(exit status, what was said, complaints)"""
    said, complaints = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complaints):
        status = study_report.main(list(arguments))
    return status, said.getvalue(), complaints.getvalue()


class TestStudyReport(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = os.path.join(self._folder.name, 'study')
        os.mkdir(self.folder)

    def tearDown(self):
        self._folder.cleanup()

    def test_faster(self):
        write_runs(self.folder, {'SJ': [10, 11, 12, 13, 14, 15], 'SG': [10, 11, 12, 13, 14, 15], 'SW': [20, 22, 24, 26, 28, 30]})
        status, said, _ = run(self.folder)
        self.assertEqual(status, 0)
        # All six pairs on one side: p = 2 / 2^6, and the ratio of means is 12.5 / 25.
        self.assertIn('SJ is faster than SW, as in the paper: its mean time is 0.500', said)
        self.assertIn('p = 0.0312 (exact)', said)
        self.assertIn('SJ was quicker than SW for 6 of 6: exact binomial p = 0.0312', said)
        self.assertIn('time: mean 12.500 in SJ, 12.500 in SG; no pair differs', said)
        with open(os.path.join(self.folder, 'report.html'), encoding='utf-8') as text:
            page = text.read()
        self.assertEqual(page.count('data:image/png;base64,'), 2)  # distributions and ways
        self.assertIn('paper: SJ', page)
        self.assertNotIn('http', page)  # self-contained

    def test_not_faster(self):
        write_runs(self.folder, {'SJ': [20, 11, 12], 'SW': [10, 12, 11]})
        _, said, _ = run(self.folder)
        self.assertIn('SJ is not faster than SW, unlike in the paper', said)
        self.assertIn('not beyond chance', said)

    def test_one_condition_without_ways(self):
        write_runs(self.folder, {'SW': [10, 11]})
        for name in os.listdir(os.path.join(self.folder, 'paths')):
            os.remove(os.path.join(self.folder, 'paths', name))
        status, _, _ = run(self.folder)
        self.assertEqual(status, 0)
        self.assertFalse(os.path.exists(os.path.join(self.folder, 'ways.png')))

    def test_nothing_there(self):
        status, _, complaint = run(self.folder)
        self.assertEqual(status, 2)
        self.assertIn('runs.csv is missing: give the folder that hidwa_study wrote', complaint)

    def test_another_table(self):
        with open(os.path.join(self.folder, 'runs.csv'), 'w', encoding='utf-8') as text:
            text.write('condition,participant\nSJ,1\n')
        status, _, complaint = run(self.folder)
        self.assertEqual(status, 2)
        self.assertIn('no column setting', complaint)

    def test_no_map(self):
        write_runs(self.folder, {'SJ': [10, 11]})
        status, _, complaint = run(self.folder, os.path.join(self.folder, 'none.yaml'))
        self.assertEqual(status, 2)
        self.assertIn('cannot be read as a map', complaint)


if __name__ == '__main__':
    unittest.main()
