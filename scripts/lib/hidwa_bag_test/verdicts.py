# SPDX-License-Identifier: BSD-3-Clause
"""What is to be said of each expectation."""
import math

import numpy as np

from . import judge


class Verdicts:
    """Of the answers to a recording. Each expectation's method returns its faults in words, [] where it is met."""

    def __init__(self, description, recording, answers, robot):
        self._d, self._recording, self._answers, self._robot = description, recording, answers, robot
        self._cycles = answers.cycles
        self._sent = [cycle for cycle in self._cycles if cycle.outcome != cycle.FAIL]

    def _after_start(self, cycle):
        return cycle.header.stamp.to_sec() - self._recording.start

    @staticmethod
    def _command(cycle):
        return cycle.command.linear.x, cycle.command.angular.z

    def cycles(self):
        """A test of nothing shows nothing."""
        return [] if len(self._cycles) >= 10 else [f'the planner ran only {len(self._cycles)} cycles: is there a plan?']

    def arrived(self):
        if self._answers.reached == self._d.expect.arrived:
            return []
        return [f'the goal was {"" if self._answers.reached else "not "}reached at the end']

    def failures(self):
        failed = [cycle for cycle in self._cycles if cycle.outcome == cycle.FAIL]
        return [] if len(failed) <= self._d.expect.failures else [
            f'{len(failed)} cycles without a command (allowed: {self._d.expect.failures}), the first after '
            f'{self._after_start(failed[0]):.2f} s: {failed[0].fault}']

    def finite(self):
        return [f'after {self._after_start(cycle):.2f} s: {self._command(cycle)}' for cycle in self._sent
                if not all(map(math.isfinite, self._command(cycle)))]

    def _driven(self):
        """(cycle, command, previous command, time passed [s], follower) of every cycle that commanded something."""
        follower, previous, last = self._recording.follow(), (0.0, 0.0), None
        for cycle in self._cycles:
            time = cycle.header.stamp.to_sec()
            follower.advance(time)
            # Cycles that the machine held up: what counts is the time that passed.
            passed = max(self._robot.period, time - last) if last else self._robot.period
            failed = cycle.outcome == cycle.FAIL
            if not failed:
                yield cycle, self._command(cycle), previous, passed, follower
            previous, last = (0.0, 0.0) if failed else self._command(cycle), time  # who fails is stopped by the host

    def limits(self):
        faults = []
        for cycle, command, previous, passed, follower in self._driven():
            fault = judge.limit_fault(command, previous, follower.measured, self._robot.period, passed,
                                      self._robot.limits)
            if fault:
                faults.append(f'after {self._after_start(cycle):.2f} s: {fault}')
        return faults

    def collision_free(self):
        faults, robot, looked = [], self._robot, 0
        for cycle, command, previous, _, follower in self._driven():
            pose = follower.pose()
            if pose is None or follower.scan_time is None or not all(map(math.isfinite, command)):
                continue
            looked += 1
            hold = robot.latency + robot.period
            met = judge.swept_points(robot.footprint, pose, command, hold, robot.decel, follower.points)
            # The bag's robot may be where, and so fast that, nobody could stop it in time.
            if met and not judge.brakes_fully(command, previous, follower.measured, robot.period, robot.decel):
                faults.append(f'after {self._after_start(cycle):.2f} s: {met} points of the scan lie on the way to rest '
                              f'from v = {command[0]:.3f} m/s, omega = {command[1]:.3f} rad/s')
        return faults if looked else ['no cycle could be held against a scan: are scan, frame and base_frame right?']

    def contacts(self):
        follower, count, touching = self._recording.follow(), 0, False
        for time in np.arange(self._recording.start, self._recording.end, 0.05):
            follower.advance(time)
            pose = follower.pose()
            if pose is None:
                continue
            touched = bool(judge.covered(self._robot.footprint, [pose], follower.points).any())
            count, touching = count + (touched and not touching), touched
        return [] if count <= self._d.expect.contacts else [
            f'{count} times the scan lies in the footprint of the robot (allowed: {self._d.expect.contacts})']

    def deviation(self):
        recorded = self._recording.of(self._d.commands)
        times = np.array([cycle.header.stamp.to_sec() for cycle in self._sent])
        found = judge.mean_deviation(times, np.array([self._command(c) for c in self._sent]).reshape(-1, 2),
                                     np.array([time for time, _ in recorded]),
                                     np.array([(m.linear.x, m.angular.z) for _, m in recorded]).reshape(-1, 2))
        if found is None:
            return [f'no command was recorded on {self._d.commands} before a cycle: name the right topic by commands']
        return [f'{name}: {value:.3f} {unit} on average (allowed: {self._d.expect.deviation[name]:g})'
                for name, unit, value in zip(('v', 'omega'), ('m/s', 'rad/s'), found)
                if name in self._d.expect.deviation and value > self._d.expect.deviation[name]]

    def states(self):
        faults = []
        for entry in self._d.expect.states:
            at = self._recording.start + entry['at']
            near = [s for s in self._answers.states if abs(s.header.stamp.to_sec() - at) <= 2.0 * self._robot.period]
            names = sorted({state.state_name for state in near}) or ['nothing said']
            if entry['is'] not in names:
                faults.append(f'after {entry["at"]:g} s the state is {" or ".join(names)}, not {entry["is"]}')
        return faults

    def all(self):
        """{expectation: faults} of all that are expected."""
        return {name: getattr(self, name)() for name in ['cycles', *self._d.expect.given()]}
