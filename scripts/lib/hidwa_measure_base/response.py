# SPDX-License-Identifier: BSD-3-Clause
"""How a base answers steps of its command. A step is taken for a delay, and then an even change of the velocity, or one that gets
slower and slower (a lag: such a base follows every command later by its time constant, which counts as latency). What is
compared is how far the robot came, which odometry knows better than how fast it is. Times in s; lengths in m or rad.

Of all that explains a measurement about equally well, the careful answer counts: the longest latency, the smallest acceleration."""
from dataclasses import dataclass

import numpy as np

from .track import Run

COARSE = np.arange(0.0, 1.25, 0.025)           # [s], latencies at first ...
FINE = np.arange(-0.15, 0.1525, 0.005)         # [s], ... and around the best of them
DURATIONS = np.r_[0.0, np.geomspace(0.02, 3.0, 25)]  # of a change [s]
RATES = np.geomspace(0.5, 2.0, 57)             # of the usual rate, 2.5 % apart
SILENCE = 0.3         # [s] without commands; from then on they have ceased
CLOSEST = 0.015       # [s]; between two messages of odometry that count
LAGS = np.geomspace(0.01, 1.0, 60)             # time constants [s]
STEADY = 0.5          # [s]; a command stays the same for this long before a step, and after it
BEFORE, WINDOW = 0.5, 4.0  # [s]; of odometry before and after a step that count
SMALLEST = (0.05, 0.1)     # [m/s], [rad/s]; what changes by less is no step
NOISE = (2e-4, 5e-4)  # [m], [rad]; what odometry resolves at best
SURE = 4.0            # squared standard deviations


@dataclass
class Step:
    """A command that changed at once."""
    time: float       # [s]
    before: float     # [m/s] or [rad/s]
    after: float
    begin: float      # from here on the base has surely answered the command before [s]
    end: float        # the next command that differs [s]

    @property
    def slows(self):
        return abs(self.after) < abs(self.before)


@dataclass
class Answer:
    """How the base answered a step."""
    step: Step
    latency: float    # [s]; the longest that explains it
    change: float     # of the velocity [m/s] or [rad/s]
    time: np.ndarray  # from the step on [s]
    way: np.ndarray   # measured, from the step on
    fitted: np.ndarray


@dataclass
class Answers:
    """The steps of one axis and one kind."""
    each: list        # Answer
    rate: float       # [m/s^2] or [rad/s^2]: the smallest that explains them


def steps(track, axis):
    """The Steps of one axis: commands that stood, then others that stand. What leads from forwards to backwards is none."""
    found, before = [], Run(-np.inf, np.inf, np.inf, (0.0, 0.0))
    for run in track.runs():
        old, new = before.command[axis], run.command[axis]
        steady = min(run.begin - before.begin, run.end - run.begin) >= STEADY
        ceased = run.begin - before.end > SILENCE  # the base has stopped by itself
        if steady and not ceased and abs(new - old) >= SMALLEST[axis] and old * new >= 0.0:
            found.append(Step(run.begin, old, new, max(run.begin - BEFORE, 0.5 * (before.begin + run.begin)), run.end))
        before = run
    return found


def _ramp(time, latency, duration):
    """How far a robot came whose velocity changes by 1 evenly: (..., n) for latency and duration (..., 1)."""
    since = np.maximum(time - latency, 0.0)
    with np.errstate(divide='ignore', invalid='ignore'):
        within = np.where(duration > 0.0, since ** 2 / (2.0 * duration), since)
    return np.where(since < duration, within, since - 0.5 * duration)


def _lag(time, latency, constant):
    """The same where the velocity approaches its new value with a time constant."""
    since = np.maximum(time - latency, 0.0)
    return since + constant * np.expm1(-since / constant)


class _Fit:
    """One step against all latencies: what was driven before and after evenly is fitted at once, whatever the velocities."""

    def __init__(self, step, time, way):
        chosen = np.flatnonzero((time >= step.begin) & (time <= min(step.end, step.time + WINDOW)))
        if len(chosen) > 2:
            chosen = chosen[::max(1, int(CLOSEST / np.median(np.diff(time[chosen]))))]
        self.step, self.time, self.way, self.latencies = step, time[chosen] - step.time, way[chosen], COARSE
        self.usable = np.count_nonzero(self.time > 0.0) >= 4 and np.count_nonzero(self.time <= 0.0) >= 2
        if not self.usable:
            return
        even = np.column_stack([np.ones_like(self.time), self.time])
        self.even, _ = np.linalg.qr(even)
        self._left = self.way - self.even @ (self.even.T @ self.way)

    def errors(self, duration, form=_ramp):
        """Sum of squared errors for each of the latencies, and the change of velocity that goes with it."""
        shape = form(self.time[None, :], self.latencies[:, None], duration)
        shape = shape - (shape @ self.even) @ self.even.T
        size = np.einsum('ij,ij->i', shape, shape)
        with np.errstate(divide='ignore', invalid='ignore'):
            change = np.where(size > 1e-12, shape @ self._left / size, 0.0)
        return float(self._left @ self._left) - change ** 2 * size, change

    def fitted(self, latency, duration, form):
        basis = np.column_stack([np.ones_like(self.time), self.time, form(self.time, latency, duration)])
        return basis @ np.linalg.lstsq(basis, self.way, rcond=None)[0]


def answers(found, time, way, axis):
    """The Answers of an axis to Steps of one kind; None where odometry shows none of them."""
    kept = []  # (fit, change of the velocity, duration)
    for fit in (_Fit(step, time, way) for step in found):
        if fit.usable:
            tried = [(*fit.errors(duration), duration) for duration in DURATIONS]
            error, change, duration = min(tried, key=lambda one: one[0].min())
            if abs(change[error.argmin()]) >= 0.5 * SMALLEST[axis]:  # the robot answered
                kept.append((fit, abs(change[error.argmin()]), max(duration, DURATIONS[1])))
                fit.latencies = np.maximum(fit.latencies[error.argmin()] + FINE, 0.0)
    if not kept:
        return None
    rates = RATES * np.median([size / duration for _, size, duration in kept])
    ramps = np.array([[fit.errors(size / rate)[0] for rate in rates] for fit, size, _ in kept])  # (fits, rates, latencies)
    lags = np.array([[fit.errors(constant, _lag)[0] for constant in LAGS] for fit, _, _ in kept])
    of_ramps, of_lags = (errors.min(axis=2).sum(axis=0) for errors in (ramps, lags))
    free = max(1, sum(len(fit.time) - 4 for fit, _, _ in kept))
    variance = max(min(of_ramps.min(), of_lags.min()) / free, NOISE[axis] ** 2)
    lagging = of_lags.min() + SURE * variance < of_ramps.min()
    if lagging:
        chosen = int(np.flatnonzero(of_lags <= of_lags.min() + SURE * variance)[-1])
        rate, form = float(np.median([size for _, size, _ in kept]) / LAGS[chosen]), _lag
    else:
        chosen = int(np.flatnonzero(of_ramps <= of_ramps.min() + SURE * variance)[0])
        rate, form = float(rates[chosen]), _ramp
    each = []
    for (fit, size, _), own in zip(kept, (lags if lagging else ramps)[:, chosen]):
        delay = float(fit.latencies[np.flatnonzero(own <= own.min() + SURE * variance)[-1]])
        duration = LAGS[chosen] if lagging else size / rates[chosen]
        latency = delay + LAGS[chosen] if lagging else delay
        each.append(Answer(fit.step, latency, size, fit.time, fit.way, fit.fitted(delay, duration, form)))
    return Answers(each, rate)


def shift(sent_time, sent, time, way, axis):
    """By how much a drive follows its commands [s], where those change all the time; the time in which the base speeds up counts as
    latency. The longest that explains the drive about as well as the best does; None where it explains less than half of it."""
    if len(sent_time) < 10 or len(time) < 10:
        return None
    fine = np.arange(sent_time[0], max(sent_time[-1], time[-1]) + 0.005, 0.005)
    value = sent[np.clip(np.searchsorted(sent_time, fine, side='right') - 1, 0, len(sent) - 1)]
    asked = np.r_[0.0, np.cumsum(value[:-1] * np.diff(fine))]
    latencies = np.arange(0.0, 1.2525, 0.005)
    begin = sent_time[0] + latencies[-1]
    pieces = [np.flatnonzero((time >= a) & (time < a + WINDOW)) for a in np.arange(begin, sent_time[-1] - 0.5 * WINDOW, WINDOW)]
    pieces = [piece for piece in pieces if len(piece) >= 6]
    if not pieces:
        return None
    errors, whole, count = np.zeros(len(latencies)), 0.0, 0
    for piece in pieces:
        t = time[piece] - time[piece[0]]
        even, _ = np.linalg.qr(np.column_stack([np.ones_like(t), t]))
        left = way[piece] - even @ (even.T @ way[piece])
        shape = np.interp(time[piece][None, :] - latencies[:, None], fine, asked)
        shape = shape - (shape @ even) @ even.T
        size = np.einsum('ij,ij->i', shape, shape)
        share = np.divide(shape @ left, size, out=np.zeros_like(size), where=size > 1e-9)
        errors += left @ left - np.maximum(share, 0.0) ** 2 * size
        whole += left @ left
        count += len(piece) - 3
    if not errors.min() < 0.5 * whole or whole < count * NOISE[axis] ** 2 * 10.0:
        return None
    variance = max(errors.min() / max(1, count), NOISE[axis] ** 2)
    return float(latencies[np.flatnonzero(errors <= errors.min() + SURE * variance)[-1]])
