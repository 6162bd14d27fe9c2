# SPDX-License-Identifier: BSD-3-Clause
"""Measures how a base answers commands: for `rosrun hidwa_local_planner measure_base`."""
