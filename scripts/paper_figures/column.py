"""Figure 15: a tall column with 50 layers of particles, and where a height field ceases to do."""

import numpy as np

from plotting import plt

from .common import kept, per_frame
from .model import Claim, Figure, Outcome, Run

RADIUS = 0.05                                     # [m]
ASPECTS = (0.5, 1, 2, 3)                          # height over radius
LOW = 1                                           # aspect ratios up to here count as shallow
FRONT = RADIUS / 40                               # [m] of sand: thinner is no front, as 5 mm in scenes/column_collapse
MOMENTS = (0.02, 0.06, 0.14)                          # [s] of the pictures
POLICIES = {"constant": ("hbar of 10 cells", ()),
            "truncated": ("hbar = min(0.8 h, R0/4)", ("sand.hbar={policy: truncated, scale: 0.8, cap: 1.25 cm}",))}
FILM = Run("tall_column", "tall_column/scene.yaml")
COLUMNS = {(policy, aspect): Run(f"column_{policy}_a{aspect:g}", "tall_column/scene.yaml",
                                 ("particles=", f"sand.initial.depth={100 * RADIUS * aspect:g} cm", *settings))
           for policy, (_, settings) in POLICIES.items() for aspect in ASPECTS}


def measured_runout(aspect):
    """(R - R0)/R0 of round columns: Lube, Huppert, Sparks and Hallworth 2004."""
    return 1.24 * aspect if aspect < 1.7 else 1.6 * np.sqrt(aspect)


def runout(series):
    """(R - R0)/R0, with R where the sand gets thinner than FRONT, the mean over the four half axes."""
    depth = series.depth(-1).astype(float)
    middle = series.x.size // 2
    fronts = []
    for ray, place in ((depth[middle], series.x), (depth[:, middle], series.y)):
        for side in (1, -1):
            r, h = np.abs(place[middle:] if side > 0 else place[:middle][::-1]), \
                   ray[middle:] if side > 0 else ray[:middle][::-1]
            last = np.flatnonzero(h > FRONT)[-1]
            if last + 1 == r.size:
                fronts.append(r[-1])
            else:
                fronts.append(r[last] + (h[last] - FRONT) / (h[last] - h[last + 1]) * (r[last + 1] - r[last]))
    return float(np.mean(fronts)) / RADIUS - 1


def draw_columns(studio):
    """Deposits and runouts of all columns; returns the picture, relative differences from experiments, and a table."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6))
    off, rows = {}, []
    for policy, mark in zip(POLICIES, "ox"):
        found = []
        for number, aspect in enumerate(ASPECTS):
            with studio.series(COLUMNS[policy, aspect].name) as series:
                found.append(runout(series))
                left.plot(100 * series.x, 100 * series.depth(-1)[series.y.size // 2], "-" if mark == "o" else ":",
                          color=f"C{number}", label=f"a = {aspect:g}" if mark == "o" else None)
        off[policy] = [value / measured_runout(aspect) - 1 for aspect, value in zip(ASPECTS, found)]
        right.plot(ASPECTS, found, mark, label=POLICIES[policy][0])
        rows += [[POLICIES[policy][0], f"{aspect:g}", f"{value:.2f}", f"{measured_runout(aspect):.2f}",
                  f"{100 * error:+.0f} %"]
                 for aspect, value, error in zip(ASPECTS, found, off[policy])]
    left.set(xlabel="x [cm]", ylabel="depth [cm]", title=f"Deposits; dotted: {POLICIES['truncated'][0]}")
    left.legend()
    line = np.linspace(0.1, ASPECTS[-1], 100)
    right.plot(line, [measured_runout(aspect) for aspect in line], "k", label="measured columns (Lube et al. 2004)")
    right.set(xlabel="height over radius a", ylabel="runout (R - R0)/R0", title=f"Runout, h > {1e3 * FRONT:g} mm")
    right.legend()
    return studio.save(figure, "columns.png"), off, rows


def draw(studio):
    parts = [studio.trace("tall_column", f"part{number}", "--show", "particles", "--zoom", 1.5, "--size", "440x330",
                          times=[time]) for number, time in enumerate(MOMENTS)]
    film = (studio.beside(parts, "column.jpg", len(parts)), "Particles at "
            + ", ".join(f"{time:g}" for time in MOMENTS) + " s.")
    drawing, off, rows = draw_columns(studio)
    low = [value for aspect, value in zip(ASPECTS, off["constant"]) if aspect <= LOW]
    with studio.series("tall_column") as series:
        report = series.report
    particles, solver = per_frame(report, "particles"), per_frame(report, "step")
    return Outcome(
        pictures=[film, (drawing, "Deposits and runouts of four columns.")],
        claims=[Claim("the assumption 'works quite well for granular flows whose vertical length scale is smaller than "
                      "the horizontal length scale'", f"runout against measured columns for a = 0.5 and {LOW}: "
                      + ", ".join(f"{100 * value:+.0f} %" for value in low),
                      "within 20 %", max(map(abs, low)) <= 0.2),
                Claim("'if the vertical length is much larger, certain kind of mismatch could arise', as in Fig. 15",
                      f"a = 2 and {ASPECTS[-1]}: " + ", ".join(f"{100 * value:+.0f} %"
                                                               for value in off["constant"][2:]),
                      "both run more than 25 % too far", min(off["constant"][2:]) > 0.25),
                Claim("'this can always be improved by adjusting the value of hbar'",
                      f"with {POLICIES['truncated'][0]}: " + ", ".join(f"{100 * value:+.0f} %"
                                                                       for value in off["truncated"]),
                      "the largest difference is smaller than with hbar of 10 cells",
                      max(map(abs, off["truncated"])) < max(map(abs, off["constant"])),
                      "the cap was chosen for this; no rule gives it"),
                Claim("50 layers of particles cost 65 ms a frame, the equations less than 1 ms (GTX 1060)",
                      f"{report['particles']['count']} particles: {particles:.0f} ms, equations {solver:.1f} ms a "
                      f"frame of 1/30 s on {report['device']} ({report['threads']} threads)",
                      "the particles cost more than ten times what the equations do, as in the paper",
                      particles > 10 * solver, "particles move once a frame here, the equations in steps"),
                kept(report)],
        tables=[("", ["hbar", "a", "runout (R - R0)/R0", "measured columns", "difference"], rows)],
        notes=["The left half of the paper's figure, Narain et al.'s 3-D solver, is not part of this project: only the "
               "paper's own side is made.",
               "1.6 sqrt(a) beyond a = 1.7 is quoted from the literature without its tables at hand; it meets 1.24 a "
               "there."])


FIGURE = Figure("15", "Fig. 15: a tall column in particles",
                "'A comparison between the simulation results produced by our method (right) and Narain et al.'s "
                "method'; 'the simulation result [...] is quite similar'; and under limitations: 'if the vertical "
                "length is much larger, certain kind of mismatch could arise during the simulation, as shown in Figure "
                "15'. Table 1: 64 x 64, 128 x 128 x 50 particles, 30 deg, hbar of 10 cells.", draw,
                (FILM, *COLUMNS.values()))
