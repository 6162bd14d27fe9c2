# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/demo, scripts/report and scripts/test share."""
