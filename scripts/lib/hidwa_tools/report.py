# SPDX-License-Identifier: BSD-3-Clause
"""report.json and report.png out of a bag."""
import argparse
import json
import os
import sys

from .bag import read_drive
from .errors import BagError
from .figure import draw
from .measure import measure


def write_report(bag, folder):
    """Writes report.json and report.png into the folder and returns the report."""
    drive = read_drive(bag)
    try:
        report = measure(drive)
    except ValueError as fault:
        raise BagError(f'{bag}: {fault}') from fault
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, 'report.json'), 'w', encoding='utf-8') as out:
        json.dump(report, out, indent=2)
        out.write('\n')
    draw(drive, report, os.path.join(folder, 'report.png'))
    return report


def main(arguments=None):
    """scripts/report"""
    parser = argparse.ArgumentParser(
        prog='scripts/report', description='Recomputes length, contacts, regions, the person\'s effect and the cycle '
        'times of a drive from its bag alone, and draws it.')
    parser.add_argument('bag', help='recorded by scripts/demo')
    parser.add_argument('--out', metavar='DIR', help='where report.json and report.png go (default: beside the bag)')
    options = parser.parse_args(arguments)
    try:
        report = write_report(options.bag, options.out or os.path.dirname(os.path.abspath(options.bag)))
    except BagError as fault:
        print(f'scripts/report: {fault}', file=sys.stderr)
        return 2
    print(json.dumps(report, indent=2))
    return 0


if __name__ == '__main__':
    sys.exit(main())
