# SPDX-License-Identifier: BSD-3-Clause
"""The person's devices and tabs in the page as a whole, and what the page says where nobody hears it."""
import unittest

import office
from test_page import PageTest

# A gamepad that is dead, one that is worn, and one that the tests move.
PADS = """
    const pad = (index, rest) => ({
      index, id: 'pad ' + index, connected: true, mapping: 'standard', axes: [rest, 0, 0, 0], timestamp: 0,
      buttons: Array.from({length: 16}, () => ({pressed: false, value: 0}))});
    window.pads = [pad(0, 0), pad(1, 0.09), pad(2, 0)];
    navigator.getGamepads = () => window.pads;
"""
KEY = """
    const event = new KeyboardEvent(arguments[0], {code: 'ArrowLeft', key: 'ArrowLeft', bubbles: true});
    Object.defineProperty(event, 'timeStamp', {value: arguments[1]});
    document.body.dispatchEvent(event);
"""


class Devices(PageTest):
    scripts = (PADS,)

    def test_the_pad_that_is_moved_steers_and_a_worn_one_takes_nothing_from_a_finger(self):
        self.browser.js('window.pads[2].axes = [-1.00002, -0.5, 0, 0]')
        self.assertTrue(self.server.wait(lambda all: any(
            one['type'] == 'stick' and (one['left'], one['forward']) == (1, 0.5) for one in all)))
        self.browser.js('window.pads[2].axes = [0, 0, 0, 0]')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and not one['held'] for one in all)))
        self.server.clear()
        x, y = self.drag(-0.8, 0.0)
        self.browser.js('setInterval(() => { window.pads[1].axes[0] = 0.1 - 0.02 * Math.random(); }, 10)')
        self.settle()
        self.assertTrue(all(abs(one['left'] - 0.8) < 0.02 for one in self.sticks()[5:]), self.sticks())
        self.browser.mouse('mouseReleased', x, y)
        self.assertTrue(self.server.wait(lambda all: [one for one in all if one['type'] == 'stick'][-1]['held'] is False))

    def test_a_key_whose_event_has_no_time_or_another_clocks(self):
        for stamp in (0, 1.7e12, -1):
            self.server.clear()
            before = self.browser.js('return performance.now()')
            self.browser.js(KEY, 'keydown', stamp)
            self.browser.js(KEY, 'keyup', stamp)
            self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stick' and not one['held'] for one in all)))
            after = self.browser.js('return performance.now()')
            self.assertTrue(all(before <= one['t'] <= after for one in self.sticks()), (stamp, before, self.sticks(), after))

    def names(self):
        return {one['page'] for _, one in self.server.messages('hello')}

    def test_a_duplicated_tab_has_a_name_of_its_own(self):
        self.browser.open(self.server.address)
        self.browser.wait(lambda: self.names(), 'hello')
        first = self.browser.driver.current_window_handle
        self.browser.js('window.open(location.href)')  # like a duplicate it copies sessionStorage
        try:
            self.browser.wait(lambda: len(self.names()) == 2, 'a hello by another name')
        finally:
            for handle in self.browser.driver.window_handles:
                if handle != first:
                    self.browser.driver.switch_to.window(handle)
                    self.browser.driver.close()
            self.browser.driver.switch_to.window(first)
        (name,) = self.loaded_again()
        self.assertEqual(self.loaded_again(), {name}, 'a reload keeps it')

    def loaded_again(self):
        """The name by which the page says hello when it is loaded again."""
        self.server.clear()
        self.browser.driver.refresh()
        self.browser.wait(lambda: self.names(), 'hello')
        return self.names()


class Says(PageTest):
    def notice(self, text):
        self.browser.wait(lambda: text in self.browser.text('notice'), 'the notice ' + text)

    def test_that_nobody_hears_it(self):
        self.addCleanup(self.server.show, unheard=None)
        self.server.show(unheard={'what': ['stop', 'mode'], 'text': 'stop (/move_base/HIDWAPlannerROS/stop). No planner runs'})
        self.notice('Nobody hears this page: stop (/move_base/HIDWAPlannerROS/stop)')
        self.assertTrue(self.browser.js("return document.getElementById('notice').classList.contains('bad')"))
        self.server.show(unheard={'what': ['goal'], 'text': 'goal (/move_base_flex/goal)'})
        self.notice('Nobody hears: goal (/move_base_flex/goal)')
        self.server.show(unheard=None)
        self.browser.wait(lambda: self.browser.text('notice') == '')
        self.server.tell({'type': 'told', 'what': 'stop', 'ok': False, 'text': 'THE STOP IS NOT HEARD: nobody listens on /stop'})
        self.notice('THE STOP IS NOT HEARD')

    def test_that_the_server_does_not_know_its_address(self):
        self.addCleanup(setattr, self.server, 'refusal', '')
        self.server.refusal = 'Start the console with --page-origin'
        self.browser.driver.refresh()
        self.notice('Start the console with --page-origin http://127.0.0.1:%d' % self.server.port)
        self.server.refusal = ''
        self.browser.wait(lambda: self.browser.text('notice') == '', 'that the page is let in')

    def test_that_the_robot_takes_none_of_its_steering_and_why(self):
        self.addCleanup(self.server.show, said='')
        said = 'The last message was dropped: it arrived 3 s later than the link needs at best.'
        self.server.show(said=said, state=office.state('AUTONOMY', active=False))
        x, y = self.drag(-0.9, 0)
        self.server.tell({'type': 'steering', 'state': 'steers', 'age': 3})
        self.notice('the robot takes none of it. ' + said)
        self.assertEqual(self.browser.text('said'), 'The planner: ' + said)
        self.server.show(state=office.state())
        self.browser.wait(lambda: self.browser.text('notice') == '')
        self.server.tell({'type': 'steering', 'state': 'unheard', 'age': 3})
        self.notice('You steer, and nobody hears it')
        self.browser.mouse('mouseReleased', x, y)

    def test_which_kind_of_picture_it_cannot_show(self):
        camera = {'on': False, 'info': None, 'fault': '/eye/image: encoding 16UC1 is not known here'}
        self.server.show(camera=camera)
        self.browser.wait(lambda: 'encoding 16UC1 is not known' in self.browser.text('camera-fault'))
        self.server.show(camera=dict(camera, fault=''))
        self.browser.wait(lambda: self.browser.text('camera-fault') == '')


if __name__ == '__main__':
    unittest.main()
