# SPDX-License-Identifier: BSD-3-Clause
"""The tests under sanitizers, each combination in a build folder of its own: forms of scripts/test --long, and a part of the short one."""
import glob
import os
import re
import shutil

from . import compilers

ADDRESS, THREAD = 'address,undefined', 'thread'
# Left out everywhere: they read the instructions of an optimised build.
UNFIT = ('hidwa_vector_width_core_test', 'hidwa_vector_width_critics_test')
# Slow cycles say so in words, which allocates.
UNFIT_CASES = '-Allocations.NoneWhileThePersonSteers'
# The short form: what reads bytes, and what starts threads.
SHORT_BUILD = ('-DHIDWA_TOOLS=demo', '-DHIDWA_TEST_SUITES=unit/robot;fuzz')
# A program with one thread has no race to find: the thread sanitizer takes the folders whose tests start threads of their own.
# No other library without ROS starts one; test/scripts looks.
THREAD_SUITES = ('unit/robot', 'unit/study', 'ways')
SUPPRESSIONS = os.path.join('test', 'sanitize')  # what is not ours, by name

# {name: (compiler, sanitizers)}: the tests that need no ROS, and host, plugin and rostests.
FORMS = {'gcc-address': ('g++', ADDRESS), 'clang-address': ('clang++', ADDRESS), 'gcc-thread': ('g++', THREAD),
         'clang-thread': ('clang++', THREAD)}
HOST_FORMS = {'ros-address': ('g++', ADDRESS), 'ros-thread': ('g++', THREAD)}


class Absent(Exception):
    """A form is left out; the text says what is absent."""


def empty_folder(path):
    """The path of a folder that is made anew."""
    shutil.rmtree(path, ignore_errors=True)
    os.makedirs(path)
    return path


def environment(root):
    """How the sanitizers are told what to do. What is not ours is named in the files of suppressions, with the reason."""
    folder = os.path.join(root, SUPPRESSIONS)
    return {'ASAN_OPTIONS': 'detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1',
            'LSAN_OPTIONS': f'suppressions={folder}/leaks.txt:print_suppressions=0',
            'UBSAN_OPTIONS': f'print_stacktrace=1:suppressions={folder}/undefined.txt',
            'TSAN_OPTIONS': f'suppressions={folder}/threads.txt:print_suppressions=0:second_deadlock_stack=1:history_size=4'}


def with_ros(options, folder):
    """Of environment(), for programs that a rostest starts and nobody reads: what they find goes to files in `folder`.

    roscpp, rosconsole and log4cxx take their own mutexes in many orders: with ROS deadlocks are not looked for.
    """
    told = {name: f'{value}:log_path={os.path.join(folder, name[:4].lower())}' for name, value in options.items() if name != 'LSAN_OPTIONS'}
    return {**options, **told, 'TSAN_OPTIONS': told['TSAN_OPTIONS'] + ':detect_deadlocks=0:exitcode=0', 'GTEST_FILTER': UNFIT_CASES}


def findings(folder):
    """One line each, of what programs left in `folder`."""
    lines = []
    for path in sorted(glob.glob(os.path.join(folder, '*'))):
        with open(path, encoding='utf-8', errors='replace') as report:
            text = report.read()
        found = re.findall(r'^SUMMARY: (.*)|^(.*: runtime error: .*)', text, re.MULTILINE) or [(text[:200], '')] * bool(text.strip())
        lines += [f'{os.path.basename(path)}: {first or second}' for first, second in found]
    return lines


def cmake_options(compiler, sanitizers):
    """What CMake is told: assertions stay, and -O2, since GCC inlines nothing of Eigen below it."""
    if compiler == 'clang++' and not compilers.fuzzes(compilers.clang()):
        raise Absent(f'left out, absent: Clang with its run-time libraries ({compilers.REMEDY})')
    found = compilers.clang() if compiler == 'clang++' else compiler
    own = [f'-DHIDWA_TEST_SUITES={";".join(THREAD_SUITES)}'] if sanitizers == THREAD else []
    return [f'-DCMAKE_CXX_COMPILER={found}', f'-DHIDWA_SANITIZE={sanitizers}', '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O2',
            *own]


def ctest_options(others=()):
    """Which tests are left out: those that fit no such build, and others."""
    return ['-E', '^(' + '|'.join((*UNFIT, *others)) + ')$']


def flags(sanitizers):
    """For packages that do not know HIDWA_SANITIZE: the compiler's and the linker's."""
    own = [f'-fsanitize={sanitizers}', '-fno-sanitize-recover=all', '-fno-omit-frame-pointer', '-g1']
    if 'undefined' in sanitizers:
        own.append('-fsanitize=float-cast-overflow')
        own.append('-Wno-error=maybe-uninitialized')  # GCC warns of its own std::regex there
    return ' '.join(own)
