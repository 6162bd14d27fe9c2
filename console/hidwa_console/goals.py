# SPDX-License-Identifier: BSD-3-Clause
"""Where the robot is to go: one goal after the other, by move_base's action. All of it runs in the server's thread."""
import itertools
import math

MOST = 50          # goals that wait
TOUR_PAUSE = 5.0   # [s] without anything to do, then the tour goes on
NEAR = 0.5         # [m]; a goal of the tour that is nearer than this is passed over
SEND_AGAIN = 2.0   # [s] after which a goal that move_base does not know is sent again: it may not have been connected
SUCCEEDED, PREEMPTED, RECALLED = 3, 2, 8  # actionlib_msgs/GoalStatus


class Goals:
    """`send(id, (x, y, yaw))` gives move_base a goal, `cancel()` ends all of its goals; `progress` is told. tour: poses to drive to
    for ever while nobody wants anything else."""

    def __init__(self, send, cancel, progress, tour=()):
        self._send, self._cancel, self._progress = send, cancel, progress
        self._tour, self._numbers = itertools.cycle(tour) if tour else None, itertools.count(1)
        self.start, self.active, self.waiting = None, None, []
        self.outcome, self.text = '', ''
        self._id, self._idle_since, self._resting = None, None, False
        self._unknown_since = None  # of the goal that was sent, until move_base names it

    def see(self, pose, now, stopped):
        """Where the robot is; once a tick. stopped: somebody stops it."""
        if pose is None:
            return
        self.start = self.start or tuple(pose)
        if self.active and self._unknown_since is not None and now - self._unknown_since > SEND_AGAIN:
            self._unknown_since = now
            self._send(self._id, self.active)
        if self.active or self.waiting or self._resting or stopped or self._tour is None:
            self._idle_since = now
        elif self._idle_since is None:
            self._idle_since = now - TOUR_PAUSE  # the first goal at once
        elif now - self._idle_since >= TOUR_PAUSE:
            goal = next(self._tour)
            if math.dist(goal[:2], pose[:2]) >= NEAR:
                self._drive(tuple(goal), now)

    def goal(self, x, y, yaw, append, pose, now):
        """(ok, text). yaw None: as the robot arrives."""
        if append and len(self.waiting) >= MOST:
            return False, f'{MOST} goals wait already'
        before = (self.waiting or [self.active or pose])[-1] if append else pose
        if yaw is None:
            yaw = math.atan2(y - before[1], x - before[0]) if before else 0.0
        self._resting = False
        if append and self.active:
            self.waiting.append((x, y, yaw))
        else:
            self.waiting = [*self.waiting, (x, y, yaw)] if append else [(x, y, yaw)]
            self._next(now)
        return True, ''

    def home(self, append, pose, now):
        """Back to where the robot was first seen."""
        return self.goal(*self.start, append, pose, now) if self.start else (False, 'it is not known yet where the robot began')

    def cancel(self):
        """Nothing to do any more; the tour rests until another goal is given."""
        self.waiting, self._resting = [], True
        self._cancel()
        if self.active:
            self._end('cancelled', '')
        return True, ''

    def skip(self, now):
        """On to the next goal that waits."""
        if not self.waiting:
            return False, 'no other goal waits'
        self._next(now)
        return True, ''

    def seen(self, number, pose, now):
        """A goal on move_base's action, whoever gave it."""
        if number == self._id:
            return
        self._id, self.active, self.waiting, self.outcome, self.text = number, tuple(pose), [], '', 'another program gave this goal'
        self._progress.begin(now)

    def known(self, numbers):
        """The goals that move_base knows."""
        if self._id in numbers:
            self._unknown_since = None

    def result(self, number, status, text, now):
        """The end of a goal."""
        if number != self._id or not self.active:
            return
        reached = status == SUCCEEDED
        self._end('reached' if reached else 'cancelled' if status in (PREEMPTED, RECALLED) else 'failed', '' if reached else text)
        if reached and self.waiting:
            self._next(now)

    def _next(self, now):
        self._drive(self.waiting.pop(0), now)

    def _drive(self, pose, now):
        self._id, self.active, self.outcome, self.text = f'console-{next(self._numbers)}-{now:.3f}', pose, '', ''
        self._unknown_since = now
        self._progress.begin(now)
        self._send(self._id, pose)

    def _end(self, outcome, text):
        self.active, self.outcome, self.text = None, outcome, text
        self._progress.end()

    def report(self):
        """The page's `goals`."""
        def short(pose):
            return pose and [round(v, 3) for v in pose]
        return {'active': short(self.active), 'waiting': [short(p) for p in self.waiting], 'start': short(self.start),
                'outcome': self.outcome, 'text': self.text}
