# SPDX-License-Identifier: BSD-3-Clause
"""How old a page's message is: the offset of the page's clock, measured by ping."""
import collections

WINDOW = 30.0        # [s] for which a measurement counts; clocks drift apart
STEP_MARGIN = 0.02   # [s] beyond which two measurements that exclude each other mean a clock that was set
EARLY_MARGIN = 0.05  # [s] a message may seem to come from the future, beyond the error of the offset

Measured = collections.namedtuple('Measured', 'at rtt offset')  # [s] each; offset: page's time minus ours


class PageClock:
    """Times of this side are monotonic [s], those of the page are its performance.now() [ms].

    A ping sent at a and answered at b with the page's time p says that p lies between a and b: the offset is p - (a + b) / 2,
    wrong by (b - a) / 2 at most. Of the measurements of the last 30 s the one with the shortest way counts."""

    def __init__(self):
        self._measured = collections.deque()
        self._sent = None  # (id, at) of the ping on its way
        self._next, self.count, self.rtt = 1, 0, None

    def ping(self, now):
        """The id of a ping to send now, or None while one is on its way."""
        if self._sent:
            return None
        self._sent = (self._next, now)
        self._next += 1
        return self._sent[0]

    def pong(self, number, page_time, now):
        """Takes an answer; False where it answers no ping."""
        if not self._sent or number != self._sent[0]:
            return False
        sent, self._sent = self._sent[1], None
        self.rtt = now - sent
        self.count += 1
        self._take(Measured(now, self.rtt, page_time / 1000.0 - (sent + now) / 2.0))
        return True

    def _take(self, new):
        best = self._best()
        if best and abs(new.offset - best.offset) > (new.rtt + best.rtt) / 2.0 + STEP_MARGIN:
            self._measured.clear()  # both cannot be true: the page's clock was set, or stood still in a sleep
        self._measured.append(new)
        while self._measured[0].at < new.at - WINDOW:
            self._measured.popleft()

    def _best(self):
        return min(self._measured, key=lambda m: m.rtt) if self._measured else None

    def age(self, page_time, now):
        """Age [s] of a message of this page time [ms]; None where it cannot be said: nothing measured, or from the future."""
        best = self._best()
        if best is None:
            return None
        age = now - (page_time / 1000.0 - best.offset)
        return None if age < -(best.rtt / 2.0 + EARLY_MARGIN) else max(0.0, age)

    def delay(self, now):
        """The last exchange's time, or how long the ping on its way has waited if that is longer [s]."""
        waiting = now - self._sent[1] if self._sent else 0.0
        return max(waiting, self.rtt or 0.0)
