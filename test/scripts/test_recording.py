# SPDX-License-Identifier: BSD-3-Clause
"""The launch files' argument record: which topics, which file, and a bag that Ctrl-C leaves readable."""
import json
import os
import subprocess
import tempfile
import unittest

import rosbag
import rosgraph

from hidwa_tools import demo, recording
from hidwa_tools.drive import unconnected
from hidwa_tools.processes import Child
from hidwa_tools.waiting import PATIENCE, wait_for

COMMAND, RECORDER = '/robot/base/command', '/robot/robot_record_drive_bag'
LAUNCH = '''<launch><group ns="robot">
  <rosparam param="move_base">{{HIDWAPlannerROS: {{s_omega: 321.0, twist_topic: /console/twist, joy_topic: joy}},
    local_costmap: {{laser: {{observation_sources: front, front: {{topic: scan, data_type: LaserScan}}}}}}}}</rosparam>
  <node name="record_drive" pkg="hidwa_local_planner" type="record_drive" output="screen" required="true">
    <remap from="cmd_vel" to="base/command"/> <remap from="joy" to="/console/joy"/>
    <param name="bag" value="{bag}"/> <param name="also" value="imu"/>
  </node>
</group></launch>'''


class Stick(unittest.TestCase):
    def test_its_sign_stands_in_the_axis_or_as_in_bags_of_before_alone(self):
        for parameters, axis, sign in (({}, 0, 1), ({'axis_angular': '3'}, 3, 1), ({'axis_angular': '3 reversed'}, 3, -1),
                                       ({'axis_angular': 2, 'axis_angular_sign': -1}, 2, -1)):
            self.assertEqual(recording.stick_of(parameters), {'axis': axis, 'sign': sign, 'dead_zone': 0.1})


class Names(unittest.TestCase):
    def test_demo_and_launch_share_a_list(self):
        short, full = recording.recorded_topics('NavfnROS'), recording.recorded_topics('NavfnROS', seen=True)
        self.assertEqual(full[:len(short)], short)
        self.assertIn('/scan', set(full) - set(short))
        self.assertEqual(len(full), len(set(full)))
        for name in ('/demo_info', '/map', '/ground_truth', '/move_base/goal', '/move_base/NavfnROS/plan',
                     '/move_base/HIDWAPlannerROS/cycle', '/tf', '/tf_static'):
            self.assertIn(name, short)
        other = recording.recorded_topics('GlobalPlanner', 'DWAPlannerROS')
        self.assertIn('/move_base/DWAPlannerROS/global_plan', other)
        self.assertIn('/move_base/GlobalPlanner/plan', other)

    def test_a_plugin_is_known_by_what_comes_after_the_last_slash_or_colons(self):
        for lookup, name in (('hidwa_local_planner/HIDWAPlannerROS', 'HIDWAPlannerROS'), ('navfn::NavfnROS', 'NavfnROS'),
                             ('nav_core_adapter::LocalPlannerAdapter', 'LocalPlannerAdapter'), ('a/b::C', 'C'), ('Bare', 'Bare')):
            self.assertEqual(recording.plugin_name(lookup), name)
        adapted = recording.recorded_topics('global::GlobalPlanner', 'nav_core_adapter::LocalPlannerAdapter')
        self.assertEqual([topic for topic in adapted if ':' in topic], [])
        self.assertIn('/move_base/LocalPlannerAdapter/global_plan', adapted)
        self.assertIn('/move_base/GlobalPlanner/plan', adapted)

    def test_what_a_costmap_watches(self):
        costmap = {'width': 4.0, 'obstacles': {'observation_sources': 'a b', 'a': {'topic': 'scan', 'data_type': 'LaserScan'},
                                               'b': {'topic': 'cloud', 'data_type': 'PointCloud2'}}, 'inflation': {}}
        self.assertEqual(recording.observed_topics(costmap), (['scan'], ['cloud']))
        self.assertEqual(recording.observed_topics({}), ([], []))

    def test_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(recording.bag_path(folder + '/drive'), folder + '/drive.bag')
            open(folder + '/old.bag.active', 'w', encoding='utf-8').close()
            for text, fault in (('drive.bag', 'is relative.*PWD/drive.bag'), (folder, 'is a folder'),
                                (folder + '/none/drive.bag', 'no folder .*none; make it'), (folder + '/old', 'is not overwritten')):
                with self.assertRaisesRegex(ValueError, fault):
                    recording.bag_path(text)


class Recording(unittest.TestCase):
    def wait_for(self, condition, what):
        self.assertTrue(wait_for(condition), f'waited in vain for {what}')

    def recorder_has(self, topics):
        """Whether the topics are published and all that publish them send to the recorder."""
        published = {name for name, _ in rosgraph.Master('/test').getSystemState()[0]}
        return topics <= published and not unconnected(RECORDER, topics)

    def test_names_remaps_parameters_and_the_end(self):
        with tempfile.TemporaryDirectory() as folder:
            bag, file = folder + '/drive.bag', folder + '/record.launch'
            with open(file, 'w', encoding='utf-8') as out:
                out.write(LAUNCH.format(bag=bag))
            environment = demo.environment(folder)
            command = ['roslaunch', '-p', environment['ROS_MASTER_URI'].rsplit(':', 1)[1], file]
            launched, driver = Child(command, folder + '/launch.log', environment), None
            try:
                self.wait_for(rosgraph.is_master_online, 'the master')
                driver = Child(['rostopic', 'pub', '-r', '20', COMMAND, 'geometry_msgs/Twist', '{}'], os.devnull, environment)
                self.wait_for(lambda: self.recorder_has({COMMAND, '/robot/record_drive/parameters'}), 'the recorder')
                self.wait_for(lambda: os.path.exists(bag + '.active') and os.path.getsize(bag + '.active') > 0, 'the file')
                master = rosgraph.Master('/test').getSystemState()[1]
                asked = {topic for topic, nodes in master if RECORDER in nodes}
            finally:
                launched.stop()
                if driver:
                    driver.stop()
            self.assertEqual(sorted(os.path.basename(p) for p in os.listdir(folder) if 'bag' in p), ['drive.bag'])
            with rosbag.Bag(bag) as recorded:
                self.assertEqual(recorded.get_compression_info().compression, 'lz4')
                self.assertGreater(recorded.get_message_count(COMMAND), 0)
                texts = [m.data for _, m, _ in recorded.read_messages('/robot/record_drive/parameters')]
            self.assertEqual(json.loads(texts[-1])['/robot/move_base']['HIDWAPlannerROS']['s_omega'], 321.0)
            for name in ('/console/twist', '/console/joy', '/robot/scan', '/robot/imu', '/robot/map', '/tf', '/rosout',
                         '/robot/move_base/HIDWAPlannerROS/cycle', '/robot/move_base/local_costmap/costmap_updates'):
                self.assertIn(name, asked)
            self.assertNotIn('/robot/joy', asked)
            self.assertNotIn('/robot/cmd_vel', asked)
            # The same again: refused, in words, and what is there stays as it is.
            size = os.path.getsize(bag)
            again = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   timeout=PATIENCE)
            self.assertIn('drive.bag exists and is not overwritten', again.stdout)
            self.assertEqual(os.path.getsize(bag), size)


if __name__ == '__main__':
    unittest.main()
