# SPDX-License-Identifier: BSD-3-Clause
"""The operator's console: a server beside move_base, and the page that it serves. docs/use/console.md, docs/understand/console_protocol.md."""
