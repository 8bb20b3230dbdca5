#!/usr/bin/python3
"""How far particles that are moved once a frame end from those that are moved with every step.

    scripts/measure_particle_moves.py SCENE [--frame 33 ms] [--parts 24] [--set KEY=VALUE ...]

Runs the scene with a frame for every short step (1/parts of a frame), takes the velocities, and carries the same
tracers through them twice, without a grid in which they could meet: in every short step with its own velocity (eq. 31,
by the midpoint rule), and once a frame with the mean of the velocities at its two ends, as sandsim does.
"""

import numpy as np

from plotting import arguments, run
from sandsim_series import Series


def sample(field, x, y):
    """Bilinear interpolation of (ny, nx) at places in cells from the first centre; at walls the edge goes on."""
    ny, nx = field.shape
    x, y = np.clip(x, 0, nx - 1), np.clip(y, 0, ny - 1)
    i, j = np.minimum(x.astype(int), nx - 2), np.minimum(y.astype(int), ny - 2)
    s, t = x - i, y - j
    below, above = ((1 - s) * field[row, i] + s * field[row, i + 1] for row in (j, j + 1))
    return (1 - t) * below + t * above


def carry(places, u, v, time, hops):
    """Moves the places (x, y), in cells, with the velocity (u, v) in cells a second."""
    x, y = places
    step = time / hops
    for _ in range(hops):
        middle = x + step / 2 * sample(u, x, y), y + step / 2 * sample(v, x, y)
        x, y = x + step * sample(u, *middle), y + step * sample(v, *middle)
    return x, y


def main():
    parser = arguments(__doc__.splitlines()[0], result=False)
    parser.add_argument("scene", help="scene file")
    parser.add_argument("--frame", default="33 ms", help="frame interval of the particles")
    parser.add_argument("--parts", type=int, default=24, help="short steps in a frame")
    parser.add_argument("--set", dest="settings", action="append", default=[], help="as of sandsim run")
    options = parser.parse_args()
    number, unit = options.frame.split()
    output = options.output or "results/particle_moves"
    run(options.scene, output, [*options.settings, f"time.frame_interval={float(number) / options.parts} {unit}"])
    with Series(output) as series:
        spacing = series.spacing
        velocity = [tuple(part.astype(float) / spacing for part in series.velocity(k)) for k in range(series.frames)]
        wet = np.argwhere(series.depth(0) > 0.1 * spacing)
        start = wet[:, 1].astype(float), wet[:, 0].astype(float)
        time = series.time
    fine, coarse, largest = start, start, 0.0
    print("   time   way: mean  largest   apart: mean   99 %  largest   [cells]")
    for first in range(0, len(time) - options.parts, options.parts):
        last = first + options.parts
        for k in range(first, last):
            mean = [0.5 * (a + b) for a, b in zip(velocity[k], velocity[k + 1])]
            fine = carry(fine, *mean, time[k + 1] - time[k], 1)
        mean = [0.5 * (a + b) for a, b in zip(velocity[first], velocity[last])]
        span = time[last] - time[first]
        hops = max(1, int(np.ceil(span * max(np.abs(mean[0]).max(), np.abs(mean[1]).max()))))
        coarse = carry(coarse, *mean, span, hops)
        way = np.hypot(fine[0] - start[0], fine[1] - start[1])
        apart = np.hypot(fine[0] - coarse[0], fine[1] - coarse[1])
        moved = way > 0.5
        if moved.any():
            print(f"{time[last]:6.3f} s {way[moved].mean():10.2f} {way.max():8.2f} {apart[moved].mean():13.3f} "
                  f"{np.percentile(apart[moved], 99):6.2f} {apart.max():8.2f}")
        largest = max(largest, apart.max())


if __name__ == "__main__":
    main()
