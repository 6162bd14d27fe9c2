# SPDX-License-Identifier: BSD-3-Clause
"""The tests and the table of scripts/platforms: what was tried in each system, and how it went."""
import datetime
import glob
import json
import os
import re
import subprocess
import sys

from . import tests
from .counting import Counts
from .places import SPACE

TRIED_ONLY = ('debian-next',)  # what fails there is told, and does not count
ELSEWHERE = ('long', 'sanitized', 'python', 'console', 'browser', 'lint', 'drive')  # tests that are judged where the project is built
HEADS = ('system', 'compiler', 'CMake', 'Python', 'urdfdom', 'roscpp', 'warnings', 'tests passed', 'failed', 'demo', 'minutes')
WARNING = re.compile(r'^.*\bwarning: .*$', re.MULTILINE)
ERROR = re.compile(r'^(?:.*\berror: .*|CMake Error.*(?:\n+ .*)?)$', re.MULTILINE)
FEW = 5  # of one kind of fault are told


def output_of(*command):
    """What a command prints, errors too, whatever its exit status."""
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors='replace', check=False).stdout


def first_number(text):
    """The first version number in a text; `?` where there is none."""
    found = re.search(r'\d+(\.\d+)+', text)
    return found.group() if found else '?'


def versions():
    """What this system builds with."""
    package = {name: first_number(output_of('dpkg-query', '-W', '-f', '${Version}', f'lib{name}-dev')) for name in ('urdfdom', 'roscpp')}
    return {'compiler': 'GCC ' + first_number(output_of(os.environ.get('CXX', 'g++'), '-dumpfullversion')),
            'CMake': first_number(output_of('cmake', '--version')), 'Python': '.'.join(map(str, sys.version_info[:3])), **package}


def complaints(logs, pattern):
    """The matches in the logs of the builds, each once: what is built twice says it twice."""
    found = {}
    for path in sorted(logs):
        with open(path, encoding='utf-8', errors='replace') as text:
            found.update(dict.fromkeys(' '.join(match.split()) for match in pattern.findall(text.read())))
    return list(found)


def run_tests():
    """(counts, names of what failed). What cannot be built is not tested."""
    try:
        tree = tests.configure_tree([*tests.build_package(), *tests.build_rostests()])
    except tests.BuildFailed as fault:
        print(fault, flush=True)
        return Counts(), ['the build']
    return tests.ctest(tree, ['-LE', f'^({"|".join(ELSEWHERE)})$'])


def try_here():
    """Runs the tests in this system, and writes its row of the table."""
    counts, failed = run_tests()
    logs = [path for base in (SPACE, os.path.join(SPACE, 'build', 'tests', 'ros'))
            for path in glob.glob(os.path.join(base, 'log', 'build_*', '**', 'stdout_stderr.log'), recursive=True)]
    row = {**versions(), 'warnings': complaints(logs, WARNING), 'errors': complaints(logs, ERROR), 'passed': counts.passed,
           'failed': counts.failed, 'failed_tests': failed, 'demo': None}
    try:
        with open(os.path.join(SPACE, 'report', 'report.json'), encoding='utf-8') as text:
            report = json.load(text)
        row['demo'] = {key: report[key] for key in ('arrived', 'path_length_m', 'contacts')}
    except OSError:
        pass  # the demo wrote no report
    with open(os.path.join(SPACE, 'row.json'), 'w', encoding='utf-8') as out:
        json.dump(row, out, indent=1)


def faults(row):
    """What keeps a system from being supported, a line each; empty: nothing."""
    if row is None:
        return ['it did not come to its end']
    demo, found = row['demo'], []
    for kind in ('errors', 'warnings', 'failed_tests'):
        lines = row[kind]
        found += [f'{kind.replace("_", " ")[:-1]}: `{line}`' for line in lines[:FEW]]
        if len(lines) > FEW:
            found.append(f'{len(lines) - FEW} more {kind.replace("_", " ")}')
    if not row['passed'] or (row['failed'] and not row['failed_tests']):
        found.append(f"{row['passed']} tests passed, {row['failed']} failed")
    if demo is None or not demo['arrived'] or demo['contacts'] != 0:
        found.append('the demo left no report' if demo is None else 'the demo did not arrive without a contact')
    return found


def cells(name, row, minutes):
    """A line of the table."""
    if row is None:
        return [name] + ['–'] * (len(HEADS) - 2) + [minutes]
    demo = row['demo']
    drive = '–'
    if demo is not None:
        drive = f"{demo['path_length_m']:.1f} m, contacts: {demo['contacts']}" + ('' if demo['arrived'] else ', did not arrive')
    return [name, *(row[key] for key in ('compiler', 'CMake', 'Python', 'urdfdom', 'roscpp')), str(len(row['warnings'])),
            str(row['passed']), str(row['failed']), drive, minutes]


def table(rows, commit, date):
    """(Markdown, whether every supported system is without a fault) of {name: (row or None, minutes)}."""
    lines = [f'{date}, {commit}:', '', '| ' + ' | '.join(HEADS) + ' |', '|' + '---|' * len(HEADS)]
    lines += ['| ' + ' | '.join(cells(name, *of_name)) + ' |' for name, of_name in rows.items()]
    told = {name: faults(row) for name, (row, _) in rows.items()}
    lines += [''] + [f'- {name}: {fault}' for name, found in told.items() for fault in found]
    return '\n'.join(lines).rstrip(), not any(found for name, found in told.items() if name not in TRIED_ONLY)


def read(path, otherwise=None, of=lambda text: text):
    """What a file holds, or something else where there is none."""
    try:
        with open(path, encoding='utf-8') as text:
            return of(text.read())
    except OSError:
        return otherwise


def main(arguments):
    """`try`, in the chroot; `table FOLDER COMMIT NAME...`, outside."""
    if arguments[0] == 'try':
        try_here()
        return 0
    folder, commit, names = arguments[1], arguments[2], arguments[3:]
    rows = {}
    for name in names:
        space = os.path.join(folder, name, 'space')
        rows[name] = read(os.path.join(space, 'row.json'), of=json.loads), read(os.path.join(space, 'minutes'), '–').strip()
    text, well = table(rows, commit, datetime.date.today().isoformat())
    print(text)
    return 0 if well else 1


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
