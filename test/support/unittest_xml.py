#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""unittest_xml.py MODULE.py xml:RESULTS: runs the unittest cases of a file and writes how each went, in the format of xunit.
Exit status 1 where one failed, or where there is none."""
import os
import sys
import time
import unittest
import xml.etree.ElementTree as xml


class Recorded(unittest.TextTestResult):
    """A result that keeps an XML element for each case."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.suite, self._begin = xml.Element('testsuite'), 0.0

    def startTest(self, test):
        super().startTest(test)
        self._begin = time.monotonic()

    def _add(self, test, kind=None, text=''):
        seconds = time.monotonic() - self._begin
        case = xml.SubElement(self.suite, 'testcase', classname=type(test).__name__, name=str(test), time=f'{seconds:.3f}')
        if kind:
            xml.SubElement(case, kind).text = text

    def addSuccess(self, test):
        super().addSuccess(test)
        self._add(test)

    def addError(self, test, err):
        super().addError(test, err)
        self._add(test, 'error', self._exc_info_to_string(err, test))

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self._add(test, 'failure', self._exc_info_to_string(err, test))

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self._add(subtest, 'failure', self._exc_info_to_string(err, test))

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self._add(test, 'skipped', reason)


def main(path, results):
    folder, name = os.path.split(os.path.abspath(path))
    sys.path.insert(0, folder)
    cases = unittest.defaultTestLoader.loadTestsFromName(os.path.splitext(name)[0])
    result = unittest.TextTestRunner(resultclass=Recorded, verbosity=2).run(cases)
    results = results.split('xml:', 1)[-1]
    os.makedirs(os.path.dirname(results), exist_ok=True)
    xml.ElementTree(result.suite).write(results, encoding='utf-8', xml_declaration=True)
    return 0 if result.wasSuccessful() and result.testsRun else 1


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
