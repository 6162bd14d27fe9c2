# SPDX-License-Identifier: BSD-3-Clause
"""Normal form of a sequence of events: no times, repeats collapsed."""

LONGEST_PATTERN = 6


def collapse(events):
    """Lines of text for `events`; a pattern that repeats becomes one "( ... )+", shorter patterns first."""
    items, length = list(events), 1
    while length <= LONGEST_PATTERN:
        collapsed = _collapse_length(items, length)
        # What collapsed may make a shorter pattern repeat.
        length = 1 if collapsed != items else length + 1
        items = collapsed
    return [line for item in items for line in _lines(item, "")]


def without_repeats(events):
    """Each run of equal events once."""
    return [event for i, event in enumerate(events) if i == 0 or event != events[i - 1]]


def _collapse_length(items, length):
    out = []
    i = 0
    while i < len(items):
        pattern = items[i:i + length]
        repeats = 1
        while items[i + repeats * length:i + (repeats + 1) * length] == pattern:
            repeats += 1
        if repeats > 1:
            out.append(tuple(pattern))
            i += repeats * length
        else:
            out.append(items[i])
            i += 1
    return out


def _lines(item, indent):
    if isinstance(item, str):
        return [indent + item]
    inner = [line for part in item for line in _lines(part, indent + "  ")]
    return [indent + "("] + inner + [indent + ")+"]
