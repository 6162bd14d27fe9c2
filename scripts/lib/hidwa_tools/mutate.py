# SPDX-License-Identifier: BSD-3-Clause
"""scripts/mutate, once everything needed is installed: puts deliberate faults into a copy of the sources, one at a time, and asks the
tests that need no ROS whether they notice."""
import argparse
import csv
import filecmp
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree

from . import mutation
from .places import ROOT, SPACE

FOLDER = os.path.join(SPACE, 'build', 'mutate')
FOLDERS = ('src/core', 'src/input', 'src/control')
LIBRARY = 'libhidwa_core.'  # that all of these belong to
EQUIVALENT = os.path.join(ROOT, 'test', 'mutation', 'equivalent.txt')
PARTS = ('CMakeLists.txt', 'cmake', 'src', 'lab', 'include', 'test', 'launch', 'maps', 'urdf', 'scripts')  # what the tests need
SUITES = ('unit/core', 'unit/input', 'unit/control', 'unit/record', 'oracle', 'property', 'attack')
CLOSED_LOOP = ('unit/drive', 'closed_loop')  # with --closed-loop: they take as long as all others together
MEMORY = 6 << 30     # [byte], of a test: a fault may ask for all there is
BAR = 95.0           # [%]
SLOW_CASE = 3.0      # [s], of one case of a program
SLOW = ' (slow cases)'
OUTPUT = '--gtest_output=xml:'
CORES = os.cpu_count() or 1


class MutateError(Exception):
    """It cannot go on; the text says why."""


def files_below(path):
    """The files of a folder, or the file."""
    if os.path.isfile(path):
        return [path]
    return [os.path.join(place, name) for place, _, names in os.walk(path) for name in names]


def slow_cases(command):
    """{name: seconds} of the cases that took long, out of what a GoogleTest program has written; of another program none."""
    for word in command:
        if word.startswith(OUTPUT):
            cases = xml.etree.ElementTree.parse(word[len(OUTPUT):]).getroot().iter('testcase')
            times = {f"{case.get('classname')}.{case.get('name')}": float(case.get('time', 0.0)) for case in cases}
            return {name: seconds for name, seconds in times.items() if seconds > SLOW_CASE}
    return {}


def is_long(test):
    """Whether a test, as ctest lists it, is left to the long form."""
    return any(one['name'] == 'LABELS' and 'long' in one['value'] for one in test.get('properties', []))


def is_script(test):
    """Whether a test runs no program that was built."""
    return test.get('command', [''])[0].endswith('python3')


class Tests:
    """The tests of the build folder, and how long each takes without a fault."""

    def __init__(self, build, whole):
        self._build, self._kills, self.time = build, {}, {}
        self.names = [test['name'] for test in self._listing() if not is_script(test) and (whole or not is_long(test))]
        self._commands = {}

    def _listing(self):
        listing = subprocess.run(['ctest', '--show-only=json-v1'], cwd=self._build, stdout=subprocess.PIPE, check=True).stdout
        return json.loads(listing)['tests']

    def programs(self):
        """The targets to build: the long form of a test is the same program."""
        return sorted({re.sub('_long$', '', name) for name in self.names})

    def find_programs(self):
        """Those that have the library in them that the faults are put into; once they are built."""
        self._commands = {test['name']: test['command'] for test in self._listing()
                          if test['name'] in self.names and 'command' in test and LIBRARY in self._libraries(test['command'])}
        if not self._commands:
            raise MutateError(f'no test has {LIBRARY} in it: nothing would find a fault')

    def _libraries(self, words):
        programs = [word for word in words if word.startswith(self._build) and os.path.isfile(word)]
        return subprocess.run(['ldd', *programs], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout

    def measure(self, quick):
        """Runs them; one that fails without a fault finds nothing. Of a program whose cases take seconds, those become a test
        of their own that comes later; with `quick` none at all."""
        for name in sorted(self._commands):
            begin = time.monotonic()
            if self._run(name, 3600.0):
                raise MutateError(f'{name} fails without any fault: see {self._build}/{name}.log')
            self.time[name] = time.monotonic() - begin
            print(f'    {name}: {self.time[name]:.1f} s', flush=True)
            self._set_apart(name, quick)

    def _set_apart(self, name, quick):
        slow = slow_cases(self._commands[name])
        if not slow:
            return
        command, seconds, cases = self._commands[name], sum(slow.values()), ':'.join(sorted(slow))
        self._commands[name], self.time[name] = [*command, '--gtest_filter=-' + cases], max(0.0, self.time[name] - seconds)
        if not quick:
            self._commands[name + SLOW], self.time[name + SLOW] = [*command, '--gtest_filter=' + cases], seconds

    def _run(self, name, patience):
        """Exit status, or 'time'."""
        def bound():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        with open(os.path.join(self._build, name + '.log'), 'wb') as log:
            child = subprocess.Popen(self._commands[name], cwd=self._build, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                     preexec_fn=bound, start_new_session=True, env={**os.environ, 'GTEST_FAIL_FAST': '1'})
            try:
                return child.wait(patience)
            except subprocess.TimeoutExpired:
                return 'time'
            finally:
                if child.poll() is None:
                    os.killpg(child.pid, signal.SIGKILL)
                    child.wait()

    def order(self, path):
        """Those first that have found most faults of this file's folder in their time; among the others the shortest."""
        folder = os.path.dirname(path)

        def worth(name):
            return (self._kills.get((folder, name), 0) + 0.1) / (self.time[name] + 0.5)
        return sorted(self._commands, key=worth, reverse=True)

    def finds(self, path):
        """The test that fails now, with a fault in this file; None where all pass."""
        folder = os.path.dirname(path)
        for name in self.order(path):
            if self._run(name, 10.0 + 4.0 * self.time[name]):
                self._kills[folder, name] = self._kills.get((folder, name), 0) + 1
                return name
        return None


class Tree:
    """A copy of the sources, and its build."""

    def __init__(self, jobs, closed_loop):
        self.source, self.build, self._jobs = os.path.join(FOLDER, 'source'), os.path.join(FOLDER, 'build'), str(jobs)
        self._suites, self._tools = (SUITES + CLOSED_LOOP, 'ON') if closed_loop else (SUITES, 'OFF')

    def copy(self):
        """As the sources are now; a file that is the same keeps its time, so that little is built anew."""
        wanted = {os.path.relpath(path, ROOT) for part in PARTS for path in files_below(os.path.join(ROOT, part))}
        for path in wanted:
            from_, to = os.path.join(ROOT, path), os.path.join(self.source, path)
            if not os.path.exists(to) or not filecmp.cmp(from_, to, shallow=False):
                os.makedirs(os.path.dirname(to), exist_ok=True)
                shutil.copy(from_, to)
        for path in files_below(self.source):
            if os.path.relpath(path, self.source) not in wanted:
                os.remove(path)

    def configure(self):
        with open(os.path.join(FOLDER, 'configure.log'), 'wb') as log:
            done = subprocess.run(
                ['cmake', '-S', self.source, '-B', self.build, '-GNinja', '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_UNITY=OFF',
                 f'-DHIDWA_TEST_SUITES={";".join(self._suites)}', f'-DHIDWA_TOOLS={self._tools}',
                 '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -DNDEBUG', '-DCMAKE_LINK_DEPENDS_NO_SHARED=ON'],
                stdout=log, stderr=log, check=False)
        if done.returncode:
            raise MutateError(f'cmake failed: see {FOLDER}/configure.log')

    def make(self, programs):
        """Whether they build."""
        command = ['ninja', '-C', self.build, '-j', self._jobs, *programs]
        with open(os.path.join(FOLDER, 'build.log'), 'wb') as log:
            return subprocess.run(command, stdout=log, stderr=log, check=False).returncode == 0

    def write(self, mutant, text):
        """The mutant's line becomes `text`."""
        path = os.path.join(self.source, mutant.path)
        with open(path, encoding='utf-8') as file:
            lines = file.read().split('\n')
        lines[mutant.line - 1] = text
        with open(path, 'w', encoding='utf-8') as file:
            file.write('\n'.join(lines))


def judge(tree, tests, mutant):
    """(what became of it, the test that found it)."""
    tree.write(mutant, mutant.after)
    try:
        if not tree.make(tests.programs()):
            return 'no code', ''
        found = tests.finds(mutant.path)
        return ('found', found) if found else ('survived', '')
    finally:
        tree.write(mutant, mutant.before)


def chosen(options):
    """The mutants in the order in which they are tried, and those that are left out, with their reasons."""
    equivalent = mutation.read_equivalents(EQUIVALENT)
    every = [m for path in mutation.sources(ROOT, FOLDERS) if path.startswith(options.folder)
             for m in mutation.mutants_of_file(ROOT, path)]
    order = mutation.shuffled(every, options.seed)
    left_out = {m.key(): equivalent[m.key()] for m in order if m.key() in equivalent}
    return len(every), [m for m in order if m.key() not in left_out], left_out


def earlier(path):
    """Results of a run before: {key: row}."""
    if not os.path.exists(path):
        return {}
    with open(path, encoding='utf-8', newline='') as text:
        return {row['mutant']: row for row in csv.DictReader(text)}


def run(options):
    """The figures, {what became of them: number}."""
    total, order, left_out = chosen(options)
    os.makedirs(FOLDER, exist_ok=True)
    results = os.path.join(FOLDER, f"mutants{options.folder.strip('/').replace('/', '_').replace('src', '', 1)}.csv")
    known = earlier(results) if options.go_on else {}
    tree = Tree(options.jobs, options.closed_loop)
    tree.copy()
    tree.configure()
    print(f'==> building; {total} places can be changed, {len(left_out)} of them in a way that nothing can notice', flush=True)
    tests = Tests(tree.build, options.long)
    if not tree.make(tests.programs()):
        raise MutateError(f'the build failed: see {FOLDER}/build.log')
    tests.find_programs()
    print('==> the tests without a fault', flush=True)
    tests.measure(options.quick)
    counts = {'found': 0, 'survived': 0, 'no code': 0}
    with open(results, 'w', encoding='utf-8', newline='') as out:
        table = csv.DictWriter(out, ['outcome', 'test', 'seconds', 'line', 'mutant'])
        table.writeheader()
        for mutant in order:
            if counts['found'] + counts['survived'] >= options.count:
                break
            begin, row = time.monotonic(), known.get(mutant.key())
            if row is None or (row['outcome'] == 'survived' and not options.quick):
                outcome, test = judge(tree, tests, mutant)
                row = {'outcome': outcome, 'test': test, 'seconds': f'{time.monotonic() - begin:.0f}', 'line': mutant.line,
                       'mutant': mutant.key()}
            counts[row['outcome']] += 1
            table.writerow(row)
            out.flush()
            print(f"{counts['found'] + counts['survived']:4d} {row['outcome']:9} {row['seconds']:>4} s {row['test']:28} "
                  f"{mutant.path}:{mutant.line}: {mutant.before.strip()} -> {mutant.after.strip()}", flush=True)
    return counts


def main(arguments=None):
    """scripts/mutate"""
    parser = argparse.ArgumentParser(
        prog='scripts/mutate', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds core, input and control with one deliberate fault at a time (an operator or a\n'
        'constant changed), and runs the tests that need no ROS until one fails. The seed chooses the faults. Ends with the share\n'
        'that was found; build/mutate/mutants.csv has a row each. It takes hours; docs/evidence/trust.md has the figures.',
        epilog=f'exit status: 0 at least {BAR:g} % were found; 1 fewer; 2 something did not run\n'
        'Faults that change nothing that can be seen are listed with their reasons in test/mutation/equivalent.txt.')
    parser.add_argument('--count', type=int, default=200, metavar='N', help='faults (200)')
    parser.add_argument('--seed', type=int, default=1, metavar='N', help='other faults (1)')
    parser.add_argument('--folder', default='src/', metavar='FOLDER', help='only there, as src/core/motion')
    parser.add_argument('--jobs', type=int, default=CORES, metavar='N', help='compilers at the same time (one a core)')
    parser.add_argument('--quick', action='store_true', help=f'only the cases that take less than {SLOW_CASE:g} s; --go-on then asks the '
                        'others about what they left')
    parser.add_argument('--long', action='store_true', help='the long form of the tests, too')
    parser.add_argument('--closed-loop', action='store_true', help='ask whole drives too, where nothing else finds the fault')
    parser.add_argument('--go-on', action='store_true', help='take over what a run before has found; try its survivors again')
    options = parser.parse_args(arguments)
    try:
        counts = run(options)
    except (MutateError, OSError, ValueError, subprocess.SubprocessError) as fault:
        print(f'scripts/mutate: {fault}', file=sys.stderr)
        return 2
    tried = counts['found'] + counts['survived']
    share = 100.0 * counts['found'] / tried if tried else 0.0
    print(f"{tried} faults, {counts['found']} found, {counts['survived']} survived: {share:.1f} % "
          f"({counts['no code']} more do not compile)")
    return 0 if share >= BAR else 1


if __name__ == '__main__':
    sys.exit(main())
