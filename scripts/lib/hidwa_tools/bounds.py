# SPDX-License-Identifier: BSD-3-Clause
"""What a cycle and a drive may cost, and which measured cases keep to it."""
import re
from dataclasses import dataclass

# Cases and the most that a quantile of theirs may be [us].
TIMES = (
    (r'cycle/819/120/polygon/(tight|open)', 'p50', 100.0),
    (r'cycle/819/120/polygon/(tight|open)', 'p99', 250.0),
    (r'cycle/2000x56/200/polygon/(tight|open)', 'p99', 600.0),
    (r'cycle/100000/.*', 'p50', 10000.0),
)
GROWTH = 1.25     # of a pose's time from 2,000 to 100,000 candidates
REAL_TIME = 50.0  # how many times faster than real time a whole drive runs, at least


@dataclass
class Verdict:
    """One bound on one case."""
    text: str
    met: bool
    note: str = ''

    def __str__(self):
        return f"{'met   ' if self.met else 'MISSED'}  {self.text}{self.note}"


def judge_times(cases):
    """Quantiles by the wall clock; where only that is too long, the thread's own time tells whose fault it is."""
    verdicts = []
    for pattern, quantile, most in TIMES:
        for name, case in cases.items():
            if not re.fullmatch(pattern, name) or 'p50_us' not in case:
                continue
            wall, cpu = case[f'{quantile}_us'], case[f'{quantile}_cpu_us']
            busy = wall > most >= cpu
            verdicts.append(Verdict(f'{name}: {quantile} {wall:.0f} us, at most {most:.0f}', wall <= most,
                                    f'; {cpu:.0f} us by its own time, the machine was busy' if busy else ''))
    return verdicts


def judge_kernel(cases):
    """What a pose costs with the same situation again and again: hardly more for many."""
    verdicts = []
    for name, case in cases.items():
        many = cases.get(name.replace('/2000/', '/100000/'), {})
        if not name.startswith('cycle_cached/2000/') or 'ns_per_pose' not in case or 'ns_per_pose' not in many:
            continue
        growth = many['ns_per_pose'] / case['ns_per_pose']
        verdicts.append(Verdict(f"{name}: {case['ns_per_pose']:.2f} ns a pose, {many['ns_per_pose']:.2f} at 100,000 candidates: "
                                f'{growth:.2f} times, at most {GROWTH}', growth <= GROWTH))
    return verdicts


def judge_allocations(cases):
    """A cycle allocates nothing."""
    measured = {name: case['allocations'] for name, case in cases.items()
                if name.startswith(('cycle/', 'cycle_cached/', 'cycle_watched/')) and 'allocations' in case}
    if not measured:
        return []
    worst = max(measured, key=measured.get)
    return [Verdict(f'allocations a cycle: {measured[worst]:.1f} in {worst}, at most 0', measured[worst] == 0.0)]


def judge_drives(cases):
    """Whole drives by the wall clock."""
    verdicts = []
    for name, case in cases.items():
        if not name.startswith('drive/') or 'times_real_time' not in case:
            continue
        times, cpu = case['times_real_time'], case['times_real_time_cpu']
        busy = times < REAL_TIME <= cpu
        verdicts.append(Verdict(f'{name}: {times:.0f} times real time, at least {REAL_TIME:.0f}', times >= REAL_TIME,
                                f'; {cpu:.0f} times by its own time, the machine was busy' if busy else ''))
    return verdicts


def judge(cases):
    """Every bound on every case that was measured."""
    return judge_times(cases) + judge_kernel(cases) + judge_allocations(cases) + judge_drives(cases)
