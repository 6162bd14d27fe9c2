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

from hidwa_tools import study_report

COLUMNS = ['id', 'experiment', 'participant', 'condition', 'order', 'setting', 'seed', 'ending', 'arrived', 'duration',
           'length', 'regions_crossed', 'contacts', 'operator_active', 'interventions', 'v_change', 'omega_change',
           'agreement', 'clearance', 'mode_errors', 'failures', 'brakes', 'acc_rms', 'acc_p99', 'bend_acc_rms', 'jerk_rms',
           'jerk_p99', 'at_limit', 'bend_at_limit', 'mean_clearance']


def write_runs(folder, durations):
    """durations: {condition: [s for participant 1, 2, ...]}"""
    os.makedirs(os.path.join(folder, 'paths'), exist_ok=True)
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
        self.assertIn('SJ is faster than SW, as in the paper: the mean time in SJ is 0.500 of that in SW (the paper: 0.921)', said)
        self.assertIn('p = 0.0312 (exact)', said)
        self.assertIn('SJ was quicker than SW for 6 of 6: exact binomial p = 0.0312', said)
        self.assertIn('time: mean 12.500 in SJ, 12.500 in SG; no pair differs', said)
        with open(os.path.join(self.folder, 'report.html'), encoding='utf-8') as text:
            page = text.read()
        self.assertEqual(page.count('data:image/png;base64,'), 2)  # distributions and ways
        self.assertIn('paper: SJ', page)
        self.assertNotIn('http', page)  # self-contained

    def test_no_difference_shown_is_no_order(self):
        # p = 1: one pair each way, of equal rank. p = 0.5: two pairs, both quicker in SJ, 2 / 2^2.
        for times, p in (({'SJ': [10, 12], 'SW': [12, 10]}, '1.0000'), ({'SJ': [10, 10], 'SW': [12, 13]}, '0.5000')):
            write_runs(self.folder, times)
            _, said, _ = run(self.folder)
            self.assertIn('No difference in time shown between SJ and SW, unlike in the paper', said)
            self.assertIn(f'p = {p}.', said)
            self.assertIn('SJ is not faster here: no difference is shown.', said)
            self.assertNotIn('SJ is faster', said)

    def test_the_other_way_round(self):
        write_runs(self.folder, {'SJ': [20, 22, 24, 26, 28, 30], 'SW': [10, 11, 12, 13, 14, 15]})
        _, said, _ = run(self.folder)
        self.assertIn('SJ is not faster than SW, unlike in the paper: SW is', said)
        self.assertIn('SJ is not faster here, SW is. SW takes -12.50 s against SJ', said)  # 12.5 s against 25 s

    def test_what_differs_from_the_paper(self):
        # The second person's way is 2 m longer in SW: at SJ's 1 m/s that is 2 s of the 4 s; means 2 / 2 = 1 s and 2 s.
        write_runs(self.folder, {'SJ': [10, 10], 'SW': [10, 14]})
        self.change('SW1', length='12.0', contacts='2', regions_crossed='1')
        self.change('SW0', contacts='')
        _, said, _ = run(self.folder)
        self.assertIn('SW takes +2.00 s against SJ, of which +1.00 s by the length of the way and +1.00 s by the mean speed', said)
        for line in ('mean time, SW: 12.00 s (the paper: 187.17 s)', 'ratio SJ / SW: 0.833 (the paper: 0.921)',
                     'faster: no difference shown, p = 1.0000 (the paper: SJ, p < 0.001)',
                     'regions crossed, mean, SW: 0.500 (the paper: 0.406)',
                     'contacts, in all, SW: 2 (known of 1 of 2) (the paper: 3)', '1 of 2 in SW crossed a region'):
            self.assertIn(line, said)
        with open(os.path.join(self.folder, 'report.html'), encoding='utf-8') as text:
            self.assertIn('What differs from the paper, and why', text.read())

    def change(self, run_id, **cells):
        """Gives cells of a run other values."""
        path = os.path.join(self.folder, 'runs.csv')
        with open(path, encoding='utf-8', newline='') as text:
            rows = list(csv.DictReader(text))
        with open(path, 'w', encoding='utf-8', newline='') as text:
            table = csv.DictWriter(text, COLUMNS)
            table.writeheader()
            table.writerows({**row, **cells} if row['id'] == run_id else row for row in rows)

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
