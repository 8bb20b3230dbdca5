#!/usr/bin/python3
"""Writes the terrain and the snow of scenes/avalanche: a mountain side with gullies above a valley, and a slab on it.

    make_avalanche.py [FOLDER]      writes terrain.npy and snow.npy there (default: scenes/avalanche)

512 x 512 values of float32 [m], row 0 at the smallest y, 2 m apart. The noise is that of make_dem.py: the same file
with every version of numpy, to rounding.
"""

import argparse
from pathlib import Path

import numpy as np

from make_dem import fractal_noise, value_noise

CELLS, SPACING = 512, 2.0                # [m]
EXTENT = CELLS * SPACING                 # [m]
CREST = 90.0                             # x of the fracture line [m]
LENGTH, WIDTH, DEPTH = 190.0, 600.0, 3.0  # of the slab, downhill, across, vertically [m]


def smooth(edge, width):
    """From 0 to 1 over `width` about an edge."""
    t = np.clip(edge / width + 0.5, 0, 1)
    return t * t * (3 - 2 * t)


def places():
    centres = (np.arange(CELLS) + 0.5) * SPACING
    return np.meshgrid(centres, centres)


def terrain():
    """Elevation (y, x) [m]: falls along +x, at 34 deg under the slab and ever less below it, out to a level valley."""
    x, y = places()
    along = x / EXTENT
    side = 380 * np.exp(-along / 0.347)
    # Gullies half-way down, which end in fans.
    steep = smooth(0.5 - along, 0.5)
    bend = 0.03 * value_noise(3 * along, 2 * y / EXTENT, 11)
    gully = fractal_noise(1.0 * along, 3.4 * (y / EXTENT + bend), 23, octaves=3, ridged=True)
    rocks = fractal_noise(9 * along, 9 * y / EXTENT, 31, octaves=4)
    smaller = fractal_noise(5 * along, 5 * y / EXTENT, 41, octaves=3)
    return side + EXTENT * (steep * (0.032 * gully + 0.006 * rocks) + 0.0015 * smaller)


def snow():
    """Depth of the slab (y, x) [m]: sharp at the fracture line, with ragged flanks and a tapering lower end."""
    x, y = places()
    ragged = 14 * value_noise(y / 70, np.zeros_like(y), 51) + 6 * value_noise(y / 22, np.zeros_like(y), 52)
    flank = 20 * value_noise(x / 45, np.zeros_like(x), 53)
    top = x > CREST + ragged
    across = np.abs(y - EXTENT / 2) < WIDTH / 2 + flank
    lower = smooth(CREST + LENGTH + 2 * ragged - x, 60)
    return np.where(top & across, DEPTH * lower, 0) * (1 + 0.15 * value_noise(x / 30, y / 30, 54))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?",
                        default=Path(__file__).resolve().parent.parent / "scenes/avalanche")
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    np.save(folder / "terrain.npy", terrain().astype(np.float32))
    np.save(folder / "snow.npy", snow().astype(np.float32))


if __name__ == "__main__":
    main()
