#!/usr/bin/python3
"""Writes the files of scenes/bowl: the bed and the sand at the start as rasters of one row, and the exact profiles.

Sand in a parabolic bowl with Coulomb friction: its surface is always a plane, and it moves as a whole like a pendulum
with dry friction (derivation in solver/reference/coulomb_bowl.hpp). Half-way between two centres of these rasters the
interpolated parabola is off by the same 6e-7 m everywhere, so that coarser grids see the exact slopes.
"""

import argparse
from pathlib import Path

import numpy as np

from plotting import ROOT

HEIGHT, HALF_WIDTH, START = 0.1, 1.0, 0.5       # [m] depth of the bowl, half the width of the sand, its displacement
GRAVITY, FRICTION = 9.8, 0.02                   # [m/s^2], [-]
LENGTH, SPACING = 4.0, 0.005                    # [m] of the rasters
FREQUENCY = np.sqrt(2 * GRAVITY * HEIGHT) / HALF_WIDTH          # [1/s]
BOUND = 0.5 * FRICTION * HALF_WIDTH**2 / HEIGHT                 # [m] friction holds the sand within it


def displacement(half_swings):
    """[m] of the sand after this many half swings; each takes 2 BOUND off the reach and changes the side."""
    turn, part = divmod(half_swings, 1)
    side = -1 if turn % 2 else 1
    return side * (BOUND + (START - 2 * BOUND * turn - BOUND) * np.cos(np.pi * part))


def depth(x, at):
    return np.maximum(0, HEIGHT * (1 - ((x - at) / HALF_WIDTH) ** 2))


def write_row(path, values):
    """An ESRI ASCII grid of one row that is as wide as any cell."""
    head = f"ncols {values.size}\nnrows 1\nxllcorner {-LENGTH / 2:g}\nyllcorner -0.5\ndx {SPACING:g}\ndy 1\n"
    path.write_text(head + "\n".join(f"{value:.9g}" for value in values) + "\n")


def write_profile(path, half_swings):
    at = displacement(half_swings)
    x = np.arange(round((at - HALF_WIDTH) / SPACING) - 2, round((at + HALF_WIDTH) / SPACING) + 3) * SPACING
    head = (f"# Exact depth after {half_swings:g} half swings, {half_swings * np.pi / FREQUENCY:.17g} s: displacement "
            f"{at:.9g} m.\n# Made by scripts/make_bowl.py.\nx_m,depth_m\n")
    path.write_text(head + "".join(f"{a:.6g},{h:.9g}\n" for a, h in zip(x, depth(x, at))))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "scenes/bowl", help="folder to write to")
    folder = parser.parse_args().output
    x = -LENGTH / 2 + SPACING * (np.arange(round(LENGTH / SPACING)) + 0.5)
    write_row(folder / "bed.asc", HEIGHT * ((x / HALF_WIDTH) ** 2 - 1))
    write_row(folder / "sand.asc", depth(x, START))
    write_profile(folder / "first_swing.csv", 0.5)
    write_profile(folder / "second_swing.csv", 1.5)


if __name__ == "__main__":
    main()
