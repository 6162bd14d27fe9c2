# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench, once everything needed is installed: builds, measures, and compares with bounds and records."""
import argparse
import json
import os
import subprocess
import sys

from .bounds import judge
from .places import ROOT, SPACE
from .plain_build import BuildError, build

FOLDER = os.path.join(SPACE, 'build', 'bench')
RATIOS = os.path.join(ROOT, 'test', 'benchmark', 'ratios.json')
FALL = 0.2  # a ratio that fell by more than this part is shown


class BenchError(Exception):
    """Something did not run."""


def measure(pattern, quick, path):
    """Runs the benchmark, its JSON into a file, and returns its cases by name: counters, or a fault in words."""
    command = [os.path.join(FOLDER, 'test', 'benchmark', 'hidwa_benchmark'), f'--benchmark_filter={pattern}',
               f'--benchmark_out={path}', '--benchmark_out_format=json']
    # Its own table is too wide to read; a line a case shows that it moves.
    with subprocess.Popen(command + ['--quick'] * quick, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
        for line in run.stdout:
            name = line.split(' ')[0]
            if '/' in name and sys.stderr.isatty():
                print(f'\r\x1b[K{name}', end='', file=sys.stderr, flush=True)
        complaint = run.stderr.read()
    if sys.stderr.isatty():
        print('\r\x1b[K', end='', file=sys.stderr, flush=True)
    if run.returncode:
        raise BenchError(f"hidwa_benchmark ended with status {run.returncode}: does '{pattern}' name a case?\n{complaint}")
    with open(path, encoding='utf-8') as text:
        return {case['name']: case for case in json.load(text)['benchmarks']}


def ratios(cases):
    """How many times longer the straightforward cycle takes, for every case that both ran."""
    found = {}
    for name, case in cases.items():
        naive = cases.get(f'naive_{name}')
        if name.startswith('cycle/') and naive and 'p50_cpu_us' in naive and 'p50_cpu_us' in case:
            found[name] = round(naive['p50_cpu_us'] / case['p50_cpu_us'], 2)
    return found


def time(value):
    """Microseconds for a column."""
    return f'{value:.0f}' if value >= 100.0 else f'{value:.1f}'


def table(cases, found):
    """The measured cases, one a line."""
    rows = [('case', 'candidates', 'cycles', 'p50 us', 'p99 us', 'p50 cpu', 'p99 cpu', 'ns/pose', 'allocations', 'naive/ours')]
    for name, case in cases.items():
        if 'p50_us' not in case:
            continue
        rows.append((name, f"{case['candidates']:.0f}", f"{case['cycles']:.0f}", time(case['p50_us']), time(case['p99_us']),
                     time(case['p50_cpu_us']), time(case['p99_cpu_us']), f"{case['ns_per_pose']:.2f}",
                     f"{case['allocations']:.1f}", f'{found[name]:.1f}' if name in found else ''))
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return '\n'.join('  '.join(text.ljust(width) if column == 0 else text.rjust(width)
                               for column, (text, width) in enumerate(zip(row, widths))).rstrip() for row in rows)


def show_samples(cases):
    """What finer samples buy, one line a sampling."""
    for name, case in cases.items():
        if name.startswith('samples/') and 'omega_change' in case:
            refused = (f"; where the wish is refused, what is chosen deviates by {case['deviation']:.1f} (J {case['excess']:.1f} "
                       f"above the finest samples')" if 'deviation' in case else '')
            print(f"{name}: mean change of omega {case['omega_change']:.4f} rad/s{refused}")


def show_drives(cases):
    """The drives, one a line."""
    for name, case in cases.items():
        if 'times_real_time' in case:
            print(f"{name}: {case['driven_m']:.0f} m in {case['simulated_s']:.0f} s of simulated time, "
                  f"{case['times_real_time']:.0f} times real time; {case['planning']:.0%} of it is planning")


def read_ratios():
    """What was recorded; nothing where nothing was."""
    try:
        with open(RATIOS, encoding='utf-8') as text:
            return json.load(text)
    except FileNotFoundError:
        return {}


def record(found):
    """Keeps the ratios; those of cases that did not run stay as they were."""
    kept = {**read_ratios(), **found}
    with open(RATIOS, 'w', encoding='utf-8') as out:
        json.dump(kept, out, indent=2, sort_keys=True)
        out.write('\n')


def show_ratios(found):
    """The cases that fell behind their record."""
    recorded = read_ratios()
    known = [name for name in found if name in recorded]
    fallen = [name for name in known if found[name] < (1.0 - FALL) * recorded[name]]
    print(f'\nratios to the straightforward cycle: {len(known)} recorded, {len(fallen)} fell by more than {FALL:.0%}')
    for name in fallen:
        print(f'  FELL    {name}: {recorded[name]:.1f} recorded, {found[name]:.1f} now')


def show_faults(cases):
    """What was left out, and where the two cycles choose differently. True when something other than data was missing."""
    broken = False
    for name, case in cases.items():
        if 'error_message' in case:
            absent = case['error_message'].startswith('cannot read ')
            broken = broken or not absent
            print(f"  {'left out' if absent else 'FAILED'}  {name}: {case['error_message']}")
        elif case.get('agreeing', 1.0) < 1.0:
            print(f"  differs {name}: it chooses as the planner does in {case['agreeing']:.0%} of the situations only")
    return broken


def show_bounds(cases):
    """Which bounds are met, one a line."""
    verdicts = judge(cases)
    met = sum(verdict.met for verdict in verdicts)
    print(f'\nbounds: {met} of {len(verdicts)} met')
    for verdict in verdicts:
        print(f'  {verdict}')


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(
        prog='scripts/bench', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds hidwa_benchmark and shows how long a cycle takes, beside a\n'
        'straightforward cycle that chooses the same (naive_cycle), and which bounds are met.',
        epilog='cases: cycle/CANDIDATES/CELLS/circle|polygon/open|tight, cycle_cached/... (one situation again and again),\n'
        'cycle_watched/... (collisions of all candidates, as for subscribers), naive_cycle/...,\n'
        'and whole drives in simulated time: drive/office/alone|steered. samples/VxOMEGA: what so many samples buy.\n'
        'p50 and p99 are of single cycles by the wall clock; "cpu" are the same by the thread\'s own time, which others on\n'
        'the machine do not lengthen: by it ns/pose and ratios are made. A missed bound does not change the exit status.\n'
        'exit status: 0 everything ran; 2 something did not\n'
        'environment: HIDWA_DATA=DIR the real data, barn/worlds.txt for "tight" (default: ../shared/data); HIDWA_SPACE and\n'
        'HIDWA_INSTALL: scripts/build --help')
    parser.add_argument('--filter', default='.', metavar='REGEX', help='only cases whose name it matches somewhere')
    parser.add_argument('--quick', action='store_true', help='a tenth of the cycles, for a first look')
    parser.add_argument('--record', action='store_true', help='keep the ratios in test/benchmark/ratios.json')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    parser.add_argument('--json', metavar='FILE', default=os.path.join(FOLDER, 'bench.json'),
                        help='where the figures go (default: build/bench/bench.json)')
    return parser.parse_args(arguments)


def main(arguments=None):
    """scripts/bench"""
    options = parse(arguments)
    try:
        if not options.no_build:
            print('==> building', flush=True)
            build('hidwa_benchmark', FOLDER, ['-DHIDWA_TESTS=OFF', '-DHIDWA_BENCHMARKS=ON'])
        print('==> measuring', flush=True)
        cases = measure(options.filter, options.quick, os.path.abspath(options.json))
    except (BenchError, BuildError, OSError) as fault:
        print(f'scripts/bench: {fault}', file=sys.stderr)
        return 2
    found = ratios(cases)
    print(table(cases, found))
    show_drives(cases)
    show_samples(cases)
    broken = show_faults(cases)
    show_bounds(cases)
    show_ratios(found)
    if options.record:
        record(found)
        print(f'  {len(found)} recorded in {os.path.relpath(RATIOS, ROOT)}')
    return 2 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
