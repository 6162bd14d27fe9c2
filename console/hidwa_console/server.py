# SPDX-License-Identifier: BSD-3-Clause
"""The web server: every request is checked first (host, origin, session), then it gets the page, or a socket."""
import json
import os
import re
import time

import tornado.web
import tornado.websocket

from . import access, messages
from .bounds import Bucket
from .desk import Visitor

RATE, BURST = 120.0, 400         # [1/s] messages of one page on one socket, and at once
LARGEST = 64 * 1024              # [byte], of any message to the server
MOST_SOCKETS = 48                # at a time, of all kinds
HELLO_PATIENCE = 10.0            # [s] for a page's first message
POLICY, TRY_LATER = 1008, 1013   # close codes
IN_ORDER = (1000, 1001)          # close codes of a page that went away on purpose
MIME = {'.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.webmanifest': 'application/manifest+json'}


class Checked:
    """What every handler asks first; `console` is the Console."""

    def initialize(self, console, **settings):
        self.console = console
        for name, value in settings.items():
            setattr(self, name, value)

    def set_default_headers(self):
        a = self.application.settings['access']
        host = self.request.headers.get('Host', '')
        for name, value in access.headers(a.sockets_of(host if a.host_allowed(host) else 'localhost')).items():
            self.set_header(name, value)

    def prepare(self):
        if not self.console.access.host_allowed(self.request.headers.get('Host')):
            raise tornado.web.HTTPError(403, reason='this address is not known here (--host-name adds a name, --page-origin an address)')

    def write_error(self, status_code, **_):
        self.set_header('Content-Type', 'text/plain; charset=utf-8')
        self.finish(f'{status_code} {self._reason}\n')

    def admitted(self):
        return self.console.access.admitted(self.get_cookie(access.COOKIE))


class PageFiles(Checked, tornado.web.StaticFileHandler):
    """The page, and the browser's libraries."""

    def initialize(self, console, path, default_filename=None):
        Checked.initialize(self, console)
        tornado.web.StaticFileHandler.initialize(self, path, default_filename)

    def get_content_type(self):
        return MIME.get(os.path.splitext(self.absolute_path)[1]) or super().get_content_type()

    def set_extra_headers(self, path):
        self.set_header('Cache-Control', 'no-cache')


class ReportFiles(PageFiles):
    """The report of the last drive: for whom is admitted."""

    def prepare(self):
        super().prepare()
        if not self.admitted():
            raise tornado.web.HTTPError(403, reason='log in first')


class Login(Checked, tornado.web.RequestHandler):
    """A token for a session."""

    def get(self):
        page = self.request.headers.get('X-Page-Origin')  # a browser sends no Origin with this request
        if page and not self.console.access.same_origin(page, self.request.headers.get('Host')):
            self.set_header('Content-Type', 'text/plain; charset=utf-8')
            self.set_status(421)
            self.finish(f'The console does not know the address of this page: start it with --page-origin {printable(page)}')
            return
        self.set_status(204 if self.admitted() else 403)

    def post(self):
        if not self.console.access.same_origin(self.request.headers.get('Origin'), self.request.headers.get('Host')):
            raise tornado.web.HTTPError(403, reason='the request comes from another page')
        try:
            token = json.loads(self.request.body.decode('utf-8'))['token']
        except (ValueError, KeyError, TypeError):
            raise tornado.web.HTTPError(400, reason='send {"token": "..."}') from None
        session = self.console.access.log_in(token, time.monotonic())
        if session is None:
            raise tornado.web.HTTPError(429, reason='too many attempts; wait a little')
        if not session:
            raise tornado.web.HTTPError(403, reason='wrong token')
        self.set_cookie(access.COOKIE, session, path='/', httponly=True, samesite='Strict',
                        secure=self.console.access.by_tls(self.request.headers.get('Origin')))
        self.set_status(204)


class Missing(Checked, tornado.web.RequestHandler):
    """Everything else."""

    def prepare(self):
        super().prepare()
        raise tornado.web.HTTPError(404)


class Socket(Checked, tornado.websocket.WebSocketHandler):
    """What the sockets share: bounds, and that a fault ends the connection and nothing else."""

    def prepare(self):
        super().prepare()
        if not self.admitted():
            raise tornado.web.HTTPError(403, reason='log in first')
        if not self.request.headers.get('Origin'):
            raise tornado.web.HTTPError(403, reason='sockets are for the page, and a page names its origin')

    def check_origin(self, origin):
        return self.console.access.same_origin(origin, self.request.headers.get('Host'))

    def open(self, *_):
        self.bucket, self.page = Bucket(RATE, BURST), None
        if not self.console.enter(self):
            self.end(TRY_LATER, 'too many connections')
            return
        self.set_nodelay(True)
        self.console.later(HELLO_PATIENCE, self._require_hello)
        self.opened()

    def _require_hello(self):
        if self.ws_connection and not self.greeted():
            self.end(POLICY, 'no hello')

    def on_message(self, data):
        if not self.bucket.take(time.monotonic()):
            self.end(POLICY, 'too many messages')
            return
        try:
            self.take(data)
        except messages.Malformed as fault:
            self.end(POLICY, f'malformed: {fault}'[:100])

    def say(self, message):
        """Sends a dict as JSON, or bytes; a connection that is gone takes nothing."""
        binary = isinstance(message, bytes)
        try:
            self.write_message(message if binary else json.dumps(message, allow_nan=False), binary)
        except tornado.websocket.WebSocketClosedError:
            pass

    def end(self, code, reason):
        self.close(code, printable(reason))

    def on_close(self):
        self.console.exit(self)
        self.closed()

    def opened(self):
        """What a kind of socket does first."""

    def closed(self):
        """What a kind of socket does last."""


class ControlSocket(Socket):
    """/control: commands."""

    def opened(self):
        self.visitor = Visitor(self.say, self.end)
        self.console.desk.enter(self.visitor)

    def greeted(self):
        return self.visitor.page is not None

    def take(self, data):
        kind, fields = messages.read(data)
        if not self.console.desk.take(self.visitor, kind, fields):
            raise messages.Malformed('the first message is hello')

    def closed(self):
        visitor = getattr(self, 'visitor', None)
        if visitor:
            self.console.desk.leave(visitor, self.close_code in IN_ORDER)


class ViewSocket(Socket):
    """/view: the newest of everything, and the next when the last was taken in."""

    def opened(self):
        self.seen, self.number, self.waiting, self.candidates = {}, 0, False, False

    def greeted(self):
        return self.page is not None

    def take(self, data):
        message = _plain(data)
        if message['type'] == 'hello':
            self.page = messages.pattern(messages.PAGE)(message.get('page'))
        elif message['type'] == 'ack':
            if message.get('n') == self.number:
                self.waiting = False
        elif message['type'] == 'want':
            self.candidates = messages.flag(message.get('candidates'))
        else:
            raise messages.Malformed('it has no type that is known')

    def show(self, scene):
        """A tick, if the page is ready for one."""
        if not self.page or self.waiting or not self.ws_connection:
            return
        binary, fields = scene.tick(self.seen)
        for message in binary:
            self.say(message)
        self.number += 1
        self.waiting = True
        self.say({'type': 'tick', 'n': self.number, **fields})


class CameraSocket(Socket):
    """/camera: the newest picture, whenever the page asks for the next."""

    def opened(self):
        self.seen, self.asked = 0, False

    def greeted(self):
        return self.page is not None

    def take(self, data):
        message = _plain(data)
        if message['type'] == 'hello' and not self.page:
            self.page = messages.pattern(messages.PAGE)(message.get('page'))
            self.console.camera.watch(1)
        elif message['type'] == 'next':
            self.asked = True
        else:
            raise messages.Malformed('it has no type that is known')

    def show(self, camera):
        """A picture, if the page asked for one and there is another."""
        found = camera.picture(self.seen) if self.page and self.asked else None
        if found:
            self.seen, self.asked = found[0], False
            self.say(found[1])

    def closed(self):
        if self.page:
            self.console.camera.watch(-1)


def printable(text):
    """The text in ASCII, without control characters."""
    return ''.join(c if ' ' <= c <= '~' else '?' for c in text)


def _plain(data):
    """A small JSON object with a type."""
    if isinstance(data, bytes) or len(data) > messages.LARGEST:
        raise messages.Malformed('it is binary or too large')
    try:
        message = json.loads(data)
    except (ValueError, RecursionError):
        raise messages.Malformed('it is no JSON') from None
    if not isinstance(message, dict) or not isinstance(message.get('type'), str):
        raise messages.Malformed('it has no type')
    return message


def application(console, page, libraries, foxglove):
    """The Tornado application. page: the folder of the page; libraries: {name: folder} of the browser's libraries; foxglove: the handler
    of Foxglove's protocol."""
    own = {'console': console}
    routes = [(r'/control', ControlSocket, own), (r'/view', ViewSocket, own), (r'/camera', CameraSocket, own), (r'/login', Login, own),
              (r'/foxglove(?:/([^/]*))?', foxglove, own),
              (r'/report/(report[\w.]*)', ReportFiles, {**own, 'path': console.report_folder})]
    routes += [(rf'/lib/{re.escape(name)}/(.*)', PageFiles, {**own, 'path': folder}) for name, folder in libraries.items()]
    routes += [(r'/lib/.*', Missing, own), (r'/(.*)', PageFiles, {**own, 'path': page, 'default_filename': 'index.html'})]
    return tornado.web.Application(routes, access=console.access, websocket_max_message_size=LARGEST,
                                   default_handler_class=Missing, default_handler_args=own, log_function=lambda handler: None)
