# SPDX-License-Identifier: BSD-3-Clause
"""Who is let in: hosts, origins, tokens, sessions. Nothing here knows Tornado or ROS."""
import hmac
import ipaddress
import secrets
from urllib.parse import urlsplit

from .bounds import Bucket

LOOPBACK = ('localhost', '127.0.0.1', '::1')
COOKIE = 'hidwa_console'
USUAL = {'http': 80, 'https': 443}  # ports that a browser leaves out
SESSIONS = 64                       # remembered; the oldest goes
LOGIN_RATE, LOGIN_BURST = 0.5, 10   # [1/s] attempts, and at once


def is_loopback(address):
    """Whether a server bound to this address is reached from this machine alone."""
    if address == 'localhost':
        return True
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return False


def split_host(host):
    """(name, port or None) of a Host header, in lower case; ('', None) where it is none."""
    if not host or any(c in host for c in '/@?#\\ \t,'):
        return '', None
    try:
        parts = urlsplit('//' + host)
        return (parts.hostname or '').lower(), parts.port
    except ValueError:
        return '', None


class Access:
    """Which requests are admitted. A page of another site can make a browser send requests here; it can neither change Origin
    nor, by pointing its own name at this address (DNS rebinding), Host.

    page_origins: as browsers see the page where its address is another one than this server's: behind a proxy, or a port that is
    forwarded under another number. The Host of such a request is that of the origin, or one of this server's own."""

    def __init__(self, port, names=(), token=None, secure=False, foreign_origins=(), page_origins=()):
        self._port, self._token, self._scheme = port, token, 'https' if secure else 'http'
        self._hosts = {name.lower() for name in (*LOOPBACK, *names)}
        self._foreign = {origin.rstrip('/').lower() for origin in foreign_origins}
        self._pages = {place_of(origin): origin.rstrip('/').lower() for origin in page_origins}
        self._sessions, self._attempts = [], Bucket(LOGIN_RATE, LOGIN_BURST)

    @property
    def open(self):
        """Whether no token is asked for."""
        return self._token is None

    def host_allowed(self, host):
        """Whether a request names this server by a name that it knows."""
        name, port = split_host(host)  # some proxies leave the port out
        return self._own(host) or any(name == page[1] and port in (None, page[2]) for page in self._pages)

    def _own(self, host):
        name, port = split_host(host)
        return name in self._hosts and (port or USUAL[self._scheme]) == self._port

    def same_origin(self, origin, host):
        """Whether a request comes from a page that this server served."""
        if not origin:
            return False
        return place_of(origin) in self._pages or (self._own(host) and origin.lower() == f'{self._scheme}://{host.lower()}')

    def by_tls(self, origin):
        """Whether the page of this origin comes by TLS, here or at the proxy."""
        return self._scheme == 'https' or (place_of(origin) in self._pages and origin.lower().startswith('https:'))

    def sockets_of(self, host):
        """The origins of the sockets of a page that was asked for by this Host."""
        own = f'{self._scheme}://{host}'
        return sorted(origin.replace('http', 'ws', 1) for origin in {own, *self._pages.values()})

    def foreign_allowed(self, origin, token):
        """Whether another program, or a page of another site, may use Foxglove's protocol. On loopback: programs, and pages from
        this machine. Elsewhere: the named origins and programs, with the token in the path."""
        if self._token is not None and not self._right(token):
            return False
        if not origin or origin.lower() in self._foreign:
            return self._token is None or bool(self._foreign)
        if self._token is not None:
            return False
        try:
            return origin == 'file://' or (urlsplit(origin).hostname or '') in LOOPBACK
        except ValueError:
            return False

    def _right(self, token):
        return isinstance(token, str) and hmac.compare_digest(token.encode('utf-8', 'replace'), self._token.encode())

    def log_in(self, token, now):
        """A new session's secret; '' for a wrong token, None after too many attempts. now: monotonic [s]."""
        if not self._attempts.take(now):
            return None
        if self._token is None or not self._right(token):
            return ''
        self._sessions = [*self._sessions[-(SESSIONS - 1):], secrets.token_urlsafe(32)]
        return self._sessions[-1]

    def admitted(self, cookie):
        """Whether a request with this cookie (or None) may use the sockets."""
        if self._token is None:
            return True
        given = (cookie or '').encode('utf-8', 'replace')
        return any([hmac.compare_digest(given, session.encode()) for session in self._sessions])


def place_of(origin):
    """(scheme, name, port) of an origin, in lower case; None where it is none."""
    scheme, _, host = (origin or '').rstrip('/').lower().partition('://')
    name, port = split_host(host)
    return (scheme, name, port or USUAL[scheme]) if name and scheme in USUAL else None


def new_token():
    """128 bits, for an address that a person copies."""
    return secrets.token_urlsafe(16)


def headers(sockets):
    """Security headers of every answer; `sockets`: the origins to which the page's sockets go."""
    policy = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
              f"connect-src 'self' {' '.join(sockets)}; worker-src 'self'; font-src 'self'; manifest-src 'self'; base-uri 'none'; "
              "form-action 'self'; frame-ancestors 'none'")
    return {'Content-Security-Policy': policy, 'X-Content-Type-Options': 'nosniff', 'Referrer-Policy': 'no-referrer',
            'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Resource-Policy': 'same-origin',
            'X-Frame-Options': 'DENY', 'Cache-Control': 'no-cache', 'Server': 'hidwa_console'}
