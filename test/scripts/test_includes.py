# SPDX-License-Identifier: BSD-3-Clause
"""Who includes whom: what is installed needs nothing else, and the rooms of the house form no circle."""
import collections
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
PUBLIC = os.path.join('include', 'hidwa_local_planner')
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
TOGETHER = re.compile(r'`([\w/]+)`\s+and\s+`([\w/]+)`\s+include each other')


def read(*path):
    with open(os.path.join(*path), encoding='utf-8') as text:
        return text.read()


class Tree:
    """The C++ files below include/, src/ and lab/, and what each includes: {file: [(name, its file or None), ...]}."""

    def __init__(self, root):
        self.root, self.includes = root, {}
        for base in ('include', 'src', 'lab'):
            for folder, _, names in os.walk(os.path.join(root, base)):
                for name in names:
                    if name.endswith(('.hpp', '.cpp', '.inc')):
                        self._take(os.path.relpath(os.path.join(folder, name), root))

    def _take(self, file):
        text = read(self.root, file)
        self.includes[file] = [(name, self._find(file, name)) for _, name in INCLUDE.findall(text)]

    def _find(self, file, name):
        for place in (os.path.dirname(file), 'include', 'src', 'lab'):
            path = os.path.normpath(os.path.join(place, name))
            if os.path.isfile(os.path.join(self.root, path)):
                return path
        return None

    def public(self):
        return sorted(file for file in self.includes if file.startswith(PUBLIC + os.sep))

    def private_includes_of_public_headers(self):
        return [f'{file}: {name}' for file in self.public() for name, found in self.includes[file]
                if found is not None and not found.startswith(PUBLIC + os.sep)]

    def includes_of_the_laboratory(self):
        """By what runs on a robot."""
        return [f'{file}: {name}' for file, includes in self.includes.items() if not file.startswith('lab' + os.sep)
                for name, found in includes if found is not None and found.startswith('lab' + os.sep)]

    def edges(self):
        """{room: {room that it includes: [by which files]}}."""
        graph = collections.defaultdict(lambda: collections.defaultdict(list))
        for file, includes in self.includes.items():
            for name, found in includes:
                if found is not None and room(found) != room(file):
                    graph[room(file)][room(found)].append(f'{file}: {name}')
        return graph

    def arrows(self, allowed):
        """The includes from one room to another that allowed(from, to) does not allow."""
        return sorted(line for room_from, others in self.edges().items() for room_to, lines in others.items()
                      if not allowed(room_from, room_to) for line in lines)

    def circles(self):
        """Sets of rooms that reach each other."""
        graph = {key: set(others) for key, others in self.edges().items()}
        reached = {key: reachable(graph, key) for key in graph}
        found = {frozenset(b for b in reached[a] if a in reached.get(b, ())) for a in graph if a in reached[a]}
        return sorted(sorted(circle) for circle in found)

    def needs(self, file):
        """All that a file includes from outside, by name, and by way of which it comes to it."""
        outside, seen, left = set(), {file}, [file]
        while left:
            for name, found in self.includes[left.pop()]:
                if found is None:
                    outside.add(name)
                elif found not in seen:
                    seen.add(found)
                    left.append(found)
        return outside

    def without_ros(self):
        """The public headers that need but themselves, the standard library and Eigen."""
        return [file for file in self.public() if file.endswith('.hpp')
                and all(re.fullmatch(r'[a-z_]+|Eigen/\w+', name) for name in self.needs(file))]


def room(file):
    """core, core/motion, critics, ...: the folder, which is the same below include/ and src/; lab/ has others."""
    parts = os.path.relpath(file, PUBLIC if file.startswith(PUBLIC + os.sep) else file.split(os.sep)[0]).split(os.sep)
    return '/'.join(parts[:2]) if parts[0] == 'core' and len(parts) > 2 else parts[0]


def reachable(graph, start):
    found, left = set(), [start]
    while left:
        for other in graph.get(left.pop(), ()):
            if other not in found:
                found.add(other)
                left.append(other)
    return found


def rows(design):
    """{room: its row in the design's table of who includes whom}."""
    table = design.split('Which folder includes which:')[-1]
    lines = re.findall(r'^\| ((?:`[\w/]+`(?:, )?)+) \|', table, re.MULTILINE)
    return {name: row for row, line in enumerate(lines) for name in re.findall(r'`([\w/]+)`', line)}


def in_core(name):
    return name.split('/')[0] == 'core'


def eigen():
    """Where Eigen's headers are."""
    asked = subprocess.run(['pkg-config', '--variable=includedir', 'eigen3'], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True, check=False)
    return asked.stdout.strip() or '/usr/include/eigen3'


def compiled_alone(tree, headers, compiler='c++'):
    """What the compiler says of the headers, each by itself and with nothing but include/ and Eigen; empty: all is well."""
    compiler = [compiler, '-std=c++17', '-Wall', '-Wextra', '-isystem', eigen()]
    with tempfile.TemporaryDirectory() as folder:
        # Headers that include Eigen take it precompiled: it is nine tenths of the time.
        first = os.path.join(folder, 'first.hpp')
        with open(first, 'w', encoding='utf-8') as out:
            out.write('#include <Eigen/Core>\n')
        subprocess.run([*compiler, '-x', 'c++-header', first, '-o', first + '.gch'], check=True)
        sources = []
        for number, header in enumerate(headers):
            sources.append(os.path.join(folder, f'header_{number}.cpp'))
            with open(sources[-1], 'w', encoding='utf-8') as out:
                out.write('#include "first.hpp"\n' if 'Eigen/Core' in tree.needs(header) else '')
                out.write(f'#include "{os.path.relpath(header, "include")}"\n')
        jobs = os.cpu_count() or 1
        running = [subprocess.Popen([*compiler, '-fsyntax-only', '-I', os.path.join(tree.root, 'include'), *sources[job::jobs]],
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                   for job in range(jobs) if sources[job::jobs]]
        said = [(job.communicate()[0], job.returncode) for job in running]
    return ''.join(text for text, status in said if status != 0 or ' warning: ' in text)


class Includes(unittest.TestCase):
    """Of this package."""

    @classmethod
    def setUpClass(cls):
        cls.tree = Tree(ROOT)

    def test_installed_headers_include_installed_ones_only(self):
        self.assertEqual(self.tree.private_includes_of_public_headers(), [])

    def test_what_is_installed_is_for_critics_and_for_planners_without_ros(self):
        self.assertEqual({room(file) for file in self.tree.public()}, {'core', 'core/util', 'critics'})

    def test_every_installed_header_compiles_alone(self):
        headers = self.tree.without_ros()
        self.assertGreater(len(headers), 15)
        self.assertEqual(compiled_alone(self.tree, headers), '')

    def test_rooms_form_no_circle_but_those_that_the_design_explains(self):
        explained = [sorted(pair) for pair in TOGETHER.findall(read(ROOT, 'docs', 'understand', 'design.md'))]
        self.assertEqual([circle for circle in self.tree.circles() if circle not in explained], [])

    def test_what_the_design_explains_is_still_so(self):
        explained = [sorted(pair) for pair in TOGETHER.findall(read(ROOT, 'docs', 'understand', 'design.md'))]
        self.assertEqual([circle for circle in explained if circle not in self.tree.circles()], [])

    def test_no_arrow_points_up(self):
        row = rows(read(ROOT, 'docs', 'understand', 'design.md'))
        self.assertGreater(len(row), 15)
        self.assertEqual(self.tree.arrows(lambda a, b: row.get(b, 0) <= row.get(a, len(row))), [])

    def test_the_planner_is_included_from_above_alone(self):
        below = [file for file, includes in self.tree.includes.items() if room(file).startswith('core/') and room(file) != 'core/planner'
                 and any(found == os.path.join(PUBLIC, 'core', 'planner.hpp') for _, found in includes)]
        self.assertEqual(below, [])

    def test_core_includes_no_other_room(self):
        self.assertEqual(self.tree.arrows(lambda a, b: not in_core(a) or in_core(b)), [])

    def test_critics_include_what_other_packages_critics_may(self):
        self.assertEqual(self.tree.arrows(lambda a, b: a != 'critics' or b in ('core', 'core/util')), [])
        private = [f'{file}: {name}' for file, includes in self.tree.includes.items() if room(file) == 'critics'
                   for name, found in includes if found is not None and in_core(room(found)) and not found.startswith(PUBLIC)]
        self.assertEqual(private, [])

    def test_what_runs_on_a_robot_includes_nothing_of_the_laboratory(self):
        self.assertEqual(self.tree.includes_of_the_laboratory(), [])

    def test_ros_is_included_by_mbf_and_replay_alone(self):
        self.assertEqual(self.tree.arrows(lambda a, b: b != 'ros' or a in ('mbf', 'replay')), [])


class MadeUp(unittest.TestCase):
    """A tree with a fault of each kind: that these tests can fail."""

    def tree(self, **files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in files.items():
            base, path = name.split('__', 1)
            path = os.path.join(folder.name, PUBLIC if base == 'include' else base, *path.split('__')) + '.hpp'
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w', encoding='utf-8') as out:
                out.write('#pragma once\n' + text)
        return Tree(folder.name)

    def test_a_private_header_in_an_installed_one(self):
        tree = self.tree(include__core__a='#include "core/motion/b.hpp"\n', src__core__motion__b='')
        self.assertEqual(tree.private_includes_of_public_headers(),
                         [os.path.join(PUBLIC, 'core', 'a.hpp') + ': core/motion/b.hpp'])

    def test_a_header_of_the_laboratory_in_one_of_the_robot(self):
        tree = self.tree(src__core__a='#include "sim/b.hpp"\n', lab__sim__b='#include "core/a.hpp"\n')
        self.assertEqual(tree.includes_of_the_laboratory(), [os.path.join('src', 'core', 'a.hpp') + ': sim/b.hpp'])

    def test_a_circle_of_three(self):
        tree = self.tree(src__core__motion__a='#include "core/distance/b.hpp"\n',
                         src__core__distance__b='#include "hidwa_local_planner/input/c.hpp"\n',
                         include__input__c='#include "core/motion/a.hpp"\n', src__sim__d='#include "core/motion/a.hpp"\n')
        self.assertEqual(tree.circles(), [['core/distance', 'core/motion', 'input']])

    def test_files_of_one_room_are_no_circle(self):
        tree = self.tree(src__sim__a='#include "b.hpp"\n', src__sim__b='#include "a.hpp"\n', include__core__c='')
        self.assertEqual(tree.circles(), [])

    def test_an_arrow_out_of_core(self):
        tree = self.tree(src__core__planner__a='#include "hidwa_local_planner/critics/b.hpp"\n', include__critics__b='')
        self.assertEqual(len(tree.arrows(lambda a, b: not in_core(a) or in_core(b))), 1)

    def test_an_arrow_up(self):
        row = rows('Which folder includes which:\n| `core` | |\n| `core/motion`, `core/movers` | |\n| `core/cycle` | |\n')
        self.assertEqual(row, {'core': 0, 'core/motion': 1, 'core/movers': 1, 'core/cycle': 2})
        tree = self.tree(src__core__motion__a='#include "core/cycle/b.hpp"\n', src__core__cycle__b='#include "core/movers/c.hpp"\n',
                         src__core__movers__c='')
        self.assertEqual(tree.arrows(lambda a, b: row.get(b, 0) <= row.get(a, len(row))),
                         [os.path.join('src', 'core', 'motion', 'a.hpp') + ': core/cycle/b.hpp'])

    def test_a_header_that_lacks_an_include(self):
        tree = self.tree(include__core__good='#include <vector>\nusing Good = std::vector<int>;\n',
                         include__core__bad='using Bad = std::vector<int>;\n')
        good, bad = os.path.join(PUBLIC, 'core', 'good.hpp'), os.path.join(PUBLIC, 'core', 'bad.hpp')
        self.assertEqual(compiled_alone(tree, [good]), '')
        self.assertIn('bad.hpp', compiled_alone(tree, [good, bad]))

    def test_headers_that_need_ros_are_told_by_what_they_include(self):
        tree = self.tree(include__ros__a='#include <ros/ros.h>\n', include__ros__b='#include "a.hpp"\n',
                         include__ros__c='#include "hidwa_local_planner/Made.h"\n', include__core__d='#include <Eigen/Core>\n')
        self.assertEqual(tree.without_ros(), [os.path.join(PUBLIC, 'core', 'd.hpp')])


if __name__ == '__main__':
    unittest.main()
