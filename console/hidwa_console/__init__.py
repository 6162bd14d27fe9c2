# SPDX-License-Identifier: BSD-3-Clause
"""The operator's console: a server beside move_base, and the page that it serves.

docs/use/console.md says how it is used, docs/understand/console_protocol.md what page and server say to each other.
"""
