# SPDX-License-Identifier: BSD-3-Clause
"""How much a visitor may send."""


class Bucket:
    """So many messages a second [1/s], and `burst` at once. Times are monotonic [s]."""

    def __init__(self, rate, burst):
        self._rate, self._burst, self._left, self._at = rate, burst, burst, None

    def take(self, now):
        """Whether one more is within bounds."""
        if self._at is not None:
            self._left = min(self._burst, self._left + (now - self._at) * self._rate)
        self._at = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True
