# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import io
import json
import os
import tempfile
import unittest
from unittest import mock

from hidwa_tools import bench
from hidwa_tools.bounds import judge

OURS = 'cycle/819/120/polygon/tight'


def case(p50=50.0, p99=80.0, **more):
    """A measured case; the thread's own times are the wall clock's unless they are given."""
    return {'candidates': 800.0, 'cycles': 2000.0, 'poses': 30000.0, 'p50_us': p50, 'p99_us': p99, 'p50_cpu_us': p50,
            'p99_cpu_us': p99, 'ns_per_pose': 1e3 * p50 / 30000.0, 'allocations': 0.0, **more}


def lines(cases, word=''):
    """The bounds that speak of something."""
    return [str(verdict) for verdict in judge(cases) if word in str(verdict)]


def printed(function, *arguments):
    """What a function prints, and what it returns."""
    with contextlib.redirect_stdout(io.StringIO()) as said:
        result = function(*arguments)
    return said.getvalue(), result


class Bounds(unittest.TestCase):
    def test_times(self):
        self.assertEqual(lines({OURS: case(100.0, 251.0)}, 'p'),
                         [f'met     {OURS}: p50 100 us, at most 100', f'MISSED  {OURS}: p99 251 us, at most 250'] +
                         lines({OURS: case()}, 'allocations'))
        self.assertEqual(lines({'cycle/100000/200/circle/open': case(10001.0)}, 'p50'),
                         ['MISSED  cycle/100000/200/circle/open: p50 10001 us, at most 10000'])

    def test_cases_without_a_bound(self):
        others = {name: case(1e6, 1e6) for name in ('cycle/819/120/circle/tight', 'naive_' + OURS, 'cycle/2000/200/polygon/open')}
        self.assertEqual(lines(others, ' us'), [])

    def test_a_busy_machine_is_named_but_the_bound_is_missed(self):
        self.assertEqual(lines({OURS: case(120.0, p50_cpu_us=90.0)}, 'p50'),
                         [f'MISSED  {OURS}: p50 120 us, at most 100; 90 us by its own time, the machine was busy'])
        self.assertNotIn('busy', lines({OURS: case(120.0, p50_cpu_us=110.0)}, 'p50')[0])

    def test_growth_with_the_candidates(self):
        few, many = 'cycle_cached/2000/120/circle/open', 'cycle_cached/100000/120/circle/open'
        kernel = {few: case(ns_per_pose=2.0), many: case(ns_per_pose=2.5)}
        self.assertEqual(lines(kernel, 'times'), [f'met     {few}: 2.00 ns a pose, 2.50 at 100,000 candidates: 1.25 times, '
                                                  'at most 1.25'])
        kernel[many] = case(ns_per_pose=2.6)
        self.assertTrue(lines(kernel, 'times')[0].startswith('MISSED'))
        self.assertEqual(lines({few: kernel[few]}, 'times'), [])

    def test_allocations(self):
        some = {OURS: case(), 'cycle_cached/2000/120/circle/open': case(allocations=0.5), 'naive_' + OURS: case(allocations=900.0)}
        self.assertEqual(lines(some, 'allocations'),
                         ['MISSED  allocations a cycle: 0.5 in cycle_cached/2000/120/circle/open, at most 0'])
        self.assertTrue(lines({OURS: case()}, 'allocations')[0].startswith('met'))
        self.assertEqual(lines({'naive_' + OURS: case(allocations=900.0)}), [])

    def test_drives(self):
        def drive(times, cpu):
            return {'drive/office/alone': {'times_real_time': times, 'times_real_time_cpu': cpu}}
        self.assertEqual(lines(drive(50.0, 60.0)), ['met     drive/office/alone: 50 times real time, at least 50'])
        self.assertEqual(lines(drive(40.4, 45.0)), ['MISSED  drive/office/alone: 40 times real time, at least 50'])
        self.assertEqual(lines(drive(40.4, 55.0)), ['MISSED  drive/office/alone: 40 times real time, at least 50; 55 times by '
                                                    'its own time, the machine was busy'])

    def test_what_did_not_run_is_not_judged(self):
        self.assertEqual(judge({OURS: {'error_message': 'cannot read worlds.txt'}}), [])


class Ratios(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, 'ratios.json')
        patch = mock.patch.object(bench, 'RATIOS', self.path)
        patch.start()
        self.addCleanup(patch.stop)

    def test_by_the_threads_own_time(self):
        cases = {OURS: case(60.0, p50_cpu_us=50.0), 'naive_' + OURS: case(900.0, p50_cpu_us=400.0), 'cycle/1/1/circle/open': case(),
                 'cycle_cached/2000/120/circle/open': case()}
        self.assertEqual(bench.ratios(cases), {OURS: 8.0})
        cases['naive_' + OURS] = {'error_message': 'cannot read worlds.txt'}
        self.assertEqual(bench.ratios(cases), {})

    def test_only_a_ratio_that_fell_far_is_shown(self):
        bench.record({'a': 10.0, 'b': 10.0, 'c': 10.0})
        said, _ = printed(bench.show_ratios, {'a': 7.9, 'b': 8.1, 'new': 1.0})
        self.assertIn('2 recorded, 1 fell by more than 20%', said)
        self.assertEqual([line for line in said.splitlines() if 'FELL' in line], ['  FELL    a: 10.0 recorded, 7.9 now'])

    def test_a_record_keeps_what_did_not_run(self):
        self.assertEqual(bench.read_ratios(), {})
        bench.record({'a': 10.0, 'b': 9.0})
        bench.record({'b': 11.0})
        self.assertEqual(bench.read_ratios(), {'a': 10.0, 'b': 11.0})


class Output(unittest.TestCase):
    def test_table(self):
        text = bench.table({OURS: case(99.94, 120.4), 'naive_' + OURS: case(800.0), 'broken': {'error_message': 'x'}}, {OURS: 8.04})
        heading, ours, naive = text.splitlines()
        self.assertEqual(heading.split()[0], 'case')
        self.assertEqual(ours.split(), [OURS, '800', '2000', '99.9', '120', '99.9', '120', '3.33', '0.0', '8.0'])
        self.assertEqual(naive.split()[-1], '0.0')  # no ratio of its own
        self.assertEqual(ours.index('99.9') + 4, heading.index('p50 us') + 6)  # numbers end where their heading does

    def test_samples(self):
        cases = {OURS: case(), 'samples/20x20': {'omega_change': 0.01712, 'deviation': 120.17, 'excess': 16.66},
                 'samples/10x10': {'omega_change': 0.0131}}
        said, _ = printed(bench.show_samples, cases)
        self.assertEqual(said, 'samples/20x20: mean change of omega 0.0171 rad/s; where the wish is refused, what is chosen '
                         "deviates by 120.2 (J 16.7 above the finest samples')\n"
                         'samples/10x10: mean change of omega 0.0131 rad/s\n')

    def test_drives(self):
        drive = {'times_real_time': 149.6, 'times_real_time_cpu': 155.0, 'planning': 0.62, 'driven_m': 151.4, 'simulated_s': 308.8}
        said, _ = printed(bench.show_drives, {OURS: case(), 'drive/office/alone': drive})
        self.assertEqual(said, 'drive/office/alone: 151 m in 309 s of simulated time, 150 times real time; 62% of it is planning\n')

    def test_faults(self):
        absent, broken = printed(bench.show_faults, {OURS: {'error_message': 'cannot read worlds.txt'}})
        self.assertEqual((absent, broken), (f'  left out  {OURS}: cannot read worlds.txt\n', False))
        failed, broken = printed(bench.show_faults, {OURS: {'error_message': 'vx_samples: too few'}})
        self.assertEqual((failed, broken), (f'  FAILED  {OURS}: vx_samples: too few\n', True))
        differs, broken = printed(bench.show_faults, {'naive_' + OURS: case(agreeing=0.5)})
        self.assertIn('in 50% of the situations only', differs)
        self.assertFalse(broken)
        self.assertEqual(printed(bench.show_faults, {'naive_' + OURS: case(agreeing=1.0)}), ('', False))


class Run(unittest.TestCase):
    """With a benchmark that writes what it is told to."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.makedirs(os.path.join(self.folder, 'test', 'benchmark'))
        for name, value in (('FOLDER', self.folder), ('RATIOS', os.path.join(self.folder, 'ratios.json'))):
            patch = mock.patch.object(bench, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def run_bench(self, script, *arguments):
        """(exit status, output, complaints) of scripts/bench --no-build."""
        program = os.path.join(self.folder, 'test', 'benchmark', 'hidwa_benchmark')
        with open(program, 'w', encoding='utf-8') as out:
            out.write('#!/bin/sh\n' + script)
        os.chmod(program, 0o755)
        with contextlib.redirect_stderr(io.StringIO()) as complaints:
            said, status = printed(bench.main, ['--no-build', '--json', os.path.join(self.folder, 'bench.json'), *arguments])
        return status, said, complaints.getvalue()

    def writes(self, cases):
        """A script that leaves these cases in the file it is told to."""
        text = json.dumps({'benchmarks': [{'name': name, **values} for name, values in cases.items()]})
        return f'for a; do case $a in --benchmark_out=*) cat > "${{a#*=}}" <<END\n{text}\nEND\nesac; done\n'

    def test_a_missed_bound_is_no_failure(self):
        status, said, complaints = self.run_bench(self.writes({OURS: case(500.0, 900.0), 'naive_' + OURS: case(1000.0)}))
        self.assertEqual((status, complaints), (0, ''))
        self.assertIn('bounds: 1 of 3 met', said)
        self.assertIn('0 recorded, 0 fell', said)
        self.assertFalse(os.path.exists(bench.RATIOS))

    def test_record_then_fall(self):
        status, said, _ = self.run_bench(self.writes({OURS: case(50.0), 'naive_' + OURS: case(500.0)}), '--record')
        self.assertEqual(status, 0)
        self.assertIn('1 recorded in', said)
        _, said, _ = self.run_bench(self.writes({OURS: case(70.0), 'naive_' + OURS: case(500.0)}))
        self.assertIn(f'  FELL    {OURS}: 10.0 recorded, 7.1 now', said)

    def test_a_case_that_fails_does(self):
        self.assertEqual(self.run_bench(self.writes({OURS: {'error_message': 'no such critic'}}))[0], 2)
        self.assertEqual(self.run_bench(self.writes({OURS: {'error_message': 'cannot read worlds.txt'}}))[0], 0)

    def test_the_benchmark_does_not_run(self):
        status, _, complaints = self.run_bench('echo "it says why" >&2; exit 1', '--filter', 'nonsense')
        self.assertEqual(status, 2)
        self.assertIn("does 'nonsense' name a case?", complaints)
        self.assertIn('it says why', complaints)
        os.remove(os.path.join(self.folder, 'test', 'benchmark', 'hidwa_benchmark'))
        with contextlib.redirect_stderr(io.StringIO()) as complaints:
            _, status = printed(bench.main, ['--no-build'])
        self.assertEqual(status, 2)
        self.assertIn('hidwa_benchmark', complaints.getvalue())

    def test_quick_and_filter_reach_it(self):
        script = f'echo "$@" > {self.folder}/arguments\n' + self.writes({OURS: case()})
        self.run_bench(script, '--quick', '--filter', 'cycle/819')
        with open(os.path.join(self.folder, 'arguments'), encoding='utf-8') as text:
            arguments = text.read()
        self.assertIn('--benchmark_filter=cycle/819', arguments)
        self.assertIn('--quick', arguments)


if __name__ == '__main__':
    unittest.main()
