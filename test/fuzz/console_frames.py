#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A fuzzer of the console: what a page or another program sends, and the robot's messages as bytes. Every frame is taken, or refused by
Malformed or Broken; what is taken is finite and inside its bounds. The same seed tries the same frames.

    console_frames.py --seconds 60 --seed 1        # or --inputs 5000
"""
import argparse
import json
import math
import os
import random
import struct
import sys
import time

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path[0:0] = [os.path.join(ROOT, 'console'), os.path.join(ROOT, 'scripts', 'lib')]

from hidwa_console import messages, wire  # noqa: E402
from hidwa_console.desk import Desk, Settings, Visitor  # noqa: E402
from hidwa_console.steering import Stick  # noqa: E402

SLOWEST = 2.0  # [s], of one frame
PAGE = '0123456789abcdef' * 2
SEEDS = [
    {'type': 'hello', 'page': PAGE, 'name': 'somebody'}, {'type': 'pong', 'id': 1, 't': 10.0},
    {'type': 'stick', 't': 10.0, 'left': 0.5, 'forward': 1, 'held': True},
    {'type': 'hand', 't': 10.0, 'left': 0.5, 'forward': 1, 'up': -1.5, 'grip': True, 'stop': False},
    {'type': 'release', 't': 10.0, 'why': 'blur'}, {'type': 'stop', 't': 1.0, 'on': True}, {'type': 'claim'}, {'type': 'give', 'to': 2},
    {'type': 'refuse', 'to': 2}, {'type': 'mode', 'mode': 'switching'}, {'type': 'take_control', 'on': True},
    {'type': 'goal', 'x': 1.0, 'y': -2.0, 'yaw': 0.5, 'append': True}, {'type': 'cancel'}, {'type': 'home'}, {'type': 'record', 'on': True},
    {'type': 'tune', 'values': {'s_omega': 400.0, 'mode': 'off', 'escape': True}}, {'type': 'preset', 'name': 'pilot_1'},
    {'type': 'study', 'answer': {'stress': {'a': 1.0}, 'again': True}}]
WORDS = ['NaN', 'Infinity', '1e999', '-0', '9' * 400, '1e-999', 'null', 'true', '[]', '{}', '""', '"\\ud800"', '"\\u0000"',
         '[' * 50, '{"a":' * 50, '0.1', '9007199254740993', '"stop"', str(2 ** 53), '-1', '"' + 'a' * 300 + '"']
INTERESTING = [0, 1, 2, 127, 128, 255, 2 ** 16, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1]


class Finding(Exception):
    """Something that must not be."""


def require(holds, what):
    if not holds:
        raise Finding(what)


def mutated_text(text, dice):
    """The text with some of it changed."""
    for _ in range(dice.randint(1, 4)):
        at = dice.randrange(len(text) + 1)
        to = min(len(text), at + dice.randint(0, 6))
        what = dice.randrange(4)
        if what == 0:
            text = text[:at] + text[to:]
        elif what == 1:
            text = text[:at] + dice.choice(WORDS) + text[to:]
        elif what == 2:
            text = text[:at] + chr(dice.choice([dice.randrange(32, 127), dice.randrange(0, 0x300)])) + text[to:]
        else:
            text = text[:at] + text[at:to] * dice.randint(2, 5) + text[to:]
    return text


def mutated_value(value, dice):
    """A JSON value with one part of it another."""
    if isinstance(value, dict) and value and dice.random() < 0.9:
        name = dice.choice(sorted(value))
        if dice.random() < 0.1:
            return {k: v for k, v in value.items() if k != name}
        return {**value, name: mutated_value(value[name], dice)}
    if isinstance(value, (int, float)) and not isinstance(value, bool) and dice.random() < 0.6:
        return dice.choice([value + dice.uniform(-2, 2), -value, value * 10 ** dice.randint(0, 300), dice.choice(INTERESTING),
                            10 ** dice.randint(0, 500)])
    return dice.choice([None, True, False, 0, -1, 1e308, 'x' * dice.randint(0, 200), [], {}, [[]], {'': {}}, '\ud800', 10 ** 400])


def mutated_bytes(data, dice):
    """Bytes with some of them changed, and now and then a length that lies."""
    data = bytearray(data)
    for _ in range(dice.randint(1, 6)):
        at, what = dice.randrange(len(data) + 1), dice.randrange(5)
        if what == 0:
            del data[at:at + dice.randint(1, 8)]
        elif what == 1:
            data[at:at] = bytes(dice.randrange(256) for _ in range(dice.randint(1, 8)))
        elif what == 2 and at + 4 <= len(data):
            data[at:at + 4] = struct.pack('<I', dice.choice(INTERESTING))
        elif at < len(data):
            data[at] = dice.randrange(256)
    return bytes(data)


class Outputs:
    """What the desk asks for; nothing of it leaves."""

    def steer(self, command):
        most = 1.0 if isinstance(command, Stick) else 100.0  # a stick's deflection, or metres
        for value in command:
            require(isinstance(value, bool) or abs(value) <= most, f'{command} steers')

    def stop(self, on):
        require(isinstance(on, bool), f'stop({on!r})')

    def input_timeout(self):
        return 0.5

    def mode(self):
        return 'joystick'

    def in_control(self):
        return False

    def do(self, kind, fields):
        if kind == 'goal':
            require(abs(fields['x']) <= messages.FARTHEST and abs(fields['y']) <= messages.FARTHEST, f'a goal at {fields}')
        return True, ''


class Pages:
    """Two pages at the desk, which send whatever was thought of."""

    def __init__(self, dice):
        self._dice, self._now = dice, 10.0
        self._desk = Desk(Outputs(), Settings(0.3, 0.5), lambda: self._now)
        self._visitors = []
        self._enter()
        self._enter()

    def _enter(self):
        visitor = Visitor(lambda message: json.dumps(message, allow_nan=False), lambda code, reason: None)
        self._desk.enter(visitor)
        self._visitors.append(visitor)

    def give(self, frame):
        visitor = self._dice.choice(self._visitors)
        self._now += self._dice.uniform(0.0, 0.2)
        try:
            kind, fields = messages.read(frame)
        except messages.Malformed:
            return
        require_finite(fields)
        self._desk.take(visitor, kind, fields)
        self._desk.tick()
        if self._dice.random() < 0.02:
            self._desk.leave(visitor, self._dice.random() < 0.5)
            self._visitors.remove(visitor)
            self._enter()


def require_finite(value):
    """No part of it is a number that is none."""
    if isinstance(value, dict):
        for part in value.values():
            require_finite(part)
    elif isinstance(value, (int, float)):
        require(abs(value) <= 1e308 and (isinstance(value, float) or abs(value) < 2 ** 53), f'{str(value)[:40]} is taken')


def frames_of_pages(dice):
    """What a page may send: well formed or not."""
    pages = Pages(dice)
    while True:
        value = dice.choice(SEEDS)
        if dice.random() < 0.5:
            value = mutated_value(value, dice)
        text = json.dumps(value)
        if dice.random() < 0.4:
            text = mutated_text(text, dice)
        frame = text.encode('utf-8', 'replace') if dice.random() < 0.02 else text
        yield frame, pages.give


def serialised():
    """Messages of the robot as rospy writes them: (how they are read, bytes)."""
    header = struct.pack('<III', 1, 2, 3) + struct.pack('<I', 3) + b'map'
    pose = struct.pack('<7d', 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    grid = header + struct.pack('<IIfII', 1, 2, 0.05, 4, 3) + pose + struct.pack('<I', 12) + bytes(12)
    update = header + struct.pack('<iiII', 1, 1, 2, 2) + struct.pack('<I', 4) + bytes(4)
    scan = header + struct.pack('<7fI', -1.0, 1.0, 0.5, 0.0, 0.1, 0.1, 9.0, 5) + struct.pack('<5f', 1, 2, 3, 4, 5) + struct.pack('<I', 0)
    path = header + struct.pack('<I', 2) + (header + pose) * 2
    image = header + struct.pack('<I', 4) + b'jpeg' + struct.pack('<I', 3) + b'abc'
    candidate = (struct.pack('<6dI', 0.1, 0, 0, 0, 0, 0.2, 2) + struct.pack('<6d', *range(6)) + struct.pack('<I', 0) + struct.pack('<I', 1)
                 + struct.pack('<I', 4) + b'Path' + struct.pack('<dd', 1.0, 2.0) + struct.pack('<d', 7.0) + struct.pack('<I', 0) * 2)
    evaluation = header + struct.pack('<I', 2) + candidate * 2 + struct.pack('<II', 1, 0)
    return [(wire.path, path), (wire.grid, grid), (wire.grid_update, update), (wire.scan, scan), (wire.compressed_image, image),
            (wire.evaluation, evaluation)]


def robot_messages(dice):
    """The robot's messages, changed."""
    seeds = serialised()
    for read, data in seeds:
        read(data)  # unchanged each can be read

    def give(read, data):
        try:
            read(data)
        except wire.Broken:
            pass
    while True:
        read, data = dice.choice(seeds)
        yield mutated_bytes(data, dice), lambda frame, read=read: give(read, frame)


def goals(dice):
    """Goals of other programs, by Foxglove's protocol."""
    from hidwa_console.foxglove import goal_of
    from geometry_msgs.msg import PoseStamped
    from io import BytesIO
    message, buffer = PoseStamped(), BytesIO()
    message.header.frame_id, message.pose.orientation.w, message.pose.position.x = 'map', 1.0, 1.0
    message.serialize(buffer)
    pose = {'position': {'x': 1, 'y': 2, 'z': 0}, 'orientation': {'x': 0, 'y': 0, 'z': 0, 'w': 1}}
    text = json.dumps({'header': {'frame_id': 'map'}, 'pose': pose})

    def give(frame):
        encoding, data = frame
        try:
            frame_id, x, y, yaw = goal_of(encoding, data)
        except messages.Malformed:
            return
        require(isinstance(frame_id, str) and all(math.isfinite(v) for v in (x, y, yaw)), f'a goal at {x}, {y}, {yaw}')
        require(max(abs(x), abs(y)) <= messages.FARTHEST, f'a goal at {x}, {y}')
    while True:
        if dice.random() < 0.5:
            yield ('ros1', mutated_bytes(buffer.getvalue(), dice)), give
        else:
            yield ('json', mutated_text(text, dice).encode('utf-8', 'replace')), give


def sources(dice):
    """What is fuzzed; other programs' goals only where ROS's messages are installed."""
    found = [frames_of_pages(dice), robot_messages(dice)]
    try:
        import hidwa_console.foxglove  # noqa: F401
        found.append(goals(dice))
    except ImportError as absent:
        print(f'goals of other programs are left out: {absent}')
    return found


def run(seed, seconds=math.inf, inputs=math.inf):
    """(number of frames given, the finding or None)."""
    dice, end, given = random.Random(seed), time.monotonic() + seconds, 0
    all_of_them = sources(dice)
    while given < inputs and time.monotonic() < end:
        frame, give = next(dice.choice(all_of_them))
        begin = time.monotonic()
        try:
            give(frame)
            require(time.monotonic() - begin < SLOWEST, f'took {time.monotonic() - begin:.1f} s')
        except Exception as fault:  # whatever it is, the server would not have caught it
            return given, f'{type(fault).__name__}: {fault}\n    frame {given} of seed {seed}: {frame!r}'[:4000]
        given += 1
    return given, None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--seconds', type=float, default=math.inf)
    parser.add_argument('--inputs', type=float, default=math.inf)
    parser.add_argument('--seed', type=int, default=1)
    options = parser.parse_args()
    if math.isinf(options.seconds) and math.isinf(options.inputs):
        parser.error('give --seconds or --inputs')
    given, finding = run(options.seed, options.seconds, options.inputs)
    print(f'{given} inputs')
    if finding:
        print(finding)
    return 1 if finding else 0


if __name__ == '__main__':
    sys.exit(main())
