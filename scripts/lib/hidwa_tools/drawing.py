# SPDX-License-Identifier: BSD-3-Clause
"""What the pictures of drives and studies share: the operator's states and the colours of ways."""
STATE_NAMES = ('AUTONOMY', 'SHARED', 'HOLD', 'MANUAL', 'STOPPED', 'LOST', 'BLOCKED')
STEERED = ('SHARED', 'MANUAL', 'STOPPED', 'BLOCKED')  # the person gives input now; in HOLD it has ended
INK, DRIVEN, STEERED_COLOUR = '#22303c', '#1f4e9c', '#d62728'
