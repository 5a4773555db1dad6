# SPDX-License-Identifier: GPL-3.0-or-later
"""changed.py FILE FRAME AMOUNT - adds the amount to a coordinate of the first particle in that frame."""

import sys

import h5py

with h5py.File(sys.argv[1], "r+") as results:
    results["particles/trajectory/position/value"][int(sys.argv[2]), 0, 0] += float(sys.argv[3])
