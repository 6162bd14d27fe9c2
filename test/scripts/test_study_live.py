# SPDX-License-Identifier: BSD-3-Clause
"""The study with real people: who drives what when, what is refused, and tables, tests and page out of the bags."""
import contextlib
import csv
import io
import json
import os
import tempfile
import unittest
from unittest import mock

import numpy as np

from hidwa_tools import conditions, geometry, questionnaires, study_bags, study_live
from hidwa_tools.errors import DemoError
from hidwa_tools.statistics import signed_ranks
from synthetic_bag import RealDrive, SyntheticDrive

PACKAGE = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def touch(self, *names):
        for name in names:
            open(self.path(name), 'w', encoding='utf-8').close()

    def write(self, name, *lines):
        with open(self.path(name), 'w', encoding='utf-8') as out:
            out.write('\n'.join(lines) + '\n')


class Course(Folder):
    def test_counterbalanced(self):
        courses = [conditions.course(p) for p in range(1, 33)]
        self.assertEqual(courses[:2], [('SJ', 'SW', 'SG'), ('SW', 'SJ', 'SG')])
        # 32 people: SJ first for 16, SW first for 16, SG last for all.
        self.assertEqual([sum(c[place] == name for c in courses) for place in (0, 1) for name in ('SJ', 'SW')], [16] * 4)
        self.assertTrue(all(c[2] == 'SG' for c in courses))

    def test_next_by_what_is_there(self):
        self.assertEqual(conditions.next_of(self.path('none'), 7), (1, 'SJ'))
        self.touch('p07_o1_SJ.bag', 'p07_o2_SW.bag', 'p08_o1_SW.bag', 'p09_o1_SJ.bag.active', 'other.bag', 'p10_o1_XX.bag')
        self.assertEqual(conditions.next_of(self.folder, 7), (3, 'SG'))
        self.assertEqual(conditions.next_of(self.folder, 8), (2, 'SJ'))
        self.assertEqual(conditions.next_of(self.folder, 9), (1, 'SJ'))
        self.touch('p07_o3_SG.bag')
        self.assertEqual(conditions.next_of(self.folder, 7), (4, None))


class Live(Folder):
    def admit(self, *arguments, answers=()):
        """(place or None, what was said) of the questions before a drive."""
        options, _ = study_live.parse(['--out', self.folder, *arguments])
        said = io.StringIO()
        with mock.patch('builtins.input', side_effect=[*answers, EOFError]), contextlib.redirect_stdout(said):
            return study_live.admit(options), said.getvalue()

    def test_asks_before_it_starts(self):
        who = ('--participant', '7', '--condition', 'SJ')
        self.assertEqual([self.admit(*who, answers=answers)[0] for answers in (['y'], ['n'], [''], [])], [1, None, None, None])
        self.assertEqual(self.admit(*who, '--yes')[0], 1)
        self.assertIn('nothing keeps the person', self.admit('--participant', '8', '--condition', 'SW', '--yes')[1])
        self.assertNotIn('nothing keeps', self.admit('--participant', '8', '--condition', 'SW', '--yes', '--guard', 'nearest')[1])

    def test_out_of_order_is_asked_about_and_refused_unasked(self):
        self.touch('p07_o1_SJ.bag')
        early = ('--participant', '7', '--condition', 'SG')
        with self.assertRaisesRegex(DemoError, 'SJ, SW, SG in this order, and SW is next, not SG'):
            self.admit(*early, '--yes')
        self.assertEqual([self.admit(*early, answers=answers)[0] for answers in (['y', 'y'], ['y', 'n'], ['n'])], [2, None, None])

    def test_a_drive_is_never_overwritten(self):
        self.touch('p07_o1_SJ.bag', 'new.bag')
        with self.assertRaisesRegex(DemoError, 'has driven SJ already, .*p07_o1_SJ.bag: it is never overwritten'):
            self.admit('--participant', '7', '--condition', 'SJ')
        with self.assertRaisesRegex(DemoError, 'not overwritten; the new one stays'):
            study_live.keep(self.path('new.bag'), self.path('p07_o1_SJ.bag'))
        self.assertTrue(os.path.exists(self.path('new.bag')))
        study_live.keep(self.path('new.bag'), self.path('p07_o2_SW.bag'))
        self.assertFalse(os.path.exists(self.path('new.bag')))

    def test_arguments_that_make_no_sense(self):
        good = ['--out', self.folder, '--participant', '7', '--condition', 'SJ']
        for bad, said in ((['--participant', '0'], 'counts from 1'), (['--mode', 'off'], 'what the condition'),
                          (['--robot', '--', 'rate'], 'no argument of a launch file'), (['--condition', 'SX'], 'invalid choice'),
                          (['--robot', 'a.launch', 'record:=b.bag'], 'record is what')):
            with contextlib.redirect_stderr(io.StringIO()) as complaint, self.assertRaises(SystemExit):
                study_live.parse(good + bad)
            self.assertIn(said, complaint.getvalue())

    def test_robot_takes_a_file_or_none(self):
        good = ['--out', self.folder, '--participant', '7', '--condition', 'SJ', '--robot']
        for also, robot, rest in ((['map:=f.yaml'], '', ['map:=f.yaml']), (['a.launch', 'x:=1'], 'a.launch', ['x:=1']), ([], '', [])):
            options, further = study_live.parse(good + also)
            self.assertEqual((options.robot, further), (robot, rest))

    def test_parameters_of_a_condition_stand_over_device_and_file(self):
        self.write('own.yaml', 'HIDWAPlannerROS: {s_omega: 400, mode: off}')
        options, _ = study_live.parse(['--out', self.folder, '--participant', '7', '--condition', 'SW', '--device', 'quest2ros',
                                       '--params', self.path('own.yaml')])
        planner = study_live.merged_parameters(options, PACKAGE)['HIDWAPlannerROS']
        self.assertEqual((planner['mode'], planner['guard'], planner['s_omega']), ('switching', 'none', 400))
        self.assertEqual(planner['gesture_topic'], '/q2r_right_hand_pose')
        options.device = 'nothing'
        with self.assertRaisesRegex(DemoError, "no device 'nothing'; there are .*xbox"):
            study_live.merged_parameters(options, PACKAGE)

    def test_a_launch_file_must_pass_on_what_is_needed(self):
        self.write('robot.launch', '<launch><arg name="mode"/><arg name="record"/></launch>')
        options, rest = study_live.parse(['--out', self.folder, '--participant', '7', '--condition', 'SG', '--robot',
                                          self.path('robot.launch'), 'map:=floor.yaml'])
        with self.assertRaisesRegex(DemoError, 'takes no argument extra_params'):
            study_live.robot_command(options, rest, self.folder, 'p.yaml')
        options.robot = os.path.join(PACKAGE, 'launch', 'robot.launch')
        command = study_live.robot_command(options, rest, self.folder, 'p.yaml')
        self.assertEqual(command[2:], ['mode:=gesture', 'extra_params:=p.yaml', f'record:={self.path("drive.bag")}', 'map:=floor.yaml'])

    def test_attempts_have_folders_of_their_own(self):
        options, _ = study_live.parse(['--out', self.folder, '--participant', '7', '--condition', 'SJ'])
        folders = [os.path.basename(study_live.attempt_folder(options, 'p07_o1_SJ')) for _ in range(2)]
        self.assertEqual(folders, ['p07_o1_SJ_attempt1', 'p07_o1_SJ_attempt2'])


def pulses(time):
    """To the left from 2.0 to 2.5 s and from 3.0 to 3.5 s."""
    return 1.0 if 2.0 <= time < 2.5 or 3.0 <= time < 3.5 else 0.0


class Analysis(Folder):
    def drive(self, name, length, mode, operator='joystick', **also):
        bag = SyntheticDrive(length=length, **also)
        bag.info.update(mode=mode, operator=operator)
        bag.write(self.path(name))

    def analysed(self, *options):
        """(exit status, what was said, complaint)"""
        with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(io.StringIO()) as complaint:
            status = study_bags.main([self.folder, *options])
        return status, said.getvalue(), complaint.getvalue()

    def rows(self):
        with open(self.path('runs.csv'), encoding='utf-8', newline='') as text:
            return list(csv.DictReader(text))

    def test_table_and_page(self):
        self.drive('p01_o1_SJ.bag', 2.0, 'joystick', stick=pulses, blocks=[(1.0, 0.2, 1.5, 0.5)])
        self.drive('p01_o2_SW.bag', 3.0, 'switching', regions=[[(1, 0.1), (2, 0.1), (2, 1)]], operator='avoid')
        self.drive('p02_o1_SW.bag', 3.5, 'switching', blocks=[(1.0, 0.1, 1.5, 0.5)])
        status, said, complaint = self.analysed()
        self.assertEqual((status, complaint), (0, ''))
        first, second, third = self.rows()
        self.assertEqual(list(first), list(study_bags.COLUMNS))
        self.assertEqual([first[c] for c in ('id', 'participant', 'condition', 'order', 'ending', 'arrived', 'contacts')],
                         ['p01_o1_SJ', '1', 'SJ', '1', 'arrived', '1', '0'])
        # 2 m at 0.5 m/s; two pulses of 0.5 s; the block begins 0.05 m beyond the side at 0.15.
        expected = {'duration': 4.0, 'length': 2.0, 'interventions': 2, 'operator_active': 1.0, 'v_change': 0.0, 'omega_change': 0.01,
                    'clearance': 0.05, 'failures': 0, 'brakes': 0}
        for column, value in expected.items():
            self.assertAlmostEqual(float(first[column]), value, places=3, msg=column)
        self.assertEqual((second['regions_crossed'], second['agreement']), ('1', '1.000000'))
        self.assertEqual((third['contacts'], float(third['clearance'])), ('1', 0.0))
        self.assertIn('participant 1 has not driven SG', said)
        with open(self.path('study.json'), encoding='utf-8') as text:
            self.assertEqual(json.load(text)['simulated'], [1])
        with open(self.path('report.html'), encoding='utf-8') as text:
            page = text.read()
        self.assertIn('A study; simulated: participant 1', page)
        self.assertEqual(page.count('data:image/png;base64,'), 2)
        with open(self.path('paths/p01_o1_SJ.csv'), encoding='utf-8', newline='') as text:
            way = list(csv.DictReader(text))
        self.assertEqual(list(way[0]), ['t', 'x', 'y', 'theta', 'v', 'omega', 'state'])
        self.assertIn('SHARED', {row['state'] for row in way})
        self.assertAlmostEqual(float(way[-1]['x']), 2.0, delta=0.03)  # 0.05 s at 0.5 m/s

    def test_columns_are_those_of_hidwa_study(self):
        with open(os.path.join(PACKAGE, 'lab', 'study', 'table.cpp'), encoding='utf-8') as text:
            source = text.read()
        block = source[source.index('names{') + 6:source.index('};', source.index('names{'))]
        self.assertEqual([name.strip().strip('"') for name in block.replace('\n', ' ').split(',')], list(study_bags.COLUMNS))

    def test_a_real_robots_bag_leaves_open_what_it_cannot_know(self):
        RealDrive().write(self.path('p01_o1_SJ.bag'))
        status, said, _ = self.analysed()
        row, = self.rows()
        self.assertEqual((status, row['contacts'], row['regions_crossed'], row['arrived']), (0, '', '', '1'))
        self.assertIn('contacts is not known of any drive', said)
        with open(self.path('report.html'), encoding='utf-8') as text:
            self.assertIn('<h1>A study</h1>', text.read())

    def test_refusals(self):
        self.assertIn('holds no bags like p07_o1_SJ.bag', self.analysed()[2])
        self.drive('p01_o1_SJ.bag', 1.0, 'switching')
        self.assertIn('was driven in mode switching, but SJ is joystick', self.analysed()[2])
        self.drive('p01_o1_SJ.bag', 1.0, 'joystick')
        self.touch('p01_o2_SJ.bag')
        status, _, complaint = self.analysed()
        self.assertEqual(status, 2)
        self.assertIn('p01_o2_SJ.bag is the second drive', complaint)

    def test_out_of_order_is_remarked(self):
        self.drive('p01_o1_SW.bag', 1.0, 'switching')
        self.assertIn('p01_o1_SW: out of the order SJ, SW, SG of participant 1', self.analysed()[1])


class Answered(Folder):
    DRIVES = {(p, c) for p in range(1, 7) for c in ('SJ', 'SW', 'SG')}

    def test_the_papers_tests(self):
        effort = {'SJ': [10, 15, 20, 5, 15, 10], 'SW': [25, 20, 30, 15, 20, 35], 'SG': [10, 15, 20, 5, 15, 10]}
        self.write('questionnaires.csv', 'participant,condition,effort,ease', *(
            f'{i + 1},{c},{effort[c][i]},{2 if c == "SJ" else 3}' for c in effort for i in range(6)))
        self.write('choices.csv', 'participant,preferred,easier,preferred_of_three', *(
            f'{i},{"SJ" if i < 4 else "SW"},SJ,SG' for i in range(1, 7)))
        answers = questionnaires.read_answers(self.folder, self.DRIVES)
        self.assertEqual(answers.remarks, [])
        said = questionnaires.statements(answers)
        # 6 of 6: 1/64 = 0.0156 one-sided; 3 of 6: 42/64 = 0.6562 by chance, two-sided 1.
        self.assertIn('6 of 6 found SJ easier than SW: exact binomial p = 0.0156 (one-sided), 0.0312 (two-sided)', said[1])
        self.assertIn('3 of 6 preferred SJ to SW: exact binomial p = 0.6562 (one-sided), 1.0000 (two-sided)', said[0])
        self.assertEqual(said[2], 'preferred of the three: SJ 0, SG 6, SW 0')
        # All six lower in SJ: one-sided 1/64.
        line, = [s for s in said if s.startswith('effort') and 'in SW' in s]
        self.assertIn('mean 12.50 (median 12.5) in SJ', line)
        self.assertIn('one-sided (lower in SJ), 6 pairs', line)
        self.assertIn('p = 0.0156', line)
        self.assertAlmostEqual(signed_ranks(effort['SJ'], effort['SW'], 'less').p, 1 / 64)
        self.assertIn('no pair differs', [s for s in said if s.startswith('effort') and 'in SG' in s][0])
        self.assertIn('two-sided, 6 pairs', [s for s in said if s.startswith('ease') and 'in SW' in s][0])
        # The paper's own: 22 of 32 found SJ easier, stated as p = 0.026 one-sided and 50.0 % to 83.9 %. Exactly it is 0.02505.
        answers.choices = {i: {'easier': 'SJ' if i < 22 else 'SW'} for i in range(32)}
        line, = questionnaires.statements(answers)[:1]
        self.assertIn('p = 0.0251 (one-sided)', line)
        self.assertIn('50.0 % to 83.9 %', line)

    def test_missing_people_and_values_are_named_and_simulated_ones_left_out(self):
        self.write('questionnaires.csv', 'participant,condition,effort,mental', '1,SJ,10,20', '1,SW,,30', '2,SJ,10,10', '9,SJ,5,5')
        self.write('choices.csv', 'participant,preferred', '1,SJ', '2,SW')
        answers = questionnaires.read_answers(self.folder, {(1, 'SJ'), (1, 'SW'), (2, 'SJ'), (3, 'SJ')}, simulated=[2])
        self.assertEqual(set(answers.choices), {1})
        for remark in ('answers of simulated people are left out: participant 2', 'no line of participant 3 for SJ',
                       'participant 9 answered for SJ, of which there is no drive', 'participant 1, SW: no effort',
                       'choices.csv has no line of participant 3'):
            self.assertTrue(any(remark in text for text in answers.remarks), remark)

    def test_faults_name_the_line(self):
        for lines, said in ((['participant,condition,effort', '1,SJ,101'], "line 2: effort is 0 to 100, not '101'"),
                            (['participant,condition,ease', '1,SJ,nan'], "line 2: ease is 1 to 7, not 'nan'"),
                            (['participant,condition,ease', '1,SJ,5', '1,SJ,4'], 'line 3: participant 1 has answered for SJ already'),
                            (['participant,condition', '1,XX'], "SJ, SG or SW, not 'XX'"), (['participant'], 'no column condition'),
                            (['participant,condition', 'Ann,SJ'], "'Ann' is no number")):
            self.write('questionnaires.csv', *lines)
            with self.assertRaisesRegex(questionnaires.AnswersError, said):
                questionnaires.read_answers(self.folder, self.DRIVES)
        os.remove(self.path('questionnaires.csv'))
        self.assertIsNone(questionnaires.read_answers(self.folder, self.DRIVES))
        self.write('choices.csv', 'participant,preferred', '1,SG')
        with self.assertRaisesRegex(questionnaires.AnswersError, "preferred is SJ or SW, not 'SG'"):
            questionnaires.read_answers(self.folder, self.DRIVES)


class Gap(unittest.TestCase):
    def test_to_squares_equals_a_slow_twin(self):
        random = np.random.default_rng(7)
        square = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]]) / 2.0
        share = np.linspace(0.0, 1.0, 100, endpoint=False)[:, None]

        def outline(polygon):
            return np.vstack([a + share * (b - a) for a, b in zip(polygon, np.roll(polygon, -1, axis=0))])
        apart = 0
        for _ in range(20):
            polygon = geometry.placed(geometry.circle(0.4, 5), *random.uniform(-1.0, 1.0, 3))
            centres = random.uniform(-1.5, 1.5, (3, 2))
            mine = geometry.gap_to_squares(polygon, centres, 0.2)
            twin = min(np.hypot(*(outline(polygon)[:, None, :] - outline(c + 0.2 * square)[None]).transpose(2, 0, 1)).min()
                       for c in centres)
            apart += mine > 0.0
            if mine > 0.0:
                self.assertAlmostEqual(mine, twin, delta=0.005)  # edges of 0.47 m in 100 steps
        self.assertGreater(apart, 5)
        self.assertEqual(geometry.gap_to_squares(geometry.circle(0.4), np.array([[0.0, 0.0]]), 0.1), 0.0)  # inside
        self.assertEqual(geometry.gap_to_squares(geometry.circle(0.4), np.zeros((0, 2)), 0.1), np.inf)


if __name__ == '__main__':
    unittest.main()
