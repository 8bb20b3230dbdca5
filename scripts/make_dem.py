#!/usr/bin/python3
"""Writes a rough synthetic terrain as an ESRI ASCII grid: a valley between ridges, falling along +x.

    make_dem.py dem.asc [--seed 1] [--cells 256 256] [--spacing 4]

The same seed gives the same file with every version of numpy: the noise comes from an integer hash of the lattice
point, not from numpy's generators, and uses only sums and products. Elevations are rounded to a millimetre.
"""
import argparse

import numpy as np


def hashed(ix, iy, seed):
    """Uniform numbers in [-1, 1) from lattice points: three rounds of Murmur3's finaliser."""
    mask = np.uint64(0xFFFFFFFF)
    state = np.full(np.broadcast(ix, iy).shape, seed, dtype=np.uint64) & mask
    for word in (ix, iy, np.full_like(ix, 0x9E3779B9)):
        state = (state ^ (word.astype(np.uint64) & mask)) & mask
        for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35)):
            state = ((state ^ (state >> np.uint64(shift))) * np.uint64(factor)) & mask
        state = state ^ (state >> np.uint64(16))
    return state.astype(np.float64) / 2.0**31 - 1.0


def value_noise(x, y, seed):
    """Noise of unit wavelength: hashed lattice values joined by the smooth step 6 t^5 - 15 t^4 + 10 t^3."""
    cell_x, cell_y = np.floor(x), np.floor(y)
    t, s = x - cell_x, y - cell_y
    t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
    s = s * s * s * (s * (s * 6.0 - 15.0) + 10.0)
    ix, iy = cell_x.astype(np.int64), cell_y.astype(np.int64)
    lower = hashed(ix, iy, seed) * (1.0 - t) + hashed(ix + 1, iy, seed) * t
    upper = hashed(ix, iy + 1, seed) * (1.0 - t) + hashed(ix + 1, iy + 1, seed) * t
    return lower * (1.0 - s) + upper * s


def fractal_noise(x, y, seed, octaves=6, persistence=0.45, ridged=False):
    """Octaves of doubled frequency and falling amplitude; ridged: sharp crests where the noise changes sign."""
    total, amplitude = np.zeros_like(x), 1.0
    for octave in range(octaves):
        noise = value_noise(x * 2.0**octave, y * 2.0**octave, seed + 101 * octave)
        total += amplitude * (1.0 - 2.0 * np.abs(noise) if ridged else noise)
        amplitude *= persistence
    return total


def elevation(nx, ny, spacing, seed):
    """Elevation [m], rows from north to south. Lengths scale with the extent along x."""
    extent = nx * spacing
    x, y = np.meshgrid((np.arange(nx) + 0.5) / nx, (np.arange(ny)[::-1] + 0.5) / nx)
    middle = 0.5 * ny / nx + 0.06 * value_noise(2.5 * x, np.zeros_like(x), seed + 7)
    aside = np.abs(y - middle)
    # A steep head that flattens to a runout plain, across it a valley floor with walls that steepen away from it.
    along = 0.24 * (1.0 - x) * (1.0 - x) + 0.02 * (1.0 - x)
    walls = 0.55 * aside * aside / (aside + 0.12)
    roughness = 0.15 + 1.5 * aside
    ridges = 0.030 * roughness * fractal_noise(4.0 * x, 4.0 * y, seed + 1000, ridged=True)
    bumps = 0.010 * roughness * fractal_noise(14.0 * x, 14.0 * y, seed + 2000)
    return extent * (along + walls + ridges + bumps)


def write_esri_ascii(path, values, spacing):
    ny, nx = values.shape
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"ncols {nx}\nnrows {ny}\nxllcorner 0\nyllcorner 0\ncellsize {spacing:g}\nNODATA_value -9999\n")
        for row in values:
            file.write(" ".join(f"{value:.3f}" for value in row) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", help="file to write (.asc)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cells", type=int, nargs=2, default=(256, 256), metavar=("NX", "NY"))
    parser.add_argument("--spacing", type=float, default=4.0, help="in metres")
    options = parser.parse_args()
    if min(options.cells) < 1 or options.spacing <= 0.0 or options.seed < 0:
        parser.error("cells and spacing must be positive, the seed not negative")
    nx, ny = options.cells
    write_esri_ascii(options.output, elevation(nx, ny, options.spacing, options.seed), options.spacing)


if __name__ == "__main__":
    main()
