# SPDX-License-Identifier: BSD-3-Clause
"""The desk with the controls: who sits at it, and what of their messages goes out. It knows neither sockets nor ROS."""
import collections

from .lease import Lease
from .page_clock import PageClock
from .steering import Hand, Steering, Stick

PINGS_AT_FIRST, QUICK_PERIOD, PERIOD = 10, 0.1, 0.5  # ping every 0.1 s ten times, then every 0.5 s
SILENT = 30.0      # [s] without an answer to a ping, then the socket is closed
SAY_AGAIN = 0.5    # [s] between two notices that commands are late
STOP_AGAIN = 0.5   # [s] between two messages of a stop that is held
REMEMBERED = 256   # pages that have numbers
NAMESAKE = 4001    # close code of a page whose name another connection has taken: it makes itself another one
NEEDS_CONTROL = ('mode', 'take_control', 'goal', 'cancel', 'skip', 'home', 'record', 'tune', 'undo', 'preset', 'study')

Settings = collections.namedtuple('Settings', 'max_age stop_delay')  # [s] each; stop_delay 0: never


class Visitor:
    """One page on /control; `say` sends it a message (a dict), `close(code, reason)` ends its connection."""

    def __init__(self, say, close):
        self.say, self.close = say, close
        self.page, self.number, self.name = None, None, ''
        self.clock, self.pinged_at = PageClock(), None
        self.engaged = False  # it has the controls in view: a long delay stops the robot
        self.told = None      # (state, at) of the last notice about steering
        self.shown = None     # the last `control` message


class Desk:
    """`outputs` has steer(command) and stop(on), which say why nobody hears it, else nothing, input_timeout(), mode(), in_control()
    and do(type, fields) -> (ok, text). Times are monotonic [s]; `clock()` says which it is."""

    def __init__(self, outputs, settings, clock, study=False):
        self._outputs, self._settings, self._clock, self._study = outputs, settings, clock, study
        self._lease = Lease()
        self._steering = Steering(self._steer, settings.max_age)
        self._unheard = ''  # why nobody heard the last command
        self._visitors, self._numbers = [], collections.OrderedDict()
        self._next_number = 1
        self.stop_on, self._stop_said_at = None, None  # stop_on: None, or (why, number of the visitor)

    # -- connections

    def enter(self, visitor):
        """A page's socket opened; its `hello` comes next."""
        self._visitors.append(visitor)

    def leave(self, visitor, in_order):
        """A page's socket closed; in_order: the page went away on purpose (close codes 1000 and 1001)."""
        if visitor not in self._visitors:
            return
        self._visitors.remove(visitor)
        if self._holds(visitor):
            if in_order:
                self._steering.release()
            self._steering.forget()
        if visitor.page and not self._at(visitor.page):
            self._lease.left(visitor.page, self._clock())
        self._show_control()

    def take(self, visitor, kind, fields):
        """A message of a page. False where it may not say that before `hello`."""
        if kind == 'hello':
            self._hello(visitor, fields)
            return True
        if visitor.page is None:
            return False
        if kind in NEEDS_CONTROL:
            self._do(visitor, kind, fields)
        else:
            getattr(self, '_on_' + kind)(visitor, fields)
        return True

    def tick(self):
        """At least ten times a second."""
        now = self._clock()
        if self._lease.lapse(now):
            self._handed_over()
        if self._steering.in_mode(self._outputs.mode()):
            self._show_control()
        for visitor in list(self._visitors):
            self._ping(visitor, now)
            if self._holds(visitor) and visitor.engaged and self._too_slow(visitor, now):
                self._stop(True, 'delay', None)
        if self.stop_on and now - self._stop_said_at >= STOP_AGAIN:
            self._say_stop(True, now)

    def planner_runs(self):
        """The planner began to run its cycles."""
        if self.holder():
            self._steering.greet()

    # -- messages

    def _hello(self, visitor, fields):
        page, now = fields['page'], self._clock()
        for other in [v for v in self._visitors if v.page == page and v is not visitor]:
            other.page = None  # its new connection has taken its place
            other.close(NAMESAKE, 'another page has said hello by this name')
            self._visitors.remove(other)
        if page not in self._numbers:
            self._numbers[page] = self._next_number
            self._next_number += 1
            while len(self._numbers) > REMEMBERED:
                self._numbers.popitem(last=False)
        visitor.page, visitor.number, visitor.name = page, self._numbers[page], fields['name']
        self._lease.back(page)
        self._lease.lapse(now)
        if self._holds(visitor):
            self._steering.forget()
            visitor.engaged = False
        visitor.say({'type': 'welcome', 'version': 1, 'you': visitor.number, 'max_age': self._settings.max_age,
                     'stop_delay': self._settings.stop_delay, 'input_timeout': self._outputs.input_timeout(),
                     'study': self._study})
        visitor.say(self._stop_message())
        self._show_control()

    def _on_pong(self, visitor, fields):
        visitor.clock.pong(fields['id'], fields['t'], self._clock())

    def _on_stick(self, visitor, fields):
        self._command(visitor, fields, Stick(fields['left'], fields['forward'], fields['held']))

    def _on_hand(self, visitor, fields):
        self._command(visitor, fields, Hand(fields['left'], fields['forward'], fields['up'], fields['grip']))

    def _steer(self, command):
        self._unheard = self._outputs.steer(command) or ''

    def _ask_to_stop(self, visitor):
        unheard = self._stop(True, 'page', visitor.number)
        if unheard:
            visitor.say({'type': 'told', 'what': 'stop', 'ok': False, 'text': f'THE STOP IS NOT HEARD: {unheard}'})

    def _command(self, visitor, fields, command):
        if fields['stop']:
            self._ask_to_stop(visitor)
        now = self._clock()
        age = visitor.clock.age(fields['t'], now)
        if not self._holds(visitor):
            self._tell(visitor, 'watching', age, now)
            return
        o, needed = self._outputs, self._steering.neutral_needed
        state = self._steering.take(command, age, now, o.input_timeout(), o.mode(), o.in_control())
        visitor.engaged = visitor.engaged or state in ('steers', 'neutral_needed')
        state = 'unheard' if state == 'steers' and self._unheard else state
        self._tell(visitor, state, age, now)
        if needed != self._steering.neutral_needed:
            self._show_control()

    def _on_release(self, visitor, fields):
        if not self._holds(visitor):
            return
        self._steering.release()
        if fields['why'] in ('hidden', 'blur', 'pagehide'):
            visitor.engaged = False
        self._tell(visitor, 'released', None, self._clock())

    def _on_stop(self, visitor, fields):
        if fields['on']:
            self._ask_to_stop(visitor)
            return
        age = visitor.clock.age(fields['t'], self._clock())
        if not self._holds(visitor):
            text = 'only who holds the controls ends a stop'
        elif age is None or age > self._settings.max_age:
            text = 'the message came too late: let go again'
        else:
            self._stop(False, 'page', visitor.number)
            text = ''
        visitor.say({'type': 'told', 'what': 'stop', 'ok': not text, 'text': text})

    def _on_claim(self, visitor, _):
        held = self._holds(visitor)
        result = self._lease.claim(visitor.page, self._clock())
        if result == 'granted' and not held:
            self._handed_over()
        visitor.say({'type': 'claim', 'result': result})
        self._show_control()

    def _on_give(self, visitor, fields):
        to = self._page_of(fields['to'])
        if (to is None) == (fields['to'] is None) and self._lease.give(visitor.page, to):
            self._handed_over()
        else:
            visitor.say({'type': 'told', 'what': 'give', 'ok': False, 'text': 'nobody with that number asks for the controls'})

    def _on_refuse(self, visitor, fields):
        page = self._page_of(fields['to'])
        if self._lease.refuse(visitor.page, page):
            self._at(page)[0].say({'type': 'claim', 'result': 'refused'})
            self._show_control()

    def _do(self, visitor, kind, fields):
        if self._holds(visitor):
            visitor.engaged = True
            ok, text = self._outputs.do(kind, fields)
        else:
            ok, text = False, 'only who holds the controls may do that'
        visitor.say({'type': 'told', 'what': kind, 'ok': ok, 'text': text})

    # -- what follows of them

    def tell_holder(self, message):
        """Says something to who holds the controls."""
        for visitor in self._visitors:
            if self._holds(visitor):
                visitor.say(message)

    def close(self):
        """The server ends: steering is released, a stop stays."""
        self._steering.release()

    def holder(self):
        """Whether anybody holds the controls."""
        return self._lease.holder is not None

    def _stop(self, on, why, number):
        """A stop that is held already stays as it is; every request for one goes out. Says why nobody hears it, else nothing."""
        if not on:
            self.stop_on = None
        elif self.stop_on is None:
            self.stop_on = (why, number)
        elif why == 'delay':
            return ''
        unheard = self._say_stop(on, self._clock())
        for visitor in self._visitors:
            if visitor.page:
                visitor.say(self._stop_message())
        return unheard

    def _say_stop(self, on, now):
        self._stop_said_at = now
        return self._outputs.stop(on)

    def _stop_message(self):
        why, by = self.stop_on or ('page', None)
        return {'type': 'stop', 'on': self.stop_on is not None, 'why': why, 'by': by}

    def _handed_over(self):
        """The controls have another holder, or none: what the one before steered ends."""
        self._steering.release()
        self._steering.demand_neutral()
        for visitor in self._visitors:
            visitor.engaged = self._holds(visitor)
        self._show_control()

    def _ping(self, visitor, now):
        clock = visitor.clock
        period = QUICK_PERIOD if clock.count < PINGS_AT_FIRST else PERIOD
        if clock.delay(now) > SILENT:
            visitor.close(1001, 'no answer to ping')
        elif visitor.page and (visitor.pinged_at is None or now - visitor.pinged_at >= period):
            delay, number = clock.delay(now), clock.ping(now)
            if number is not None:
                visitor.pinged_at = now
                visitor.say({'type': 'ping', 'id': number, 'delay': round(1e3 * delay, 1),
                             'rtt': None if clock.rtt is None else round(1e3 * clock.rtt, 1)})

    def _too_slow(self, visitor, now):
        return 0.0 < self._settings.stop_delay < visitor.clock.delay(now) and visitor.clock.count > 0 and not self.stop_on

    def _tell(self, visitor, state, age, now):
        if visitor.told and visitor.told[0] == state and (state != 'late' or now - visitor.told[1] < SAY_AGAIN):
            return
        visitor.told = (state, now)
        visitor.say({'type': 'steering', 'state': state, 'age': None if age is None else round(1e3 * age, 1)})

    def _show_control(self):
        present = [v for v in self._visitors if v.page]
        everybody = [{'visitor': v.number, 'name': v.name, 'holder': self._holds(v)} for v in present]
        claims = [{'visitor': v.number, 'name': v.name} for page in self._lease.claims for v in self._at(page)]
        for visitor in present:
            held = self._holds(visitor)
            message = {'type': 'control', 'holder': self._numbers.get(self._lease.holder), 'you': visitor.number, 'held': held,
                       'neutral_needed': held and self._steering.neutral_needed, 'claims': claims if held else [],
                       'visitors': everybody}
            if message != visitor.shown:
                visitor.shown = message
                visitor.say(message)

    def _holds(self, visitor):
        return visitor.page is not None and visitor.page == self._lease.holder

    def _at(self, page):
        return [v for v in self._visitors if v.page == page]

    def _page_of(self, number):
        return next((v.page for v in self._visitors if v.page and v.number == number), None)
