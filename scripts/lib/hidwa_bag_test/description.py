# SPDX-License-Identifier: BSD-3-Clause
"""What a bag test is to do and to expect, out of its YAML file."""
import difflib
import os
from dataclasses import dataclass, field

import yaml

from .errors import BagTestError

STATES = ('AUTONOMY', 'SHARED', 'HOLD', 'MANUAL', 'STOPPED', 'LOST', 'BLOCKED')
LIMITS = ('max_vel_x', 'min_vel_x', 'max_vel_theta', 'acc_lim_x', 'acc_lim_theta', 'decel_lim_x', 'decel_lim_theta')


@dataclass
class Expectations:
    """None or False: nothing is expected of it."""
    arrived: object = None         # bool: the planner says so of the last plan, or does not
    contacts: object = None        # at most so many times a scan point lies in the footprint where the bag's robot is
    finite: bool = True            # every command is a number
    limits: object = True          # every command keeps the limits; a dict: these instead of the planner's parameters
    collision_free: bool = True    # each command, and braking after it, keeps the footprint off the scan
    failures: object = None        # at most so many cycles without a command
    deviation: object = None       # {v, omega}: from the recorded command, mean absolute difference [m/s, rad/s]
    states: list = field(default_factory=list)  # [{at: [s] after start, is: name}]

    def given(self):
        """Names of what is expected."""
        asked = {'arrived': self.arrived is not None, 'contacts': self.contacts is not None, 'finite': self.finite,
                 'limits': bool(self.limits) or self.limits == {}, 'collision_free': self.collision_free,
                 'failures': self.failures is not None, 'deviation': bool(self.deviation), 'states': bool(self.states)}
        return [name for name, wanted in asked.items() if wanted]


@dataclass
class Description:
    """A bag test."""
    path: str                      # of the YAML file
    bag: str
    plan: dict                     # {topic: name}, {driven: true} or {free: [m]}
    start: float = 0.0             # [s] after the bag's beginning
    duration: object = None        # [s]; None: to its end
    rate: float = 2.0              # simulated seconds a second
    topics: dict = field(default_factory=lambda: {name: name for name in ('/odom', '/scan', '/tf', '/tf_static')})
    odom: str = '/odom'            # recorded names
    scan: str = '/scan'
    commands: str = '/cmd_vel'
    frame: str = 'odom'            # in which the robot is followed
    base_frame: str = 'base_link'
    scan_age: float = 0.3          # [s]; a scan is known to the planner when it is so old
    if_absent: str = 'fail'        # or skip, where there is no such bag
    expect: Expectations = field(default_factory=Expectations)


def _number(low, high):
    def check(value):
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
            raise ValueError(f'give a number from {low:g} to {high:g}')
        return float(value)
    return check


def _count(value):
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise ValueError('give a whole number, 0 or more')
    return value


def _flag(value):
    if not isinstance(value, bool):
        raise ValueError('give true or false')
    return value


def _text(value):
    if not isinstance(value, str) or not value:
        raise ValueError('give a text')
    return value


def _one_of(*names):
    def check(value):
        if value not in names:
            raise ValueError(f'give one of {", ".join(names)}')
        return value
    return check


def _topics(value):
    if isinstance(value, list):
        value = {name: name for name in value}
    if not isinstance(value, dict) or not all(isinstance(n, str) for pair in value.items() for n in pair):
        raise ValueError('give a list of topics, or {recorded: played} to rename them')
    return value


def _plan(value):
    kinds = {'topic': _text, 'driven': _flag, 'free': _number(0.2, 100.0)}
    if not isinstance(value, dict) or len(value) != 1 or next(iter(value)) not in kinds:
        raise ValueError('give {topic: NAME}, {driven: true} or {free: METRES}')
    (kind, content), = value.items()
    if kind == 'driven' and content is not True:
        raise ValueError('give {driven: true}')
    return {kind: kinds[kind](content)}


def _keys(value, checks, where, needed=()):
    """The dict with every entry checked; ValueError names the entry."""
    if not isinstance(value, dict):
        raise ValueError(f'{where or "the file"} must hold "key: value" lines')
    prefix = where + '.' if where else ''
    for key in value:
        if key not in checks:
            near = difflib.get_close_matches(str(key), checks, 1)
            hint = f'did you mean {near[0]}?' if near else f'there are {", ".join(checks)}'
            raise ValueError(f'unknown key {prefix}{key}: {hint}')
    for key in needed:
        if key not in value:
            raise ValueError(f'{prefix}{key} is missing: give it')
    result = {}
    for key, content in value.items():
        try:
            result[key] = checks[key](content)
        except _Nested as fault:
            raise ValueError(str(fault)) from fault
        except ValueError as fault:
            raise ValueError(f'{prefix}{key} = {content!r}: {fault}') from fault
    return result


class _Nested(ValueError):
    """Names its place already."""


def _nested(checks, where, needed=()):
    def check(value):
        try:
            return _keys(value, checks, where, needed)
        except ValueError as fault:
            raise _Nested(str(fault)) from fault
    return check


def _states(value):
    if not isinstance(value, list):
        raise ValueError('give a list of {at: SECONDS, is: STATE}')
    check = _nested({'at': _number(0.0, 1e6), 'is': _one_of(*STATES)}, 'expect.states', ('at', 'is'))
    return [check(entry) for entry in value]


def _limits(value):
    if isinstance(value, bool):
        return value
    return _nested({name: _number(-50.0, 50.0) for name in LIMITS}, 'expect.limits')(value)


_EXPECT = {'arrived': _flag, 'contacts': _count, 'finite': _flag, 'limits': _limits, 'collision_free': _flag,
           'failures': _count, 'states': _states,
           'deviation': _nested({'v': _number(0.0, 10.0), 'omega': _number(0.0, 10.0)}, 'expect.deviation')}
_KEYS = {'bag': _text, 'plan': _plan, 'start': _number(0.0, 1e6), 'duration': _number(0.1, 1e6),
         'rate': _number(0.1, 100.0), 'topics': _topics, 'odom': _text, 'scan': _text, 'commands': _text, 'frame': _text,
         'base_frame': _text, 'scan_age': _number(0.0, 5.0), 'if_absent': _one_of('fail', 'skip'),
         'expect': _nested(_EXPECT, 'expect')}


def read_description(path, bag=None):
    """Reads a Description; `bag` stands in for the file's own. BagTestError says in one line what is wrong with it."""
    try:
        with open(path, encoding='utf-8') as text:
            content = yaml.safe_load(text)
    except OSError as fault:
        raise BagTestError(f'{path} cannot be read ({fault.strerror}): give the test\'s YAML file by --test') from fault
    except yaml.YAMLError as fault:
        mark = getattr(fault, 'problem_mark', None)
        where = f', line {mark.line + 1}' if mark else ''
        raise BagTestError(f'{path}{where}: no YAML ({getattr(fault, "problem", fault)})') from fault
    try:
        if bag and isinstance(content, dict):
            content['bag'] = bag
        values = _keys(content, _KEYS, '', ('bag', 'plan'))
    except ValueError as fault:
        raise BagTestError(f'{path}: {fault}') from fault
    values['expect'] = Expectations(**values.get('expect', {}))
    values['bag'] = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(path)), values['bag']))
    return Description(path=path, **values)
