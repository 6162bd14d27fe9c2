# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the planner against recorded drives; scripts/bag_test is the node. Times [s] are the bag's own unless said."""
