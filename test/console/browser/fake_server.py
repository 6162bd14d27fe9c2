# SPDX-License-Identifier: BSD-3-Clause
"""A server for the page alone: it shows a scene that the test sets and keeps what the page sends. It knows no ROS.

It runs in a thread of its own. Commands are kept with the time at which they came, so that a test can measure.
"""
import asyncio
import json
import os
import threading
import time

import tornado.httpserver
import tornado.ioloop
import tornado.netutil
import tornado.web
import tornado.websocket
from hidwa_tools.waiting import PATIENCE

from hidwa_tools.report import NO_PICTURE

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = os.path.join(HERE, '..', '..', '..', 'console', 'page')
POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; worker-src 'self'; "
          "font-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'")


class Files(tornado.web.StaticFileHandler):
    """Files with the security policy of the real server."""

    def set_extra_headers(self, path):
        self.set_header('Content-Security-Policy', POLICY)
        self.set_header('Cache-Control', 'no-store')


class Login(tornado.web.RequestHandler):
    """Everybody is admitted, unless the page's address is not known."""

    def get(self):
        refusal = self.application.settings['server'].refusal
        self.set_status(421 if refusal else 204)
        if refusal:
            self.finish(refusal + ' ' + self.request.headers['X-Page-Origin'])


class Report(tornado.web.RequestHandler):
    """The report of a robot without matplotlib: figures, and no picture beside them."""

    def get(self):
        self.write({'path_length_m': 2.0, 'no_picture': NO_PICTURE})


class Control(tornado.websocket.WebSocketHandler):
    """/control: keeps every message as (seconds, message)."""

    def prepare(self):
        if self.server.refusal:
            raise tornado.web.HTTPError(403)

    def open(self):
        self.server.controls.append(self)
        self.write_message({'type': 'ping', 'id': 1, 'rtt': None, 'delay': 12})

    @property
    def server(self):
        return self.application.settings['server']

    def on_message(self, message):
        message = json.loads(message)
        with self.server.changed:
            self.server.received.append((time.monotonic(), message))
            self.server.changed.notify_all()
        if message['type'] == 'hello':
            self.write_message({'type': 'welcome', 'you': 1, 'max_age': 0.3, 'stop_delay': 1.0, 'input_timeout': 0.5, 'study': False,
                                'version': 1})
            self.write_message(self.server.control)

    def on_close(self):
        with self.server.changed:
            self.server.controls.remove(self)
            self.server.received.append((time.monotonic(), {'type': 'closed', 'code': self.close_code}))
            self.server.changed.notify_all()


class View(tornado.websocket.WebSocketHandler):
    """/view: the scene, again and again."""

    def open(self):
        self.server = self.application.settings['server']
        self.sent = {}
        self.n = 0
        self.waiting = False
        self.timer = tornado.ioloop.PeriodicCallback(self.tick, 50)
        self.timer.start()

    def on_message(self, message):
        message = json.loads(message)
        if message['type'] == 'ack':
            self.waiting = False
        elif message['type'] == 'want':
            self.server.wants = message['candidates']

    def on_close(self):
        self.timer.stop()

    def tick(self):
        if self.waiting or self.ws_connection is None:
            return
        with self.server.changed:
            binary = dict(self.server.binary)
            fields = dict(self.server.fields)
        for name, data in binary.items():
            if self.sent.get(name) is not data:
                self.write_message(data, binary=True)
                self.sent[name] = data
        always = {key: fields.pop(key) for key in ('time', 'pose', 'velocity', 'state')}
        new = {key: value for key, value in fields.items() if self.sent.get(key) != value}
        self.sent.update(new)
        self.n += 1
        self.waiting = True
        self.write_message(dict(always, type='tick', n=self.n, **new))


class FakeServer:
    """Listens on a free port of 127.0.0.1. lib: folder of the npm packages, or None."""

    def __init__(self, lib=None, page=PAGE):
        self.changed = threading.Condition()
        self.received = []
        self.controls = []
        self.binary = {}
        self.wants = False
        self.refusal = ''  # what a page is told whose address is not known; empty: it is
        self.fields = {'time': 0.0, 'pose': None, 'velocity': None, 'state': None}
        self.control = {'type': 'control', 'holder': 1, 'you': 1, 'held': True, 'neutral_needed': False, 'claims': [],
                        'visitors': [{'visitor': 1, 'name': '', 'holder': True}]}
        ready = threading.Event()
        self.thread = threading.Thread(target=self._run, args=(lib, page, ready), daemon=True)
        self.thread.start()
        ready.wait()

    def _run(self, lib, page, ready):
        asyncio.set_event_loop(asyncio.new_event_loop())
        self.loop = tornado.ioloop.IOLoop.current()
        routes = [(r'/login', Login), (r'/control', Control), (r'/view', View)]
        if lib:
            routes.append((r'/lib/(.*)', Files, {'path': lib}))
        routes += [(r'/report/report.json', Report), (r'/(.*)', Files, {'path': page, 'default_filename': 'index.html'})]  # others: 404
        server = tornado.httpserver.HTTPServer(tornado.web.Application(routes, server=self))
        sockets = tornado.netutil.bind_sockets(0, '127.0.0.1')
        server.add_sockets(sockets)
        self.port = sockets[0].getsockname()[1]
        ready.set()
        self.loop.start()

    @property
    def address(self):
        return 'http://127.0.0.1:%d/' % self.port

    def show(self, binary=None, **fields):
        """Puts parts of the scene: binary messages by any name, and fields of the tick."""
        with self.changed:
            self.binary.update(binary or {})
            self.fields.update(fields)

    def tell(self, message):
        """Sends a message on every /control."""
        self.loop.add_callback(lambda: [one.write_message(message) for one in list(self.controls)])

    def cut(self):
        """Closes every /control without a word."""
        self.loop.add_callback(lambda: [one.ws_connection.stream.close() for one in list(self.controls)])

    def messages(self, kind=None):
        """What came so far, of one type or all but pong: [(seconds, message)]."""
        with self.changed:
            return [(at, one) for at, one in self.received if (one['type'] == kind if kind else one['type'] not in ('pong', 'hello'))]

    def clear(self):
        """Forgets what came."""
        with self.changed:
            self.received.clear()

    def forget(self, kind):
        """Forgets what came of one type."""
        with self.changed:
            self.received[:] = [(at, one) for at, one in self.received if one['type'] != kind]

    def wait(self, condition, seconds=PATIENCE):
        """Waits until condition(list of messages) holds; returns whether it does."""
        end = time.monotonic() + seconds
        with self.changed:
            while not condition([one for _, one in self.received]):
                left = end - time.monotonic()
                if left <= 0:
                    return False
                self.changed.wait(left)
        return True

    def end(self):
        """Stops listening."""
        self.loop.add_callback(self.loop.stop)
        self.thread.join(PATIENCE)
