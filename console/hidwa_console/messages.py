# SPDX-License-Identifier: BSD-3-Clause
"""A page's messages on /control: read, checked, nothing taken on trust."""
import json
import math
import re

LARGEST = 4096   # [byte], of a message
FARTHEST = 1e5   # [m], of a goal
LARGEST_INTEGER = 2 ** 31 - 1  # as a parameter; ROS has no larger ones
PAGE = re.compile(r'[0-9a-f]{32}')
NAME = re.compile(r'[A-Za-z_][A-Za-z0-9_]{0,63}')
MODES = ('off', 'joystick', 'gesture', 'switching')
WHYS = ('hidden', 'blur', 'pagehide', 'pointer', 'tracking', 'device')


class Malformed(Exception):
    """A message that is none; the text says why."""


def number(low, high):
    """A check: a finite number in [low, high]."""
    def check(value):
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
            raise Malformed(f'is no number from {low:g} to {high:g}')
        return float(value)
    return check


def integer(value):
    """A check: a whole number that a page may name."""
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2 ** 53:
        raise Malformed('is no whole number')
    return value


def flag(value):
    """A check: true or false."""
    if not isinstance(value, bool):
        raise Malformed('is neither true nor false')
    return value


def word(*allowed):
    """A check: one of these words."""
    def check(value):
        if value not in allowed:
            raise Malformed(f'is none of {", ".join(allowed)}')
        return value
    return check


def text(longest):
    """A check: a text, without control characters and cut to length."""
    def check(value):
        if not isinstance(value, str):
            raise Malformed('is no text')
        return ''.join(c for c in value if c.isprintable())[:longest].strip()
    return check


def pattern(expression):
    """A check: a text that matches."""
    def check(value):
        if not isinstance(value, str) or not expression.fullmatch(value):
            raise Malformed('has not the form of its kind')
        return value
    return check


def or_none(check):
    """A check that also takes null."""
    return lambda value: None if value is None else check(value)


def parameters(value):
    """A check: {name: number, text or flag}, of at most 64."""
    if not isinstance(value, dict) or not 0 < len(value) <= 64:
        raise Malformed('is no set of parameters')
    for name, given in value.items():
        pattern(NAME)(name)
        if not isinstance(given, (bool, int, float, str)) or (isinstance(given, float) and not math.isfinite(given)):
            raise Malformed(f'has no value for {name}')
        if isinstance(given, int) and abs(given) > LARGEST_INTEGER:
            raise Malformed(f'has too large a number for {name}')
    return value


def answer(value):
    """A check: what a participant answers, {name: number or flag or {name: number}}."""
    if not isinstance(value, dict) or len(value) > 4:
        raise Malformed('is no answer')
    for given in value.values():
        if isinstance(given, dict):
            for rating in given.values():
                number(-1e6, 1e6)(rating)
        elif not isinstance(given, bool):
            raise Malformed('is no answer')
    return value


UNIT, METRES, TIME, PLACE = number(-1, 1), number(-100, 100), number(0, 1e15), number(-FARTHEST, FARTHEST)
# {type: {field: (check, default)}}; a field without a default is required.
FIELDS = {
    'hello': {'page': (pattern(PAGE),), 'name': (text(40), '')},
    'pong': {'id': (integer,), 't': (TIME,)},
    'stick': {'t': (TIME,), 'left': (UNIT,), 'forward': (UNIT,), 'held': (flag,), 'stop': (flag, False)},
    'hand': {'t': (TIME,), 'left': (METRES,), 'forward': (METRES,), 'up': (METRES,), 'grip': (flag,), 'stop': (flag, False)},
    'release': {'t': (TIME,), 'why': (word(*WHYS),)},
    'stop': {'t': (TIME,), 'on': (flag,)},
    'claim': {},
    'give': {'to': (or_none(integer), None)},
    'refuse': {'to': (integer,)},
    'mode': {'mode': (word(*MODES),)},
    'take_control': {'on': (flag,)},
    'goal': {'x': (PLACE,), 'y': (PLACE,), 'yaw': (or_none(number(-1e3, 1e3)), None), 'append': (flag, False)},
    'cancel': {},
    'skip': {},
    'home': {'append': (flag, False)},
    'record': {'on': (flag,)},
    'tune': {'values': (parameters,)},
    'undo': {},
    'preset': {'name': (pattern(NAME),)},
    'study': {'answer': (answer,)},
}


def read(data):
    """(type, {field: value}) of a message as it came. Malformed where it is none."""
    if isinstance(data, bytes):
        raise Malformed('it is binary')
    if len(data) > LARGEST:
        raise Malformed('it is too large')
    try:
        message = json.loads(data, parse_constant=_refuse)
    except (ValueError, RecursionError) as fault:
        raise Malformed('it is no JSON') from fault
    if not isinstance(message, dict) or not isinstance(message.get('type'), str) or message['type'] not in FIELDS:
        raise Malformed('it has no type that is known')
    kind = message['type']
    return kind, {name: _field(message, name, *spec) for name, spec in FIELDS[kind].items()}


def _refuse(name):
    raise ValueError(name)  # NaN and infinities are no JSON


def _field(message, name, check, *default):
    if name not in message:
        if default:
            return default[0]
        raise Malformed(f'{message["type"]} has no {name}')
    try:
        return check(message[name])
    except Malformed as fault:
        raise Malformed(f'{name} of {message["type"]} {fault}') from None
