# SPDX-License-Identifier: BSD-3-Clause
"""report.json and report.png out of a bag."""
import argparse
import json
import os
import sys

from . import geometry
from .bag import TOPICS, Names, read_drives
from .errors import BagError
from .measure import driven_without_goal, measure
from .options import positive

NO_PICTURE = 'matplotlib is not installed: apt-get install python3-matplotlib'
NAMED = ('odom', 'scan', 'cmd_vel', 'joy', 'map', 'goal')  # topics that can be named


def write_report(bag, folder, names=None, goal=None):
    """Writes report.json and report.png into the folder and returns the report. A bag with several goals has a list of
    reports instead, {'goals': [...]}, and report_1.png, report_2.png, ...; `goal` (from 1) asks for one of them alone.
    Without matplotlib, which a robot need not have, there is no picture, and `no_picture` says so."""
    draw, remark = _drawing()
    drives = read_drives(bag, names)
    if goal is not None:
        if not 1 <= goal <= len(drives):
            raise BagError(f'{bag} has no goal {goal}: it holds {len(drives)}, counted from 1')
        drives = [drives[goal - 1]]
    else:
        remark = {'driven_without_goal_s': driven_without_goal(drives[0]), **remark}  # any drive has the whole bag's states
    if len(drives) == 1:
        report = {**_measured(bag, drives[0]), **remark}
        _write(folder, report)
        draw(drives[0], report, os.path.join(folder, 'report.png'), _title(bag, drives[0]))
        return report
    reports = []
    for i, drive in enumerate(drives, 1):
        try:
            report = _measured(bag, drive)
        except BagError as fault:
            reports.append({'goal_number': i, 'arrived': drive.arrived, 'outcome': drive.result_text, 'not_measured': str(fault)})
            continue
        reports.append({'goal_number': i, **report})
        os.makedirs(folder, exist_ok=True)
        draw(drive, report, os.path.join(folder, f'report_{i}.png'), f'{os.path.basename(bag)}, goal {i} of {len(drives)}')
    report = {'goals': reports, **remark}
    _write(folder, report)
    return report


def _drawing():
    """(how a drive is drawn, what the report says of that)"""
    try:
        from .figure import draw
    except ModuleNotFoundError as fault:
        if fault.name != 'matplotlib':
            raise
        return (lambda *_: None), {'no_picture': NO_PICTURE}
    return draw, {}


def _measured(bag, drive):
    try:
        return measure(drive)
    except ValueError as fault:
        raise BagError(f'{bag}: {fault}') from fault


def _write(folder, report):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, 'report.json'), 'w', encoding='utf-8') as out:
        json.dump(report, out, indent=2)
        out.write('\n')


def _title(bag, drive):
    """How the picture calls a drive that has no map's name."""
    return None if drive.demo else os.path.basename(bag)


def outline(text):
    """[[x, y], ...] [m] of at least three corners."""
    try:
        corners = json.loads(text)
        if len(corners) < 3 or any(len(c) != 2 or not all(isinstance(v, (int, float)) for v in c) for c in corners):
            raise ValueError
    except (TypeError, ValueError):
        raise argparse.ArgumentTypeError(f"'{text}' is no outline: give [[x, y], [x, y], [x, y], ...] in m") from None
    return corners


def _parser():
    parser = argparse.ArgumentParser(
        prog='scripts/report', description="Computes length, contacts, regions, the person's effect and the cycle times of a "
        'drive from its bag alone, and draws it. The bag may be any: of scripts/demo, of record:= on a real robot, or one that '
        'holds no more than odometry. What it lacks is listed. Several goals have a section and a picture each.')
    parser.add_argument('bag', help='the bag; one that was cut short is read from a repaired copy')
    parser.add_argument('--out', metavar='DIR', help='where report.json and report.png go (default: beside the bag)')
    parser.add_argument('--goal', type=int, metavar='N', help='the N-th goal alone, from 1')
    parser.add_argument('--footprint', type=outline, metavar='[[X,Y],...]', help="the robot's outline in its frame [m]")
    parser.add_argument('--radius', type=positive, metavar='R', help='the same of a round robot [m]')
    parser.add_argument('--namespace', default='', metavar='/NS', help='topics below it, where a bag holds several robots')
    parser.add_argument('--base-frame', metavar='FRAME', help="the robot's frame (default: the odometry's child, base_link)")
    parser.add_argument('--map-frame', metavar='FRAME', help='the frame to draw in (default: map, else odometry)')
    for key in NAMED:
        parser.add_argument(f'--{key}-topic'.replace('_', '-'), metavar='TOPIC', help=f'(default: {TOPICS[key][1]}, or by its type)')
    return parser


def main(arguments=None):
    """scripts/report"""
    options = _parser().parse_args(arguments)
    footprint = options.footprint or (geometry.circle(options.radius, 64).tolist() if options.radius else None)
    namespace = '/' + options.namespace.strip('/') if options.namespace.strip('/') else ''
    topics = {key: getattr(options, key + '_topic') for key in NAMED if getattr(options, key + '_topic')}
    map_frame = options.map_frame and options.map_frame.lstrip('/')
    names = Names(topics, namespace, options.base_frame, map_frame, footprint)
    try:
        report = write_report(options.bag, options.out or os.path.dirname(os.path.abspath(options.bag)), names, options.goal)
    except BagError as fault:
        print(f'scripts/report: {fault}', file=sys.stderr)
        return 2
    print(json.dumps(report, indent=2))
    return 0


if __name__ == '__main__':
    sys.exit(main())
