# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test --long: each form of testing in full, one after the other, with a table at the end; what has passed is kept."""
import datetime
import hashlib
import json
import os
import subprocess
import sys
import time

from . import coverage, fuzz, sanitize, tests
from .counting import Counts
from .places import ROOT, SPACE

FOLDER = os.path.join(SPACE, 'build', 'tests', 'long')
LIMIT = 10 * 3600.0  # [s], of one form


def tool(name, *arguments):
    """A form that is a script of its own: one test, which passes with exit status 0."""
    def form():
        status = subprocess.run([os.path.join(ROOT, 'scripts', name), *arguments], check=False, timeout=LIMIT).returncode
        return Counts(passed=int(status == 0), failed=int(status != 0))
    form.__doc__ = ' '.join(['scripts/' + name, *arguments])
    return form


def whole():
    """every test that CTest knows, with all its cases"""
    return tests.ctest(tests.build(), [])[0]


def without_ros(name, *options, which=()):
    """Counts of the tests that need no ROS, from a build of plain CMake with these options."""
    folder = os.path.join(tests.WORK, name)
    tests.run(name + '_configure', 'cmake', '-S', ROOT, '-B', folder, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_TOOLS=ON',
              '-DHIDWA_UNITY=ON', *options)
    tests.run(name + '_build', 'cmake', '--build', folder, '-j', str(tests.CORES))
    return tests.ctest(folder, which, own=True)[0]


def plain():
    """core, operator, simulator and benchmark by CMake alone, and their tests: they know no ROS"""
    return without_ros('plain', '-DHIDWA_BENCHMARKS=ON', '-DCMAKE_BUILD_TYPE=Release', which=['-LE', '^long$'])


def sanitized(name):
    """The tests that need no ROS by one compiler and sanitizer."""
    compiler, sanitizers = sanitize.FORMS[name]

    def form():
        return without_ros(name, *sanitize.cmake_options(compiler, sanitizers), which=sanitize.ctest_options())
    form.__doc__ = f'the tests that need no ROS, by {compiler} with the sanitizers {sanitizers}'
    return form


def sanitized_host(name):
    """Host, plugin, tools and rostests, all built with a sanitizer, in a space of their own."""
    compiler, sanitizers = sanitize.HOST_FORMS[name]

    def form():
        space = os.path.join(tests.WORK, name)
        findings = sanitize.empty_folder(os.path.join(space, 'findings'))
        flags = sanitize.flags(sanitizers)
        environment = {**os.environ, **sanitize.with_ros(sanitize.environment(ROOT), findings), 'HIDWA_SPACE': space, 'CXX': compiler,
                       'CXXFLAGS': flags, 'LDFLAGS': flags, 'HIDWA_INSTALL': 'skip'}
        done = subprocess.run([sys.executable, '-m', tests.__name__, 'ros', 'package'], env=environment, stdout=subprocess.PIPE,
                              text=True, check=False, timeout=LIMIT)
        found = sanitize.findings(findings)
        print('\n'.join([done.stdout, *(f'    found: {line}' for line in found)]), flush=True)
        return (Counts.read(done.stdout) or Counts(failed=1)) + Counts(passed=not found, failed=len(found))
    form.__doc__ = f'host, plugin and rostests by {compiler} with the sanitizers {sanitizers}'
    return form


def fuzzing():
    """a minute of each fuzz target"""
    well, found = fuzz.build_and_run()
    return Counts(passed=len(well), failed=len(found))


def covered():
    """lines and branches of the parts that decide that run"""
    return coverage.run(without_ros)


FORMS = {
    'whole': whole, 'plain': plain, **{name: sanitized(name) for name in sanitize.FORMS},
    **{name: sanitized_host(name) for name in sanitize.HOST_FORMS}, 'fuzz': fuzzing, 'coverage': covered,
    'attack': tool('attack'), 'ways': tool('ways'), 'soak': tool('soak', '--no-build', '--hours', '1', '--rate', '2'),
    'mutate': tool('mutate', '--long')}


def sources():
    """What identifies the sources as they are now."""
    def git(*words):
        return subprocess.run(['git', '-C', ROOT, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout
    changed = git('diff', 'HEAD') + git('ls-files', '--others', '--exclude-standard')
    commit = git('rev-parse', '--short', 'HEAD').decode().strip() or 'unknown'
    return commit + ('+' + hashlib.sha256(changed).hexdigest()[:8] if changed else '')


def result_of(name):
    """What a form said when it was last run; None where it never was."""
    try:
        with open(os.path.join(FOLDER, name + '.json'), encoding='utf-8') as text:
            return json.load(text)
    except (OSError, ValueError):
        return None


def run_form(name, now):
    """Runs a form, and keeps what it says."""
    tests.step(f'{name}: {FORMS[name].__doc__}')
    begin = time.monotonic()
    try:
        counts = FORMS[name]()
    except (tests.BuildFailed, fuzz.FuzzError, sanitize.Absent, subprocess.TimeoutExpired) as fault:
        print(fault)
        counts = Counts(skipped=1) if isinstance(fault, sanitize.Absent) else Counts(failed=1)
    os.makedirs(FOLDER, exist_ok=True)
    result = {'sources': now, 'date': datetime.date.today().isoformat(), 'minutes': round((time.monotonic() - begin) / 60.0, 1),
              'passed': counts.passed, 'failed': counts.failed, 'skipped': counts.skipped}
    with open(os.path.join(FOLDER, name + '.json'), 'w', encoding='utf-8') as out:
        json.dump(result, out)
    return result


def table(names):
    """The results of forms as lines of a table."""
    lines = ['| form | passed | failed | skipped | minutes | sources | date |', '|---|---|---|---|---|---|---|']
    for name in names:
        r = result_of(name)
        lines.append(f"| {name} | {r['passed']} | {r['failed']} | {r['skipped']} | {r['minutes']} | {r['sources']} | {r['date']} |")
    return lines


def main(parser, options):
    """scripts/test --long"""
    for name in options.names:
        if name not in FORMS:
            parser.error(f"there is no form '{name}'; there are {', '.join(FORMS)}")
    names, now, total = options.names or list(FORMS), sources(), Counts()
    for name in names:
        result = result_of(name)
        if options.anew or result is None or result['sources'] != now or result['failed'] or not result['passed']:
            result = run_form(name, now)
        else:
            tests.step(f'{name}: has passed with these sources (--anew: run it again)')
        total += Counts(result['passed'], result['failed'], result['skipped'])
    print('\n'.join(table(names)))
    print(total, flush=True)
    return 1 if total.failed or not total.passed else 0
