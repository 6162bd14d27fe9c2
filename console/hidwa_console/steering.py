# SPDX-License-Identifier: BSD-3-Clause
"""What of a page's stick and hand reaches the planner. The rules of old commands are here and nowhere else."""
import collections

Stick = collections.namedtuple('Stick', 'left forward held')    # [-1, 1] each; held: a finger is on it
Hand = collections.namedtuple('Hand', 'left forward up grip')   # [m] each; grip: the hand steers
NEUTRAL = Stick(0.0, 0.0, False)
SEEN = 0.06  # [s] for the planner to see a neutral command that it needs: it reads the newest message alone
DEVICE_OF_MODE = {'joystick': Stick, 'switching': Stick, 'gesture': Hand}


def is_neutral(command):
    """Whether the device gives no input."""
    return not command.grip if isinstance(command, Hand) else command == NEUTRAL


class Steering:
    """Passes fresh commands on to `send(command)`, and nothing else. Times are monotonic [s].

    - A command older than max_age does not steer, and neither does any other within max_age after it: of what a slow link
      delivers at once even the newest part is dropped.
    - Steering that paused for longer than the planner's timeout was lost there: it counts again only after a neutral command.
    - A neutral command ends steering however old it is: once, then nothing is sent."""

    def __init__(self, send, max_age):
        self._send, self.max_age = send, max_age
        self.neutral_needed, self.active, self._mode = True, False, None
        self._sent_at, self._late_at, self._centred_at = None, None, None

    def demand_neutral(self):
        """Another holder."""
        self.neutral_needed = True

    def in_mode(self, mode):
        """The planner's mode, or None: in another one it asks for a neutral device again. True if it is another."""
        if mode == self._mode:
            return False
        self._mode = mode
        self.release()
        self.demand_neutral()
        return True

    def take(self, command, age, now, timeout, mode, in_control=False):
        """What became of a command: 'steers', 'released', 'late', 'neutral_needed', 'clock' or 'mode'. age [s], or None where
        the page's clock is not known; timeout: the planner's input_timeout [s], 0: none; mode: the planner's, or None;
        in_control: the operator drives alone (MANUAL), so that a neutral command is one too."""
        neutral = is_neutral(command)
        self._notice_pause(now, timeout)
        fault = self._fault(command, age, now, mode)
        if fault:
            if neutral:
                self.release()
            return fault
        if neutral:
            if self.active or self.neutral_needed or in_control:
                self._centred_at = now if self.neutral_needed else self._centred_at
                self._pass(command, now, active=False)
            self.neutral_needed = False
            return 'released'
        if self.neutral_needed or (self._centred_at is not None and now - self._centred_at < SEEN):
            return 'neutral_needed'
        self._pass(command, now, active=True)
        return 'steers'

    def release(self):
        """Ends steering at once; nothing is sent where nothing steers."""
        if self.active:
            self.active = False
            self._send(NEUTRAL)

    def greet(self):
        """The planner begins to run: a change of its mode took effect only now, and it counts no device that it has not seen in
        neutral since. Nothing while something steers."""
        if not self.active and not self.neutral_needed:
            self._send(NEUTRAL)

    def forget(self):
        """The page was cut off: nothing more is sent, so that the planner notices the loss."""
        self.active, self.neutral_needed = False, True

    def _fault(self, command, age, now, mode):
        if age is None:
            return 'clock'
        if age > self.max_age:
            self._late_at = now
        if self._late_at is not None and now - self._late_at <= self.max_age:
            return 'late'
        if mode is not None and DEVICE_OF_MODE.get(mode) is not type(command) and not is_neutral(command):
            return 'mode'
        return ''

    def _notice_pause(self, now, timeout):
        if self.active and timeout > 0.0 and now - self._sent_at > timeout:
            self.forget()

    def _pass(self, command, now, active):
        self.active, self._sent_at = active, now
        self._send(command)
