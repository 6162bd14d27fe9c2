# SPDX-License-Identifier: BSD-3-Clause
"""How many tests passed, failed and were skipped, out of what the test tools say."""
import json
import os
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass


@dataclass
class Counts:
    """Numbers of tests."""
    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def __add__(self, other):
        return Counts(self.passed + other.passed, self.failed + other.failed, self.skipped + other.skipped)

    @property
    def total(self):
        return self.passed + self.failed + self.skipped

    def __str__(self):
        return f'{self.passed} passed, {self.failed} failed, {self.skipped} skipped'

    @staticmethod
    def read(output):
        """Those that an output ends with, as str() writes them; None where it does not."""
        end = re.search(r'^(\d+) passed, (\d+) failed, (\d+) skipped\n*\Z', output, re.MULTILINE)
        return Counts(*map(int, end.groups())) if end else None


def count_xml(path):
    """Counts of one result file of gtest, rosunit or rostest; None where there is none or it is broken."""
    try:
        root = xml.parse(path).getroot()
    except (OSError, xml.ParseError):
        return None
    counts = Counts()
    for case in root.iter('testcase'):
        if case.find('failure') is not None or case.find('error') is not None:
            counts.failed += 1
        elif case.find('skipped') is not None or case.get('status') == 'notrun' or case.get('result') == 'skipped':
            counts.skipped += 1
        else:
            counts.passed += 1
    return counts


CTEST_LINE = re.compile(r'^\s*\d+/\d+ Test\s+#\d+: (\S+) [. ]*(\*{3})?\s*(.*?)\s+[\d.]+ sec', re.MULTILINE)


def ctest_outcomes(output):
    """{test: 'passed', 'skipped' or 'failed'} out of what ctest prints; what did not run has failed."""
    outcomes = {}
    for name, stars, word in CTEST_LINE.findall(output):
        if not stars and word.startswith('Passed'):
            outcomes[name] = 'passed'
        else:
            outcomes[name] = 'skipped' if word.startswith('Skipped') else 'failed'
    return outcomes


def ctest_result_files(listing):
    """{test: its result file or None} out of `ctest --show-only=json-v1`."""
    files = {}
    for test in json.loads(listing)['tests']:
        paths = [word.split('xml:', 1)[-1] for word in test.get('command', []) if word.endswith('.xml')]
        files[test['name']] = paths[0] if paths else None
    return files


def count_ctest(output, listing, since):
    """Counts of a ctest run that began at `since` [s]: case by case where a test left a fresh result file, else one
    for the test. A test that was listed and never reported has failed; so has a run without tests."""
    outcomes, files = ctest_outcomes(output), ctest_result_files(listing)
    counts = Counts()
    for name, path in files.items():
        outcome = outcomes.get(name, 'failed')
        fresh = path is not None and os.path.exists(path) and os.path.getmtime(path) >= since
        cases = count_xml(path) if fresh else None
        if cases is None or cases.total == 0:
            cases = Counts(**{outcome: 1})
        elif outcome == 'failed' and cases.failed == 0:
            cases += Counts(failed=1)  # it crashed, or ran out of time, after its last case
        counts += cases
    return counts if files else Counts(failed=1)
