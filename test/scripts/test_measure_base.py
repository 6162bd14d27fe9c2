# SPDX-License-Identifier: BSD-3-Clause
"""measure_base against bases whose answers are known by construction, and against a real robot's bags."""
import contextlib
import io
import math
import os
import random
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np
import yaml

from hidwa_measure_base import course, findings, main
from hidwa_measure_base.course import Course, Doubt, Watch, phases
from hidwa_measure_base.track import Track
from hidwa_tools.places import DATA, ROOT

STEP = 0.002  # [s]


class Base:
    """A differential drive along x that turns: a latency, then a ramp; what is below the dead band does not move it. Without a
    command for `watchdog` [s] it stops."""

    def __init__(self, latency=0.12, acc=(0.8, 2.0), decel=(0.6, 1.6), dead=(0.0, 0.0), watchdog=0.4, spread=0.0):
        self.latency, self.acc, self.decel, self.dead, self.watchdog = latency, acc, decel, dead, watchdog
        self._spread, self._random = spread, random.Random(5)
        self.way, self.speed, self.target = [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]
        self.x, self.y, self._pending, self._heard, self.longest = 0.0, 0.0, [], -math.inf, 0.0

    def command(self, now, v, omega):
        delay = self.latency - self._spread * self._random.random()
        if self._pending and self._pending[-1][1:] == (v, omega):
            delay = self.latency
        self._pending.append((max(now + delay, self._pending[-1][0] if self._pending else 0.0), v, omega))

    def follow(self, axis, wanted):
        """The velocity of the next step."""
        slows = abs(wanted) < abs(self.speed[axis])
        limit = (self.decel if slows else self.acc)[axis] * STEP
        return self.speed[axis] + max(-limit, min(limit, wanted - self.speed[axis]))

    def advance(self, now):
        while self._pending and self._pending[0][0] <= now:
            self._heard, *self.target = self._pending.pop(0)
        for axis in (0, 1):
            wanted = self.target[axis] if now - self._heard <= self.watchdog else 0.0
            wanted = wanted if abs(wanted) >= self.dead[axis] else 0.0
            self.speed[axis] = self.follow(axis, wanted)
            self.way[axis] += self.speed[axis] * STEP
        self.x += self.speed[0] * STEP * math.cos(self.way[1])
        self.y += self.speed[0] * STEP * math.sin(self.way[1])


class LaggingBase(Base):
    """One whose velocity approaches the command with a time constant."""
    constant = 0.25  # [s]

    def follow(self, axis, wanted):
        return self.speed[axis] + (wanted - self.speed[axis]) * STEP / self.constant


def guided(base, rate=50.0, delay=0.0, noise=0.0, stamped=0.0, change=None, lifted=False, **options):
    """The Track of a guided measurement of a base: odometry at `rate` [Hz] that arrives `delay` [s] after it was measured, whose stamp
    is `stamped` [s] before its arrival. `change(row)` may alter a row of odometry or leave it out."""
    track, all_ = Track(), phases(options.get('speed', 0.25), options.get('turn', 0.5), options.get('times', 3))
    drive, watch, draw = Course(track, all_), Watch(track, lifted), np.random.default_rng(3)
    under_way, now, command_at, odometry_at = [], 0.0, 1.0, 0.013
    while True:
        now += STEP
        base.advance(now)
        if now >= odometry_at:
            odometry_at += 1.0 / rate * draw.uniform(0.95, 1.05)
            error = noise * draw.normal(size=3)
            under_way.append((now + delay, base.x + error[0], base.y + error[1], base.way[1] + error[2], *base.speed))
        while under_way and under_way[0][0] <= now:
            row = (*under_way.pop(0), now - stamped)
            row = change(row) if change else row
            if row:
                track.receive(*row)
        if now >= command_at:
            command_at += 0.05
            watch.check(now)
            try:
                command = drive.command(now)
            except StopIteration:
                return track
            if command:
                track.command(now, *command)
                base.command(now, *command)
                base.longest = max(base.longest, abs(command[0]), abs(command[1]) * course.FASTEST / course.FASTEST_TURN)


def measured(base, **options):
    return findings.find(guided(base, **options))


class Known(unittest.TestCase):
    def assert_near(self, found, base, latency, share):
        """The latency is not below the true one, and no more than `latency` [s] above; rates are not above by more than 5 %, and not
        below by more than `share`."""
        self.assertGreaterEqual(found.latency, base.latency - 0.0026)  # as finely as it is looked for
        self.assertLessEqual(found.latency, base.latency + latency)
        for rates, truth in ((found.acceleration, base.acc), (found.deceleration, base.decel)):
            for axis in (0, 1):
                self.assertLessEqual(rates[axis], 1.05 * truth[axis])
                self.assertGreaterEqual(rates[axis], (1.0 - share) * truth[axis])

    def test_a_base_is_found_as_it_is(self):
        for base, times in ((Base(), 10), (Base(latency=0.03, acc=(2.5, 3.2), decel=(2.5, 3.2)), 3),
                            (Base(latency=0.45, acc=(0.3, 0.5), decel=(0.25, 0.4)), 3)):
            with self.subTest(latency=base.latency):
                found = measured(base, times=times)
                # To and fro, two axes, on and off; twice on before commands cease.
                self.assertEqual(len(found.latencies), times * 2 * 2 * 2 + 2)
                self.assert_near(found, base, 0.015, 0.10)

    def test_slow_odometry(self):
        for rate in (10.0, 20.0, 50.0):
            with self.subTest(rate=rate):
                found, base = measured(Base(), rate=rate), Base()
                self.assert_near(found, base, 0.5 / rate + 0.01, 0.15)
                self.assertEqual(any('comes only every' in remark for remark in found.remarks), rate == 10.0)

    def test_odometry_that_arrives_late_counts_as_latency_and_is_said(self):
        for stamped in (0.06, 0.3, -0.2):  # true stamps, stamps that are late, a clock that is ahead
            found = measured(Base(), delay=0.06, stamped=stamped)
            self.assertGreaterEqual(found.latency, 0.18 - 0.0026)
            self.assertLessEqual(found.latency, 0.195)
            self.assertEqual([('old by its stamps' in r, 'ahead of this machine' in r) for r in found.remarks],
                             {0.06: [], 0.3: [(True, False)], -0.2: [(False, True)]}[stamped])

    def test_noise(self):
        # 1 mm and 1 mrad of each pose; a step drives 0.3 m.
        self.assert_near(measured(Base(), noise=1e-3), Base(), 0.05, 0.30)

    def test_a_base_that_lags_needs_no_more_way_than_is_said_at_any_speed(self):
        for constant in (0.1, 0.25):
            base = LaggingBase(latency=0.1)
            base.constant = constant
            found = measured(base, rate=20.0)
            values = {name: value for name, (value, _) in findings.parameters(found).items()}
            # It goes on at full speed for the latency, and then as far as it would in the time constant.
            for speed in (0.05, 0.25, 1.0):
                said = speed * values['control_latency'] + speed ** 2 / (2.0 * values['decel_lim_x'])
                self.assertGreaterEqual(said, speed * (0.1 + constant) - 1e-3)
            self.assertLessEqual(values['control_latency'], 0.1 + constant + 0.05)

    def test_the_longest_latency_counts(self):
        # Some commands are quicker by up to 0.05 s: none overtakes the one before, which was sent 0.05 s earlier.
        found = measured(Base(latency=0.2, spread=0.1))
        self.assertLessEqual(0.19, found.latency)
        self.assertLessEqual(found.latency, 0.22)
        self.assertLess(min(found.latencies), 0.17)

    def test_a_twist_alone_is_enough(self):
        found = measured(Base(), change=lambda row: (row[0], 0.0, 0.0, 0.0, *row[4:]))
        self.assert_near(found, Base(), 0.02, 0.12)

    def test_the_dead_band(self):
        found = measured(Base(dead=(0.05, 0.22)))
        # Commands grow by 0.015 m/s and 0.03 rad/s: the first ones that move it are 0.06 and 0.24.
        self.assertEqual([tuple(round(v, 3) for v in band) for band in found.dead_band], [(0.045, 0.06), (0.21, 0.24)])
        self.assertEqual(findings.parameters(found)['min_in_place_vel_theta'][0], 0.24)
        found = measured(Base())
        self.assertEqual(found.dead_band[1][0], 0.0)
        self.assertNotIn('min_in_place_vel_theta', findings.parameters(found))

    def test_when_commands_cease(self):
        # The last command counts for 0.12 + 0.4 s, and 0.25 m/s end after 0.25 / 0.6 = 0.417 s: rest after 0.937 s, and
        # 0.52 * 0.25 + 0.25^2 / 1.2 = 0.182 m further on. What is below 1.5 mm counts as rest: the last 0.07 s.
        found = measured(Base())
        self.assertAlmostEqual(found.stop_time, 0.92, delta=0.08)
        self.assertEqual(found.stop_way, '0.18 m')
        self.assertIn('rests after', findings.text(found))
        found = measured(Base(watchdog=math.inf))
        self.assertIsNone(found.stop_time)
        self.assertIn('THE BASE DOES NOT STOP BY ITSELF', findings.text(found))

    def test_what_is_printed_is_what_the_planner_takes(self):
        with open(os.path.join(ROOT, 'include', 'hidwa_local_planner', 'core', 'parameter_list.inc'), encoding='utf-8') as text:
            listed = text.read()
        found = measured(Base(dead=(0.0, 0.2)))
        values = yaml.safe_load(findings.text(found))['HIDWAPlannerROS']
        self.assertEqual(set(values), {'control_latency', 'acc_lim_x', 'decel_lim_x', 'acc_lim_theta', 'decel_lim_theta',
                                       'min_in_place_vel_theta'})
        for name, value in values.items():
            self.assertIn(f'({name},', listed)
            self.assertIsInstance(value, (int, float))
        self.assertGreaterEqual(values['control_latency'], 0.12)
        self.assertLessEqual(values['decel_lim_x'], 0.6)


class Driving(unittest.TestCase):
    def test_it_is_never_faster_than_it_says_and_ends_where_it_began(self):
        base = Base()
        track = guided(base, speed=0.3, turn=0.6)
        self.assertLessEqual(base.longest, 0.3)
        self.assertLess(max(abs(row[1]) for row in track.odometry), course.FREE)
        self.assertLess(math.hypot(base.x, base.y), 0.15)
        self.assertEqual(track.commands[-1][1:], (0.0, 0.0))
        for words in (['--speed', '0.31'], ['--turn', '0.7'], ['--speed', 'nan'], ['--clearance', '0']):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
                main.parser().parse_args(words)

    def assert_doubt(self, said, base=None, **options):
        base = base or Base()
        with self.assertRaisesRegex(Doubt, said):
            guided(base, **options)

    def test_every_doubt_ends_it(self):
        self.assert_doubt('no odometry', change=lambda row: None)
        self.assert_doubt(r'missing: the last message is 0\.5', change=lambda row: row if row[0] < 7.0 else None)
        self.assert_doubt('jumped by 0.4', change=lambda row: row if row[0] < 7.0 else (row[0], row[1] + 0.4, *row[2:]))
        self.assert_doubt('jumped by .* and 1.5', change=lambda row: row if row[0] < 7.0 else (*row[:3], row[3] + 1.5, *row[4:]))
        self.assert_doubt('no number', change=lambda row: row if row[0] < 7.0 else (row[0], math.nan, *row[2:]))
        self.assert_doubt('back in time', change=lambda row: row if row[0] < 7.0 else (*row[:6], row[6] - 1.0))
        self.assert_doubt('other way', change=lambda row: (row[0], -row[1], *row[2:]))
        self.assert_doubt('does not move', Base(dead=(1.0, 1.0)))
        self.assert_doubt('does not come to rest', Base(decel=(0.001, 1.0), watchdog=math.inf), lifted=True)

    def test_a_base_that_goes_away_is_not_followed(self):
        # Backwards it is not driven at all: each time it ends farther ahead.
        class Forwards(Base):
            def command(self, now, v, omega):
                super().command(now, max(v, 0.0), omega)
        with self.assertRaisesRegex(Doubt, 'does not move at a command of -0.25'):
            guided(Forwards())

        class Drifting(Base):
            def command(self, now, v, omega):
                super().command(now, v if v >= 0.0 else 0.4 * v, omega)
        with self.assertRaisesRegex(Doubt, 'from where it began'):
            guided(Drifting(), times=10)
        guided(Drifting(), times=10, lifted=True)  # lifted, it goes nowhere

    def test_each_doubt_leaves_what_was_sent_at_its_limits(self):
        base = Base(watchdog=math.inf)
        with self.assertRaises(Doubt):
            guided(base, change=lambda row: row if row[0] < 7.0 else None)
        self.assertLessEqual(base.longest, 0.3)


class Bags(unittest.TestCase):
    def run_on(self, name, *options):
        path = os.path.join(DATA, 'bags', name)
        if not os.path.exists(path):
            self.skipTest(f'{path} is absent')
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said, \
             contextlib.redirect_stderr(io.StringIO()) as remark:
            picture = os.path.join(folder, 'picture.png')
            status = main.main(['--bag', path, '--picture', picture, *options])
            drawn = os.path.exists(picture)
        return status, said.getvalue(), remark.getvalue(), drawn

    def test_steps_of_a_real_robot(self):
        status, said, remark, drawn = self.run_on('neato_test_drive.bag')
        self.assertEqual(status, 0, remark)
        values = yaml.safe_load(said)['HIDWAPlannerROS']
        # By eye: 1 m/s is commanded at 2.18 s of the bag; odometry at 2.48 s still says 0, at 2.53 s 0.22 m/s. Its usual steps
        # show after 0.1 to 0.2 s.
        self.assertGreaterEqual(values['control_latency'], 0.30)
        self.assertLessEqual(values['control_latency'], 0.45)
        self.assertIn('only 7 steps', said)
        self.assertIn('was not measured', said)
        self.assertTrue(drawn)

    def test_a_real_robot_that_follows_a_person(self):
        status, said, remark, drawn = self.run_on('neato_person_follower.bag')
        self.assertEqual(status, 0, remark)
        values = yaml.safe_load(said)['HIDWAPlannerROS']
        self.assertEqual(set(values), {'control_latency'})
        self.assertGreaterEqual(values['control_latency'], 0.1)
        self.assertLessEqual(values['control_latency'], 0.5)
        self.assertIn('have no steps', said)
        self.assertIn('There is no picture', remark)
        self.assertFalse(drawn)

    def test_without_matplotlib_there_is_no_picture_and_it_says_so(self):
        with mock.patch.dict(sys.modules, {'matplotlib': None, 'hidwa_measure_base.picture': None}):
            del sys.modules['hidwa_measure_base.picture']
            status, said, remark, drawn = self.run_on('neato_test_drive.bag')
        self.assertEqual((status, drawn), (0, False))
        self.assertIn('matplotlib is not installed', remark)
        self.assertIn('control_latency', said)

    def test_a_bag_without_commands_or_odometry_is_refused_by_name(self):
        status, _, remark, _ = self.run_on('neato_test_drive.bag', '--cmd-vel-topic', '/other')
        self.assertEqual(status, 2)
        self.assertIn('/other is not in the bag', remark)


if __name__ == '__main__':
    unittest.main()
