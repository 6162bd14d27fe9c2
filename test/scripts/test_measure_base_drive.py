# SPDX-License-Identifier: BSD-3-Clause
"""measure_base with a robot that moves: the package's simulator, whose latency and limits are known. Needs what scripts/build built."""
import argparse
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rospy
import yaml
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from hidwa_measure_base.node import SIGNALS, drive
from hidwa_measure_base.track import Track
from hidwa_tools import demo
from hidwa_tools.places import ROOT
from hidwa_tools.processes import Child, end_on_signals
from hidwa_tools.waiting import PATIENCE, wait_for

LATENCY, ACC, DECEL, ACC_THETA, DECEL_THETA, TIMEOUT = 0.15, 0.8, 0.6, 2.0, 1.6, 1.0
LAUNCH = f'''<launch>
  <param name="/use_sim_time" value="true"/>
  <node name="hidwa_sim" pkg="hidwa_local_planner" type="hidwa_sim_node" required="true">
    <param name="map" value="{{maps}}/office.yaml"/>
    <param name="x" value="12.5"/> <param name="y" value="12.5"/> <param name="yaw" value="1.5708"/>
    <param name="rate" value="2.0"/> <param name="latency" value="{LATENCY}"/> <param name="command_timeout" value="{TIMEOUT}"/>
    <param name="acc_lim_x" value="{ACC}"/> <param name="decel_lim_x" value="{DECEL}"/>
    <param name="acc_lim_theta" value="{ACC_THETA}"/> <param name="decel_lim_theta" value="{DECEL_THETA}"/>
  </node>
</launch>'''


class MeasureBaseDrive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.environment = demo.environment(cls.folder.name)
        maps = os.path.join(demo.package_path('hidwa_local_planner'), 'maps')
        file = os.path.join(cls.folder.name, 'base.launch')
        with open(file, 'w', encoding='utf-8') as out:
            out.write(LAUNCH.format(maps=maps))
        port = cls.environment['ROS_MASTER_URI'].rsplit(':', 1)[1]
        master = Child(['roscore', '-p', port], os.path.join(cls.folder.name, 'master.log'), cls.environment)
        cls.addClassCleanup(master.stop)
        cls.assertTrue(cls(), wait_for(rosgraph.is_master_online), 'no master')
        rospy.set_param('/use_sim_time', True)
        cls.launch = ['roslaunch', '--wait', '-p', port, file]
        rospy.init_node('measure_base_drive', disable_signals=True)
        cls.commands, cls.odometry = [], []
        rospy.Subscriber('/cmd_vel', Twist, lambda m: cls.commands.append((m.linear.x, m.angular.z)), queue_size=100)
        rospy.Subscriber('/odom', Odometry, cls.odometry.append, queue_size=10)

    def setUp(self):
        """A robot that stands where it begins: what was cut short leaves it somewhere on the way."""
        del self.odometry[:]
        robot = Child(self.launch, os.path.join(self.folder.name, 'launch.log'), self.environment)
        self.addCleanup(robot.stop)
        self.assertTrue(wait_for(lambda: self.odometry), 'no odometry')
        self.assertTrue(wait_for(self.stands), 'the robot does not rest')
        del self.commands[:]

    def stands(self):
        twist = self.odometry[-1].twist.twist
        return twist.linear.x == 0.0 and twist.angular.z == 0.0

    def start(self, answer, *options):
        program = subprocess.Popen(['/usr/bin/python3', os.path.join(ROOT, 'scripts', 'measure_base'), *options], cwd=self.folder.name,
                                   env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.kill)
        program.stdin.write(answer + '\n')
        program.stdin.flush()
        return program

    def end_of(self, program):
        """(exit status, what it printed, what it complained of); it has left the robot at rest."""
        said, complaint = program.communicate(timeout=PATIENCE)
        if self.commands:
            self.assertTrue(wait_for(lambda: self.commands[-1] == (0.0, 0.0)))
        self.assertTrue(wait_for(self.stands))
        return program.returncode, said, complaint

    def drives(self, program):
        """Waits until the robot drives; the program must not end before."""
        self.assertTrue(wait_for(lambda: self.odometry[-1].twist.twist.linear.x > 0.1 or program.poll() is not None))
        self.assertIsNone(program.poll(), program.poll() and program.stderr.read())

    def test_it_measures_what_the_robot_is(self):
        for _ in range(3):
            status, said, complaint = self.end_of(self.start('yes'))
            if 'odometry is missing' not in complaint:
                break
            self.doCleanups()  # a busy machine did not hear it for a quarter of a second: anew, as a user would
            self.setUp()
        self.assertEqual(status, 0, complaint)
        values = yaml.safe_load(said[said.index('# Measured'):])['HIDWAPlannerROS']
        # Steps of the simulation last 0.01 s. Messages take some milliseconds, twice as many by the clock of the simulation.
        self.assertGreaterEqual(values['control_latency'], LATENCY - 0.01)
        self.assertLessEqual(values['control_latency'], LATENCY + 0.10)
        for name, truth in (('acc_lim_x', ACC), ('decel_lim_x', DECEL), ('acc_lim_theta', ACC_THETA), ('decel_lim_theta', DECEL_THETA)):
            self.assertLessEqual(values[name], 1.05 * truth, name)
            self.assertGreaterEqual(values[name], 0.75 * truth, name)
        self.assertIn('When commands cease the base rests after', said)
        self.assertTrue(os.path.exists(os.path.join(self.folder.name, 'measure_base.png')), complaint)
        self.assertLessEqual(max(abs(v) for v, _ in self.commands), 0.3)
        self.assertLessEqual(max(abs(omega) for _, omega in self.commands), 0.6)

    def test_without_a_yes_nothing_moves(self):
        status, said, complaint = self.end_of(self.start('no'))
        self.assertEqual((status, self.commands), (2, []), complaint)
        self.assertIn('2 m free ahead', said)
        self.assertIn('nothing was driven', complaint)

    def test_a_signal_ends_it_and_it_sends_zero(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            del self.commands[:]
            program = self.start('yes')
            self.drives(program)
            program.send_signal(number)
            status, _, complaint = self.end_of(program)
            self.assertEqual(status, 1)
            self.assertIn('ended by hand; the robot was told to stop', complaint)

    def test_a_signal_counts_that_comes_while_rospy_publishes(self):
        class Swallows:
            """Like rospy's connections, it catches everything while it sends."""
            track = Track()

            def check(self):
                self.track.receive(rospy.get_time(), 0.0, 0.0, 0.0, 0.0, 0.0, rospy.get_time())

            def send(self, *_):
                try:
                    os.kill(os.getpid(), signal.SIGTERM)
                    time.sleep(0.01)
                except BaseException:  # pylint: disable=broad-exception-caught
                    pass

        options = argparse.Namespace(speed=0.3, turn=0.6, lifted=False)
        for number in SIGNALS:
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        end_on_signals()
        with self.assertRaises(KeyboardInterrupt):
            drive(Swallows(), options, lambda _: None)

    def test_somebody_else_on_the_topic_ends_it(self):
        program = self.start('yes')
        self.drives(program)
        other = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        self.addCleanup(other.unregister)
        status, _, complaint = self.end_of(program)
        self.assertEqual(status, 1)
        self.assertIn('/measure_base_drive may send commands on /cmd_vel', complaint)
        status, _, complaint = self.end_of(self.start('yes'))  # and keeps it from beginning
        self.assertEqual((status, self.commands[-1]), (2, (0.0, 0.0)))
        self.assertIn('/measure_base_drive may send', complaint)

    def test_something_near_keeps_it_from_beginning(self):
        status, _, complaint = self.end_of(self.start('yes', '--clearance', '5'))
        self.assertEqual((status, self.commands), (2, []))
        self.assertRegex(complaint, r'the scan sees something \d\.\d\d m .* nearer than --clearance 5 m')

    def test_what_is_not_there_is_named(self):
        for options, said in ((('--odom-topic', 'wheels'), 'no odometry comes on /wheels'),
                              (('--cmd-vel-topic', 'nowhere'), 'nobody listens to /nowhere')):
            status, _, complaint = self.end_of(self.start('yes', *options))
            self.assertEqual((status, self.commands), (2, []))
            self.assertIn(said, complaint)


if __name__ == '__main__':
    unittest.main()
