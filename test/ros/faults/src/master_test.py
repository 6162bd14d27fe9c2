#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The ROS master dies while the robot drives and somebody steers, and comes back without its memory: the nodes know each other and
go on. On a master of its own, which nothing else uses."""
import os
import signal
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import paths  # noqa: E402
import rosgraph  # noqa: E402
import rospkg  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from dynamic_reconfigure.msg import Config, DoubleParameter  # noqa: E402
from dynamic_reconfigure.srv import Reconfigure  # noqa: E402
from std_msgs.msg import String  # noqa: E402

from command_watch import PLANNER, CommandWatch  # noqa: E402
from hidwa_tools.processes import Child, free_port  # noqa: E402
from hidwa_tools.waiting import wait_for  # noqa: E402
from message_gate import Gate  # noqa: E402
from running_host import Journal, RunningHost, Stick  # noqa: E402

PLACES = ((30.0, 15.0), (5.5, 8.0))  # far apart in the office [m]


class Masters(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.port = free_port()
        os.environ.update(ROS_MASTER_URI=f'http://localhost:{self.port}', ROS_LOG_DIR=self.folder.name)
        self.children = []
        self.master = self.start_master()
        launch = os.path.join(paths.ROOT, 'test', 'ros', 'faults', 'launch', 'robot.launch')
        self.start(['roslaunch', launch])

    def tearDown(self):
        for child in reversed(self.children):
            child.stop()
        self.folder.cleanup()

    def start(self, command):
        child = Child(command, None, dict(os.environ))
        self.children.append(child)
        return child

    def start_master(self):
        master = self.start(['rosmaster', '--core', '-p', str(self.port)])
        self.assertTrue(wait_for(rosgraph.is_master_online), 'no master')
        return master

    def test_gone_and_back(self):
        rospy.init_node('master_test', disable_signals=True)
        gate, log, stick = Gate(), Journal(), Stick()
        host = RunningHost(PLACES)
        self.assertTrue(gate and log and host.wait_until_ready(), 'move_base does not come up')
        watch = CommandWatch()
        change = rospy.ServiceProxy(PLANNER + '/set_parameters', Reconfigure, persistent=True)
        change(Config())
        modes = rospy.Publisher(PLANNER + '/set_mode', String, queue_size=1)
        self.assertTrue(wait_for(lambda: modes.get_num_connections() > 0))
        self.assertTrue(host.drives())
        watch.begin()
        self.assertTrue(wait_for(watch.cycles), 'no cycles come')  # who has not found the planner yet never does without a master

        os.kill(self.master.pid, signal.SIGKILL)
        self.assertTrue(wait_for(lambda: not rosgraph.is_master_online()))
        stick.left = 0.5
        self.assertTrue(wait_for(lambda: host.state_name() == 'SHARED'), 'the stick does not count')
        # A change asks the master for parameters, and another mode may look for topics: neither may hold up the cycle.
        waiting = threading.Thread(target=lambda: quietly(change, Config(doubles=[DoubleParameter('max_vel_x', 0.4)])), daemon=True)
        waiting.start()
        modes.publish('switching')
        self.goes_on(watch)
        stick.left = 0.0

        self.start_master()
        modes.publish('joystick')
        if not host.drives():
            self.fail(host.account('the robot does not drive on') + '\n' + '\n'.join(log.lines[-20:]))
        self.goes_on(watch)
        if version_of('xmlrpcpp') >= (1, 15, 12):  # before, what has asked a dead master asks it for ever (ros_comm #2185)
            self.assertTrue(wait_for(lambda: not waiting.is_alive()), 'the change was never answered')
        self.assertEqual(watch.faults(), [])
        self.assertEqual(watch.abrupt_stops(), 0)
        self.assertEqual(host.contacts, 0)

    def goes_on(self, watch):
        """No cycle waits for anything: 40 come, and none is long."""
        before = len(watch.cycles())
        self.assertTrue(wait_for(lambda: len(watch.cycles()) > before + 40), 'no cycles come any more')
        # What asks a dead master waits for seconds.
        self.assertLess(max(cycle.duration for cycle in watch.cycles()[before:]), 1.0)


def version_of(package):
    return tuple(map(int, rospkg.RosPack().get_manifest(package).version.split('.')))


def quietly(call, *arguments):
    try:
        call(*arguments)
    except (rospy.ServiceException, rospy.ROSException):
        pass


if __name__ == '__main__':
    rostest.rosrun('hidwa_fault_tests', 'master_test', Masters, sys.argv)
