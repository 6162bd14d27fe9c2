# SPDX-License-Identifier: BSD-3-Clause
"""One seed, one scene, whatever the compiler: C++ leaves open in which order a call's arguments are worked out."""
import glob
import os
import re
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
OPEN, CLOSE = '([{', ')]}'


def without_words(text):
    """Comments and strings blanked; every character keeps its place."""
    return re.sub(r'//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', lambda found: ' ' * len(found.group()), text)


def generators(text):
    """Names of the file's generators of random numbers."""
    return {'random', 'random_', *re.findall(r'\b(?:Random|mt19937(?:_64)?)\b\s*[&*]?\s*(\w+)', text)}


def arguments(text):
    """(position, arguments) of every pair of round brackets."""
    opened = []
    for at, sign in enumerate(text):
        if sign in OPEN:
            opened.append((sign, at, [at + 1]))
        elif sign == ',' and opened:
            opened[-1][2].append(at + 1)
        elif sign in CLOSE and opened:
            kind, begin, parts = opened.pop()
            if kind == '(':
                yield begin, [text[a:b] for a, b in zip(parts, [*parts[1:], at + 1])]


def drawn_twice(text):
    """Lines of calls of which two arguments draw a random number."""
    text = without_words(text)
    name = '(?:' + '|'.join(sorted(generators(text))) + ')'
    draw = re.compile(rf'\b{name}(?:\.|->)\w+\(|\b\w+\(\*?{name}[,)]')
    return [text.count('\n', 0, at) + 1 for at, parts in arguments(text) if sum(bool(draw.search(part)) for part in parts) > 1]


class OrderOfDraws(unittest.TestCase):

    def test_it_is_seen(self):
        for line in ('f(random.uniform(0, 1), random.uniform(0, 1));', 'Point p(normal(random), normal(random));',
                     'void f(sim::Random& own) { g(own.in(0, 1), 2.0, {own.in(0, 1)}); }'):
            self.assertEqual(drawn_twice(line), [1], line)

    def test_order_that_is_kept_is_let_be(self):
        for line in ('f(random, random.in(0, 1));', 'const Point p{random.in(0, 1), random.in(0, 1)};', 'f(random.in(0, 1), 2.0);',
                     'f(Point{random.in(0, 1), random.in(0, 1)}, 3);', 'const double a = random.in(0, 1), b = random.in(0, 1);'):
            self.assertEqual(drawn_twice(line), [], line)

    def test_no_call_draws_twice(self):
        seen, where = 0, []
        for folder in ('src', 'lab', 'test', 'include'):
            for path in glob.glob(os.path.join(ROOT, folder, '**', '*.[ch]pp'), recursive=True):
                with open(path, encoding='utf-8') as source:
                    text = source.read()
                seen += 'random' in text
                where += [f'{os.path.relpath(path, ROOT)}:{line}' for line in drawn_twice(text)]
        self.assertEqual(where, [], 'give each draw a name first, in the order in which they are meant')
        self.assertGreater(seen, 50)


if __name__ == '__main__':
    unittest.main()
