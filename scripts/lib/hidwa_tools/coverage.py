# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test --long coverage: which lines and branches of the parts that decide run under their tests that need no ROS."""
import collections
import csv
import glob
import os
import shutil
import subprocess

from . import sanitize
from .counting import Counts
from .places import ROOT, SPACE

LINES, BRANCHES = 95.0, 90.0  # [%], at least
PARTS = ('core', 'critics', 'input', 'control')
# Without optimisation a test takes a hundred times as long: records, whole drives, campaigns and the longest tests would take
# hours, and could only add to what is counted.
SUITES = ('unit/core', 'unit/input', 'unit/control', 'oracle', 'property')
LEFT_OUT = ('hidwa_check_all_test', 'hidwa_planner_twin_test', 'hidwa_property_test', 'hidwa_twins_test', 'hidwa_walker_attack_test')
FOLDER = os.path.join(SPACE, 'build', 'tests', 'coverage')

Share = collections.namedtuple('Share', 'lines lines_run branches branches_run')


def part_of(path):
    """core, critics, input or control; None for all else. `path`: from the root of the source tree."""
    folders = path.split('/')
    if folders[:2] == ['include', 'hidwa_local_planner']:
        folders = folders[1:]
    return folders[1] if len(folders) > 2 and folders[0] in ('src', 'hidwa_local_planner') and folders[1] in PARTS else None


def percent(run, of):
    """The share that runs [%]; of nothing, all."""
    return 100.0 * run / of if of else 100.0


def shares(rows):
    """{part: Share}, out of the rows of gcovr's CSV."""
    found = {part: Share(0, 0, 0, 0) for part in PARTS}
    for row in rows:
        part = part_of(row['filename'])
        if part:
            own = (row['line_total'], row['line_covered'], row['branch_total'], row['branch_covered'])
            found[part] = Share(*(a + int(b) for a, b in zip(found[part], own)))
    return found


def table(found):
    """(the lines to print, the parts below the bar); a part without lines is below it."""
    lines, below = [f'    {"":10}{"lines":>16}{"":9}{"branches":>16}'], []
    for part, share in found.items():
        of_lines, of_branches = percent(share.lines_run, share.lines), percent(share.branches_run, share.branches)
        lines.append(f'    {part:10}{share.lines_run:>7} of {share.lines:>5} {of_lines:6.1f} %'
                     f'{share.branches_run:>9} of {share.branches:>5} {of_branches:6.1f} %')
        if not share.lines or of_lines < LINES or of_branches < BRANCHES:
            below.append(part)
    return lines, below


def worst_files(rows, most=15):
    """The files that miss most, as lines to print."""
    missed = []
    for row in rows:
        lines, branches = (int(row[f'{kind}_total']) - int(row[f'{kind}_covered']) for kind in ('line', 'branch'))
        if part_of(row['filename']) and lines + branches:
            missed.append((-lines - branches, f"    {row['filename']}: {lines} lines, {branches} branches are not run"))
    return [words for _, words in sorted(missed)[:most]]


def rows_of(root, folder):
    """gcovr's rows of a build folder whose tests have run; a page a file goes to html/ there."""
    out, pages = os.path.join(folder, 'coverage.csv'), os.path.join(folder, 'html')
    os.makedirs(pages, exist_ok=True)
    command = ['gcovr', '--root', root, '--filter', os.path.join(root, 'src', ''), '--filter', os.path.join(root, 'include', ''),
               '--exclude-throw-branches', '--exclude-unreachable-branches', '--csv', out,
               '--html-details', os.path.join(pages, 'index.html'), folder]
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    with open(out, encoding='utf-8', newline='') as text:
        return list(csv.DictReader(text))


def run(without_ros):
    """Counts of the tests and of the parts that reach the bar; `without_ros(name, *options, which)` builds and tests in FOLDER."""
    if not shutil.which('gcovr'):
        raise sanitize.Absent('left out, absent: gcovr (apt-get install gcovr)')
    for old in glob.glob(os.path.join(FOLDER, '**', '*.gcda'), recursive=True):
        os.remove(old)
    counts = without_ros('coverage', f'-DHIDWA_TEST_SUITES={";".join(SUITES)}', '-DHIDWA_COVERAGE=ON', '-DCMAKE_CXX_COMPILER=g++',
                         '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG',
                         which=['-LE', '^long$', *sanitize.ctest_options(LEFT_OUT)])
    rows = rows_of(ROOT, FOLDER)
    lines, below = table(shares(rows))
    print('\n'.join(lines + worst_files(rows)))
    print(f'    line by line: {FOLDER}/html/index.html')
    for part in below:
        print(f'    {part} is below {LINES:g} % of the lines or {BRANCHES:g} % of the branches')
    return counts + Counts(passed=len(PARTS) - len(below), failed=len(below))
