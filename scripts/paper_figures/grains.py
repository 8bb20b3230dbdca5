"""Figure 10: particles at three resolutions, and how fast they go."""

import numpy as np

from .model import Claim, Figure, Outcome, Run

CELLS = (1, 0.5, 0.25)                       # dl [dL]
TIME, INTERVAL = 0.16, 0.02                  # [s] of the picture, and of the frames
BLOCKS = 16                                  # along each side, for the evenness of the particles
ROOMY = 0.02                                 # [m] sand deeper than this counts where speeds are compared


def film(cells, velocity):
    return Run(f"grains_{cells:g}_{velocity}", "hbar/scene.yaml",
               ("sand.hbar.depth=10 cells", f"particles={{spacing: {cells:g} cells, velocity: {velocity}}}",
                f"time.end={TIME} s", f"time.frame_interval={INTERVAL} s"))


AVERAGED = [film(cells, "averaged") for cells in CELLS]
DILUTE = film(0.5, "dilute")


def followed(series, first, last):
    """Start and way of the particles that are visible in both frames: (n, 2) [m] each."""
    (start, ids), (end, later) = series.particles(first), series.particles(last)
    _, a, b = np.intersect1d(ids, later, return_indices=True)
    return start[a, :2].astype(float), (end[b, :2] - start[a, :2]).astype(float)


def cells_of(series, places):
    column = np.clip(((places[:, 0] - series.extent[0]) / series.spacing).astype(int), 0, series.x.size - 1)
    row = np.clip(((places[:, 1] - series.extent[2]) / series.spacing).astype(int), 0, series.y.size - 1)
    return row, column


def speeds(studio):
    """Mean speeds of particles over the last frame where the sand is deep: averaged, dilute [m/s], and mean h/hbar."""
    hbar, found = 10, []
    for run in (AVERAGED[CELLS.index(0.5)], DILUTE):
        with studio.series(run.name) as series:
            start, way = followed(series, series.frames - 2, series.frames - 1)
            depth = series.depth(-2)[cells_of(series, start)]
            chosen = depth > ROOMY
            moving = np.hypot(*way[chosen].T)
            found.append((float(moving.mean() / INTERVAL),
                          float((moving * np.maximum(1,
                                                     depth[chosen] / (hbar * series.spacing))).sum() / moving.sum())))
    return found[0][0], found[1][0], found[0][1]


def evenness(series):
    """Of the particles in blocks of the grid: chi squared per degree of freedom (below 1: more even than chance), the
    number of blocks, and the mean number in a cell. Only blocks that are deeper than a layer is thick count: in
    thinner sand particles below the ground are hidden."""
    places, _ = series.particles(-1)
    west, east, south, north = series.extent
    wet = series.depth(-1) > series.spacing
    count, _, _ = np.histogram2d(places[:, 1], places[:, 0], bins=BLOCKS, range=[[south, north], [west, east]])
    area = wet.reshape(BLOCKS, wet.shape[0] // BLOCKS, BLOCKS, -1).mean(axis=(1, 3))
    whole = count[area == 1]
    return float(((whole - whole.mean()) ** 2).sum() / whole.mean() / (whole.size - 1)), int(whole.size), \
        float(whole.mean() * BLOCKS**2 / wet.size)


def draw(studio):
    parts, rows, dense, even = [], [], [], []
    for cells, run in zip(CELLS, AVERAGED):
        parts.append(studio.trace(run.name, f"part{len(parts)}", "--show", "particles", "--zoom", 2, "--size",
                                  "480x360"))
        with studio.series(run.name) as series:
            value, blocks, in_a_cell = evenness(series)
            dense.append(in_a_cell)
            even.append(value)
            moved = series.report["particles"]
            rows.append([f"{cells:g} dL", f"{moved['count']}", f"{series.particles(-1)[0].shape[0]}",
                         f"{moved['merged']}", f"{moved['born']}",
                         f"{value:.2f} ({blocks} blocks)"])
    slow, fast, factor = speeds(studio)
    return Outcome(
        pictures=[(studio.beside(parts, "grains.jpg", len(parts)),
                   "dl = " + ", ".join(f"{cells:g}" for cells in CELLS) + " dL")],
        claims=[Claim("'improved visual effects as the resolution increases'",
                      "particles in a cell: " + ", ".join(f"{value:.2f}" for value in dense)
                      + "; chi squared over blocks " + ", ".join(f"{value:.2f}" for value in even),
                      "1, 4 and 16 in a cell within 2 %, and at most a tenth of the unevenness of chance (chi squared "
                      "per degree of freedom)",
                      all(abs(value * cells**2 - 1) < 0.02 for value, cells in zip(dense, CELLS)) and max(even) <= 0.1,
                      "the look itself is for the eye: see the pictures"),
                Claim("'particles actually move slower than expected if hbar < h'; a factor h/hbar may mend it",
                      f"mean speed {slow:.3f} m/s averaged and {fast:.3f} m/s dilute, {fast / slow:.2f} times; mean "
                      f"h/hbar of the moving sand {factor:.2f}",
                      "the ratio of the speeds is the mean of h/hbar, weighted by speed, within 15 %",
                      abs(fast / slow / factor - 1) < 0.15,
                      "each particle moves to where the other velocity takes it, so the two do not see the same sand")],
        tables=[("", ["dl", "particles", "visible", "merged", "born", "chi squared / d.o.f."],
                 rows)],
        notes=["The column of Fig. 6 with hbar of 10 cells: the paper does not say which sand its Fig. 10 shows.",
               f"Particles move once a frame of {1e3 * INTERVAL:g} ms."])


FIGURE = Figure("10", "Fig. 10: particles at three resolutions",
                "'Figure 10 shows a comparison of our particle-based enrichment with three different resolutions of "
                "particles [dl = dL, 0.5 dL, 0.25 dL]. We can notice improved visual effects as the resolution "
                "increases. [...] the particles actually move slower than expected if hbar < h. One possible solution "
                "is to multiply the advection velocity [...] with a scaling factor, e.g., h/hbar.'", draw,
                (*AVERAGED, DILUTE))
