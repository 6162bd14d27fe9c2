# SPDX-License-Identifier: BSD-3-Clause
"""What a soak measures, minute by minute, and what it must come to. Standard library only."""
import collections
import csv
import json
import os

MEMORY_STEPS = 16.0   # [MB] that the host may grow after its first minute: what is needed for the first time, as to search a way
MEMORY_SLACK = 2.0    # [MB] that it may grow in the second half
BUSY = 1.5            # load a core; a minute with more says nothing of times
SLOWER = 1.5          # p99 of the last third of the minutes over that of the first; and
SLOWER_BY = 2.0       # [ms] more at the least

# A minute of simulated time. memory: of the host, resident [MB]; p99: of the cycles' time [ms]; late: cycles that came more than
# half a period late; lost: cycles of which nobody heard; abrupt: zeros that the host sent itself; load: of the machine, a core.
Minute = collections.namedtuple('Minute', 'minute memory cycles p99 late lost goals disturbances abrupt contacts load faults')


def quantile(values, share):
    """The value below which this share of the values lies; nan where there are none."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else float('nan')


def lateness(stamps, period, pause):
    """How many of the gaps between cycles [s] are more than half a period too long. A gap beyond `pause` is the host's: it had no
    goal, or recovered. One below zero is a clock that jumped."""
    gaps = [after - before for before, after in zip(stamps, stamps[1:])]
    return sum(1.5 * period < gap <= pause for gap in gaps)


def lost(numbers):
    """How many are missing in an ascending row of sequence numbers."""
    return sum(max(0, after - before - 1) for before, after in zip(numbers, numbers[1:]))


def quiet_ones(minutes):
    """The minutes, from the second on, in which the machine was not too busy to measure times."""
    return [minute for minute in minutes[1:] if minute.load <= BUSY]


def verdict(minutes):
    """What did not hold, in words. Memory and times are judged from the second minute on."""
    found = [f'minute {minute.minute}: {fault}' for minute in minutes for fault in minute.faults]
    found += [f'minute {minute.minute}: the planner was not called once' for minute in minutes if not minute.cycles]
    if sum(minute.lost for minute in minutes):
        found.append(f'{sum(minute.lost for minute in minutes)} cycles of which nobody heard')
    settled = minutes[1:]
    if len(settled) < 3:
        return found
    for begin, allowed, when in ((0, MEMORY_STEPS, 'after its first minute'), (len(settled) // 2, MEMORY_SLACK, 'in the second half')):
        grown = settled[-1].memory - settled[begin].memory
        if grown > allowed:
            found.append(f'the host grew by {grown:.1f} MB {when} ({allowed:g} MB is allowed)')
    quiet = quiet_ones(minutes)
    if len(quiet) < 3:
        return found
    third = len(quiet) // 3
    first, last = quiet[:third], quiet[-third:]
    before, after = (quantile([minute.p99 for minute in part], 0.5) for part in (first, last))
    if after > max(SLOWER * before, before + SLOWER_BY):
        found.append(f'p99 of the cycle time rose from {before:.1f} to {after:.1f} ms')
    return found


def summary(minutes):
    """The whole run as a dict."""
    settled = minutes[1:] or minutes
    return {
        'minutes': len(minutes), 'cycles': sum(m.cycles for m in minutes), 'late_cycles': sum(m.late for m in minutes),
        'lost_cycles': sum(m.lost for m in minutes), 'goals': sum(m.goals for m in minutes),
        'disturbances': sum(m.disturbances for m in minutes), 'abrupt_stops_of_the_host': sum(m.abrupt for m in minutes),
        'contacts': minutes[-1].contacts if minutes else 0,
        'memory_after_the_first_minute_mb': settled[0].memory if settled else None,
        'memory_at_the_end_mb': settled[-1].memory if settled else None,
        'p99_first_minute_ms': settled[0].p99 if settled else None, 'p99_last_minute_ms': settled[-1].p99 if settled else None,
        'p99_largest_ms': max((m.p99 for m in settled), default=None), 'minutes_judged_for_times': len(quiet_ones(minutes)),
        'found': verdict(minutes)}


def write(minutes, folder):
    """soak.csv, a line a minute, and summary.json."""
    with open(os.path.join(folder, 'soak.csv'), 'w', encoding='utf-8', newline='') as out:
        table = csv.writer(out)
        table.writerow(Minute._fields)
        table.writerows(minute._replace(faults='; '.join(minute.faults)) for minute in minutes)
    with open(os.path.join(folder, 'summary.json'), 'w', encoding='utf-8') as out:
        json.dump(summary(minutes), out, indent=1)
