# SPDX-License-Identifier: BSD-3-Clause
"""The planner's parameters as core/parameter_list.inc declares them, for cfg/HIDWAPlanner.cfg and the scripts."""
import os
import re

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), os.pardir, os.pardir, os.pardir))
LIST = os.path.join(ROOT, 'include', 'hidwa_local_planner', 'core', 'parameter_list.inc')

NUMBER = ('name', 'default', 'low', 'high', 'unit', 'tab', 'description')
PLAIN = ('name', 'default', 'tab', 'description')
FIELDS = {'DOUBLE': NUMBER, 'INT': NUMBER, 'BOOL': PLAIN, 'STRING': PLAIN,
          'ENUM': ('enumeration', 'name', 'default', 'choices', 'tab', 'description'),
          'AXIS': ('name', 'default', 'low', 'high', 'tab', 'description')}


class Parameter:
    """One declaration; every value is the text of the list. `choices` is a list, empty but for enumerations."""

    def __init__(self, kind, fields):
        self.kind = kind  # DOUBLE, INT, BOOL, STRING, ENUM or AXIS
        self.low = self.high = self.unit = self.choices = ''
        vars(self).update(fields)
        self.choices = self.choices.split('|') if self.choices else []
        if kind == 'ENUM':  # an enumerator that is a C++ keyword ends in an underscore; its name does not
            self.default = self.default.rstrip('_')


class BadList(ValueError):
    """A line of the list that is no declaration."""


def parameters(text):
    """The parameters that the text of a list declares, in its order. Raises BadList with the line's number."""
    return [declared(line, number) for number, line in enumerate(text.splitlines(), 1) if line.startswith('HIDWA_')]


def declared(line, number):
    match = re.match(r'HIDWA_(\w+)\s*\((.*)\)\s*$', line)
    if match is None:
        raise BadList('line %d: a declaration must stand on one line' % number)
    kind = match.group(1)
    if kind not in FIELDS:
        raise BadList('line %d: unknown kind of parameter HIDWA_%s' % (number, kind))
    values = [value.strip().strip('"') for value in re.findall(r'"[^"]*"|[^,\s][^,]*', match.group(2))]
    if len(values) != len(FIELDS[kind]):
        raise BadList('line %d: HIDWA_%s takes %d values, not %d' % (number, kind, len(FIELDS[kind]), len(values)))
    return Parameter(kind, dict(zip(FIELDS[kind], values)))


def read():
    """The planner's parameters. Raises BadList with the file and the line."""
    with open(LIST) as source:
        try:
            return parameters(source.read())
        except BadList as fault:
            raise BadList('%s, %s' % (LIST, fault))
