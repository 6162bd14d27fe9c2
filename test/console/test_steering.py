# SPDX-License-Identifier: BSD-3-Clause
"""Old commands never count: the page's clock, what of its commands is sent, who holds the controls, the stop."""
import random
import unittest

import paths  # noqa: F401
from hidwa_console.desk import NAMESAKE, Desk, Settings, Visitor
from hidwa_console.lease import KEPT, Lease
from hidwa_console.page_clock import PageClock
from hidwa_console.steering import NEUTRAL, SEEN, Hand, Steering, Stick

LEFT = Stick(1.0, 0.0, True)
TIMEOUT, MAX_AGE = 0.5, 0.3  # [s]


class Clock(unittest.TestCase):
    def measured(self, offset, ways):
        """A clock after pings with these ways (there, back) [s]; the page's clock shows ours + offset [s]."""
        clock, now = PageClock(), 100.0
        for there, back in ways:
            number = clock.ping(now)
            clock.pong(number, 1e3 * (now + there + offset), now + there + back)
            now += 1.0
        return clock, now

    def test_age_is_wrong_by_half_the_shortest_way_at_most(self):
        dice = random.Random(3)
        for _ in range(200):
            ways = [(dice.uniform(0, 0.2), dice.uniform(0, 0.2)) for _ in range(5)]
            offset, age = dice.uniform(-1e4, 1e4), dice.uniform(0.0, 2.0)
            clock, now = self.measured(offset, ways)
            error = min(a + b for a, b in ways) / 2
            said = clock.age(1e3 * (now - age + offset), now)
            if said is None:  # taken for the future: it was so new that the error hides its age
                self.assertLess(age, error)
            else:
                self.assertLessEqual(abs(said - age), error + 1e-6)

    def test_without_an_answer_no_age_is_known(self):
        clock = PageClock()
        self.assertIsNone(clock.age(0.0, 1.0))
        clock.ping(1.0)
        self.assertFalse(clock.pong(77, 0.0, 1.1))
        self.assertIsNone(clock.age(0.0, 1.2))

    def test_the_future_is_no_age(self):
        clock, now = self.measured(5.0, [(0.01, 0.01)])
        # The error is 0.01 s, the margin 0.05 s: a message 0.07 s ahead is impossible.
        self.assertIsNone(clock.age(1e3 * (now + 5.0 + 0.07), now))
        self.assertEqual(clock.age(1e3 * (now + 5.0 + 0.03), now), 0.0)

    def test_a_clock_that_was_set_is_measured_anew(self):
        clock, now = self.measured(5.0, [(0.01, 0.01)] * 3)
        number = clock.ping(now)
        clock.pong(number, 1e3 * (now + 0.05 - 3.0), now + 0.1)  # 8 s back, as after a sleep
        self.assertAlmostEqual(clock.age(1e3 * (now - 3.0), now + 0.2), 0.2, delta=0.051)

    def test_delay_is_that_of_the_ping_on_its_way_if_longer(self):
        clock, now = self.measured(0.0, [(0.1, 0.1)])
        self.assertAlmostEqual(clock.delay(now), 0.2)
        clock.ping(now)
        self.assertIsNone(clock.ping(now + 1.0))
        self.assertAlmostEqual(clock.delay(now + 1.5), 1.5)


class Steers(unittest.TestCase):
    def setUp(self):
        self.sent, self.now = [], 10.0
        self.steering = Steering(self.sent.append, MAX_AGE)

    def take(self, command, age=0.0, after=0.05, mode='joystick', **more):
        self.now += after
        return self.steering.take(command, age, self.now, TIMEOUT, mode, **more)

    def centred(self):
        self.assertEqual(self.take(NEUTRAL), 'released')
        self.sent.clear()
        self.now += SEEN

    def test_centred_once_then_it_steers(self):
        self.assertEqual(self.take(LEFT), 'neutral_needed')
        self.assertEqual(self.sent, [])
        self.assertEqual(self.take(NEUTRAL), 'released')
        self.assertEqual(self.take(LEFT, after=SEEN / 2), 'neutral_needed')  # the planner may not have seen it yet
        self.assertEqual(self.take(LEFT), 'steers')
        self.assertEqual(self.sent, [NEUTRAL, LEFT])

    def test_one_release_then_silence(self):
        self.centred()
        self.take(LEFT)
        for _ in range(5):
            self.take(NEUTRAL)
        self.steering.release()
        self.assertEqual(self.sent, [LEFT, NEUTRAL])

    def test_who_drives_alone_repeats_the_centred_stick(self):
        self.centred()
        for _ in range(3):
            self.take(NEUTRAL, in_control=True)
        self.assertEqual(self.sent, [NEUTRAL] * 3)

    def test_late_does_not_steer_nor_does_what_came_with_it(self):
        self.centred()
        # Two seconds of frames at 20 Hz at once: ages 2.00, 1.95, ... 0.00. None steers, though seven are fresh by themselves.
        said = [self.take(LEFT, age=2.0 - 0.05 * i, after=0.0001) for i in range(41)]
        self.assertEqual(set(said), {'late'})
        self.assertEqual(self.sent, [])
        self.assertEqual(self.take(LEFT, after=MAX_AGE + 0.01), 'steers')  # what comes in time later does

    def test_a_release_counts_however_late(self):
        self.centred()
        self.take(LEFT)
        self.assertEqual(self.take(NEUTRAL, age=9.0), 'late')
        self.assertEqual(self.sent, [LEFT, NEUTRAL])

    def test_a_late_neutral_is_not_centring(self):
        self.take(NEUTRAL, age=9.0)
        self.assertTrue(self.steering.neutral_needed)

    def test_a_pause_longer_than_the_planners_timeout_asks_for_neutral(self):
        self.centred()
        self.take(LEFT)
        self.assertEqual(self.take(LEFT, after=TIMEOUT - 0.01), 'steers')
        self.assertEqual(self.take(LEFT, after=TIMEOUT + 0.01), 'neutral_needed')
        self.assertEqual(self.sent, [LEFT, LEFT])

    def test_without_a_clock_nothing_steers(self):
        self.centred()
        self.assertEqual(self.take(LEFT, age=None), 'clock')
        self.assertEqual(self.sent, [])

    def test_the_device_of_the_mode(self):
        self.centred()
        self.assertEqual(self.take(LEFT, mode='gesture'), 'mode')
        self.assertEqual(self.take(LEFT, mode='off'), 'mode')
        self.assertEqual(self.take(Hand(0.1, 0.0, 0.0, True), mode='gesture'), 'steers')

    def test_never_more_than_a_slow_twin_sends(self):
        """Random histories against the rules said backwards: a deflection was sent only if it was fresh, no late message came within
        max_age before it, and since the last gap, cut or handover a fresh neutral was sent."""
        dice = random.Random(5)
        for _ in range(300):
            self.setUp()
            centred, last_late, last_sent = None, -9.0, None
            for _ in range(60):
                age = dice.choice([0.0, 0.1, 0.31, 2.0, None])
                command = dice.choice([LEFT, LEFT, NEUTRAL])
                before, after = len(self.sent), dice.choice([0.01, 0.05, 0.2, 0.6])
                if dice.random() < 0.05:
                    self.steering.forget()
                    centred, last_sent = None, None
                self.take(command, age, after)
                new = self.sent[before:]
                self.assertLessEqual(len(new), 1)
                if last_sent is not None and self.now - last_sent > TIMEOUT:
                    centred, last_sent = None, None
                if age is not None and age > MAX_AGE:
                    last_late = self.now
                usable = age is not None and self.now - last_late > MAX_AGE
                if LEFT in new:
                    self.assertTrue(usable and centred is not None, (age, self.now - last_late, centred))
                    last_sent = self.now
                elif new or command == NEUTRAL:
                    last_sent = None
                if usable and command == NEUTRAL:
                    centred = self.now


class Holds(unittest.TestCase):
    def test_first_come_then_by_request(self):
        lease = Lease()
        self.assertEqual(lease.claim('a', 0.0), 'granted')
        self.assertEqual(lease.claim('b', 1.0), 'asked')
        self.assertFalse(lease.give('b', 'b'))
        self.assertFalse(lease.give('a', 'c'))  # who did not ask
        self.assertTrue(lease.give('a', 'b'))
        self.assertEqual((lease.holder, lease.claims), ('b', []))

    def test_kept_for_a_while_then_the_first_that_asked_has_them(self):
        lease = Lease()
        lease.claim('a', 0.0)
        lease.claim('b', 0.0)
        lease.left('a', 10.0)
        self.assertFalse(lease.lapse(10.0 + KEPT - 0.01))
        self.assertTrue(lease.lapse(10.0 + KEPT))
        self.assertEqual(lease.holder, 'b')

    def test_who_comes_back_in_time_keeps_them(self):
        lease = Lease()
        lease.claim('a', 0.0)
        lease.left('a', 10.0)
        lease.back('a')
        self.assertFalse(lease.lapse(99.0))


class Outputs:
    """What the desk sends to the robot."""

    def __init__(self):
        self.sent, self.stops, self.done, self.alone = [], [], [], False
        self.unheard = ''

    def steer(self, command):
        self.sent.append(command)
        return self.unheard

    def stop(self, on):
        self.stops.append(on)
        return self.unheard

    def do(self, kind, fields):
        self.done.append((kind, fields))
        return True, ''

    def input_timeout(self):
        return TIMEOUT

    def mode(self):
        return 'joystick'

    def in_control(self):
        return self.alone


class Seat(Visitor):
    """A page at the desk that hears and can answer pings."""

    def __init__(self, test, page, answers=True):
        super().__init__(self.hear, lambda code, reason: self.closed.append(code))
        self.heard, self.closed, self._test, self.answers = [], [], test, answers
        test.desk.enter(self)
        test.desk.take(self, 'hello', {'page': page * 32, 'name': page})
        test.pass_time(0.5)

    def hear(self, message):
        self.heard.append(message)
        if message['type'] == 'ping' and self.answers:
            self._test.desk.take(self, 'pong', {'id': message['id'], 't': 1e3 * self._test.now})

    def say(self, message):  # the Visitor's own is replaced by its constructor
        raise NotImplementedError

    def stick(self, left, age=0.0, **more):
        self._test.desk.take(self, 'stick', {'t': 1e3 * (self._test.now - age), 'left': left, 'forward': 0.0, 'held': left != 0.0,
                                             'stop': False, **more})

    def last(self, kind):
        return [m for m in self.heard if m['type'] == kind][-1]


class AtTheDesk(unittest.TestCase):
    def setUp(self):
        self.now, self.out = 50.0, Outputs()
        self.desk = Desk(self.out, Settings(MAX_AGE, 2.0), lambda: self.now)

    def pass_time(self, seconds):
        for _ in range(round(20 * seconds)):
            self.now += 0.05
            self.desk.tick()

    def holder(self, page='a'):
        seat = Seat(self, page)
        self.desk.take(seat, 'claim', {})
        seat.stick(0.0)
        self.pass_time(0.1)
        self.out.sent.clear()
        return seat

    def test_only_the_holder_steers(self):
        self.holder()
        other = Seat(self, 'b')
        other.stick(0.0)
        other.stick(1.0)
        self.assertEqual(self.out.sent, [])
        self.assertEqual(other.last('steering')['state'], 'watching')

    def test_a_watcher_stops_and_the_holder_alone_lets_go(self):
        seat, other = self.holder(), Seat(self, 'b')
        self.desk.take(other, 'stop', {'t': 0.0, 'on': True})  # as old as can be
        self.assertEqual(self.out.stops, [True])
        self.desk.take(other, 'stop', {'t': 1e3 * self.now, 'on': False})
        self.assertNotIn(False, self.out.stops)
        self.desk.take(seat, 'stop', {'t': 1e3 * (self.now - 1.0), 'on': False})  # the holder, but late
        self.assertNotIn(False, self.out.stops)
        self.desk.take(seat, 'stop', {'t': 1e3 * self.now, 'on': False})
        self.assertEqual(self.out.stops[-1], False)

    def test_what_nobody_hears_is_said(self):
        seat, watcher = self.holder(), Seat(self, 'b')
        seat.stick(1.0)
        self.assertEqual(seat.last('steering')['state'], 'steers')
        self.out.unheard = 'nobody listens on /joy'
        seat.stick(1.0)
        self.assertEqual(seat.last('steering')['state'], 'unheard')
        for one in (seat, watcher):
            self.desk.take(one, 'stop', {'t': 1e3 * self.now, 'on': True})
            told = one.last('told')
            self.assertEqual((told['what'], told['ok']), ('stop', False))
            self.assertIn('nobody listens on /joy', told['text'])
        self.assertEqual(self.out.stops, [True, True], 'and it goes out all the same')
        self.out.unheard = ''
        seat.stick(1.0)
        self.assertEqual(seat.last('steering')['state'], 'steers')

    def test_two_pages_of_one_name_do_not_cut_each_other_off(self):
        first = self.holder('a')
        Seat(self, 'a')
        self.assertEqual(first.closed[0], NAMESAKE)

    def test_a_stop_in_old_commands_counts(self):
        seat = self.holder()
        for i in range(41):
            seat.stick(1.0, age=2.0 - 0.05 * i, stop=i == 20)
        self.assertEqual((self.out.sent, self.out.stops), ([], [True]))

    def test_a_stop_is_said_again_and_outlasts_who_asked(self):
        seat = self.holder()
        self.desk.take(seat, 'stop', {'t': 1e3 * self.now, 'on': True})
        self.desk.leave(seat, True)
        self.pass_time(KEPT + 10.0)
        self.assertEqual(set(self.out.stops), {True})
        self.assertGreater(len(self.out.stops), 20)

    def test_cut_while_steering_nothing_more_is_sent(self):
        seat = self.holder()
        seat.stick(1.0)
        self.desk.leave(seat, False)
        self.pass_time(20.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0])

    def test_gone_in_order_while_steering_one_release(self):
        seat = self.holder()
        seat.stick(1.0)
        self.desk.leave(seat, True)
        self.pass_time(20.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0, 0.0])

    def test_hidden_while_steering_one_release_then_silence(self):
        seat = self.holder()
        seat.stick(1.0)
        for _ in range(3):
            self.desk.take(seat, 'release', {'t': 0.0, 'why': 'hidden'})
        self.pass_time(3.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0, 0.0])

    def test_back_after_a_cut_the_stick_is_to_be_centred(self):
        seat = self.holder()
        seat.stick(1.0)
        self.desk.leave(seat, False)
        again = Seat(self, 'a')
        self.assertTrue(again.last('control')['held'])
        again.stick(1.0)
        self.assertEqual(len(self.out.sent), 1)
        again.stick(0.0)
        self.pass_time(0.1)
        again.stick(1.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0, 0.0, 1.0])

    def test_handed_over_while_steering_one_release_and_the_other_centres(self):
        seat, other = self.holder(), Seat(self, 'b')
        self.desk.take(other, 'claim', {})
        self.assertEqual(seat.last('control')['claims'], [{'visitor': 2, 'name': 'b'}])
        seat.stick(1.0)
        self.desk.take(seat, 'give', {'to': 2})
        other.stick(-1.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0, 0.0])
        seat.stick(1.0)
        other.stick(0.0)
        self.pass_time(0.1)
        other.stick(-1.0)
        self.assertEqual([c.left for c in self.out.sent], [1.0, 0.0, 0.0, -1.0])

    def test_a_planner_that_begins_to_run_sees_a_neutral_device_unless_one_steers(self):
        self.desk.planner_runs()
        self.assertEqual(self.out.sent, [], 'nobody has the controls')
        seat = self.holder()
        before = len(self.out.sent)
        self.desk.planner_runs()
        self.assertEqual([c.left for c in self.out.sent[before:]], [0.0])
        seat.stick(1.0)
        self.desk.planner_runs()
        self.assertEqual([c.left for c in self.out.sent[before:]], [0.0, 1.0])

    def test_a_link_that_stands_still_stops_the_robot(self):
        seat = self.holder()
        seat.stick(1.0)
        seat.answers = False
        self.pass_time(1.9)
        self.assertEqual(self.out.stops, [])
        self.pass_time(1.0)
        self.assertTrue(self.out.stops and all(self.out.stops))
        self.assertEqual(seat.last('stop')['why'], 'delay')

    def test_but_not_if_the_page_was_hidden(self):
        seat = self.holder()
        self.desk.take(seat, 'release', {'t': 1e3 * self.now, 'why': 'hidden'})
        seat.answers = False
        self.pass_time(10.0)
        self.assertEqual(self.out.stops, [])

    def test_wishes_need_the_controls(self):
        self.holder()
        other = Seat(self, 'b')
        for kind in ('goal', 'mode', 'tune', 'record', 'cancel', 'take_control'):
            self.desk.take(other, kind, {})
        self.assertEqual(self.out.done, [])

    def test_nothing_before_hello(self):
        visitor = Visitor(lambda message: None, lambda code, reason: None)
        self.desk.enter(visitor)
        self.assertFalse(self.desk.take(visitor, 'stop', {'t': 0.0, 'on': True}))


if __name__ == '__main__':
    unittest.main()
