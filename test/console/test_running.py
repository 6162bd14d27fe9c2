# SPDX-License-Identifier: BSD-3-Clause
"""The console beside the planner and a simulated robot: what a page does, the robot does, and what it must not do it cannot."""
import asyncio
import http.client
import json
import math
import os
import shutil
import signal
import socket
import ssl
import struct
import subprocess
import time
import unittest
import urllib.error
import urllib.request
from unittest import mock

import rospy
import tornado.httpclient
import tornado.websocket
from geometry_msgs.msg import PoseStamped
from hidwa_local_planner.msg import OperatorState
from sensor_msgs.msg import CameraInfo, CompressedImage, Joy
from std_msgs.msg import Bool

import paths
from hidwa_console.node import say
from hidwa_console.server import MOST_SOCKETS, TRY_LATER
from command_watch import CommandWatch
from page_twin import PATIENCE, Page, View, until
from running import World
from test_layouts import bytes_of

ENDS = ({'x': 5.5, 'y': 2.5, 'yaw': -1.57}, {'x': 55.0, 'y': 27.0, 'yaw': 1.57})  # [m, m, rad] of the office
W = None


class Heard:
    """What reached the planner's topics."""

    def __init__(self):
        self.joy, self.hands, self.stops, self.cycles = [], [], [], 0
        rospy.init_node('console_test', disable_signals=True)
        self._subscribers = [
            rospy.Subscriber('/joy', Joy, self.joy.append, queue_size=100),
            rospy.Subscriber('/hand_pose', PoseStamped, self.hands.append, queue_size=100),
            rospy.Subscriber('/move_base/HIDWAPlannerROS/operator_state', OperatorState, self._count, queue_size=100),
            rospy.Subscriber('/move_base/HIDWAPlannerROS/stop', Bool, lambda m: self.stops.append(m.data), queue_size=100)]

    def _count(self, _):
        self.cycles += 1

    async def later(self, count):
        """The planner has worked so many cycles more, 20 of them a second at most."""
        begin = self.cycles
        await until(lambda: self.cycles > begin + count, f'{count} cycles')

    def connected(self):
        return all(s.get_num_connections() for s in self._subscribers)


def setUpModule():
    global W
    W = World()
    try:
        W.child, W.port, _ = W.console()
        W.heard = Heard()
    except BaseException:
        W.end()
        raise


def tearDownModule():
    rospy.signal_shutdown('the tests have ended')
    W.end()


class OnBoard(unittest.IsolatedAsyncioTestCase):
    """A page `a` with its view, that holds the controls of a robot that drives."""

    async def asyncSetUp(self):
        self.pages = []
        self.a = await self.page('a')
        self.view = await View(self.a).open()
        await until(lambda: self.view.fields.get('pose') and self.view.fields.get('mode'), 'robot and planner')
        await until(W.heard.connected, 'the topics')
        await self.a.claim()
        if self.a.last('stop', on=True):
            self.a.say('stop', t=self.a.now(), on=False)
        await self.mode('joystick')

    async def asyncTearDown(self):
        if not self.a.closed and self.a.told_control.get('held'):
            self.a.stick(0.0)
            self.a.say('give')
        for page in self.pages:
            page.control.close()
        self.view.close()
        await asyncio.sleep(0.05)

    async def page(self, letter, **more):
        page = await Page(W.port, letter * 32, **more).open(letter)
        self.pages.append(page)
        return page

    async def mode(self, mode):
        if self.view.fields['mode'] != mode:
            self.a.say('mode', mode=mode)
            await until(lambda: self.view.fields['mode'] == mode and self.a.told_control['neutral_needed'], mode)
            await self.a.hold(0.0, lambda: not self.a.told_control['neutral_needed'], 'a centred stick')

    async def drive(self):
        """Until the robot drives by itself, to the end that is farther away: it is a minute from there at least."""
        x, y = self.view.fields['pose'][:2]
        self.a.say('goal', **max(ENDS, key=lambda end: math.hypot(end['x'] - x, end['y'] - y)))
        await until(lambda: self.state() == 'AUTONOMY' and self.view.fields['velocity'][0] > 0.3, 'a robot that drives')

    def told(self, field, otherwise=None):
        """Of the newest state that the view has."""
        return (self.view.fields['state'] or {}).get(field, otherwise)

    def state(self):
        return self.told('name')

    async def steer(self, left, seconds, page=None, age=0.0):
        for _ in range(round(20 * seconds)):
            (page or self.a).stick(left, age=age)
            await asyncio.sleep(0.05)

    async def steer_until(self, left, state, page=None):
        await (page or self.a).hold(left, lambda: self.state() == state, state)


class Driving(OnBoard):
    async def test_the_stick_bends_the_way_to_its_side(self):
        await self.drive()
        for left in (0.8, -0.8):
            before = len(W.heard.joy)
            await self.steer_until(left, 'SHARED')
            # dead zone 0.1, exponent 2, max_vel_theta 1 rad/s: 0.8^2 * 1 = 0.64 rad/s to that side.
            wanted = 0.64 if left > 0 else -0.64
            await self.a.hold(left, lambda: abs(self.told('wanted', (0.0, 0.0))[1] - wanted) < 0.005, f'{wanted} rad/s')
            self.assertLessEqual({round(j.axes[0], 6) for j in W.heard.joy[before:]}, {0.0, left})
            before = len(W.heard.joy)
            self.a.stick(0.0)
            await until(lambda: self.state() in ('HOLD', 'AUTONOMY'), 'the release', self.state)
            await W.heard.later(4)  # nothing may come now
            self.assertEqual([j.axes[0] for j in W.heard.joy[before:]].count(0.0), 1)
            await self.drive()

    async def test_who_begins_to_listen_hears_a_neutral_stick_first(self):
        async def first():
            listener = await asyncio.create_subprocess_exec('rostopic', 'echo', '-n1', '/joy/axes', stdout=asyncio.subprocess.PIPE)
            return listener, asyncio.ensure_future(listener.communicate())
        listener, said = await first()
        self.assertEqual((await asyncio.wait_for(said, PATIENCE))[0].decode().split('\n')[0].count('0.0'), 8)
        await self.drive()
        await self.steer_until(0.2, 'SHARED')
        heard = []
        while not heard or '0.2' not in heard[-1]:  # while somebody steers it hears that, but on a slow machine the stick may be lost
            self.assertLess(len(heard), 5, heard)
            listener, said = await first()
            await self.a.hold(0.2, said.done, 'what is steered')
            heard.append((await said)[0].decode().split('\n')[0])

    async def test_cut_while_steering_it_is_lost(self):
        await self.drive()
        watcher = await self.page('b')
        await self.steer_until(0.5, 'SHARED')
        sent = len(W.heard.joy)
        self.a.cut()
        await until(lambda: self.state() == 'LOST', 'LOST')
        self.assertLessEqual(len(W.heard.joy), sent + 1)  # the last one may have been on its way
        self.assertNotIn(0.0, [j.axes[0] for j in W.heard.joy[sent:]])
        again = await self.page('a')
        self.assertTrue(again.told_control['held'] and again.told_control['neutral_needed'])
        await again.hold(0.0, lambda: self.state() in ('HOLD', 'AUTONOMY'), 'the end of LOST')
        self.assertFalse(watcher.told_control['held'])
        again.say('give')

    async def test_gone_in_order_it_is_released(self):
        await self.drive()
        await self.steer_until(0.5, 'SHARED')
        sent = len(W.heard.joy)
        self.a.control.close(1001, 'the tab was closed')
        await until(lambda: 0.0 in [j.axes[0] for j in W.heard.joy[sent:]], 'a release')
        await until(lambda: self.state() in ('HOLD', 'AUTONOMY'), 'HOLD')
        await W.heard.later(12)  # longer than the planner's timeout of 0.5 s: no second one, and nothing is lost
        self.assertEqual([j.axes[0] for j in W.heard.joy[sent:]].count(0.0), 1)
        self.assertNotEqual(self.state(), 'LOST')
        (await self.page('a')).say('give')

    async def test_two_seconds_at_once(self):
        await self.drive()
        before = len(W.heard.joy)
        for i in range(41):
            self.a.stick(1.0, age=2.0 - 0.05 * i)
        await until(lambda: self.a.last('steering', state='late'), 'that they are late')
        self.a.say('hello', page=self.a.page)  # behind them: once it is answered they were read
        count = len([m for m in self.a.heard if m['type'] == 'welcome'])
        await until(lambda: len([m for m in self.a.heard if m['type'] == 'welcome']) > count - 1, 'the last of them')
        await W.heard.later(4)
        self.assertEqual(self.state(), 'AUTONOMY')
        for i in range(41):
            self.a.stick(1.0, age=2.0 - 0.05 * i, stop=i == 3)
        await until(lambda: self.state() == 'STOPPED', 'STOPPED')
        self.assertEqual([j.axes[0] for j in W.heard.joy[before:] if j.axes[0] != 0.0], [])

    async def test_a_stop_stays_until_somebody_at_the_controls_lets_go(self):
        await self.drive()
        self.a.say('stop', t=self.a.now(), on=True)
        await until(lambda: self.state() == 'STOPPED' and self.view.fields['velocity'] == [0.0, 0.0], 'a robot at rest')
        self.a.cut()
        b = await self.page('b')
        b.say('stop', t=b.now(), on=False)
        await until(lambda: b.last('told', what='stop', ok=False), 'that watchers do not let go')
        b.say('claim')
        await until(lambda: b.told_control['held'], 'the controls, after the lease')
        self.assertEqual((self.state(), b.last('stop')['on']), ('STOPPED', True))
        b.say('stop', t=b.now(), on=False)
        await until(lambda: self.state() == 'AUTONOMY' and self.view.fields['velocity'][0] > 0.1, 'a robot that drives on')
        b.say('give')

    async def test_a_watcher_stops(self):
        await self.drive()
        b = await self.page('b')
        await self.steer(0.5, 0.2)
        b.say('stop', t=b.now() - 1e4, on=True)  # ten seconds late
        await until(lambda: self.state() == 'STOPPED', 'STOPPED')
        self.assertEqual(self.a.last('stop')['by'], b.last('welcome')['you'])

    async def test_a_second_visitor_watches_until_it_is_given(self):
        await self.drive()
        b, before = await self.page('b'), len(W.heard.joy)
        b.stick(0.0)
        await self.steer(1.0, 0.3, page=b)
        await until(lambda: b.last('steering', state='watching'), 'that it watches')
        self.assertEqual([j.axes[0] for j in W.heard.joy[before:] if j.axes[0] != 0.0], [])
        b.say('claim')
        await until(lambda: self.a.told_control['claims'], 'the request')
        self.a.say('give', to=self.a.told_control['claims'][0]['visitor'])
        await until(lambda: b.told_control['held'] and not self.a.told_control['held'], 'the handover')
        b.stick(0.0)
        await self.steer_until(0.5, 'SHARED', page=b)
        b.stick(0.0)
        b.say('give')

    async def test_a_hand_steers(self):
        await self.drive()
        await self.mode('gesture')

        async def move(far, frames, grip):
            for i in range(frames):
                self.a.say('hand', t=self.a.now(), left=far * i / frames, forward=0.0, up=0.0, grip=grip)
                await asyncio.sleep(0.03)
        # A planner that takes the mode only now wants to see the hand open first: whoever is not heard opens it again.
        deadline = time.monotonic() + PATIENCE
        while self.state() != 'SHARED':
            self.assertLess(time.monotonic(), deadline, f'SHARED; it is {self.state()}')
            await move(0.0, 10, False)
            await until(lambda: not self.a.told_control['neutral_needed'], 'an open hand')
            await move(-0.2, 30, True)
        self.assertLess(self.view.fields['state']['wanted'][1], 0.0)  # to the right
        self.a.say('release', t=self.a.now(), why='tracking')
        await until(lambda: self.state() in ('HOLD', 'AUTONOMY'), 'the release')
        await self.mode('joystick')

    async def test_control_is_taken_and_given_back(self):
        await self.drive()
        await self.mode('switching')
        self.a.say('take_control', on=True)
        await until(lambda: self.state() == 'MANUAL', 'MANUAL')
        for _ in range(15):
            self.a.stick(0.0, 0.6)
            await asyncio.sleep(0.05)
        self.assertEqual(self.state(), 'MANUAL')
        for _ in range(15):  # in control the centred stick is a command too, and is repeated
            self.a.stick(0.0)
            await asyncio.sleep(0.05)
        self.assertEqual(self.state(), 'MANUAL')
        self.a.say('take_control', on=False)
        await until(lambda: self.state() == 'AUTONOMY', 'AUTONOMY')
        await self.mode('joystick')


class Killed(OnBoard):
    async def console(self, letter):
        """Another console, and a page of it that holds its controls; meanwhile our page answers its pings."""
        child, port, _ = await asyncio.get_running_loop().run_in_executor(None, W.console)
        page = await Page(port, letter * 32).open(letter)
        self.pages.append(page)
        await page.claim()
        return child, page

    async def test_while_somebody_steers_the_robot_drives_on_by_itself(self):
        await self.drive()
        child, page = await self.console('e')
        await self.drive()
        watch = CommandWatch()
        await self.steer_until(0.5, 'SHARED', page)
        os.kill(child.pid, signal.SIGKILL)
        await until(lambda: self.state() == 'LOST', 'LOST')
        begun = watch.count()
        await until(lambda: watch.count() > begun + 60 and self.view.fields['velocity'][0] > 0.3, 'a robot that drives on')
        self.assertEqual(self.view.fields['state']['wanted'][1], 0.0)
        _, again = await self.console('f')
        await self.drive()
        await self.steer_until(-0.5, 'SHARED', again)
        again.stick(0.0)
        await until(lambda: self.state() in ('HOLD', 'AUTONOMY'), 'the release')
        self.assertEqual(watch.faults(), [])
        self.assertEqual(watch.abrupt_stops(), 0)


class Going(OnBoard):
    async def test_parameters_of_the_panel_and_no_others(self):
        await until(lambda: self.view.fields.get('tuning', {}).get('parameters'), 'the panel')
        known = {p['name'] for p in self.view.fields['tuning']['parameters']}
        self.assertTrue({'s_v', 's_omega', 'delta', 'PathDist_scale', 'mode'} <= known)
        self.assertFalse({'max_vel_x', 'control_latency', 'joy_topic', 'footprint_padding'} & known)

        def value(name):
            return next(p['value'] for p in self.view.fields['tuning']['parameters'] if p['name'] == name)

        async def told(what, ok):
            await until(lambda: self.a.last('told', what=what) and self.a.last('told', what=what)['text'] != 'asked', what)
            self.assertEqual(self.a.last('told', what=what)['ok'], ok)
            self.a.heard.clear()
        self.a.say('tune', values={'s_v': 123.5, 'linear': 'axis'})
        await told('tune', True)
        await until(lambda: value('s_v') == 123.5 and value('linear') == 'axis', 'the new value')
        self.assertEqual(rospy.get_param('/move_base/HIDWAPlannerROS/s_v'), 123.5)
        self.a.say('undo')
        await until(lambda: value('s_v') == 400.0 and value('linear') == 'v_max', 'the old value')
        self.a.heard.clear()
        self.a.say('tune', values={'s_v': 1.0, 'max_vel_x': 9.0})
        await told('tune', False)
        self.a.say('preset', name='pilot_3')
        await until(lambda: value('delta') == 1.0 and value('s_omega') == 400.0, "the preset's values")
        self.a.say('undo')
        await until(lambda: value('delta') == 2.0, 'the old value')

    async def test_candidates_on_demand(self):
        await self.drive()
        self.view.want(True)
        await until(lambda: (5, 0) in self.view.binary, 'candidates')
        count, points, best = struct.unpack_from('<III', self.view.binary[(5, 0)], 28)
        self.assertTrue(100 < count <= 601 and points == 8 and best < count)
        self.view.want(False)
        await until(lambda: struct.unpack_from('<I', self.view.binary[(5, 0)], 28)[0] == 0, 'their end')

    async def test_who_takes_nothing_in_gets_nothing_more(self):
        await self.drive()
        b = await self.page('b')
        slow = await View(b).open(acknowledge=False)
        ticks = self.view.ticks
        await until(lambda: self.view.ticks > ticks + 40, 'two seconds of the other')
        self.assertEqual(slow.ticks, 1)
        slow.close()

    async def test_the_costmap_of_changes_is_the_costmap(self):
        await self.drive()
        await until(lambda: self.view.kinds.count(2) > 10, 'changes')
        whole = await View(await self.page('b')).open()
        await until(lambda: 1 in whole.grids, 'the whole')
        version = whole.grids[1]['version']
        await until(lambda: self.view.grids[1]['version'] >= version and whole.grids[1]['version'] == self.view.grids[1]['version'], 'both')
        self.assertEqual(whole.grids[1]['cells'], self.view.grids[1]['cells'])
        self.assertIn(100, whole.grids[1]['cells'])
        whole.close()


class Pictures(unittest.IsolatedAsyncioTestCase):
    """The camera's pictures: the newest, when the page asks."""

    async def test_each_once_and_the_newest(self):
        child, port, _ = W.console('--camera', '/eye/image/compressed')
        camera = rospy.Publisher('/eye/image/compressed', CompressedImage, queue_size=1)
        info = rospy.Publisher('/eye/camera_info', CameraInfo, queue_size=1, latch=True)
        info.publish(CameraInfo(width=640, height=480, K=[500.0, 0.0, 320.0, 0.0, 501.0, 240.0, 0.0, 0.0, 1.0]))
        page = await Page(port, 'b' * 32).open()
        view = await View(page).open()
        eye = await page.connect('/camera')
        eye.write_message(json.dumps({'type': 'hello', 'page': page.page}))
        await until(camera.get_num_connections, 'the console')

        async def picture():
            eye.write_message(json.dumps({'type': 'next'}))
            return (await asyncio.wait_for(eye.read_message(), PATIENCE))[16:]
        for content in (b'first', b'second'):
            camera.publish(CompressedImage(format='jpeg', data=b'\xff\xd8\xff' + content))
            self.assertEqual(await picture(), b'\xff\xd8\xff' + content)
        third = asyncio.ensure_future(picture())  # who asks before there is another one does not get the second again
        pings = page.pings
        await until(lambda: page.pings > pings + 1, 'that it has been asked')
        camera.publish(CompressedImage(format='jpeg', data=b'\xff\xd8\xffthird'))
        self.assertEqual(await third, b'\xff\xd8\xffthird')
        await until(lambda: view.fields.get('camera', {}).get('info'), 'the calibration')
        calibration = view.fields['camera']['info']
        self.assertEqual([calibration[k] for k in ('width', 'fx', 'fy', 'cx', 'cy')], [640, 500.0, 501.0, 320.0, 240.0])
        self.assertIsNone(calibration['pose'])  # tf does not know its frame
        eye.close()
        await until(lambda: not camera.get_num_connections(), 'that nobody watches')
        child.stop()


class Refused(unittest.IsolatedAsyncioTestCase):
    """Who may not come in; and whatever is sent, the node goes on."""

    async def asyncTearDown(self):
        page = await Page(W.port, 'f' * 32).open()
        self.assertTrue(W.child.running)
        page.control.close()

    async def refused(self, path='/control', headers=None, port=None, **more):
        headers = {'Origin': f'http://localhost:{port or W.port}', **(headers or {})}
        request = tornado.httpclient.HTTPRequest(f'ws://localhost:{port or W.port}{path}', headers={k: v for k, v in headers.items() if v})
        with self.assertRaises(tornado.httpclient.HTTPClientError) as caught:
            await tornado.websocket.websocket_connect(request, **more)
        self.assertEqual(caught.exception.code, 403, (path, headers))

    async def test_foreign_origins(self):
        for path in ('/control', '/view', '/camera'):
            for origin in ('http://evil.example', f'http://localhost:{W.port}.evil.example', 'null', ''):
                await self.refused(path, {'Origin': origin})

    async def test_foreign_hosts(self):
        # The name of an attacker's that points to 127.0.0.1: origin and host agree, and still.
        evil = f'evil.example:{W.port}'
        for path in ('/control', '/view', '/camera', '/foxglove'):
            await self.refused(path, {'Host': evil, 'Origin': f'http://{evil}'})
        for path in ('/', '/report/report.json', '/login'):
            request = urllib.request.Request(f'http://localhost:{W.port}{path}', headers={'Host': evil})
            with self.assertRaises(urllib.error.HTTPError) as caught:
                urllib.request.urlopen(request)
            self.assertEqual(caught.exception.code, 403)

    async def closed(self, *messages, hello=True):
        """The close code after these messages."""
        page = Page(W.port, 'e' * 32)
        page.control = await page.connect('/control')
        if hello:
            page.say('hello', page=page.page)
        asyncio.ensure_future(page._listen())
        for message in messages:
            try:
                await page.control.write_message(message, isinstance(message, bytes))
            except tornado.websocket.WebSocketClosedError:
                break
        await until(lambda: page.closed, f'the end of the connection after {str(messages[0])[:60]}')
        return page.closed

    async def test_malformed(self):
        for message in ('{', 'null', '{"type": "fly"}', '{"type": "stick"}', b'\x00\x01', '[' * 5000,
                        '{"type": "stop", "t": NaN, "on": true}'):
            self.assertEqual(await self.closed(message), 1008)
        self.assertEqual(await self.closed('{"type": "claim"}', hello=False), 1008)

    async def test_oversized(self):
        self.assertEqual(await self.closed(json.dumps({'type': 'claim', 'x': 'x' * 5000})), 1008)
        self.assertIn(await self.closed('x' * 200000), (1006, 1009))

    async def test_too_many(self):
        # Of those that get no answer: on a busy machine the answers alone would make 2,000 last longer than the limit allows.
        # 1006: what the server had not read when it closed resets the connection, and the close code with it.
        self.assertIn(await self.closed(*['{"type": "pong", "id": 0, "t": 0}'] * 2000), (1006, 1008))

    async def test_too_many_sockets(self):
        page = Page(W.port)
        sockets = [await page.connect('/control') for _ in range(MOST_SOCKETS)]
        refused = await page.connect('/control')
        self.assertIsNone(await asyncio.wait_for(refused.read_message(), PATIENCE))
        self.assertEqual(refused.close_code, TRY_LATER)
        for one in sockets:
            one.close()
            while await asyncio.wait_for(one.read_message(), PATIENCE) is not None:
                pass

    async def test_a_token_that_can_be_read_on_the_way_is_said(self):
        child, _, token = W.console('--address', '0.0.0.0', '--host-name', 'robot.lan')
        self.assertTrue(token)  # beyond loopback one is needed
        self.assertIn('everybody on the way can read and change what is sent, the token too', W.newest_log())
        child.stop()

    async def test_bytes_that_are_no_request(self):
        for data in (b'\x00' * 100, b'GET / HTTP/1.1\r\n' + b'A: ' + b'b' * 100000 + b'\r\n\r\n',
                     b'GET /../../etc/passwd HTTP/1.1\r\nHost: localhost:%d\r\n\r\n' % W.port):
            with socket.create_connection(('localhost', W.port)) as plain:
                plain.sendall(data)
                plain.settimeout(PATIENCE)
                if b'\r\n\r\n' not in data:
                    plain.shutdown(socket.SHUT_WR)  # nothing more comes, for which it would wait
                try:
                    answer = plain.recv(4096)
                except ConnectionError:
                    answer = b''
                self.assertNotIn(b'root:', answer)

    async def test_files_outside_of_the_page(self):
        for path in ('/..%2f..%2f..%2fetc/passwd', '/report/..%2frecorder.log', '/lib/three/..%2f..%2f..%2fpackage.xml', '/lib/other/x.js'):
            with self.assertRaises(urllib.error.HTTPError) as caught:
                urllib.request.urlopen(f'http://localhost:{W.port}{path}')
            self.assertIn(caught.exception.code, (403, 404))

    async def test_headers(self):
        answer = urllib.request.urlopen(f'http://localhost:{W.port}/')
        policy = answer.headers['Content-Security-Policy']
        self.assertIn("default-src 'none'", policy)
        self.assertNotIn('unsafe', policy)
        self.assertNotIn('*', policy)
        self.assertEqual(answer.headers['X-Content-Type-Options'], 'nosniff')

    async def test_a_line_is_one_write(self):
        # Two, as of print, let a thread that logs get between them: then its text stands behind the token.
        with mock.patch('sys.stdout') as out:
            say('console: here')
        self.assertEqual(out.write.call_args_list, [mock.call('console: here\n')])

    async def test_token(self):
        child, port, token = W.console('--token')
        self.assertEqual(len(token), 22)  # 16 bytes in base64
        await self.refused('/control', port=port)
        base = f'http://localhost:{port}'

        def login(given, origin=base):
            request = urllib.request.Request(base + '/login', json.dumps({'token': given}).encode(), {'Origin': origin})
            return urllib.request.urlopen(request)
        for given, origin in (('wrong', base), (token, 'http://evil.example'), (token[:-1], base)):
            with self.assertRaises(urllib.error.HTTPError) as caught:
                login(given, origin)
            self.assertEqual(caught.exception.code, 403)
        cookie = login(token).headers['Set-Cookie']
        self.assertTrue('HttpOnly' in cookie and 'SameSite=Strict' in cookie, cookie)
        session = cookie.split(';')[0]
        await self.refused('/view', {'Cookie': session[:-1]}, port)
        page = await Page(port, 'c' * 32, cookie=session).open()
        page.control.close()
        await self.refused('/foxglove', {'Origin': ''}, port, subprotocols=['foxglove.websocket.v1'])
        await self.refused('/foxglove/' + token, {'Origin': ''}, port, subprotocols=['foxglove.websocket.v1'])  # no --allow-origin
        child.stop()

    async def test_tls(self):
        key, certificate = (os.path.join(W.folder, name) for name in ('key.pem', 'cert.pem'))
        subprocess.run(['openssl', 'req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-days', '2', '-subj', '/CN=robot.lan', '-addext',
                        'subjectAltName=DNS:robot.lan', '-keyout', key, '-out', certificate], check=True, capture_output=True)
        child, port, token = W.console('--address', '0.0.0.0', '--host-name', 'robot.lan', '--certfile', certificate, '--keyfile', key)
        self.assertTrue(token)
        trusted = ssl.create_default_context(cafile=certificate)

        def ask(path, host, data=None):
            connection = http.client.HTTPSConnection('robot.lan', port, context=trusted)
            plain = socket.create_connection(('127.0.0.1', port))
            connection.sock = trusted.wrap_socket(plain, server_hostname='robot.lan')
            headers = {'Host': f'{host}:{port}', 'Origin': f'https://{host}:{port}'}
            connection.request('POST' if data else 'GET', path, data, headers)
            answer = connection.getresponse()
            answer.read()
            connection.close()
            return answer
        self.assertEqual(ask('/', 'robot.lan').status, 200)
        self.assertEqual(ask('/', 'evil.example').status, 403)
        self.assertEqual(ask('/report/report.json', 'robot.lan').status, 403)
        answer = ask('/login', 'robot.lan', json.dumps({'token': token}))
        self.assertEqual(answer.status, 204)
        self.assertIn('Secure', answer.headers['Set-Cookie'])
        child.stop()


class Foxglove(unittest.IsolatedAsyncioTestCase):
    """Another program's view, by the protocol's facts."""

    async def asyncSetUp(self):
        request = tornado.httpclient.HTTPRequest(f'ws://localhost:{W.port}/foxglove', headers={'Origin': 'http://localhost:8080'})
        self.socket = await tornado.websocket.websocket_connect(request, subprotocols=['foxglove.websocket.v1'], max_message_size=1 << 24)
        self.assertEqual(self.socket.selected_subprotocol, 'foxglove.websocket.v1')
        self.info, self.channels, self.status, self.data = None, {}, [], {}
        asyncio.ensure_future(self.listen())
        await until(lambda: self.info and self.channels, 'channels')

    async def asyncTearDown(self):
        self.socket.close()

    async def listen(self):
        while True:
            message = await self.socket.read_message()
            if message is None:
                return
            if isinstance(message, bytes):
                op, subscription, stamp = struct.unpack_from('<BIQ', message)
                self.assertEqual(op, 1)
                self.data.setdefault(subscription, []).append((stamp, message[13:]))
                continue
            message = json.loads(message)
            if message['op'] == 'serverInfo':
                self.info = message
            elif message['op'] == 'advertise':
                self.channels.update({c['topic']: c for c in message['channels']})
            elif message['op'] == 'status':
                self.status.append(message)

    def say(self, **message):
        self.socket.write_message(json.dumps(message))

    async def test_it_sees_what_is_there(self):
        self.assertEqual(self.info['metadata']['ROS_DISTRO'], 'noetic')
        for number, topic in enumerate(('/map', '/scan', '/tf_static'), 10):
            channel = self.channels[topic]
            self.assertEqual((channel['encoding'], channel['schemaEncoding']), ('ros1', 'ros1msg'))
            self.say(op='subscribe', subscriptions=[{'id': number, 'channelId': channel['id']}])
        await until(lambda: {10, 11, 12} <= set(self.data), 'messages')
        scan = rospy.wait_for_message('/scan', rospy.AnyMsg, PATIENCE)
        self.assertEqual(len(self.data[11][0][1]), len(scan._buff))
        self.say(op='unsubscribe', subscriptionIds=[11])
        self.say(op='subscribe', subscriptions=[{'id': 13, 'channelId': self.channels['/scan']['id']}])
        await until(lambda: 13 in self.data, 'scans of the new subscription')
        count = len(self.data[11])
        await until(lambda: len(self.data[13]) > 10, 'more of them')
        self.assertEqual(len(self.data[11]), count)
        self.assertIn('Header header', self.channels['/move_base/HIDWAPlannerROS/operator_state']['schema'])
        self.assertIn('MSG: geometry_msgs/Twist', self.channels['/move_base/HIDWAPlannerROS/operator_state']['schema'])
        self.assertEqual(self.channels['/move_base/HIDWAPlannerROS/operator_state']['schemaName'], OperatorState._type)

    async def test_goals_and_nothing_else(self):
        joys = len(W.heard.joy)
        self.say(op='advertise', channels=[{'id': 1, 'topic': '/joy', 'encoding': 'ros1', 'schemaName': 'sensor_msgs/Joy'},
                                           {'id': 2, 'topic': '/cmd_vel', 'encoding': 'ros1', 'schemaName': 'geometry_msgs/Twist'},
                                           {'id': 3, 'topic': '/move_base_simple/goal', 'encoding': 'ros1',
                                            'schemaName': 'geometry_msgs/PoseStamped'}])
        await until(lambda: len(self.status) == 2, 'two refusals')
        self.socket.write_message(struct.pack('<BI', 1, 1) + bytes_of(Joy(axes=[1.0], buttons=[1])), binary=True)
        await until(lambda: len(self.status) == 3, 'the third')
        goal = PoseStamped()
        goal.header.frame_id, goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = 'map', 54.0, 27.0, 1.0
        page = await Page(W.port, 'd' * 32).open()
        view = await View(page).open()
        await page.claim()
        self.socket.write_message(struct.pack('<BI', 1, 3) + bytes_of(goal), binary=True)
        await until(lambda: len(self.status) == 4, 'that the controls are held')
        self.assertIn('holds the controls', self.status[3]['message'])
        page.say('give')
        await until(lambda: page.told_control['holder'] is None, 'free controls')
        self.socket.write_message(struct.pack('<BI', 1, 3) + bytes_of(goal), binary=True)
        await until(lambda: view.fields.get('goals', {}).get('active') == [54.0, 27.0, 0.0], 'the goal')
        self.assertEqual(len(W.heard.joy), joys + 1)  # the page centred its stick
        view.close()
        page.control.close()

    @unittest.skipUnless(shutil.which('npm') and shutil.which('node'), 'npm and node bring the client')
    async def test_the_protocols_own_client(self):
        modules = os.path.join(os.environ.get('HIDWA_SPACE', paths.ROOT), 'build', 'console', 'node_modules')
        self.assertTrue(os.path.isdir(os.path.join(modules, '@foxglove')), 'run scripts/console_libraries --dev first')
        client = await asyncio.create_subprocess_exec(
            'node', os.path.join(os.path.dirname(__file__), 'foxglove_client.mjs'), f'ws://localhost:{W.port}/foxglove',
            env={**os.environ, 'NODE_PATH': modules}, stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.STDOUT)
        text = (await client.communicate())[0].decode()
        self.assertEqual(client.returncode, 0, text)
        got = json.loads(text.splitlines()[-1])
        self.assertEqual(got['schemas'], {'map': 'nav_msgs/OccupancyGrid', 'state': 'hidwa_local_planner/OperatorState'})
        self.assertEqual(got['statuses'], [''])  # the goal was taken
        # The office: 1240 x 640 cells of a byte, and a header; the state comes because the robot drives to the goal.
        self.assertGreater(got['bytes']['map'], 1240 * 640)

    async def test_malformed(self):
        self.socket.write_message(b'\x07', binary=True)
        await until(lambda: self.socket.close_code, 'the end')
        self.assertEqual(self.socket.close_code, 1008)

    async def test_other_subprotocols_and_origins(self):
        for origin, code in (('http://evil.example', 403), ('http://evil.example:8080', 403)):
            request = tornado.httpclient.HTTPRequest(f'ws://localhost:{W.port}/foxglove', headers={'Origin': origin})
            with self.assertRaises(tornado.httpclient.HTTPClientError) as caught:
                await tornado.websocket.websocket_connect(request, subprotocols=['foxglove.websocket.v1'])
            self.assertEqual(caught.exception.code, code)
        request = tornado.httpclient.HTTPRequest(f'ws://localhost:{W.port}/foxglove')
        other = await tornado.websocket.websocket_connect(request, subprotocols=['other'])
        self.assertIsNone(await other.read_message())
        self.assertEqual(other.close_code, 1008)


if __name__ == '__main__':
    unittest.main()
