#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vector_width.py LIBRARY: whether the functions marked HIDWA_VECTOR_CLONES still compute many values at once.

The compiler says nothing when it no longer vectorises a loop, and every result stays the same: only the time grows.
Exit status: 0 they do; 1 some do not; 77 the library has no such clones by its nature."""
import argparse
import re
import subprocess
import sys

# What the innermost loops must hold: packed operations, without the v of AVX. In the clone for AVX2 on 256 bits.
PACKED = {
    'add_deviation': ('mulpd', 'addpd', 'andpd'),
    'add_weighted': ('mulpd', 'addpd'),
    'cells_of_points': ('subpd', 'mulpd', 'cvttpd2dq'),
    'find_cells': ('subpd', 'mulpd', 'cvttpd2dq'),
    'gather': ('por',),
    'keep_smaller': ('pminsw',),
    'least_beyond': ('mulpd', 'addpd'),
    'least_inside': ('mulpd', 'subpd'),
    'least_of_rows': ('paddw', 'pminsw'),
    'ramp_rows': ('mulpd', 'addpd'),
    'steady_rows': ('mulpd', 'addpd'),
    'take_from': ('paddw', 'pminsw'),
    'critics::add_side': ('mulpd', 'addpd', 'subpd'),
}
CLONES = {'avx2': ('v', '%ymm'), 'default': ('', '%xmm')}
SKIPPED = 77

HEADER = re.compile(r'^[0-9a-f]+ <(?P<name>[^.]+)(\.\w+)*?\.(?P<clone>avx2|default)(\.[0-9]+)*>:$')
LINE = re.compile(r'^\s*(?P<at>[0-9a-f]+):\s+(?P<operation>\S+)\s*(?P<operands>.*)$')
TARGET = re.compile(r'^(?P<to>[0-9a-f]+) <')


def short(name):
    """critics::add_side of hidwa_local_planner::critics::(anonymous namespace)::add_side(...)."""
    name = name.replace('(anonymous namespace)::', '').replace('hidwa_local_planner::', '')
    return name.split('(')[0].strip()


def demangled(names):
    """{name: it as in the source}."""
    names = sorted(names)
    readable = subprocess.run(['c++filt'], input='\n'.join(names), check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return dict(zip(names, map(short, readable)))


def functions(listing):
    """{(function, clone): [(address, operation, operands), ...]} of a disassembly with names as the linker sees them: older
    versions of objdump cannot read those of clones."""
    found, body = {}, None
    for line in listing.splitlines():
        if line.endswith('>:'):
            header = HEADER.match(line)
            body = found.setdefault((header['name'], header['clone']), []) if header else None
            continue
        instruction = LINE.match(line) if body is not None else None
        if instruction:
            body.append((int(instruction['at'], 16), instruction['operation'], instruction['operands']))
    names = demangled({name for name, _ in found})
    return {(names[name], clone): body for (name, clone), body in found.items()}


def innermost_loops(body):
    """The address ranges that a jump back closes and that hold no other such range."""
    loops = set()
    for at, operation, operands in body:
        target = TARGET.match(operands) if operation.startswith('j') else None
        if target and body[0][0] <= int(target['to'], 16) <= at:
            loops.add((int(target['to'], 16), at))
    return [a for a in loops if not any(b != a and a[0] <= b[0] and b[1] <= a[1] for b in loops)]


def missing(body, clone, operations):
    """Those of the operations that no innermost loop holds at the clone's width."""
    prefix, register = CLONES[clone]
    loops = innermost_loops(body)
    held = {operation for at, operation, operands in body
            if register in operands and any(lo <= at <= hi for lo, hi in loops)}
    return [operation for operation in operations if prefix + operation not in held]


def judge(listing, packed):
    """What is wrong, one line a function."""
    found, faults = functions(listing), []
    for name, operations in packed.items():
        for clone in CLONES:
            if (name, clone) not in found:
                faults.append(f'{name}: the library holds no clone of it for {clone}')
                continue
            lost = missing(found[name, clone], clone, operations)
            if lost:
                faults.append(f"{name}, clone for {clone}: no loop of it holds a packed {', '.join(lost)}")
    faults += [f'{name}: marked HIDWA_VECTOR_CLONES, but what its loops must hold is not listed here'
               for name in sorted({name for name, _ in found} - set(packed))]
    return faults


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('library', help='libhidwa_core.so')
    parser.add_argument('--objdump', default='objdump', help='the disassembler')
    parser.add_argument('--compiler', default='GNU', help='who compiled it, in the words of CMake')
    options = parser.parse_args()

    def objdump(*arguments):
        return subprocess.run([options.objdump, *arguments, options.library], check=True, stdout=subprocess.PIPE, text=True,
                              env={'LC_ALL': 'C'}).stdout
    if 'x86-64' not in objdump('-f'):
        print('skipped: clones are made for x86-64 only, and this library is for another processor')
        return SKIPPED
    if options.compiler != 'GNU':
        print(f'skipped: clones are made by GCC only, and this library was compiled by {options.compiler}')
        return SKIPPED
    faults = judge(objdump('--disassemble', '--no-show-raw-insn'), PACKED)
    print('\n'.join(faults) if faults else f'{len(PACKED)} functions, each vectorised in {len(CLONES)} clones')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
