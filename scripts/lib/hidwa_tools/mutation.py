# SPDX-License-Identifier: BSD-3-Clause
"""Deliberate faults: where C++ can be changed by an operator or a constant, and a choice of them by a seed."""
import hashlib
import os
import re
from dataclasses import dataclass

# What is changed, by the pattern that finds it: (pattern, replacements). Spaces keep templates and pointers out.
OPERATORS = (
    (r' <= ', (' < ', ' > ')), (r' >= ', (' > ', ' < ')), (r'(?<!operator) < ', (' <= ', ' >= ')), (r'(?<!-) > ', (' >= ', ' <= ')),
    (r' == ', (' != ',)), (r' != ', (' == ',)),
    (r' && ', (' || ',)), (r' \|\| ', (' && ',)), (r'(?<=[(\s])!(?=[a-z_(])', ('',)),
    (r' \+ ', (' - ',)), (r' - ', (' + ',)), (r' \* ', (' / ',)), (r' / ', (' * ',)),
    (r' \+= ', (' -= ',)), (r' -= ', (' += ',)), (r' \*= ', (' /= ',)),
    (r'(?<=[=,?:] )-(?=[a-z_(])|(?<=return )-(?=[a-z_(])|(?<=\()-(?=[a-z_])', ('',)),
    (r'std::min\b', ('std::max',)), (r'std::max\b', ('std::min',)),
    (r'\btrue\b', ('false',)), (r'\bfalse\b', ('true',)),
    (r'(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.])', ('larger', 'smaller')), (r'(?<![\w.\[])\d+(?![\w.])', ('larger',)),
)
# Lines that say nothing that runs, or that a change would not compile in.
NO_CODE = re.compile(r'^\s*(#|//|namespace\b|using\b|template\b|static_assert\b|friend\b|case\b|enum\b|\}|public:|private:)')
# Memory asked for ahead of need, and what members hold before they are given a value.
NO_EFFECT = re.compile(r'\breserve\(|\bcapacity\(\)|\bshrink_to_fit\(')
MEMBER = re.compile(r'^\s*(?:mutable )?[\w:<>]+ \w+_?(?: = [-\w.:]+)?(?:, \w+(?: = [-\w.:]+)?)*;')


@dataclass(frozen=True)
class Mutant:
    """A line of a file, and what takes its place."""
    path: str    # from the root of the source tree
    line: int    # from 1
    before: str
    after: str

    def key(self):
        """What names it when lines have moved."""
        return f'{self.path}: {self.before.strip()} -> {self.after.strip()}'


def number_for(kind, text):
    """A larger or a smaller number in place of one, of the same type."""
    if '.' not in text:
        return str(int(text) + 1)
    value = float(text)
    if kind == 'larger':
        return repr(value * 1.5 if value else 1.0)
    return repr(value * 0.5 if value else -1.0)


def code_of(line):
    """The line with its comment and the content of its strings blanked, so that places stay."""
    blank = re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'', lambda text: ' ' * len(text.group()), line)
    return re.sub(r'//.*', lambda text: ' ' * len(text.group()), blank)


def is_member(path, code):
    """Whether the line declares members, or what is alike; constants are looked at."""
    if not MEMBER.match(code) or 'const' in code or 'return' in code:
        return False
    return path.endswith('.hpp') or bool(re.search(r'\w_(?: =|;|,)', code))


def mutants_of_line(path, number, line):
    """Every mutant of one line."""
    code = code_of(line)
    if NO_CODE.match(line) or NO_EFFECT.search(code) or is_member(path, code):
        return
    for pattern, replacements in OPERATORS:
        for found in re.finditer(pattern, code):
            for other in replacements:
                text = number_for(other, found.group()) if other in ('larger', 'smaller') else other
                yield Mutant(path, number, line, line[:found.start()] + text + line[found.end():])


def mutants_of_file(root, path):
    """Every mutant of one file; what lies between #if and #endif, and in /* */, is left alone."""
    with open(os.path.join(root, path), encoding='utf-8') as text:
        lines = text.read().splitlines()
    depth = 0
    for number, line in enumerate(lines, 1):
        if re.match(r'\s*#\s*if', line) and '#pragma' not in line:
            depth += 1
        elif re.match(r'\s*#\s*endif', line):
            depth -= 1
        elif not depth:
            yield from mutants_of_line(path, number, line)


def sources(root, folders):
    """C++ files of the folders, sorted."""
    found = []
    for folder in folders:
        for place, _, names in os.walk(os.path.join(root, folder)):
            found += [os.path.relpath(os.path.join(place, name), root) for name in names if name.endswith(('.cpp', '.hpp'))]
    return sorted(found)


def shuffled(mutants, seed):
    """The same order for the same seed whatever Python, and hardly another where a file has changed elsewhere."""
    def place(mutant):
        return hashlib.sha256(f'{seed} {mutant.key()} {mutant.line}'.encode()).hexdigest()
    return sorted(mutants, key=place)


def read_equivalents(path):
    """{key: reason} out of the list of mutants that change nothing that can be seen: `key` and, indented below, its reason."""
    found, key = {}, None
    with open(path, encoding='utf-8') as text:
        for line in text:
            if not line.strip() or line.startswith('#'):
                continue
            if line[0].isspace():
                found[key] = (found[key] + ' ' + line.strip()).strip()
            else:
                key = line.strip()
                found[key] = ''
    unexplained = [key for key, reason in found.items() if not reason]
    if unexplained:
        raise ValueError(f'{path}: no reason is given for {unexplained[0]}')
    return found
