# SPDX-License-Identifier: BSD-3-Clause
"""Small JSON files by which two programs talk."""
import json
import os


def write(path, content):
    """A file that is whole whenever somebody looks."""
    with open(path + '.new', 'w', encoding='utf-8') as out:
        json.dump(content, out)
    os.replace(path + '.new', path)


def read(path):
    """What the other side has written; {} before that."""
    try:
        with open(path, encoding='utf-8') as text:
            return json.load(text)
    except (OSError, ValueError):
        return {}
