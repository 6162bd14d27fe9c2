# SPDX-License-Identifier: BSD-3-Clause
"""Who holds the controls: one page, until it hands them over or has been gone for a while."""

KEPT = 5.0  # [s] for which a page that was cut off keeps the controls


class Lease:
    """Pages are named by their secret names. Times are monotonic [s]."""

    def __init__(self):
        self.holder = None  # a page, or None
        self.claims = []    # pages that ask, the first first
        self._gone_at = None

    def claim(self, page, now):
        """'granted' or 'asked'."""
        self.lapse(now)
        if self.holder in (None, page):
            self._grant(page)
            return 'granted'
        if page not in self.claims:
            self.claims.append(page)
        return 'asked'

    def give(self, page, to):
        """The holder hands the controls to a page that asked, or to nobody (None). Whether it could."""
        if page != self.holder or (to is not None and to not in self.claims):
            return False
        self._grant(to)
        return True

    def refuse(self, page, to):
        """The holder says no to a page that asked."""
        if page != self.holder or to not in self.claims:
            return False
        self.claims.remove(to)
        return True

    def left(self, page, now):
        """A page's connection ended."""
        if page in self.claims:
            self.claims.remove(page)
        if page == self.holder:
            self._gone_at = now

    def back(self, page):
        """A page is connected (again)."""
        if page == self.holder:
            self._gone_at = None

    def lapse(self, now):
        """Takes the controls from a holder that has been gone too long; the first that asked has them then. True if so."""
        if self._gone_at is None or now - self._gone_at < KEPT:
            return False
        self._grant(self.claims[0] if self.claims else None)
        return True

    def _grant(self, page):
        self.holder, self._gone_at = page, None
        if page in self.claims:
            self.claims.remove(page)
