# SPDX-License-Identifier: BSD-3-Clause
"""A page without a browser: a client of the console's sockets that reads docs/understand/console_protocol.md the slow way.

It shares no code with the server.
"""
import asyncio
import contextlib
import json
import re
import struct
import time

import paths  # noqa: F401
import tornado.httpclient
import tornado.websocket
from hidwa_tools.waiting import PATIENCE


class Page:
    """One page; `skew` [ms] is how far its clock is from ours. Use it within one asyncio loop."""

    def __init__(self, port, page='a' * 32, origin=None, host=None, cookie=None, skew=123456.0, pongs=True, path='', scheme='http'):
        self.port, self.page, self.skew, self.pongs = port, page, skew, pongs
        self.base = f'{scheme}://{host or "localhost"}:{port}'
        self.headers = {'Origin': self.base if origin is None else origin}
        if cookie:
            self.headers['Cookie'] = cookie
        self.control, self.heard, self.told_control, self.pings, self.closed = None, [], {}, 0, None

    def now(self):
        """performance.now() of this page [ms]."""
        return 1e3 * time.monotonic() + self.skew

    async def connect(self, path, subprotocols=None):
        request = tornado.httpclient.HTTPRequest(f'ws://localhost:{self.port}{path}', headers={k: v for k, v in self.headers.items() if v})
        connection = await tornado.websocket.websocket_connect(request, subprotocols=subprotocols, max_message_size=1 << 24)
        connection.protocol.stream.set_nodelay(True)  # as browsers do: else a message waits for the answer to the one before
        return connection

    async def open(self, name=''):
        """Opens /control and says hello."""
        self.control = await self.connect('/control')
        self.say('hello', page=self.page, name=name)
        asyncio.ensure_future(self._listen())
        await self.until(lambda: self.pings >= 3 or not self.pongs, 'three pings')
        return self

    async def _listen(self):
        while True:
            text = await self.control.read_message()
            if text is None:
                self.closed = self.control.close_code or 1006
                return
            message = json.loads(text)
            if message['type'] == 'ping':
                self.pings += 1
                if self.pongs:
                    with contextlib.suppress(tornado.websocket.WebSocketClosedError):  # the server may have ended it meanwhile
                        self.say('pong', id=message['id'], t=self.now())
            elif message['type'] == 'control':
                self.told_control = message
            self.heard.append(message)

    def say(self, kind, **fields):
        return self.control.write_message(json.dumps({'type': kind, **fields}))

    def stick(self, left, forward=0.0, held=None, age=0.0, **more):
        """A stick message that is `age` [s] old."""
        held = (left != 0.0 or forward != 0.0) if held is None else held
        return self.say('stick', t=self.now() - 1e3 * age, left=left, forward=forward, held=held, **more)

    def last(self, kind, **match):
        """The last message of a type that has these fields."""
        found = [m for m in self.heard if m['type'] == kind and all(m.get(k) == v for k, v in match.items())]
        return found[-1] if found else None

    async def until(self, condition, what):
        await until(condition, what)

    async def claim(self):
        """Takes the controls, and centres the stick."""
        self.say('claim')
        await self.until(lambda: self.told_control.get('held'), 'the controls')
        await self.hold(0.0, lambda: not self.told_control['neutral_needed'], 'a centred stick')

    async def hold(self, left, condition, what):
        """Holds the stick there until the condition holds. On a slow machine single messages are late and do not count, and after
        a longer pause the stick must be seen centred first."""
        deadline = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < deadline, f'waited {PATIENCE:.0f} s for {what}'
            self.stick(0.0 if self.told_control['neutral_needed'] else left)
            await asyncio.sleep(0.05)

    def cut(self):
        """The connection ends as when a cable is pulled: no close frame."""
        self.control.protocol.stream.close() if hasattr(self.control, 'protocol') and self.control.protocol else self.control.stream.close()


async def until(condition, what, found=lambda: 'missing'):
    """Waits for a condition, not for a time. `found` says what there is in its place."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f'waited {PATIENCE:.0f} s for {what}: {found()}')
        await asyncio.sleep(0.005)


async def port_of(child, log):
    """The port of the page whose address a child says in its log."""
    def said():
        with open(log, encoding='utf-8') as text:
            return text.read()
    await until(lambda: 'open http://localhost:' in said() or not child.running, 'the address')
    found = re.search(r'open http://localhost:(\d+)/', said())
    assert found, said()
    return int(found.group(1))


class View:
    """A page's /view: keeps the newest of everything."""

    def __init__(self, page):
        self._page, self.fields, self.binary, self.ticks, self.bytes = page, {}, {}, 0, 0
        self.grids, self.kinds = {}, []

    async def open(self, acknowledge=True):
        self._socket = await self._page.connect('/view')
        self._say(type='hello', page=self._page.page)
        asyncio.ensure_future(self._listen(acknowledge))
        return self

    def _say(self, **message):
        return self._socket.write_message(json.dumps(message))

    def want(self, candidates):
        return self._say(type='want', candidates=candidates)

    def close(self):
        self._socket.close()

    async def _listen(self, acknowledge):
        while True:
            message = await self._socket.read_message()
            if message is None:
                return
            self.bytes += len(message)
            if isinstance(message, bytes):
                self.kinds.append(message[0])
                self._take(message)
                continue
            tick = json.loads(message)
            self.fields.update(tick)
            self.ticks += 1
            if acknowledge:
                self._say(type='ack', n=tick['n'])

    def _take(self, message):
        kind = message[0]
        if kind in (1, 2):
            grid = read_grid(message) if kind == 1 else change_grid(self.grids[message[4]], message)
            self.grids[message[4]] = grid
        else:
            self.binary[(kind, message[4] if kind == 4 else 0)] = message


def read_runs(data, at, count):
    """Cells of runs, one after the other."""
    cells = []
    while len(cells) < count:
        value, length, shift = data[at], 0, 0
        at += 1
        while True:
            byte = data[at]
            at += 1
            length |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                break
        cells += [value] * length
    assert len(cells) == count and at == len(data), (len(cells), count, at, len(data))
    return cells


def read_grid(message):
    """A whole grid as a dict."""
    version, width, height, resolution, x, y, yaw = struct.unpack_from('<IIIf3d', message, 8)
    return {'version': version, 'width': width, 'height': height, 'resolution': resolution, 'pose': (x, y, yaw),
            'cells': read_runs(message, 8 + struct.calcsize('<IIIf3d'), width * height)}


def change_grid(grid, message):
    """The same grid one version later."""
    version, base, dx, dy, x, y, yaw = struct.unpack_from('<IIii3d', message, 8)
    assert base == grid['version'], (base, grid['version'])
    width, height, old = grid['width'], grid['height'], grid['cells']
    added = read_runs(message, 8 + struct.calcsize('<IIii3d'), width * height)
    cells = []
    for j in range(height):
        for i in range(width):
            inside = 0 <= i + dx < width and 0 <= j + dy < height
            before = old[(j + dy) * width + i + dx] if inside else 255
            cells.append((before + added[j * width + i]) % 256)
    return {**grid, 'version': version, 'pose': (x, y, yaw), 'cells': cells}


def read_path(message):
    """[(x, y, t)]"""
    (count,) = struct.unpack_from('<I', message, 8)
    return [struct.unpack_from('<3f', message, 12 + 12 * i) for i in range(count)]
