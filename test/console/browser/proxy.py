# SPDX-License-Identifier: BSD-3-Clause
"""A link between browser and server that can be held up, cut and closed: a TCP forwarder on a port of its own."""
import selectors
import socket
import threading

CHUNK = 1 << 16


class Proxy:
    """Forwards 127.0.0.1:port to 127.0.0.1:target. hold(): keeps back what the browser sends; flush(): delivers it at once;
    cut(): ends every connection without a word and takes no new ones until mend()."""

    def __init__(self, target):
        self.target = target
        self.lock = threading.RLock()
        self.pairs = {}     # a socket: the socket that its bytes go to
        self.upwards = set()  # the browser's sockets
        self.kept = {}      # a browser's socket: bytes that are held up
        self.held, self.open, self.running = False, True, True
        self.selector = selectors.DefaultSelector()
        self.listener = socket.create_server(('127.0.0.1', 0))
        self.port = self.listener.getsockname()[1]
        self.selector.register(self.listener, selectors.EVENT_READ)
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()

    def _run(self):
        while self.running:
            for key, _ in self.selector.select(0.05):
                with self.lock:
                    if key.fileobj is self.listener:
                        self._accept()
                    elif key.fileobj in self.pairs:
                        self._forward(key.fileobj)

    def _accept(self):
        browser, _ = self.listener.accept()
        if not self.open:
            browser.close()
            return
        server = socket.create_connection(('127.0.0.1', self.target))
        for one, other in ((browser, server), (server, browser)):
            one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.pairs[one] = other
            self.selector.register(one, selectors.EVENT_READ)
        self.upwards.add(browser)

    def _forward(self, one):
        try:
            data = one.recv(CHUNK)
            if data and self.held and one in self.upwards:
                self.kept[one] = self.kept.get(one, b'') + data
            elif data:
                self.pairs[one].sendall(data)
        except OSError:
            data = b''
        if not data:
            self._close(one)

    def _close(self, one):
        for end in (one, self.pairs.get(one)):
            if end is None or end not in self.pairs:
                continue
            self.selector.unregister(end)
            self.upwards.discard(end)
            self.kept.pop(end, None)
        other = self.pairs.pop(one, None)
        self.pairs.pop(other, None)
        for end in (one, other):
            if end is not None:
                end.close()

    def hold(self):
        with self.lock:
            self.held = True

    def flush(self):
        with self.lock:
            self.held = False
            for one, data in list(self.kept.items()):
                self.pairs[one].sendall(data)
            self.kept.clear()

    def cut(self):
        with self.lock:
            self.open = False
            for one in list(self.upwards):
                self._close(one)

    def mend(self):
        with self.lock:
            self.open = True

    def end(self):
        self.cut()
        self.running = False
        self.thread.join()
        self.listener.close()
