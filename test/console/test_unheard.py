# SPDX-License-Identifier: BSD-3-Clause
"""A console whose planner is not there, or has another name, and what the page is told: no simulated robot, a master alone."""
import asyncio
import json
import os
import tempfile
import time
import unittest
import urllib.error
import urllib.request

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from hidwa_local_planner.msg import OperatorState
from sensor_msgs.msg import Image, Joy
from std_msgs.msg import Bool, String

import paths
from hidwa_tools.processes import Child, free_port
from page_twin import PATIENCE, Page, View, until

PLANNER, FLEX = '/move_base/HIDWAPlannerROS', '/move_base_flex/HIDWAPlannerROS'
AS_SEEN = 'http://localhost:9000'  # the page's address behind a forwarded port
ENVIRONMENT = None


def setUpModule():
    global ENVIRONMENT
    folder = tempfile.TemporaryDirectory(prefix='hidwa_unheard_')
    unittest.addModuleCleanup(folder.cleanup)
    port = free_port()
    ENVIRONMENT = {**os.environ, 'ROS_MASTER_URI': f'http://localhost:{port}', 'ROS_LOG_DIR': folder.name, 'ROS_HOME': folder.name}
    os.environ['ROS_MASTER_URI'] = ENVIRONMENT['ROS_MASTER_URI']
    core = Child(['roscore', '-p', str(port)], os.path.join(folder.name, 'core.log'), ENVIRONMENT)
    unittest.addModuleCleanup(core.stop)
    deadline = time.monotonic() + PATIENCE
    while True:
        try:
            rospy.get_master().getPid()
            break
        except OSError:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.05)
    rospy.init_node('unheard_test', disable_signals=True)
    unittest.addModuleCleanup(rospy.signal_shutdown, 'the tests have ended')


class Unheard(unittest.IsolatedAsyncioTestCase):
    async def console(self, *options):
        """A console, and a page that has its controls: the page, and its view."""
        folder = tempfile.TemporaryDirectory(prefix='hidwa_unheard_')
        self.addCleanup(folder.cleanup)
        log, port = os.path.join(folder.name, 'log'), free_port()
        child = Child(['/usr/bin/python3', os.path.join(paths.ROOT, 'console', 'console'), '--port', str(port), *options], log, ENVIRONMENT)
        self.addCleanup(child.stop)

        def said():
            with open(log, encoding='utf-8') as text:
                return text.read()
        await until(lambda: 'console: http' in said() or not child.running, 'the address')
        self.assertTrue(child.running, said())
        page = await Page(port, 'a' * 32, origin=AS_SEEN if AS_SEEN in options else None).open()
        view = await View(page).open()
        await page.claim()
        self.addCleanup(view.close)
        return page, view

    async def asyncTearDown(self):
        for one in self.ros:
            one.unregister()

    def setUp(self):
        self.ros = []

    def listens(self, topic, kind):
        self.ros.append(rospy.Subscriber(topic, kind, lambda message: None))

    def publishes(self, topic, kind):
        self.ros.append(rospy.Publisher(topic, kind, queue_size=1, latch=True))
        return self.ros[-1]

    async def told(self, page, what, **fields):
        page.say(what, **fields)
        await until(lambda: page.last('told', what=what), what)
        return page.last('told', what=what)

    async def test_whatever_is_sent_where_nobody_listens(self):
        page, view = await self.console('--planner', PLANNER)
        self.listens(PLANNER + '/stop', Bool)  # who records
        await until(lambda: view.fields.get('unheard'), 'that nobody hears')
        self.assertEqual(view.fields['unheard']['what'], ['stop', 'mode', 'take control', 'goal'])
        self.assertIn(PLANNER, view.fields['unheard']['text'])
        for what, fields in (('stop', {'t': page.now(), 'on': True}), ('mode', {'mode': 'joystick'}), ('take_control', {'on': True}),
                             ('goal', {'x': 1.0, 'y': 1.0}), ('cancel', {})):
            told = await self.told(page, what, **fields)
            self.assertIs(told['ok'], False, what)
            self.assertIn('nobody listens on /move_base/', told['text'])
        self.publishes(FLEX + '/operator_state', OperatorState)
        await until(lambda: f'--planner {FLEX}' in view.fields['unheard']['text'], 'the name of the planner that runs')

    async def test_a_planner_that_listens_and_a_stick_that_nobody_hears(self):
        page, view = await self.console('--planner', PLANNER)
        self.publishes(PLANNER + '/mode', String).publish('joystick')
        for name, kind in (('stop', Bool), ('set_mode', String), ('take_control', Bool)):
            self.listens(f'{PLANNER}/{name}', kind)
        await until(lambda: (view.fields.get('unheard') or {}).get('what') == ['stick', 'goal'], 'stick and goal')
        self.assertIs((await self.told(page, 'mode', mode='joystick'))['ok'], True)

        async def steers_until(state):
            deadline = time.monotonic() + PATIENCE
            while not page.last('steering', state=state):
                self.assertLess(time.monotonic(), deadline, f'{state}; it is {page.last("steering")}')
                page.stick(0.5 if not page.told_control['neutral_needed'] else 0.0)
                await asyncio.sleep(0.07)
        await steers_until('unheard')
        self.listens('/joy', Joy)
        await steers_until('steers')
        await until(lambda: view.fields['unheard']['what'] == ['goal'], 'that the stick is heard')
        for one in self.ros:
            one.unregister()  # the planner dies
        await until(lambda: 'stop' in view.fields['unheard']['what'], 'that nobody hears a stop any more')

    async def test_the_planner_that_runs_is_found_by_itself(self):
        self.publishes(FLEX + '/operator_state', OperatorState)
        _, view = await self.console()
        await until(lambda: view.fields.get('unheard'), 'that nobody hears')
        self.assertIn(FLEX, view.fields['unheard']['text'])

    async def test_whether_there_is_a_goal(self):
        _, view = await self.console('--planner', PLANNER)
        state = self.publishes(PLANNER + '/operator_state', OperatorState)
        for name, without_goal in (('MANUAL', True), ('SHARED', False)):
            message = OperatorState(state_name=name, without_goal=without_goal)
            await until(lambda: state.publish(message) or (view.fields.get('state') or {}).get('name') == name, name)
            self.assertIs(view.fields['state']['without_goal'], without_goal)

    async def test_what_the_planner_says_of_the_device(self):
        _, view = await self.console('--planner', PLANNER)
        said = self.publishes('/diagnostics', DiagnosticArray)

        def status(level, text, name='move_base: HIDWAPlannerROS operator'):
            said.publish(DiagnosticArray(status=[DiagnosticStatus(name=name, level=level, message=text)]))
        status(DiagnosticStatus.WARN, 'the last message was dropped')
        await until(lambda: view.fields.get('said') == 'the last message was dropped', 'what it says')
        status(DiagnosticStatus.OK, 'SHARED')
        await until(lambda: view.fields['said'] == '', 'that nothing is wrong')
        status(DiagnosticStatus.ERROR, 'a laser is blind', 'move_base: laser')
        status(DiagnosticStatus.WARN, 'nothing more comes')
        await until(lambda: view.fields['said'] == 'nothing more comes', 'what it says')
        await until(lambda: view.fields['said'] == '', 'that it is old')

    async def test_a_forwarded_port_and_a_camera_that_is_not_known(self):
        page, view = await self.console('--planner', PLANNER, '--page-origin', AS_SEEN, '--camera', '/eye/image')
        for origin, code in ((AS_SEEN, 204), (f'http://localhost:{page.port}', 204), ('http://localhost:9001', 421)):
            request = urllib.request.Request(f'http://localhost:{page.port}/login', headers={'X-Page-Origin': origin})
            try:
                answer = urllib.request.urlopen(request)
            except urllib.error.HTTPError as refused:
                answer = refused
                self.assertIn(f'--page-origin {origin}', refused.read().decode())
            self.assertEqual(answer.status, code)
        eye = await page.connect('/camera')
        eye.write_message(json.dumps({'type': 'hello', 'page': page.page}))
        eye.write_message(json.dumps({'type': 'next'}))
        await until(lambda: view.fields.get('camera', {}).get('fault') == '/eye/image: no picture comes', 'that none comes')
        self.publishes('/eye/image', Image).publish(Image(encoding='16UC1', width=1, height=1, step=2, data=b'xx'))
        await until(lambda: '16UC1' in view.fields['camera']['fault'], 'which encoding it is')
        eye.close()


if __name__ == '__main__':
    unittest.main()
