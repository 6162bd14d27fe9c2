# SPDX-License-Identifier: BSD-3-Clause
"""The page alone, in headless Chromium, against a server that shows a scene and keeps what the page sends."""
import math
import unittest

import browser
import numpy
import office
from fake_server import FakeServer


def near(pixels, colour, tolerance=28):
    """Which pixels have about a colour #rrggbb."""
    wanted = numpy.array([int(colour[i:i + 2], 16) for i in (1, 3, 5)])
    return numpy.abs(numpy.asarray(pixels, dtype=int) - wanted).max(axis=2) <= tolerance


class PageTest(unittest.TestCase):
    """One browser for all; each test opens the page anew."""

    scripts = ()
    size = browser.DESKTOP

    @classmethod
    def setUpClass(cls):
        cls.server = FakeServer(browser.library())
        cls.addClassCleanup(cls.server.end)
        office.show(cls.server)
        cls.browser = browser.Browser(size=cls.size, scripts=cls.scripts)
        cls.addClassCleanup(cls.browser.end)

    def setUp(self):
        office.show(self.server)
        self.server.control.update(holder=1, held=True, neutral_needed=False, claims=[])
        self.browser.open(self.server.address)
        self.browser.wait(lambda: self.browser.app('Boolean(app.scene.map && app.scene.robot && app.holder.mine)'), 'the scene')
        self.server.clear()

    def colour(self, name):
        return self.browser.app("app.above.theme['%s']" % name)

    def settle(self):
        """Six periods of the repeated stick pass in the page. What it sent meanwhile has come when its mark has."""
        self.browser.app("new Promise((done) => setTimeout(done, 300)).then(() => app.send('mark'))")
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'mark' for one in all)))
        self.server.forget('mark')

    def view(self):
        """The view from on board, once it is drawn: two pictures of it are the same."""
        pictures = [None, None]

        def still():
            pictures[:] = pictures[1], numpy.asarray(self.browser.crop('board-canvas'), dtype=int)
            return pictures[0] is not None and numpy.array_equal(*pictures)
        self.browser.wait(still, 'a view that rests')
        return pictures[1]

    def sticks(self):
        return [one for _, one in self.server.messages('stick')]

    def drag(self, dx, dy):
        """Presses the stick and drags it by this share of its travel; returns where the pointer is."""
        x, y, width, _ = self.browser.middle('stick')
        travel = 0.36 * width
        self.browser.mouse('mousePressed', x, y)
        self.browser.mouse('mouseMoved', x + dx * travel, y + dy * travel)
        return x + dx * travel, y + dy * travel


class Views(PageTest):
    def test_decodes_what_the_server_sends(self):
        cells, _, _ = office.office_cells()
        shown = self.browser.app('[app.scene.map.width, app.scene.map.height, Array.from(app.scene.map.cells)'
                                 '.reduce((sum, value, i) => (sum + (value & 255) * (i % 97)) % 1000003, 0)]')
        expected = int((cells.ravel().astype(int) * (numpy.arange(cells.size) % 97)).sum() % 1000003)
        self.assertEqual(shown, [cells.shape[1], cells.shape[0], expected])

    def test_a_changed_grid_is_the_moved_old_one_and_the_difference(self):
        import scene_bytes
        rng = numpy.random.RandomState(7)
        old = rng.choice([0, 40, 99, 100, 255], size=(30, 40)).astype(numpy.uint8)
        new = rng.choice([0, 40, 99, 100, 255], size=(30, 40)).astype(numpy.uint8)
        dx, dy = 3, -2
        moved = numpy.full(old.shape, 255, numpy.uint8)
        for j in range(30):
            for i in range(40):
                if 0 <= i + dx < 40 and 0 <= j + dy < 30:
                    moved[j, i] = old[j + dy, i + dx]
        self.server.show(binary={'costmap': scene_bytes.grid(1, 50, old, 0.05, (1.0, 2.0, 0.0))})
        self.browser.wait(lambda: self.browser.app('app.scene.costmap.version') == 50)
        self.server.show(binary={'costmap': scene_bytes.changed_grid(1, 51, 50, (dx, dy), (1.15, 1.9, 0.0), new - moved)})
        self.browser.wait(lambda: self.browser.app('app.scene.costmap.version') == 51)
        cells = numpy.array(self.browser.app('Array.from(app.scene.costmap.cells)')).reshape(30, 40).astype(numpy.uint8)
        self.assertTrue((cells == new).all())

    def test_both_views_show_the_robot(self):
        above = self.browser.crop('above-canvas')
        half = [above.width // 2, above.height // 2]
        above = above.crop([half[0] - 50, half[1] - 50, half[0] + 50, half[1] + 50])  # without the buttons
        robot = near(above, self.colour('robot'))
        rows, columns = numpy.nonzero(robot)
        # The disc of 0.27 m at 44 pixels a metre has pi (0.27 * 44)^2 = 443 pixels; its edge, nose and arcs take part of them.
        self.assertGreater(robot.sum(), 100)
        self.assertAlmostEqual(columns.mean(), above.width / 2, delta=6)
        self.assertAlmostEqual(rows.mean(), above.height / 2, delta=6)
        self.browser.wait(lambda: self.browser.app('Boolean(app.board && app.board.shown)'))
        with_robot = self.view()
        self.browser.app('(app.board.body.visible = false, app.board.dirty = true)')

        def rows_of_the_robot():
            rows = numpy.nonzero(numpy.abs(with_robot - self.view()).max(axis=2) > 20)[0]
            return rows if rows.size > 300 else None
        self.browser.wait(lambda: rows_of_the_robot() is not None, 'the robot stands in the view from on board')
        self.assertGreater(rows_of_the_robot().mean(), with_robot.shape[0] / 2, 'low in the picture')

    def test_the_view_from_on_board_follows_the_robot(self):
        before = self.view()
        x, y, yaw = office.ROBOT
        self.server.show(pose=[x, y, yaw + 0.5])
        self.browser.wait(lambda: abs(self.browser.app('app.board.shown.yaw') - yaw - 0.5) < 0.1)
        self.browser.wait(lambda: (numpy.abs(before - self.view()).max(axis=2) > 20).mean() > 0.2, 'another view')

    def test_says_who_is_in_control_and_why_a_wish_is_refused(self):
        self.assertEqual(self.browser.text('state-title'), 'You steer')
        self.server.show(state=office.state('BLOCKED', refused_by='Braking', next='stop', next_reason='an obstacle ahead'))
        self.browser.wait(lambda: self.browser.text('state-title') == 'Blocked')
        self.assertEqual(self.browser.text('refusal'), 'Refused: it could not brake in time (Braking)')
        self.assertEqual(self.browser.text('next'), 'Next: stop. an obstacle ahead')
        self.server.show(state=office.state('LOST', active=False))
        self.browser.wait(lambda: 'LOST' in self.browser.text('notice'))

    def test_says_that_the_person_drives_without_a_goal_and_invites_to(self):
        goals = {'active': None, 'waiting': [], 'start': None, 'outcome': '', 'text': ''}
        self.addCleanup(office.show, self.server)
        self.server.show(goals=goals, state=None)
        self.browser.wait(lambda: 'steering works on the way to a goal' in self.browser.text('state-line'))
        self.server.show(limits={'max_vel_x': 0.5, 'min_vel_x': 0.0, 'max_vel_theta': 1.0, 'drive_without_goal': True})
        self.browser.wait(lambda: self.browser.text('state-line').startswith('Steer to drive'))
        self.server.show(state=office.state('MANUAL', without_goal=True, next='stop', next_reason='there is no goal'))
        self.browser.wait(lambda: self.browser.text('state-title') == 'You drive. No goal.')
        self.assertEqual(self.browser.text('next'), '')

    def test_says_that_steering_without_a_goal_is_not_taken(self):
        goals = {'active': None, 'waiting': [], 'start': None, 'outcome': '', 'text': ''}
        self.addCleanup(office.show, self.server)
        steered = "app.status.set({steering: 'steers', held: true, size: 1})"
        self.addCleanup(self.browser.app, "app.status.set({steering: 'released', held: false, size: 0})")
        self.server.show(goals=goals, state=None, limits={'max_vel_x': 0.5, 'min_vel_x': 0.0, 'max_vel_theta': 1.0,
                                                          'drive_without_goal': True})
        self.browser.wait(lambda: self.browser.app('app.scene.limits.driveWithoutGoal'))
        self.browser.app(steered)
        self.browser.wait(lambda: 'the robot takes none of it' in self.browser.text('notice'))
        self.server.show(limits={'max_vel_x': 0.5, 'min_vel_x': 0.0, 'max_vel_theta': 1.0, 'drive_without_goal': False})
        self.browser.wait(lambda: self.browser.text('notice') == '', 'without the parameter nobody expects it to')

    def test_the_floor_in_the_cameras_picture(self):
        # A lens 1 m above the floor that looks ahead: 2 m ahead and 0.5 m to the left is seen at
        # u = cx - fx 0.5 / 2 = 320 - 125 = 195 and v = cy + fy 1 / 2 = 240 + 250 = 490.
        info = '{fx: 500, fy: 500, cx: 320, cy: 240, pose: [0, 0, 1, -0.5, 0.5, -0.5, 0.5]}'
        seen = self.browser.app("import('/views/onboard_picture.js')"
                                '.then(({project}) => [project(%s, 2, 0.5), project(%s, -1, 0)])' % (info, info))
        self.assertAlmostEqual(seen[0][0], 195, places=6)
        self.assertAlmostEqual(seen[0][1], 490, places=6)
        self.assertIsNone(seen[1], 'behind the lens')

    def test_candidates_come_on_demand(self):
        self.assertFalse(self.server.wants)
        self.browser.click('candidates')
        self.browser.wait(lambda: self.server.wants)
        self.server.show(binary={'candidates': office.fan(office.ROBOT)})
        self.browser.wait(lambda: self.browser.app('app.scene.candidates.length') == 21)
        # Rates from -1.0 to -0.8 are rejected: three. Rate 0.3 is the cheapest.
        self.assertEqual(self.browser.app('app.scene.candidates.filter((one) => !one.legal).length'), 3)
        self.assertAlmostEqual(self.browser.app('app.scene.candidates[20].omega'), 0.3, places=6)

    def test_zoom_and_pan(self):
        x, y, _, _ = self.browser.middle('above-canvas')
        self.browser.cdp('Input.dispatchMouseEvent', {'type': 'mouseWheel', 'x': x, 'y': y, 'deltaX': 0, 'deltaY': -400})
        self.browser.wait(lambda: self.browser.app('app.above.camera.scale') > 60)
        self.assertTrue(self.browser.app('app.above.camera.following'))
        self.browser.mouse('mousePressed', x, y)
        self.browser.mouse('mouseMoved', x + 50, y)
        self.browser.mouse('mouseReleased', x + 50, y)
        self.browser.wait(lambda: not self.browser.app('app.above.camera.following'))
        scale = self.browser.app('app.above.camera.scale')
        self.assertAlmostEqual(self.browser.app('app.above.camera.x'), office.ROBOT[0] - 50 / scale, delta=0.05)

    def test_nothing_comes_from_another_host_and_nothing_breaks_the_policy(self):
        hosts = self.browser.js("return performance.getEntriesByType('resource').map((one) => new URL(one.name).host)")
        self.assertEqual(set(hosts), {'127.0.0.1:%d' % self.server.port})
        self.assertEqual(self.browser.faults(), [])


class Inputs(PageTest):
    def test_the_stick_dragged_left_steers_left_and_ends_with_one_release(self):
        x, y = self.drag(-0.8, -0.1)
        self.assertTrue(self.server.wait(lambda all: sum(one['type'] == 'stick' and one['held'] for one in all) > 4))
        left = [one for one in self.sticks() if one['held']][-1]
        self.assertAlmostEqual(left['left'], 0.8, delta=0.02)
        self.assertAlmostEqual(left['forward'], 0.1, delta=0.02)
        self.browser.mouse('mouseReleased', x, y)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and not one['held'] for one in all)))
        self.settle()
        released = [one for one in self.sticks() if not one['held']]
        self.assertEqual([(one['left'], one['forward']) for one in released], [(0, 0)])
        self.assertIs(self.sticks()[-1]['held'], False, 'silence after the release')

    def test_a_held_stick_repeats_twenty_times_a_second(self):
        x, y = self.drag(0.5, 0)
        self.server.wait(lambda all: sum(one['type'] == 'stick' for one in all) > 3)
        self.server.clear()
        self.assertTrue(self.server.wait(lambda all: sum(one['type'] == 'stick' for one in all) >= 20))
        times = [one['t'] for one in self.sticks()[:20]]
        self.browser.mouse('mouseReleased', x, y)
        # A period of 50 ms by the page's own clock; a timer may be late where the machine is busy, but it is never early.
        self.assertGreater(times[-1] - times[0], 19 * 40.0)

    def cut(self, script, why):
        x, y = self.drag(-1, 0)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and one['left'] > 0.9 for one in all)))
        self.browser.js(script)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'release' for one in all)))
        count = len(self.server.messages())
        self.browser.mouse('mouseMoved', x + 5, y)  # still pressed: it no longer counts
        self.settle()
        self.assertEqual([one['why'] for _, one in self.server.messages('release')], [why])
        self.assertEqual(len(self.server.messages()), count, 'silence after the release')
        self.browser.mouse('mouseReleased', x, y)
        self.server.clear()
        self.drag(0.9, 0)
        steers = self.server.wait(lambda all: any(one['type'] == 'stick' and one['left'] < -0.8 for one in all))
        self.assertTrue(steers, 'a new press steers')
        self.browser.mouse('mouseReleased', x, y)

    def test_a_lost_focus_releases(self):
        self.cut("window.dispatchEvent(new Event('blur'))", 'blur')

    def test_a_page_that_goes_releases(self):
        self.cut("window.dispatchEvent(new Event('pagehide'))", 'pagehide')

    def test_a_pointer_that_is_taken_away_releases(self):
        self.cut("document.getElementById('stick').dispatchEvent(new PointerEvent('pointercancel', {pointerId: 1}))", 'pointer')

    def test_a_hidden_tab_releases(self):
        self.drag(-1, 0)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and one['left'] > 0.9 for one in all)))
        first = self.browser.driver.current_window_handle
        self.browser.driver.switch_to.new_window('tab')
        try:
            self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'release' for one in all)))
            count = len(self.server.messages())
            # What it sends before it answers comes before its answer.
            self.server.tell({'type': 'ping', 'id': 99, 'rtt': None, 'delay': 12})
            self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'pong' and one['id'] == 99 for one in all)))
            self.assertEqual(len(self.server.messages('release')), 1)
            self.assertEqual(len(self.server.messages()), count)
        finally:
            self.browser.driver.close()
            self.browser.driver.switch_to.window(first)

    def test_keys_steer(self):
        self.browser.key('keyDown', 'ArrowLeft', 'ArrowLeft')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and one['left'] == 0.7 for one in all)))
        self.browser.key('keyDown', 'ArrowUp', 'ArrowUp')
        # Both keys: 0.7 in all, so 0.7 / sqrt(2) on each axis.
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and abs(one['forward'] - 0.495) < 0.001 for one in all)))
        self.browser.key('keyUp', 'ArrowLeft', 'ArrowLeft')
        self.browser.key('keyUp', 'ArrowUp', 'ArrowUp')
        self.assertTrue(self.server.wait(lambda all: [one for one in all if one['type'] == 'stick'][-1]['held'] is False))

    def test_space_stops_and_only_letting_go_on_purpose_ends_it(self):
        self.browser.key('keyDown', 'Space', ' ')
        self.browser.key('keyUp', 'Space', ' ')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' for one in all)))
        self.server.tell({'type': 'stop', 'on': True, 'why': 'page', 'by': 1})
        self.browser.until("return !document.getElementById('letgo').hidden")
        self.browser.js("window.dispatchEvent(new Event('blur'))")
        self.settle()
        self.assertEqual([one['on'] for _, one in self.server.messages('stop')], [True])
        self.browser.key('keyDown', 'KeyG', 'g')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' and one['on'] is False for one in all)))

    def test_a_stop_counts_also_while_watching(self):
        self.server.tell(dict(self.server.control, holder=2, held=False))
        self.browser.until("return document.getElementById('claim').textContent === 'Ask for the controls'")
        self.browser.click('stop')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' and one['on'] is True for one in all)))

    def test_a_goal_by_a_press_and_its_heading_by_a_drag(self):
        self.browser.click('go')
        x, y, _, _ = self.browser.middle('above-canvas')
        scale = self.browser.app('app.above.camera.scale')
        self.browser.mouse('mousePressed', x + 60, y - 30)
        self.browser.mouse('mouseMoved', x + 60, y - 90)
        self.browser.mouse('mouseReleased', x + 60, y - 90)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'goal' for one in all)))
        goal = self.server.messages('goal')[0][1]
        self.assertAlmostEqual(goal['x'], office.ROBOT[0] + 60 / scale, delta=0.03)
        self.assertAlmostEqual(goal['y'], office.ROBOT[1] + 30 / scale, delta=0.03)
        self.assertAlmostEqual(goal['yaw'], math.pi / 2, delta=0.05)
        self.assertIs(goal['append'], False)
        self.browser.click('add')
        self.browser.mouse('mousePressed', x - 40, y)
        self.browser.mouse('mouseReleased', x - 40, y)
        self.assertTrue(self.server.wait(lambda all: sum(one['type'] == 'goal' for one in all) == 2))
        goal = self.server.messages('goal')[1][1]
        self.assertEqual((goal['yaw'], goal['append']), (None, True))

    def test_modes_control_and_goals_have_buttons(self):
        self.browser.js("document.querySelector('[data-mode=switching]').click()")
        self.server.show(mode='switching')
        self.browser.until("return !document.getElementById('take').hidden")
        for button in ('take', 'cancel', 'skip', 'home', 'record', 'give'):
            self.browser.click(button)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'give' for one in all)))
        sent = [{key: value for key, value in one.items() if key != 't'} for _, one in self.server.messages()]
        self.assertEqual(sent, [
            {'type': 'mode', 'mode': 'switching'}, {'type': 'take_control', 'on': True}, {'type': 'cancel'}, {'type': 'skip'},
            {'type': 'home'}, {'type': 'record', 'on': True}, {'type': 'give'}])

    def test_centres_the_stick_once_where_the_server_asks_for_it(self):
        self.server.tell(dict(self.server.control, neutral_needed=True))
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' for one in all)))
        self.settle()
        self.assertEqual([(one['left'], one['forward'], one['held']) for one in self.sticks()], [(0, 0, False)])

    def test_a_cut_link_is_said_and_steering_begins_with_a_new_press(self):
        x, y = self.drag(-1, 0)
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' for one in all)))
        self.server.cut()
        self.browser.wait(lambda: 'The link is cut' in self.browser.text('notice'))
        self.browser.wait(lambda: self.browser.text('notice') == '')
        self.server.clear()
        self.browser.mouse('mouseMoved', x + 4, y)
        self.settle()
        self.assertEqual([one for one in self.sticks() if one['held']], [])
        self.browser.mouse('mouseReleased', x, y)

    def test_says_that_commands_were_too_late(self):
        self.server.tell({'type': 'steering', 'state': 'late', 'age': 812})
        self.browser.wait(lambda: '812 ms' in self.browser.text('notice'))

    def test_times_are_those_of_the_event(self):
        x, y = self.drag(-0.5, 0)
        self.server.wait(lambda all: any(one['type'] == 'stick' for one in all))
        self.browser.mouse('mouseReleased', x, y)
        now = self.browser.js('return performance.now()')
        for one in self.sticks():
            self.assertLess(now - one['t'], 3000)
            self.assertLessEqual(one['t'], now)


class Panels(PageTest):
    def fields(self, kind):
        return [{key: value for key, value in one.items() if key not in ('t', 'type')} for _, one in self.server.messages(kind)]

    def test_tuning_sets_what_is_valid_undoes_and_takes_presets(self):
        parameter = {'name': 's_omega', 'type': 'double', 'value': 800.0, 'default': 800.0, 'min': 0.0, 'max': 10000.0, 'choices': [],
                     'tab': 'Operator', 'text': 'Weight of the turn'}
        linear = dict(parameter, name='linear', type='enum', value='v_max', default='v_max',
                      choices=[{'value': 'v_max', 'text': ''}, {'value': 'axis', 'text': ''}])
        presets = [{'name': 'pilot_1', 'text': 'the first', 'values': {'s_omega': 400}}]
        self.server.show(tuning={'parameters': [parameter, linear], 'undo': 1, 'presets': presets})
        self.browser.until("return document.getElementById('parameter-s_omega') !== null")
        change = "const e = document.getElementById('parameter-%s'); e.value = '%s'; e.dispatchEvent(new Event('change'))"
        self.browser.js(change % ('s_omega', '-5'))
        self.browser.wait(lambda: 's_omega' in self.browser.text('notice'))
        self.assertEqual(self.fields('tune'), [], 'below its minimum')
        self.browser.js(change % ('s_omega', '400'))
        self.browser.js(change % ('linear', 'axis'))
        self.browser.click('undo')
        self.browser.js("[...document.querySelectorAll('#panel-tuning button')].find((one) => one.textContent === 'pilot 1').click()")
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'preset' for one in all)))
        self.assertEqual(self.fields('tune'), [{'values': {'s_omega': 400}}, {'values': {'linear': 'axis'}}])
        self.assertEqual((self.fields('undo'), self.fields('preset')), ([{}], [{'name': 'pilot_1'}]))

    def study(self, stage, **fields):
        always = {'stage': stage, 'participant': 1, 'condition': 'SJ', 'place': 1, 'text': 'text of ' + stage}
        self.server.show(study=dict(always, **fields))
        self.browser.wait(lambda: self.browser.text('study-text') == 'text of ' + stage)

    def press(self, text):
        self.browser.js("[...document.querySelectorAll('#study-buttons button')].find((one) => one.textContent === arguments[0]).click()",
                        text)

    def test_a_study_asks_for_consent_first_and_for_every_answer(self):
        self.addCleanup(self.server.show, study=None)
        self.study('consent')
        self.press('I agree')
        self.study('ready')
        self.press('Start')
        self.server.show(study={'stage': 'drive', 'participant': 1, 'condition': 'SJ', 'place': 1, 'text': ''})
        self.browser.until("return !document.getElementById('study').open")
        ends = {'low': 0, 'high': 100, 'low_text': 'low', 'high_text': 'high', 'step': 5}
        self.study('questions', questions=[dict(ends, name='mental', text='How demanding?'),
                                           dict(ends, name='effort', text='How hard?')])
        answer = "const e = document.querySelector('[name=%s]'); e.value = %d; e.dispatchEvent(new Event('input'))"
        self.browser.js(answer % ('mental', 35))
        self.press('Done')
        self.browser.wait(lambda: '1 is open' in self.browser.text('study-error'))
        self.browser.js(answer % ('effort', 50))
        self.press('Done')
        self.assertTrue(self.server.wait(lambda all: sum(one['type'] == 'study' for one in all) == 3))
        self.assertEqual(self.fields('study'), [
            {'answer': {'consent': True}}, {'answer': {'start': True}}, {'answer': {'ratings': {'mental': 35, 'effort': 50}}}])

    def test_says_how_a_goal_ended(self):
        goals = {'active': [30.0, 18.0, 0.0], 'waiting': [], 'start': None, 'outcome': '', 'text': ''}
        self.server.show(goals=goals)
        self.browser.wait(lambda: self.browser.app('app.scene.goals.length') == 1)
        self.assertEqual(self.browser.text('notice'), '')
        self.server.show(goals=dict(goals, active=None, outcome='failed', text='no plan leads there'))
        self.browser.wait(lambda: self.browser.text('notice') == 'The goal was not reached: no plan leads there')

    def test_says_that_it_records(self):
        self.server.show(record={'on': True, 'file': 'drive.bag', 'seconds': 75, 'report': 'none', 'text': ''})
        self.browser.wait(lambda: self.browser.text('record') == 'Recording, 1 min 15 s: end it')

    def test_a_report_without_a_picture_shows_its_figures(self):
        self.server.show(record={'on': False, 'file': 'drive.bag', 'seconds': 0, 'report': 'ready', 'text': ''})
        self.browser.click('tab-record')
        self.browser.until("return !document.getElementById('report').hidden")
        self.browser.click('report')
        self.browser.until("return document.getElementById('report-dialog').open && document.getElementById('report-picture').hidden")
        self.assertIn('apt-get install python3-matplotlib', self.browser.text('report-figures'))


class Gamepad(PageTest):
    scripts = ("""
        const pad = {index: 0, connected: true, id: 'pad', mapping: 'standard', axes: [0, 0, 0, 0], timestamp: 0,
                     buttons: Array.from({length: 16}, () => ({pressed: false, value: 0})),
                     vibrationActuator: {playEffect: (kind, how) => { window.rumbled = how; return Promise.resolve('complete'); }}};
        window.pad = pad;
        navigator.getGamepads = () => [pad];
    """,)

    def test_left_is_left_and_letting_go_is_one_release(self):
        self.browser.js('window.pad.axes[0] = -1; window.pad.axes[1] = -0.25')  # the API: left and up are -1
        self.assertTrue(self.server.wait(
            lambda all: any(one['type'] == 'stick' and one['left'] == 1 and one['forward'] == 0.25 for one in all)))
        self.browser.js('window.pad.axes[0] = 0.02; window.pad.axes[1] = 0')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and not one['held'] for one in all)))
        self.settle()
        self.assertEqual(sum(not one['held'] for one in self.sticks()), 1)
        self.browser.js('window.pad.buttons[0].pressed = true')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'take_control' and one['on'] for one in all)))

    def test_its_stop_is_held_and_stays_after_a_cut(self):
        self.browser.js('window.pad.buttons[1].pressed = true')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' and one['on'] for one in all)))
        self.browser.js('window.pad.buttons[1].pressed = false')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' and not one['on'] for one in all)))
        self.server.clear()
        self.browser.js('window.pad.buttons[1].pressed = true')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' and one['on'] for one in all)))
        self.browser.js("window.dispatchEvent(new Event('blur')); window.pad.buttons[1].pressed = false")
        self.settle()
        self.assertEqual([one['on'] for _, one in self.server.messages('stop')], [True])

    def test_rumbles_while_it_steers(self):
        self.browser.js('window.pad.axes[0] = 1')
        self.server.wait(lambda all: any(one['type'] == 'stick' for one in all))
        self.server.show(rumble=0.5)
        self.browser.until('return window.rumbled && window.rumbled.strongMagnitude === 0.5')

    def test_a_pad_that_is_gone_releases(self):
        self.browser.js('window.pad.axes[0] = 1')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and one['left'] == -1 for one in all)))
        self.browser.js("window.pad.connected = false; const e = new Event('gamepaddisconnected'); e.gamepad = window.pad; "
                        'window.dispatchEvent(e)')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'release' and one['why'] == 'device' for one in all)))


class WithoutLibrary(unittest.TestCase):
    def test_the_page_steers_without_three(self):
        server = FakeServer(None)
        self.addCleanup(server.end)
        office.show(server)
        one = browser.Browser(size=browser.PHONE)
        self.addCleanup(one.end)
        one.open(server.address)
        one.wait(lambda: one.app('Boolean(app.scene.robot && app.holder.mine)'))
        self.assertTrue(one.js("return !document.getElementById('plain').hidden"))
        x, y, width, _ = one.middle('stick')
        one.cdp('Input.dispatchTouchEvent', {'type': 'touchStart', 'touchPoints': [{'x': x, 'y': y}]})
        one.cdp('Input.dispatchTouchEvent', {'type': 'touchMove', 'touchPoints': [{'x': x - 0.36 * width, 'y': y}]})
        self.assertTrue(server.wait(lambda all: any(m['type'] == 'stick' and m['left'] > 0.95 for m in all)))
        one.cdp('Input.dispatchTouchEvent', {'type': 'touchEnd', 'touchPoints': []})
        self.assertTrue(server.wait(lambda all: any(m['type'] == 'stick' and not m['held'] for m in all)))


if __name__ == '__main__':
    unittest.main()
