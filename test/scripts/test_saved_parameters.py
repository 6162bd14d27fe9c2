# SPDX-License-Identifier: BSD-3-Clause
"""What README's line writes of a tuned planner, the launch files load again."""
import os
import re
import subprocess
import tempfile
import unittest

import yaml

from hidwa_tools import demo
from hidwa_tools.places import ROOT
from hidwa_tools.processes import Child
from hidwa_tools.waiting import wait_for

# Of each type, with what YAML makes something else of.
TUNED = {'max_vel_x': 0.45, 'decel_lim_x': -0.0, 's_omega': 1e-05, 'vx_samples': 7, 'escape': False, 'mode': 'off', 'twist_topic': '',
         'robot_description_param': 'yes', 'critics': ', '.join(f'Critic{i}WithAName' for i in range(20)), 'odom_topic': '0123'}


def lines():
    """README's lines that write a file, and the argument that takes it."""
    with open(os.path.join(ROOT, 'README.md'), encoding='utf-8') as text:
        found = re.findall(r'^    (.*tuned\.yaml)  # .*(robot_params:=\S*tuned\.yaml)$', text.read(), re.M)
    return found


@unittest.skipUnless(os.environ.get('ROS_PACKAGE_PATH'), 'no ROS in this environment (. scripts/env)')
class SavedParameters(unittest.TestCase):
    def test_the_line_of_the_readme(self):
        (line, argument), = lines()
        with tempfile.TemporaryDirectory() as folder:
            environment = demo.environment(folder)
            port = environment['ROS_MASTER_URI'].rsplit(':', 1)[1]
            master = Child(['roscore', '-p', port], os.path.join(folder, 'master.log'), environment)
            self.addCleanup(master.stop)

            def run(command):
                return subprocess.run(['bash', '-c', command], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, check=False)
            self.assertTrue(wait_for(lambda: run('rosparam list').returncode == 0), master.complaint())
            given = os.path.join(folder, 'given.yaml')
            with open(given, 'w', encoding='utf-8') as out:
                yaml.safe_dump(TUNED, out)
            self.assertEqual(run(f'rosparam load {given} /move_base/HIDWAPlannerROS').returncode, 0)
            self.assertEqual(run(line).returncode, 0)
            for launch, host in (('move_base.launch', 'move_base'), ('robot.launch map:=x.yaml', 'move_base'),
                                 ('move_base_flex.launch', 'move_base_flex')):
                name, *more = launch.split()
                said = run(f'roslaunch --dump-params {ROOT}/launch/{name} {" ".join(more)} {argument.replace("$PWD", folder)}')
                self.assertEqual(said.returncode, 0, said.stdout)
                loaded = yaml.safe_load(said.stdout)
                for key, value in TUNED.items():
                    self.assertEqual(loaded[f'/{host}/HIDWAPlannerROS/{key}'], value, key)


if __name__ == '__main__':
    unittest.main()
