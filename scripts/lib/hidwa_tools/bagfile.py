# SPDX-License-Identifier: BSD-3-Clause
"""A bag's messages by topic, also out of a bag whose recording was cut short; and which topic is the one meant."""
import os
import shutil
import tempfile
from dataclasses import dataclass, field

import rosbag

from .errors import BagError


@dataclass
class Messages:
    """What a bag holds; times [s] are when a message was recorded."""
    kinds: dict = field(default_factory=dict)   # topic: package/Type
    rows: dict = field(default_factory=dict)    # topic: [(time, message)]
    begin: float = 0.0
    end: float = 0.0
    notes: list = field(default_factory=list)   # what was wrong with the file

    def get(self, topic):
        """[(time, message)], empty where there are none."""
        return self.rows.get(topic, [])

    def last(self, topic):
        """The last message or None."""
        rows = self.get(topic)
        return rows[-1][1] if rows else None


def read_messages(path, wanted):
    """The messages of the topics for which wanted(topic, type) holds. A bag without an index (the recorder was killed) or
    cut off is repaired in a copy; the file itself is never written to. BagError where nothing can be read."""
    if not os.path.isfile(path):
        raise BagError(f'there is no bag {path}')
    try:
        try:
            with rosbag.Bag(path) as bag:
                return _read(bag, wanted)
        except (rosbag.ROSBagUnindexedException, rosbag.ROSBagFormatException):
            return _repaired(path, wanted)
        except rosbag.ROSBagException as fault:
            with open(path, 'rb') as head:
                if not head.read(9).startswith(b'#ROSBAG V'):
                    raise BagError(f'{path} is no bag: {fault}') from fault
            return _repaired(path, wanted)
    except (OSError, rosbag.ROSBagException) as fault:
        raise BagError(f'{path} cannot be read: {fault}') from fault


def _repaired(path, wanted):
    with tempfile.TemporaryDirectory(prefix='hidwa_bag_') as folder:
        copy = os.path.join(folder, 'copy.bag')
        shutil.copyfile(path, copy)
        _unmark(copy)
        with rosbag.Bag(copy, 'a', allow_unindexed=True) as bag:
            for _ in bag.reindex():
                pass
        with rosbag.Bag(copy) as bag:
            messages = _read(bag, wanted)
    messages.notes.insert(0, 'the recording was cut short: the bag has no index. Read is what is intact, from a copy; '
                             '"rosbag reindex" would repair the bag itself')
    return messages


def _unmark(copy):
    """Takes away what there is of an index, and where the file says it is: rosbag would read it in vain.

    The header record after the magic line has index_pos, 8 bytes; 0 means none (bag format 2.0)."""
    mark = b'index_pos='
    with open(copy, 'r+b') as data:
        at = data.read(4096).find(mark)
        if at < 0:
            return
        data.seek(at + len(mark))
        index = int.from_bytes(data.read(8), 'little')
        data.seek(at + len(mark))
        data.write(bytes(8))
        if 4096 <= index < os.path.getsize(copy):
            data.truncate(index)


def _read(bag, wanted):
    messages = Messages()
    messages.kinds = {topic: info.msg_type for topic, info in bag.get_type_and_topic_info().topics.items()}
    if not bag.get_message_count():
        return messages
    messages.begin, messages.end = bag.get_start_time(), bag.get_end_time()
    topics = [topic for topic, kind in messages.kinds.items() if wanted(topic, kind)]
    try:
        for topic, message, time in bag.read_messages(topics=topics) if topics else ():
            messages.rows.setdefault(topic, []).append((time.to_sec(), message))
    except Exception as fault:  # pylint: disable=broad-except  # a damaged chunk may show as anything
        messages.end = max((rows[-1][0] for rows in messages.rows.values()), default=messages.begin)
        messages.notes.append(f'reading stopped at a damaged part, {messages.end - messages.begin:.1f} s after the begin: {fault}')
    return messages


def choose(messages, kinds, usual, given=None, namespace=''):
    """(topic or None, why none) of the given types: the one given, or the usual name in the namespace, or one that ends
    so, or has that in its name, or the only one of its type. BagError for one given that is not there."""
    there = sorted(topic for topic, kind in messages.kinds.items() if kind in kinds)
    if given:
        if given not in there:
            raise BagError(f'{given} is not in the bag as {" or ".join(sorted(kinds))}; there is {", ".join(there) or "none"}')
        return given, ''
    there = [topic for topic in there if topic.startswith(namespace)]
    word = usual.strip('/').split('/')[-1]
    for matches in ([t for t in there if t == namespace + usual], [t for t in there if t.endswith(usual)],
                    [t for t in there if word in t.split('/')[-1]]):
        if matches:
            return matches[0], ''
    if len(there) == 1:
        return there[0], ''
    return None, f'several topics may be it: {", ".join(there)}' if there else ''
