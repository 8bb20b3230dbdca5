"""The figures that show objects in sand: 1 (butterfly), 9, 13, 14 and 16, each on the grid of Table 1."""

import numpy as np

from plot_objects import trenches
from plotting import ROOT, plt

from .common import kept
from .model import Claim, Figure, Outcome, Run

FINE = "particles={spacing: 0.25 cells}"
BUTTERFLY = Run("butterfly", "butterfly/scene.yaml", ("grid.cells=[256, 256]", "grid.spacing=7.8125 mm", FINE,
                                                      "time.frame_interval=1.46 s"))
TRAILS = Run("trails", "trails/scene.yaml", ("grid.cells=[256, 256]", "grid.spacing=3.90625 mm",
                                             "grid.origin=[0 m, -5 cm]",
                                             "sand.hbar={policy: constant, depth: 10 cells}", FINE,
                                             "time.frame_interval=200 ms"))
CARS = Run("cars", "cars/scene.yaml", ("grid.cells=[512, 256]", "grid.spacing=5 mm"))
WRITING = Run("writing", "writing/scene.yaml", ("grid.cells=[512, 256]", "grid.spacing=3.125 mm",
                                                "particles={spacing: 0.5 cells}", "time.frame_interval=2 s"))
BLADES = Run("blades", "blades/scene.yaml", (FINE, "time.frame_interval=500 ms"))
MOVES = "Particles move once a frame of the file, here {} ms: pictures show where they are, not each path."


def section(studio, axes, place, values, title):
    axes.plot(100 * place, 100 * values)
    axes.set(xlabel="[cm]", ylabel="surface since the start [cm]", title=title)


def butterfly(studio):
    pictures = [(studio.trace("butterfly", "drawn", "--show", "particles", "--view", -90, 55, times=[8.76]),
                 "The butterfly in particles, 8.8 s."),
                (studio.trace("butterfly", "flattening", "--view", -70, 45, times=[10.22]), "The block at 10.2 s."),
                (studio.trace("butterfly", "flattened", "--view", -90, 55), "At rest.")]
    with studio.series("butterfly") as series:
        before, after = (series.depth(frame).astype(float) for frame in (series.frame_at(8.76), -1))
        x, y = np.meshgrid(series.x, series.y)
        swept, kept_half = (x > 0.12) & (y > -0.55) & (y < 0.7), x < -0.2
        rough = [1e3 * field[swept].std() for field in (before, after)]
        moved = 1e3 * np.abs(after - before)[kept_half].max()
        report = series.report
    return Outcome(
        pictures=pictures,
        claims=[Claim("a butterfly is drawn with a stick",
                      f"surface of the right half: {rough[0]:.1f} mm rough (standard deviation)",
                      "more than 3 mm, of a bed of 60 mm", rough[0] > 3),
                Claim("'which is then flattened with a long wooden block'",
                      f"{rough[1]:.2f} mm rough behind the block; left half changed by {moved:.2f} mm at most",
                      "less than 2 % of what it was, and less than 1 mm at the left",
                      rough[1] < 0.02 * rough[0] and moved < 1),
                kept(report)],
        notes=["The drawing is ours (scenes/butterfly). " + MOVES.format(1460)])


def trails(studio):
    pictures = [(studio.trace("trails", "moving", times=[1.4]), "The three bodies at 1.4 s."),
                (studio.trace("trails", "particles", "--show", "particles", "--zoom", 1.2, "--no-objects"),
                 "Their trails at rest, in particles.")]
    surface = {"sphere": 0.125, "box": 0.16, "cone": 0.072}       # [m] widths of the bodies at the level of the bed
    with studio.series("trails") as series:
        column = int(np.argmin(np.abs(series.x - 0.5)))
        change = series.depth(-1)[:, column].astype(float) - series.depth(0)[:, column]
        found = sorted(trenches(series.y, change))                # from the cone at small y to the sphere
        figure, axes = plt.subplots(figsize=(8, 2.6))
        section(studio, axes, series.y, change, "Section across the trails at x = 50 cm")
        report = series.report
    widths = dict(zip(("cone", "box", "sphere"), (width for _, width, _ in found)))
    depths = [depth for _, _, depth in found]
    three = len(found) == 3
    off = max(abs(widths[name] / surface[name] - 1) for name in surface) if three else np.inf
    return Outcome(
        pictures=[*pictures, (studio.save(figure, "section.png"), "Across the trails.")],
        claims=[Claim("'different trails due to the different shapes of the rigid bodies'",
                      f"{len(found)} trails; widths "
                      + ", ".join(f"{name} {100 * width:.1f} cm" for name, width in widths.items())
                      + "; depths " + ", ".join(f"{100 * depth:.2f}" for depth in depths) + " cm",
                      "three trails, each as wide as its body at the level of the bed within 15 %",
                      three and off <= 0.15),
                kept(report)],
        notes=["Bodies and bed are those of scenes/trails (31 deg; Table 1: 30). " + MOVES.format(200)])


def car_gauge():
    """Distance between the middles of the wheels of scenes/cars/car.obj, at the scene's scale [m]."""
    points = np.array([line.split()[1:4] for line in (ROOT / "scenes/cars/car.obj").read_text().splitlines()
                       if line.startswith("v ")], dtype=float)
    low = points[points[:, 2] < points[:, 2].min() + 1e-6, 1]
    return 1.2 * float(low[low > 0].mean() - low[low < 0].mean())


def cars(studio):
    pictures = [(studio.trace("cars", "driving", "--view", -75, 38, times=[2]), "The cars at 2 s."),
                (studio.trace("cars", "tracks", "--view", -75, 50), "Their tracks at rest.")]
    with studio.series("cars") as series:
        column = int(np.argmin(np.abs(series.x - 1.3)))           # only the straight car has passed here: y = 67 cm
        change = series.depth(-1)[:, column].astype(float) - series.depth(0)[:, column]
        path = 0.45 + (1.3 - 0.25) * (0.875 - 0.45) / (2.25 - 0.25)
        grooves = [groove for groove in trenches(series.y, change) if abs(groove[0] - path) < 0.15]
        figure, axes = plt.subplots(figsize=(8, 2.6))
        section(studio, axes, series.y, change, "Section across the tracks at x = 1.3 m")
        report, spacing = series.report, series.spacing
    apart = grooves[-1][0] - grooves[0][0] if len(grooves) > 1 else float("nan")
    gauge = car_gauge() / np.cos(np.radians(12))
    return Outcome(
        pictures=[*pictures, (studio.save(figure, "section.png"), "Across the tracks of the straight car.")],
        claims=[Claim("'a psychological sand table with two moving cars' (a picture)",
                      f"{len(grooves)} grooves of the straight car, {100 * apart:.1f} cm apart, "
                      + ", ".join(f"{100 * depth:.1f}" for _, _, depth in grooves) + " cm deep; its wheels "
                      f"{100 * gauge:.1f} cm apart along y",
                      "two grooves, as far apart as the wheels within two cells",
                      len(grooves) == 2 and abs(apart - gauge) <= 2 * spacing),
                kept(report)],
        notes=["The other toys of the paper's table are left out; the wheels do not turn (scenes/cars)."])


def writing(studio):
    pictures = [(studio.trace("writing", "written", "--view", -90, 62), "Both characters at rest."),
                (studio.trace("writing", "particles", "--show", "particles", "--view", -90, 45),
                 "The same in particles.")]
    with studio.series("writing") as series:
        column = int(np.argmin(np.abs(series.x - 0.30)))
        change = series.depth(-1)[:, column].astype(float) - series.depth(0)[:, column]
        groove = min(trenches(series.y, change), key=lambda item: abs(item[0] - 0.6094))
        report, spacing = series.report, series.spacing
    _, width, depth = groove
    brush, tip = 0.02, 0.009                                       # [m] width, and depth of its tip
    widest = brush + 2 * tip / np.tan(np.radians(30)) + 2 * spacing
    return Outcome(
        pictures=pictures,
        claims=[Claim("'the stroke width is initialized to 5 times of the grid spacing'",
                      f"the first stroke: {1e3 * width:.0f} mm wide, {1e3 * depth:.1f} mm deep; the brush is 20 mm, "
                      f"{brush / spacing:.1f} cells of this grid",
                      "as wide as the brush, and at most by its sides at 30 deg "
                      f"wider ({1e3 * widest:.0f} mm); half as deep as its tip (9 mm) or deeper",
                      brush <= width <= widest and depth >= tip / 2),
                kept(report)],
        notes=["The brush is 5 cells of the scene's own grid (400 x 200). " + MOVES.format(2000)])


def blades(studio):
    pictures = [(studio.trace("blades", "turning", "--view", -60, 40, times=[2]), "The blades at 2 s."),
                (studio.trace("blades", "particles", "--show", "particles", "--view", -60, 40),
                 "At rest, in particles.")]
    with studio.series("blades") as series:
        depth = series.depth(-1).astype(float)
        x, y = np.meshgrid(series.x, series.y)
        r = np.hypot(x, y)
        edges = np.arange(0, 0.65, 0.02)
        middle = (edges[1:] + edges[:-1]) / 2
        mean = np.array([depth[(r >= a) & (r < b)].mean() for a, b in zip(edges, edges[1:])])
        trench = mean[(middle > 0.08) & (middle < 0.3)].mean()
        rim = mean[(middle > 0.38) & (middle < 0.5)].max()
        lowest = min(float(series.depth(frame).min()) for frame in range(series.frames))
        report, spacing = series.report, series.spacing
        figure, axes = plt.subplots(figsize=(8, 2.6))
        axes.plot(100 * middle, 100 * mean)
        axes.axhline(10, color="0.6", lw=0.8)
        axes.set(xlabel="distance from the axis [cm]", ylabel="mean depth [cm]", title="Depth at rest over rings")
    return Outcome(
        pictures=[*pictures, (studio.save(figure, "rings.png"), "A trench, and a ring about it.")],
        claims=[Claim("'interaction between rotating fan blades and the dry granular media' (a picture)",
                      f"mean depth {100 * trench:.1f} cm where the blades sweep, {100 * rim:.1f} cm in the ring about "
                      f"them; the lowest in any frame {100 * lowest:.2f} cm (bed 10, underside of the blades 6)",
                      "a trench more than 1 cm below the bed, a ring more than 1 cm above it, and nothing below the "
                      "blades",
                      trench < 0.09 and rim > 0.11 and lowest > 0.06 - 1e-6),
                kept(report)],
        notes=["The axis of the paper's blades is not given; these turn about the vertical. " + MOVES.format(500)])


TABLE = " Table 1: {}."
FIGURE_1B = Figure("1b", "Fig. 1, butterfly: drawn and flattened",
                   "'A butterfly is drawn with a wooden stick, which is then flattened by a long wooden block.'"
                   + TABLE.format("256 x 256, 1024 x 1024 particles, 30 deg, hbar of 10 cells"), butterfly,
                   (BUTTERFLY,))
FIGURE_9 = Figure("9", "Fig. 9: three trails",
                  "'three rigid bodies slide on the surface of a sand bed. We can notice different trails due to the "
                  "different shapes of the rigid bodies.'"
                  + TABLE.format("256 x 256, 1024 x 1024 particles, 30 deg, hbar of 10 cells"), trails, (TRAILS,))
FIGURE_13 = Figure("13", "Fig. 13: a sand table with two cars",
                   "'Figure 13 shows a psychological sand table with two moving cars.'"
                   + TABLE.format("512 x 256, 30 deg, hbar of 10 cells"), cars, (CARS,))
FIGURE_14 = Figure("14", "Fig. 14: writing in sand",
                   "'The painting stroke is interpolated with the latest two input points and the stroke width is "
                   "initialized to 5 times of the grid spacing. [...] we simply consider the interaction as a "
                   "cylinder.'"
                   + TABLE.format("512 x 256, 1024 x 512 particles, 30 deg, hbar of 10 cells, steps of 2 ms"),
                   writing, (WRITING,))
FIGURE_16 = Figure("16", "Fig. 16: rotating blades",
                   "'Figure 16 shows the interaction between rotating fan blades and the dry granular media.'"
                   + TABLE.format("128 x 128, 512 x 512 particles, 30 deg, hbar of 10 cells"), blades, (BLADES,))
