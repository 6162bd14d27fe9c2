# SPDX-License-Identifier: BSD-3-Clause
"""The operator's console: a server beside move_base, and the page that it serves. docs/console.md, docs/console_protocol.md."""
