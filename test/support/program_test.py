#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""program_test.py RESULTS NAME PROGRAM [ARGUMENT...]: runs a program and writes how it went in the format of xunit,
for catkin_test_results. Ends with the program's exit status; 0: passed, 77: left out, else failed."""
import subprocess
import sys
import xml.etree.ElementTree as xml

LEFT_OUT = 77


def report(name, status, output):
    """The result of one test as an XML element."""
    failed, skipped = status not in (0, LEFT_OUT), status == LEFT_OUT
    suite = xml.Element('testsuite', name=name, tests='1', errors='0', failures=str(int(failed)), skipped=str(int(skipped)))
    case = xml.SubElement(suite, 'testcase', classname=name, name=name)
    if failed:
        xml.SubElement(case, 'failure', message=f'exit status {status}').text = output
    if skipped:
        xml.SubElement(case, 'skipped').text = output
    return suite


def main(results, name, *command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    sys.stdout.write(done.stdout)
    xml.ElementTree(report(name, done.returncode, done.stdout)).write(results, encoding='utf-8', xml_declaration=True)
    return done.returncode


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
