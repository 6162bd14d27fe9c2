#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Faults in the running host. Each: the robot drives, something breaks, every command stays finite, within the limits and the
accelerations, the log names what is wrong, and when it is over the robot drives on. Nothing is touched meanwhile."""
import itertools
import json
import math
import os
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import paths  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from dynamic_reconfigure.msg import Config, DoubleParameter, IntParameter, StrParameter  # noqa: E402
from dynamic_reconfigure.srv import Reconfigure  # noqa: E402
from std_msgs.msg import String  # noqa: E402
from roscpp.srv import Empty  # noqa: E402; as std_srvs has it, which Debian has for C++ alone

from command_watch import PLANNER, CommandWatch  # noqa: E402
from hidwa_tools.waiting import PATIENCE, wait_for  # noqa: E402
from message_gate import Gate, transforms_with  # noqa: E402
from running_host import PREEMPTED, Journal, RunningHost, Stick  # noqa: E402

PLACES = ((30.0, 15.0), (5.5, 8.0))  # far apart in the office [m]
JS_EVENT = struct.Struct('=IhBB')    # struct js_event of linux/joystick.h
DOUBT = 'is not believed: the pose'    # of a velocity


def setUpModule():
    global GATE, WATCH, HOST, LOG, STICK
    GATE, LOG = Gate(), Journal()
    HOST, STICK = RunningHost(PLACES), Stick()
    assert HOST.wait_until_ready(), 'move_base does not come up'
    WATCH = CommandWatch()


class Faults(unittest.TestCase):
    def setUp(self):
        GATE.heal()
        STICK.left, STICK.ahead, STICK.sends = 0.0, 0.0, True
        self.assertTrue(HOST.drives(), 'the robot does not drive before the fault')
        self.contacts = HOST.contacts
        LOG.begin()
        WATCH.begin()

    def drives_on(self, cycles=40):
        """So many cycles more, enough to brake to rest in, and none of them fails; then the robot moves."""
        self.commands(cycles)
        self.assertNotIn('FAIL', WATCH.outcomes(), LOG.lines[-5:])
        self.assertTrue(HOST.drives(0.1), f'the robot does not drive on; {LOG.lines[-5:]}')

    def commands(self, count):
        """Waits for so many more."""
        begun = WATCH.count()
        self.assertTrue(wait_for(lambda: HOST.go_on() or WATCH.count() > begun + count), 'no commands come any more')

    def over(self, abrupt=0):
        """The fault is over: the robot drives on, and nothing was wrong with any command. `abrupt`: so many zeros of the host
        itself are part of it, at most."""
        GATE.heal()
        self.commands(20)
        self.assertTrue(HOST.drives(), f'the robot does not drive on; {LOG.lines[-5:]}')
        self.assertEqual(WATCH.faults(), [])
        held = sum('the robot is held' in line for line in LOG.lines)  # by the host, where the machine is late with its scans
        self.assertLessEqual(WATCH.abrupt_stops(), abrupt + held)
        self.assertEqual(HOST.contacts, self.contacts)

    def said(self, *parts):
        """Somebody logs one of these."""
        self.assertTrue(wait_for(lambda: any(map(LOG.said, parts))), f'nobody says {parts}; the last lines: {LOG.lines[-8:]}')

    def steer(self, left):
        """Until the planner takes the stick's word."""
        STICK.left = left
        self.assertTrue(wait_for(lambda: HOST.state_name() == 'SHARED'), HOST.state_name())


class Transforms(Faults):
    def test_lost(self):
        GATE.drop('tf')
        self.said('there is no pose of the robot in odom: check the transform from base_link')
        self.assertTrue(HOST.stands())
        self.over()

    def test_jumping(self):
        """The robot's own pose is 0.5 m to the side in every other tenth of a second, then the map is."""
        def aside(transform):
            if int(transform.header.stamp.to_sec() * 10) % 2:
                transform.transform.translation.y += 0.5
            return transform
        for child in ('base_link', 'odom'):
            GATE.disturb('tf', transforms_with(child, aside))
            self.drives_on()
        self.over()

    def test_in_the_future(self):
        GATE.disturb('tf', lambda message: transforms_with('base_link', lambda t: ahead(t, 2.0))(message))
        self.said('ahead of the clock')
        self.assertTrue(HOST.stands())
        self.over()


def ahead(transform, seconds):
    transform.header.stamp += rospy.Duration(seconds)
    return transform


class Costmap(Faults):
    def test_stale(self):
        GATE.drop('scan')
        self.said('the robot is held', 'Sensor data is out of date')  # compat's host, the real one
        self.assertTrue(HOST.stands())
        self.over(abrupt=1)  # the host's own zero

    def test_cleared_while_it_plans(self):
        clear = rospy.ServiceProxy('/move_base/clear_costmaps', Empty)
        cleared = itertools.count()

        def enough():
            clear()
            return next(cleared) > 3 and WATCH.count() > 40
        self.assertTrue(wait_for(enough))
        self.assertNotIn('FAIL', WATCH.outcomes())
        self.over()


class Odometry(Faults):
    def over(self):
        """And the velocity that was not believed is again, after ten seconds of driving."""
        super().over()
        if LOG.said(DOUBT):
            self.assertTrue(wait_for(lambda: HOST.go_on() or LOG.said('the odometry is as it should be')), LOG.lines[-8:])

    def test_frozen(self):
        """The same reading again and again, with stamps of now; the person turns the robot meanwhile, or lets go of it."""
        GATE.disturb('odom', frozen())
        self.steer(0.9)
        self.drives_on()
        self.assertTrue(wait_for(lambda: HOST.go_on() or HOST.velocity[1] > 0.7), 'the robot does not turn')
        GATE.disturb('odom', frozen())
        STICK.left = 0.0
        self.said(DOUBT)
        self.drives_on()
        self.over()

    def test_jumping(self):
        """Every third reading is 3 m/s, every seventh is no number."""
        count = itertools.count()

        def jump(message):
            i = next(count)
            if i % 3 == 0:
                message.twist.twist.linear.x = 3.0 * (-1) ** i
            if i % 7 == 0:
                message.twist.twist.angular.z = math.nan
            return message
        GATE.disturb('odom', jump)
        self.said('which the commands do not explain', DOUBT)
        self.said('its velocity is not a number; check the sender')
        self.drives_on()
        self.over()  # each command starts from the one before it, whatever was read

    def test_at_one_hertz(self):
        last = [0.0]

        def thin(message):
            if message.header.stamp.to_sec() - last[0] < 1.0:
                return None
            last[0] = message.header.stamp.to_sec()
            return message
        GATE.disturb('odom', thin)
        self.said('s old (odom_timeout 0.50 s)')

        def in_turn():
            names = iter([cycle.outcome_name for cycle in WATCH.cycles()])
            return all(name in names for name in ('BRAKE', 'DRIVE', 'BRAKE', 'DRIVE'))
        self.assertTrue(wait_for(lambda: HOST.go_on() or in_turn()), 'it does not brake and go on')
        self.over()


def frozen():
    """A disturbance of odometry: its first reading again and again."""
    kept = []

    def freeze(message):
        kept[:] = kept or [message]
        message.twist = kept[0].twist
        return message
    return freeze


class Goals(Faults):
    def test_cancelled_while_steering(self):
        self.steer(0.5)
        HOST.cancel()
        self.assertTrue(wait_for(lambda: HOST.result == PREEMPTED))
        self.assertTrue(HOST.stands())
        count, end = WATCH.count(), rospy.get_time() + 1.0
        self.assertTrue(wait_for(lambda: rospy.get_time() > end))
        self.assertEqual(WATCH.count(), count)  # the stick alone moves nothing
        STICK.left = 0.0
        self.over(abrupt=1)  # the host's own zero


class Changes(Faults):
    def test_a_storm_of_parameters_while_it_computes(self):
        """Good and bad sets as fast as they are answered, by three at once, while somebody steers."""
        call = rospy.ServiceProxy(PLANNER + '/set_parameters', Reconfigure)
        modes = rospy.Publisher(PLANNER + '/set_mode', String, queue_size=10)
        good = (
            Config(doubles=[DoubleParameter('max_vel_x', 0.3), DoubleParameter('sim_time', 1.2)]),
            Config(doubles=[DoubleParameter('max_vel_x', 0.5), DoubleParameter('sim_time', 1.7)]),
            Config(ints=[IntParameter('vx_samples', 5), IntParameter('vth_samples', 5)]),
            Config(ints=[IntParameter('vx_samples', 20), IntParameter('vth_samples', 20)]),
            Config(strs=[StrParameter('critics', 'PathDist, GoalDist, PathAlign, GoalAlign, BaseObstacle')]),
        )
        bad = (
            Config(strs=[StrParameter('critics', 'PathDist, GoalDist, NoSuchCritic')], doubles=[DoubleParameter('sim_time', 1.3)]),
            Config(doubles=[DoubleParameter('max_vel_x', -3.0), DoubleParameter('sim_time', 1.4)]),
        )
        before = call(Config()).config
        answers = []  # each set, and what its answer says is in force
        answered, end = [0, 0, 0], time.monotonic() + PATIENCE
        self.addCleanup(modes.publish, 'joystick')
        self.addCleanup(call, before)

        def storm(index):
            for config in itertools.cycle((good + bad)[index:] + (good + bad)[:index]):
                if min(answered) >= len(good + bad) or time.monotonic() > end:
                    return
                answers.append((config, call(config).config))
                modes.publish(('joystick', 'switching', 'nonsense')[answered[index] % 3])
                answered[index] += 1
        threads = [threading.Thread(target=storm, args=(index,)) for index in range(3)]
        STICK.left = 0.4
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        STICK.left = 0.0
        self.assertGreaterEqual(min(answered), len(good + bad))
        self.said('NoSuchCritic')
        for config, answer in answers:
            wanted, in_force = values(config), values(answer)
            for name, value in wanted.items():
                self.assertEqual(in_force[name] == value, config in good, f'{name} = {in_force[name]} after {wanted}')
            self.assertIn(in_force['max_vel_x'], (0.3, 0.5, values(before)['max_vel_x']))
            self.assertNotIn('NoSuchCritic', in_force['critics'])
        call(before)
        modes.publish('joystick')
        self.over()


def values(config):
    """Of a set of parameters, by name."""
    return {entry.name: entry.value for kind in (config.bools, config.ints, config.doubles, config.strs) for entry in kind}


class Clocks(Faults):
    def test_stopped(self):
        """Sensors go on, time does not."""
        GATE.drop('clock')
        silence = []  # readings of odometry since the newest command

        def listen(message):
            if WATCH.count() != self.count:
                self.count = WATCH.count()
                del silence[:]
            silence.append(message)
            return message
        self.count = WATCH.count()
        GATE.disturb('odom', listen)
        self.assertTrue(wait_for(lambda: len(silence) > 50), 'commands go on without time')  # a second
        self.over()

    def test_back(self):
        """As a bag that is played in a loop; twice."""
        for _ in range(2):
            self.assertTrue(wait_for(lambda: HOST.drives() and rospy.get_time() > 6.0), 'there is no time to go back to')
            LOG.begin()
            WATCH.begin()
            GATE.drop('odom')  # of the new time there is none yet
            GATE.shift -= 5.0
            self.said('time jumped back')
            self.said('no odometry on')
            self.assertTrue(HOST.stands())
            self.assertIn('BRAKE', WATCH.outcomes())
            self.over()


class Devices(Faults):
    def test_silent_while_steering(self):
        self.steer(0.8)
        STICK.sends = False
        self.assertTrue(wait_for(lambda: HOST.state_name() == 'LOST'), HOST.state_name())
        self.assertTrue(wait_for(lambda: not HOST.state.active and HOST.state.wanted.angular.z == 0.0), 'the lost stick still steers')
        STICK.sends = True  # as it was left: deflected
        self.over()
        self.assertEqual(HOST.state_name(), 'LOST')  # until it was seen centred
        STICK.left = 0.0
        self.assertTrue(wait_for(lambda: HOST.state_name() != 'LOST'))
        self.steer(0.8)
        STICK.left = 0.0
        self.over()

    def test_unplugged_and_plugged_in_again(self):
        """A joystick whose file goes away, as when its cable is pulled."""
        STICK.sends = False
        with tempfile.TemporaryDirectory() as folder:
            device = os.path.join(folder, 'js0')
            os.mkfifo(device)
            cable = os.open(device, os.O_RDWR)
            reader = subprocess.Popen([os.path.join(paths.ROOT, 'scripts', 'joy_reader'), f'_dev:={device}', '_default_trig_val:=true'])
            try:
                self.said(f'opened joystick {device}')
                self.assertTrue(wait_for(lambda: self.steered_by(cable)), HOST.state_name())
                os.unlink(device)  # as udev does it
                os.close(cable)
                self.said(f'joystick {device} went away')
                self.assertTrue(wait_for(lambda: HOST.state_name() == 'LOST'), HOST.state_name())
                os.mkfifo(device)
                cable = os.open(device, os.O_RDWR)
                self.assertTrue(wait_for(lambda: self.steered_by(cable)), 'it steers no more')
                reader.kill()  # what reads it dies
                self.assertTrue(wait_for(lambda: HOST.state_name() == 'LOST'), HOST.state_name())
                self.over()
            finally:
                reader.kill()
                reader.wait()
                os.close(cable)

    def steered_by(self, cable):
        """Centred, then left, until it counts."""
        for value in (0, 0, -20000):
            os.write(cable, JS_EVENT.pack(0, value, 2, 0))
            time.sleep(0.2)
        return HOST.state_name() == 'SHARED'


class Disks(Faults):
    def test_full_while_recording(self):
        """Nothing can be written beyond 400 kB."""
        def narrow():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (400000, 400000))
        with tempfile.TemporaryDirectory() as folder:
            bag = os.path.join(folder, 'drive.bag')
            recorder = subprocess.Popen([os.path.join(paths.ROOT, 'scripts', 'record_drive'), f'_bag:={bag}', '__name:=recorder'],
                                        preexec_fn=narrow)
            try:
                self.said(f'the recording to {bag} ended by itself (disk full?); the drive goes on without it')
                self.over()
            finally:
                recorder.send_signal(signal.SIGINT)
                recorder.wait()
            report = subprocess.run([os.path.join(paths.ROOT, 'scripts', 'report'), bag + '.active', '--out', folder],
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(report.returncode, 0, report.stdout)
            with open(os.path.join(folder, 'report.json'), encoding='utf-8') as written:
                self.assertGreater(json.load(written)['path_length_m'], 0.0)
            self.assertGreater(os.path.getsize(os.path.join(folder, 'report.png')), 0)


if __name__ == '__main__':
    rospy.init_node('faults_test')
    rostest.rosrun('hidwa_fault_tests', 'faults_test', 'faults_test', sys.argv)
