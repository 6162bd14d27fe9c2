# SPDX-License-Identifier: BSD-3-Clause
"""What the pages of studies share: their fault, the ways of runs, and a self-contained page."""
import base64
import csv
import glob
import html
import os

import numpy as np

from .drawing import STEERED


class ReportError(Exception):
    """The folder cannot be reported on; the text says why and what to do."""


def read_table(path, numbers, words):
    """The rows of runs.csv as dictionaries, the columns `numbers` as such, nan where a cell is empty (what is not known of a
    real robot); ReportError where a column is missing."""
    try:
        with open(path, encoding='utf-8', newline='') as text:
            rows = list(csv.DictReader(text))
    except FileNotFoundError as fault:
        raise ReportError(f'{path} is missing: give the folder that hidwa_study wrote (--out)') from fault
    if not rows:
        raise ReportError(f'{path} holds no runs: let hidwa_study finish first')
    missing = [name for name in (*words, *numbers) if name not in rows[0]]
    if missing:
        raise ReportError(f'{path} has no column {missing[0]}: it is not from this version of hidwa_study')
    for row in rows:
        for name in numbers:
            row[name] = float(row[name]) if row[name] else np.nan
    return rows


def read_way(path):
    """(points (n, 2), steered (n,)) of a run."""
    with open(path, encoding='utf-8', newline='') as text:
        rows = list(csv.DictReader(text))
    return (np.array([(float(r['x']), float(r['y'])) for r in rows]).reshape(-1, 2),
            np.array([r['state'] in STEERED for r in rows], bool))


def way_of(folder, row):
    """The file with a run's way; None where it was not kept."""
    found = glob.glob(os.path.join(glob.escape(folder), 'paths', glob.escape(row['id']) + '.csv'))
    return found[0] if found else None


def world_lines(path):
    """The lines of a file of worlds that hold one."""
    with open(path, encoding='utf-8') as text:
        return [line for line in text if line.strip() and not line.startswith('#')]


def html_table(head, rows):
    """A table of words."""
    lines = ['<tr>' + ''.join(f'<th>{html.escape(cell)}</th>' for cell in head) + '</tr>']
    lines += ['<tr>' + ''.join(f'<td>{html.escape(cell)}</td>' for cell in row) + '</tr>' for row in rows]
    return '<table>' + ''.join(lines) + '</table>'


def embedded(path):
    """A PNG as part of the page."""
    with open(path, 'rb') as data:
        return f'<img alt="" src="data:image/png;base64,{base64.b64encode(data.read()).decode()}">'


def write_page(path, title, parts):
    """Writes a page of these parts, HTML each; returns its path."""
    head = ['<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>' + title + '</title><style>',
            'body{font:15px/1.5 sans-serif;max-width:72em;margin:2em auto;padding:0 1em;color:#22303c}',
            'table{border-collapse:collapse;font-size:13px}td,th{border:1px solid #d9dee3;padding:.25em .6em;text-align:left}',
            'img{max-width:100%}</style>',
            f'<h1>{title}</h1>']
    with open(path, 'w', encoding='utf-8') as text:
        text.write('\n'.join(head + parts) + '\n</html>\n')
    return path
