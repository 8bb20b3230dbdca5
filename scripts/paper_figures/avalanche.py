"""Figure 1 (left) and 17: a snow avalanche."""

import numpy as np

from plotting import plt

from . import table1
from .common import FRAME, VOLUME
from .model import Claim, Figure, Outcome, Run

FRICTION = 20.0                        # [deg] as in Table 1
WITHIN = 3.0                           # [deg] that inner dissipation may add to the angle of the mass's way
RELEASE = Run("avalanche", "avalanche/scene.yaml")


def centre(series, frame):
    """Centre of mass of the snow, (x, y, z) [m]."""
    depth = series.depth(frame).astype(float)
    x, y = np.meshgrid(series.x, series.y)
    places = np.stack([x, y, series.bed + depth / 2])
    return (places * depth).sum(axis=(1, 2)) / depth.sum()


def travelled(series):
    """Horizontal way of the centre of mass, frame by frame [m], and how far it has come down in all [m]."""
    centres = np.array([centre(series, frame) for frame in range(series.frames)])
    return float(np.hypot(*np.diff(centres[:, :2], axis=0).T).sum()), float(centres[0, 2] - centres[-1, 2])


def draw_map(studio):
    with studio.series("avalanche") as series:
        figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6))
        for time, colour in ((0, "C0"), (8, "C1"), (16, "C2"), (24, "C3"), (series.time[-1], "C5")):
            frame = series.frame_at(time)
            left.contour(series.x, series.y, series.depth(frame), [0.2], colors=colour)
            left.plot([], [], color=colour, label=f"t = {series.time[frame]:.0f} s")
        left.contour(series.x, series.y, series.bed, 20, colors="0.6", linewidths=0.5)
        left.set(xlabel="x [m]", ylabel="y [m]", title="Where the snow is deeper than 0.2 m (0.1 dL)", aspect="equal")
        left.legend(loc="lower right")
        right.plot(series.time, series.numbers["kinetic_energy"] / 1e6,
                   label="kinetic energy / density [10$^6$ m$^5$/s$^2$]")
        right.plot(series.time, series.numbers["max_speed"], label="largest speed [m/s]")
        right.set(xlabel="t [s]", title="Energy and speed")
        right.legend()
        way, drop = travelled(series)
        return studio.save(figure, "avalanche.png"), way, drop, series.report


def judged(way, drop, report):
    angle = float(np.degrees(np.arctan2(drop, way)))
    return [Claim("a snow avalanche of friction angle 20 deg",
                  f"the centre of mass comes down {drop:.0f} m on a way of {way:.0f} m: {angle:.1f} deg",
                  f"Coulomb friction takes g mu a metre of way, so the angle is {FRICTION:g} deg or more, and at most "
                  f"{WITHIN:g} deg more (what collides and is turned aside)", FRICTION <= angle <= FRICTION + WITHIN),
            Claim("(not stated) volume is kept", f"error {abs(report['volume_error']):.1e}, nothing but snow leaves",
                  f"at most {VOLUME:g}", abs(report["volume_error"]) <= VOLUME)]


def film(studio, name, times, view):
    """The avalanche at some moments, two in a row."""
    parts = [studio.trace("avalanche", f"part{time}", "--sand", "snow", "--view", *view, "--zoom", 1.08, "--size",
                          "640x400",
                          times=[time]) for time in times]
    return studio.beside(parts, f"{name}.jpg", 2), "t = " + ", ".join(f"{time:g}" for time in times) + " s"


def in_real_time(studio):
    """Whether the device that is fastest on this avalanche (Table 1) keeps up with it."""
    row, found = table1.ROWS[0], {}
    for device in table1.devices():
        found[device] = table1.read(studio, row, device)
    best = min(found, key=lambda device: table1.times(found[device])["t_d"][0])
    milliseconds, report = table1.times(found[best])["t_d"][0], found[best]
    return Claim("'able to simulate large-scale dry granular media in real-time'; Table 1: 20 ms a frame (GTX 1060)",
                 f"{milliseconds:.0f} ms a frame of 1/30 s on {best}, "
                 f"{report['steps'] * FRAME / report['simulated_time']:.1f} steps a frame, over the first {row.end:g} "
                 f"s",
                 "less than 1/30 s a frame on the fastest device of this page", milliseconds < 1e3 * FRAME,
                 f"the paper's terrain, scale and steps a frame are not given. {table1.busy_note(studio, 'table_')}")


def draw_first(studio):
    pictures = [film(studio, "avalanche", (4, 14), (8, 30))]
    drawing, way, drop, report = draw_map(studio)
    return Outcome(pictures=[*pictures, (drawing, "Outlines of the snow, its energy and its largest speed.")],
                   claims=judged(way, drop, report),
                   notes=["The mountain is ours (`scripts/make_avalanche.py`): 1 km x 1 km in cells of 2 m, a slab of "
                          "3 m on a side of 34 deg."])


def draw_last(studio):
    pictures = [film(studio, "runout", (0, 8, 18, 60), (-40, 30))]
    with studio.series("avalanche") as series:
        way, drop = travelled(series)
        energy = series.numbers["kinetic_energy"]
        return Outcome(pictures=pictures, claims=[*judged(way, drop, series.report), in_real_time(studio)],
                       notes=["The run of Fig. 1 seen from the side: the paper shows its avalanche twice.",
                              f"At {series.time[-1]:g} s {100 * energy[-1] / energy.max():.2g} % of the largest "
                              f"kinetic energy is left: thin snow still creeps down the gullies."])


FIGURE_1A = Figure("1a", "Fig. 1, avalanche: snow on a mountain side",
                   "'we simulate a snow avalanche whose friction angle is set to 20 deg. We reconstruct the snow "
                   "surface [...] for an iso-value of h = 0.1 dL.' Table 1: 512 x 512, hbar = h, C = 0.1, t_d = 20 ms.",
                   draw_first, (RELEASE,))
FIGURE_17 = Figure("17", "Fig. 17: the avalanche runs out",
                   "'A snow avalanche. Our method is able to simulate large-scale dry granular media in real-time.'",
                   draw_last, lambda: (RELEASE, *[table1.timed(table1.ROWS[0], device) for device in table1.devices()]))
