# SPDX-License-Identifier: BSD-3-Clause
"""scripts/study analyse: the bags that scripts/study live recorded, as hidwa_study's tables, and the study's report."""
import argparse
import csv
import json
import os
import sys

import numpy as np
import yaml

from . import measure
from .bag import read_drives
from .conditions import MODES, course, driven
from .drawing import STATE_NAMES, STEERED
from .errors import BagError
from .gentleness import FIGURES
from .options import existing
from .study_report import ReportError, picture_of, say, write_report

# As lab/study/table.cpp has them.
COLUMNS = ('id', 'experiment', 'participant', 'condition', 'order', 'setting', 'seed', 'ending', 'arrived', 'duration', 'length',
           'regions_crossed', 'contacts', 'operator_active', 'interventions', 'v_change', 'omega_change', 'agreement',
           'clearance', 'mode_errors', 'failures', 'brakes', *FIGURES, 'mean_clearance')
FAR = 1.0              # [m]; up to here clearances are measured, as in drive/result.hpp
WAY_RATE = 20.0        # [Hz] of the ways kept
PEOPLE = ('joystick', None)  # operators of the demo, or of a real robot, that are no simulation
BRAKE, FAIL = 1, 2     # of Cycle.outcome


def number(value):
    """A cell: six decimals as hidwa_study writes them, whole numbers as such, empty where it is not known."""
    return '' if value is None else f'{value:.6f}' if isinstance(value, float) else str(value)


def steered(drive):
    """(time, whether the person gives input) of each state between goal and result."""
    states = drive.during(drive.states)
    return states[:, 0], np.isin(states[:, 1], [STATE_NAMES.index(name) for name in STEERED])


def interventions(drive):
    """How often the person began to steer."""
    _, now = steered(drive)
    return int(np.count_nonzero(now[1:] & ~now[:-1])) + int(len(now) > 0 and now[0])


def agreement(drive):
    """Its mean while the person steers; 1 where they never do, as hidwa_study has it."""
    values, (_, now) = drive.during(drive.agreements)[:, 1], steered(drive)
    return float(values[now].mean()) if now.any() else 1.0


def smallest_clearance(drive):
    """By map and ground truth at each command; of a real robot estimated by its laser; None where neither is there. At most FAR."""
    if drive.contacts_known:
        truth, times = drive.driven(), drive.during(drive.commands)[:, 0]
        rows = truth[np.clip(np.searchsorted(truth[:, 0], times), 0, len(truth) - 1)] if len(times) else truth
        return float(measure.clearance(drive.grid, drive.footprint, rows[:, 1:4], FAR))
    if drive.seen is None or drive.footprint is None:
        return None
    distance, scans, _ = drive.seen.clearance(drive.footprint, drive.goal_time, drive.result_time)
    return None if not scans else FAR if distance is None else min(FAR, distance)


def row_of(participant, order, condition, drive):
    """The line of runs.csv of one drive."""
    figures = measure.measure(drive)
    commands, known = drive.during(drive.commands), len(drive.states) > 0
    outcomes = [outcome for time, outcome in drive.outcomes if drive.goal_time <= time <= drive.result_time]
    return {'id': f'p{participant:02d}_o{order}_{condition}', 'experiment': 'live', 'participant': participant, 'condition': condition,
            'order': order, 'setting': 'default', 'seed': '', 'ending': 'arrived' if drive.arrived else _ending(drive),
            'arrived': int(bool(drive.arrived)), 'duration': number(float(figures['duration_s'])),
            'length': number(float(figures['path_length_m'])), 'regions_crossed': number(figures['regions_crossed']),
            'contacts': number(figures['contacts']),
            'operator_active': number(float(figures['operator_active_s']) if known else None),
            'interventions': number(interventions(drive) if known else None),
            'v_change': number(measure.mean_change(commands[:, 1])), 'omega_change': number(measure.mean_change(commands[:, 2])),
            'agreement': number(agreement(drive) if known else None), 'clearance': number(smallest_clearance(drive)),
            'mode_errors': '', 'failures': number(outcomes.count(FAIL) if outcomes else None),
            'brakes': number(outcomes.count(BRAKE) if outcomes else None),
            **{name: number(figures['turns'][name]) for name in FIGURES}, 'mean_clearance': number(figures['mean_clearance_m'])}


def _ending(drive):
    return drive.result_text.split(':')[0].replace(',', ' ')


def way_of(drive):
    """Rows t, x, y, theta, v, omega, state of a way, at WAY_RATE."""
    truth = drive.driven()
    times = np.arange(truth[0, 0], truth[-1, 0], 1.0 / WAY_RATE)
    at = np.searchsorted(truth[:, 0], times)
    states, commands = drive.states, drive.commands

    def last(rows, time):
        i = np.searchsorted(rows[:, 0], time, side='right') - 1
        return rows[i] if i >= 0 else None
    for time, row in zip(times, truth[at]):
        state, command = last(states, time), last(commands, time)
        v, omega = (command[1], command[2]) if command is not None else (row[4], row[5])
        yield [f'{time - drive.goal_time:.2f}', *(f'{v:.3f}' for v in (*row[1:4], v, omega)),
               STATE_NAMES[int(state[1])] if state is not None else STATE_NAMES[0]]


def read_regions(path):
    """Polygons of a regions file, [(n, 2)]."""
    try:
        with open(path, encoding='utf-8') as text:
            return [np.array(region['polygon'], float).reshape(-1, 2) for region in yaml.safe_load(text)['regions']]
    except (OSError, KeyError, TypeError, ValueError, yaml.YAMLError) as fault:
        raise ReportError(f'{path} cannot be read as regions: {fault}') from fault


def drive_of(path, condition, regions):
    """The drive in a bag, which must have been driven in the condition's mode."""
    drives = read_drives(path)
    if len(drives) > 1:
        raise ReportError(f'{path} holds {len(drives)} goals; a drive of a study has one. scripts/report {path} shows them')
    drive = drives[0]
    mode = drive.info.get('mode')
    if mode is not None and mode != MODES[condition]:
        raise ReportError(f'{path} was driven in mode {mode}, but {condition} is {MODES[condition]}: the name or the drive is wrong; '
                          'correct its name or move it away')
    if regions is not None:
        drive.regions = regions
    return drive


def analyse(folder, regions=None):
    """Writes runs.csv, paths/ and study.json; (what is worth saying, the floor to draw on or None)."""
    found = driven(folder)
    if not found:
        raise ReportError(f'{folder} holds no bags like p07_o1_SJ.bag: scripts/study live records them')
    twice = [path for i, (who, _, condition, path) in enumerate(found) if any(f[0] == who and f[2] == condition for f in found[:i])]
    if twice:
        raise ReportError(f'{twice[0]} is the second drive of that participant in that condition: move one of them away')
    rows, said, simulated, floor, cut = [], [], set(), None, []
    os.makedirs(os.path.join(folder, 'paths'), exist_ok=True)
    for participant, order, condition, path in found:
        drive = drive_of(path, condition, regions)
        try:
            row = row_of(participant, order, condition, drive)
        except ValueError as fault:
            raise ReportError(f'{path}: {fault}') from fault
        rows.append(row)
        if drive.info.get('operator') not in PEOPLE:
            simulated.add(participant)
        if drive.notes:
            cut.append(row['id'])
        if course(participant)[order - 1:order] != (condition,):
            said.append(f'{row["id"]}: out of the order {", ".join(course(participant))} of participant {participant}')
        floor = picture_of(drive.grid) if drive.grid is not None else floor
        with open(os.path.join(folder, 'paths', row['id'] + '.csv'), 'w', encoding='utf-8', newline='') as out:
            way = csv.writer(out, lineterminator='\n')
            way.writerow(['t', 'x', 'y', 'theta', 'v', 'omega', 'state'])
            way.writerows(way_of(drive))
    with open(os.path.join(folder, 'runs.csv'), 'w', encoding='utf-8', newline='') as out:
        table = csv.DictWriter(out, COLUMNS, lineterminator='\n')
        table.writeheader()
        table.writerows(rows)
    people = sorted({row['participant'] for row in rows})
    for who in people:
        missing = [c for c in course(who) if not any(row['participant'] == who and row['condition'] == c for row in rows)]
        if missing:
            said.append(f'participant {who} has not driven {", ".join(missing)}')
    said += [f'{name}: the recording was cut short or damaged' for name in cut]
    for column in COLUMNS[9:]:
        unknown = [row['id'] for row in rows if row[column] == '']
        if unknown and column != 'mode_errors':
            said.append(f'{column} is not known of {", ".join(unknown) if len(unknown) < len(rows) else "any drive"}')
    with open(os.path.join(folder, 'study.json'), 'w', encoding='utf-8') as out:
        json.dump({'experiment': 'live', 'participants': len(people), 'simulated': sorted(simulated), 'remarks': said}, out, indent=2)
        out.write('\n')
    return said, floor


def main(arguments=None):
    """scripts/study analyse"""
    parser = argparse.ArgumentParser(
        prog='scripts/study analyse', description="Makes hidwa_study's tables (runs.csv, paths/) and the study's report of the bags that "
        'scripts/study live recorded, with the answers in questionnaires.csv and choices.csv where they are (docs/use/study.md).')
    parser.add_argument('folder', metavar='DIR')
    parser.add_argument('--map', type=existing, metavar='FILE.yaml', help="the floor to draw (default: the bags')")
    parser.add_argument('--regions', type=existing, metavar='FILE.yaml',
                        help='regions to avoid in the map, where the bags hold none: of a real robot crossing them is an estimate')
    options = parser.parse_args(arguments)
    try:
        said, floor = analyse(options.folder, read_regions(options.regions) if options.regions else None)
        page = write_report(options.folder, options.map, floor)
        for line in said:
            print(f'==> {line}')
        say(options.folder, page)
    except (ReportError, BagError) as fault:
        print(f'scripts/study analyse: {fault}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main())
