# SPDX-License-Identifier: BSD-3-Clause
"""What colcon or catkin prints, read from standard input, made short: which package is built, and how far it is.

On a terminal the percentage stays on one line. Elsewhere each tenth is a line, so that a log stays readable.
"""
import re
import sys

PERCENT = re.compile(r'\[ *(\d+)%\] ')
PACKAGE = re.compile(r"(?:Starting >>>|Finished <<<|Failed   <<<|Aborted  <<<|==> Processing .*package:) '?([^\s']+)")


class Progress:
    """Lines in, lines out; `terminal`: one line may be written over."""

    def __init__(self, write, terminal):
        self.write, self.terminal = write, terminal
        self.package, self.shown, self.open, self.ending = '', -1, False, False

    def line(self, text):
        package, percent = PACKAGE.match(text), PERCENT.match(text)
        if package:
            self.package, self.shown = package.group(1), -1
            self.plain(text)
        elif percent:
            self.percent(int(percent.group(1)))
        elif text.startswith('Summary:') or (self.ending and text.startswith('  ')):
            self.ending = True
            self.plain(text)

    def plain(self, text):
        self.write(('\n' if self.open else '') + text + '\n')
        self.open = False

    def percent(self, percent):
        step = percent if self.terminal else percent // 10 * 10
        if step <= self.shown:
            return
        self.shown = step
        if self.terminal:
            self.write(f'\r    {self.package}: {step:3d} %')
            self.open = True
        elif step:
            self.plain(f'    {self.package}: {step} %')


def main():
    def write(text):
        sys.stdout.write(text)
        sys.stdout.flush()

    progress = Progress(write, sys.stdout.isatty())
    for text in sys.stdin:
        progress.line(text.rstrip('\n'))


if __name__ == '__main__':
    main()
