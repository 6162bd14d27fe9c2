# SPDX-License-Identifier: BSD-3-Clause
"""The report's contacts, regions and length, out of a bag, against the simulator's own counts.

Drives the simulated robot by hand: through a region, against a wall twice. Needs what scripts/build built.
"""
import json
import math
import os
import tempfile
import unittest

from geometry_msgs.msg import Twist
from move_base_msgs.msg import MoveBaseActionGoal
from nav_msgs.msg import Odometry
from std_msgs.msg import String, UInt32
import rospy

from hidwa_tools import demo, geometry, measure
from hidwa_tools.bag import INFO_TOPIC, read_drive
from hidwa_tools.drive import Latest, unconnected
from hidwa_tools.processes import Child
from hidwa_tools.waiting import wait_for

# An outline of the test's own: neither symmetric nor convex.
FOOTPRINT = [[0.30, 0.10], [0.10, 0.25], [-0.25, 0.20], [-0.15, 0.0], [-0.25, -0.20], [0.20, -0.22]]
LAUNCH = '''<launch>
  <param name="/use_sim_time" value="true"/>
  <node name="map_server" pkg="map_server" type="map_server" args="{maps}/office.yaml"/>
  <node name="hidwa_sim" pkg="hidwa_local_planner" type="hidwa_sim_node" required="true">
    <param name="map" value="{maps}/office.yaml"/>
    <param name="regions" value="{maps}/office_regions.yaml"/>
    <param name="x" value="12.5"/> <param name="y" value="12.5"/> <param name="yaw" value="1.5708"/>
    <param name="rate" value="3.0"/>
    <rosparam param="footprint">{footprint}</rosparam>
  </node>
</launch>'''
TOPICS = [INFO_TOPIC, '/map', '/ground_truth', '/move_base/goal', '/regions', '/contacts', '/regions_crossed', '/cmd_vel']


class SimulatorCounts(unittest.TestCase):
    def wait_for(self, condition, what):
        self.assertTrue(wait_for(condition), f'waited in vain for {what}')

    def start(self, folder):
        environment = demo.environment(folder)
        maps = os.path.join(demo.package_path('hidwa_local_planner'), 'maps')
        file = os.path.join(folder, 'counts.launch')
        with open(file, 'w', encoding='utf-8') as out:
            out.write(LAUNCH.format(maps=maps, footprint=json.dumps(FOOTPRINT)))
        port = environment['ROS_MASTER_URI'].rsplit(':', 1)[1]
        launched = Child(['roslaunch', '-p', port, file], os.path.join(folder, 'launch.log'), environment)
        self.addCleanup(launched.stop)
        demo.wait_for_master(launched)
        rospy.init_node('simulator_counts', disable_signals=True)
        self.truth, self.contacts = Latest('/ground_truth', Odometry), Latest('/contacts', UInt32)
        self.crossed = Latest('/regions_crossed', UInt32)
        self.velocity = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        goal = rospy.Publisher('/move_base/goal', MoveBaseActionGoal, queue_size=1)
        info = rospy.Publisher(INFO_TOPIC, String, queue_size=1, latch=True)
        info.publish(json.dumps({'footprint': FOOTPRINT, 'goal': [0, 0, 0]}))
        self.wait_for(lambda: self.truth.message and self.contacts.message and self.velocity.get_num_connections(), 'the robot')
        recorder = Child(['rosbag', 'record', '-O', os.path.join(folder, 'drive.bag'), *TOPICS, '__name:=counts_recorder'],
                         os.path.join(folder, 'recorder.log'), environment)
        self.addCleanup(recorder.stop)
        self.wait_for(lambda: not unconnected('/counts_recorder', TOPICS), 'the recorder')
        goal.publish(MoveBaseActionGoal())
        return recorder

    def command(self, v, omega, until, what):
        twist = Twist()
        twist.linear.x, twist.angular.z = v, omega

        def sent_and_met():
            self.velocity.publish(twist)
            return until()
        self.wait_for(sent_and_met, what)

    def pose(self):
        pose = self.truth.message.pose.pose
        return pose.position.x, pose.position.y, 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)

    def drive(self):
        """North through the region in the corridor, then twice against its western wall."""
        self.command(0.5, 0.0, lambda: self.pose()[1] > 16.8, 'the way north')
        self.command(0.0, 1.0, lambda: self.pose()[2] > 3.0, 'the turn left')
        for count in (1, 2):
            self.command(0.5, 0.0, lambda: self.contacts.message.data == count, f'contact {count}')
            x = self.pose()[0]
            self.command(-0.3, 0.0, lambda: self.pose()[0] > x + 0.3, 'the way back')
        self.command(0.0, 0.0, lambda: self.truth.message.twist.twist.linear.x == 0.0, 'rest')

    def test_the_bag_alone_shows_what_the_simulator_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            recorder = self.start(folder)
            self.drive()
            contacts, crossed = self.contacts.message.data, self.crossed.message.data
            recorder.stop()
            drive = read_drive(os.path.join(folder, 'drive.bag'))
        self.assertEqual((contacts, crossed), (2, 1))
        truth = drive.driven()
        self.assertEqual(measure.count_contacts(drive.grid, drive.footprint, truth), contacts)
        self.assertEqual(measure.count_regions(drive.regions, drive.footprint, truth), crossed)
        self.assertEqual(drive.simulator, {'contacts': contacts, 'regions_crossed': crossed})
        # 12.5 to 16.8 north, to the wall and back: the distance the robot says it drove, summed from its speed.
        speed = abs(truth[:-1, 4])
        driven = float((speed * (truth[1:, 0] - truth[:-1, 0])).sum())
        self.assertAlmostEqual(geometry.path_length(truth[:, 1:3]), driven, delta=0.05)


if __name__ == '__main__':
    unittest.main()
