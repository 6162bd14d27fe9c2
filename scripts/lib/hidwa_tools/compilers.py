# SPDX-License-Identifier: BSD-3-Clause
"""Which compilers are here, and whether they have the run-time libraries that sanitizers and fuzzers take."""
import os
import shutil
import subprocess
import tempfile

SOURCE = '''#include <cstddef>
#include <cstdint>
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { return size > 0 ? data[0] & 0 : 0; }
'''
CLANGS = ('clang++', 'clang++-14')
REMEDY = 'Debian: apt-get install clang libclang-rt-dev; Ubuntu 20.04: apt-get install clang'


def clang():
    """The C++ compiler of Clang; empty where there is none."""
    return next((path for path in map(shutil.which, CLANGS) if path), '')


def fuzzes(compiler):
    """Whether the compiler makes programs with libFuzzer and the sanitizers."""
    if not compiler:
        return False
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, 'target.cpp')
        with open(source, 'w', encoding='utf-8') as text:
            text.write(SOURCE)
        made = subprocess.run([compiler, '-fsanitize=fuzzer,address,undefined', source, '-o', os.path.join(folder, 'target')],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        return made.returncode == 0
