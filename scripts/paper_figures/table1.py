"""Table 1: what the equations, the objects and the particles cost, a frame and a step, on each device at hand."""

import functools
import json
import math
import os
import subprocess
from dataclasses import dataclass

import yaml

from plotting import ROOT, plt, sandsim

from .common import FRAME, stage
from .model import Claim, Figure, Outcome, Run
from .runs import BUSY

PARTICLES = 0.25                        # [cells] of 1024 x 1024 particles on 256 x 256 cells


@dataclass(frozen=True)
class Row:
    """A row of the paper's table, and the run that stands for it: its first `end` seconds."""
    figure: str
    scene: str
    settings: tuple
    end: float                          # [s]
    hbar: str
    step: str                           # the paper's
    paper: tuple                        # t_d, t_i, t_p [ms], as printed


def grid(cells, spacing, *more):
    return (f"grid.cells={cells}", f"grid.spacing={spacing}", *more)


def sparkling(cells):
    return f"particles={{spacing: {cells:g} cells}}"


ROWS = (
    Row("1, avalanche", "avalanche", (), 10, "h", "C = 0.1", ("20", "-", "-")),
    Row("1, butterfly", "butterfly", grid("[256, 256]", "7.8125 mm", sparkling(0.25)), 0.5, "10", "C = 0.1",
        ("4.8", "4.1", "70")),
    Row("5, 30 deg", "piles/scene_30deg", (), 8, "5", "0.01 s", ("< 1", "-", "-")),
    Row("6, hbar 10", "hbar", (), 0.4, "10", "0.01 s", ("1.6", "-", "-")),
    Row("6, hbar 40", "hbar", ("sand.hbar.depth=40 cells",), 0.4, "40", "0.01 s", ("1.6", "-", "-")),
    Row("9", "trails", grid("[256, 256]", "3.90625 mm", "grid.origin=[0 m, -5 cm]",
                            "sand.hbar={policy: constant, depth: 10 cells}", sparkling(0.25)), 0.5, "10", "C = 0.1",
        ("4.8", "3.8", "11")),
    Row("13", "cars", grid("[512, 256]", "5 mm"), 0.5, "10", "C = 0.1", ("10.3", "5.8", "-")),
    Row("14", "writing", grid("[512, 256]", "3.125 mm", sparkling(0.5)), 0.5, "10", "0.002 s", ("5.1", "4.1", "9")),
    Row("15 (b)", "tall_column", (), 0.3, "10", "C = 0.1", ("< 1", "-", "65")),
    Row("16", "blades", (sparkling(0.25),), 1, "10", "C = 0.1", ("1.6", "1.2", "17")))


@functools.cache
def devices():
    """{name: options of sandsim run} for what there is to run on."""
    threads = len(os.sched_getaffinity(0))
    found = {"cpu, 1 thread": ("--device", "cpu", "--threads", "1")}
    if threads > 1:
        found[f"cpu, {threads} threads"] = ("--device", "cpu", "--threads", str(threads))
    if shows_cuda(subprocess.run([sandsim(), "devices"], capture_output=True, text=True).stdout):
        found["cuda"] = ("--device", "cuda")
    return found


def shows_cuda(listing):
    """Whether `sandsim devices` lists a CUDA device, rather than the reason why there is none."""
    return any(line.startswith("cuda ") and "compute capability" in line for line in listing.splitlines())


def early_objects(scene, end):
    """--set that leaves out objects which come after the end [s]: the program takes them for a mistake."""
    objects = yaml.safe_load((ROOT / "scenes" / scene).read_text()).get("objects", [])
    early = [item for item in objects if float(item.get("start", "0 s").removesuffix(" s")) < end]
    return () if len(early) == len(objects) else (f"objects={json.dumps(early)}",)


def timed(row, device):
    scene = f"{row.scene}.yaml" if "/" in row.scene else f"{row.scene}/scene.yaml"
    name = row.figure.split("(")[0].strip().replace(", ", "_").replace(" ", "")
    settings = (*row.settings, *early_objects(scene, row.end), f"time.end={row.end:g} s",
                "time.frame_interval=33.333333 ms", "time.stop_at_rest=false")
    return Run(f"table_{name}_{device.replace(', ', '_').replace(' ', '')}", scene, settings, devices()[device],
               timed=True)


def runs():
    return tuple(timed(row, device) for row in ROWS for device in devices())


def times(report):
    """{stage: (ms a frame, ms a step)} of what the scene has; particles move once a frame."""
    frames, steps = report["simulated_time"] / FRAME, report["steps"]
    names = [("t_d", "step"), ("t_i", "objects"), ("t_p", "particles")]
    return {short: (1e3 * stage(report, name) / frames, 1e3 * stage(report, name) / steps) for short, name in names
            if any(entry["name"] == name for entry in report["stages"])}


def grid_of(report, row):
    """512 x 256, from the row's settings; scenes that are used as they are have square grids."""
    chosen = next((setting for setting in row.settings if setting.startswith("grid.cells=")), None)
    side = math.isqrt(report["cells"])
    return chosen.split("=")[1].strip("[]").replace(", ", " x ") if chosen else f"{side} x {side}"


def read(studio, row, device):
    return json.loads((studio.result(timed(row, device).name) / "run.json").read_text())


def busy_note(studio, prefix=""):
    """How busy other programs kept the machine before the figure's timed runs, in a sentence."""
    most = max(float((studio.result(run.name) / BUSY).read_text()) for run in studio.figure.planned
               if run.name.startswith(prefix))
    return f"Before the timed runs other programs kept up to {most:.1f} processors busy."


def text(value):
    return "-" if value is None else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def draw(studio):
    table, measured = [], {}
    for row in ROWS:
        for device in devices():
            report = read(studio, row, device)
            found = measured[row, device] = times(report)
            frame = [text(found.get(short, (None,))[0]) for short in ("t_d", "t_i", "t_p")]
            step = [text(found.get(short, (None, None))[1]) for short in ("t_d", "t_i")]
            particles = report.get("particles")
            table.append([row.figure, grid_of(report, row), str(particles["count"]) if particles else "-", row.hbar,
                          device,
                          f"{1e3 * report['simulated_time'] / report['steps']:.2f}",
                          f"{report['steps'] * FRAME / report['simulated_time']:.1f}", " / ".join(frame),
                          " / ".join(step),
                          row.step, " / ".join(row.paper)])
    return Outcome(pictures=[(picture(studio, measured), "Milliseconds a frame of 1/30 s, beside the paper's.")],
                   claims=claims(measured),
                   tables=[("Times are the stages of run.json on the clock, over the first seconds of each scene (0.3 "
                            "to 10 "
                            "s); a frame is 1/30 s of simulated time. t_p is for one move of all particles a frame.",
                            ["figure", "grid", "particles", "hbar [cells]", "device", "mean step [ms]", "steps a frame",
                             "t_d / t_i / t_p [ms a frame]", "t_d / t_i [ms a step]", "paper: step",
                             "paper: t_d / t_i / t_p [ms a frame]"], table)],
                   notes=["The paper's times are from a GTX 1060, and its steps in a frame are not given, so that its "
                          "times "
                          "and these cannot be divided by each other.",
                          busy_note(studio) + " On a busy machine all times are too long, and those of several threads "
                          "many times so: each step waits for the last one."])


def claims(measured):
    result = []
    for device in devices():
        within = [row.figure for row in ROWS if sum(frame for frame, _ in measured[row, device].values()) < 1e3 * FRAME]
        result.append(Claim("'real time' (t_d + t_i + t_p of the paper: 1 to 79 ms a frame)",
                            f"{device}: {len(within)} of {len(ROWS)} scenes ({'; '.join(within) or 'none'})",
                            "the sum is less than 1/30 s a frame, for every scene", len(within) == len(ROWS),
                            "" if len(within) == len(ROWS) else "the paper's own butterfly (79 ms) is not either"))
        ratios = {row.figure: measured[row, device]["t_p"][0] / measured[row, device]["t_d"][0] for row in ROWS
                  if sparkling(PARTICLES) in row.settings and "[256, 256]" in "".join(row.settings)}
        result.append(Claim("(not stated) 1024 x 1024 particles on 256 x 256 cells cost less than the equations",
                            f"{device}: t_p is " + ", ".join(f"{value:.2f} ({name})" for name, value in ratios.items())
                            + " of t_d", "below 1 on a CPU, below 0.1 on a GPU",
                            max(ratios.values()) < (0.1 if device == "cuda" else 1)))
    return result


def picture(studio, measured):
    figure, axes = plt.subplots(figsize=(10, 4))
    width = 0.8 / (len(devices()) + 1)
    for number, device in enumerate([*devices(), "the paper's GTX 1060"]):
        low = [0.0] * len(ROWS)
        for short, shade in (("t_d", 1), ("t_i", 0.6), ("t_p", 0.3)):
            if device in devices():
                high = [measured[row, device].get(short, (0,))[0] for row in ROWS]
            else:
                high = [float(row.paper["dip".index(short[-1])].strip("< ").replace("-", "0")) for row in ROWS]
            axes.bar([place + number * width for place in range(len(ROWS))], high, width * 0.9, bottom=low, alpha=shade,
                     color=f"C{number}", label=f"{device}: {short}")
            low = [a + b for a, b in zip(low, high)]
    axes.axhline(1e3 * FRAME, color="0.5", lw=0.8)
    axes.set(yscale="log", ylabel="ms a frame of 1/30 s", ylim=(0.1, None))
    axes.set_xticks([place + 0.3 for place in range(len(ROWS))], [row.figure for row in ROWS], rotation=20)
    axes.legend(ncols=2, fontsize=6)
    return studio.save(figure, "table1.png")


FIGURE = Figure("table1", "Table 1: times",
                "'Statistics and timings per frame of our examples': t_d for the equations, t_i for fluid-solid "
                "interactions, t_p for particle tracking, in CUDA on an NVIDIA GTX 1060.", draw, runs)
