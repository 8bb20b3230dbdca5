"""What the plots share: their look, their command line, running a scene, and writing a picture."""

import argparse
import json
import os
import subprocess
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
SAND = LinearSegmentedColormap.from_list("sand", ["#fbefd2", "#ecc986", "#cf9048", "#96571f"])
BARE = "#a9adb2"
LIGHT = np.radians(45)           # height of the light above the horizon
COLOURS = ["#1f5fa8", "#d1722a", "#3f8f4f", "#a23b72", "#6b5b95", "#8a8a3a"]

plt.rcParams.update({
    "figure.dpi": 120, "savefig.dpi": 120, "font.size": 9, "axes.titlesize": 10, "axes.labelsize": 9,
    "legend.fontsize": 7.5, "legend.frameon": False, "axes.grid": True, "grid.alpha": 0.25,
    "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.4,
    "axes.prop_cycle": plt.cycler(color=COLOURS), "figure.constrained_layout.use": True,
})


def arguments(description, result=True):
    """A parser with the options that all plots have."""
    parser = argparse.ArgumentParser(description=description)
    if result:
        parser.add_argument("result", type=Path, help="result folder or series.h5")
    parser.add_argument("-o", "--output", type=Path, help="picture to write (default: beside the result)")
    return parser


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    plt.close(figure)
    print(path)


def sandsim():
    """The program: $SANDSIM, or what scripts/run has built."""
    return os.environ.get("SANDSIM", str(ROOT / "build/release/bin/sandsim"))


def run(scene, output, settings=(), reuse=False, options=()):
    """Runs a scene into a folder with --set for each setting; returns its report (run.json)."""
    report = Path(output) / "run.json"
    if not (reuse and report.is_file()):
        command = [sandsim(), "run", str(scene), "-o", str(output), "--overwrite", "-q", *options]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True)
    return json.loads(report.read_text())


def lit(colours, surface, spacing, exaggeration=1.0):
    """An RGB picture (y, x, 3) lit from the north-west by the slopes of a surface. Level ground keeps its colour."""
    rise_y, rise_x = np.gradient(exaggeration * surface, spacing)
    towards_light = np.cos(LIGHT) / np.sqrt(2)
    shade = (rise_x - rise_y) * towards_light / np.sin(LIGHT) + 1
    shade = shade / np.sqrt(1 + rise_x**2 + rise_y**2)
    shade = np.clip(1 + 0.6 * (shade - 1), 0.5, 1.3)[..., None]     # softer than Lambert's law
    return np.where(shade < 1, colours * shade, colours + (1 - colours) * (shade - 1))


def shaded(surface, depth, spacing, largest, exaggeration=1.0):
    """A lit picture of a height field: sand coloured by its depth, ground grey.

    Level ground has the colour of the colour bar. Sand below half a percent of the scale is drawn as ground.
    """
    colours = SAND(depth / largest if largest > 0 else depth)[..., :3]
    colours[depth <= 0.005 * largest] = matplotlib.colors.to_rgb(BARE)
    return lit(colours, surface, spacing, exaggeration)


def show_field(axes, series, frame, largest=None, exaggeration=1.0):
    """A shaded map of one frame; returns the picture and the colour scale of its depth."""
    depth = series.depth(frame).astype(float)
    largest = float(depth.max()) if largest is None else largest
    picture = shaded(series.surface(frame).astype(float), depth, series.spacing, largest, exaggeration)
    image = axes.imshow(picture, origin="lower", extent=series.extent, interpolation="nearest")
    if np.ptp(series.bed) > 0:
        axes.contour(series.x, series.y, series.bed, 15, colors="k", linewidths=0.35, alpha=0.5)
    axes.set(xlabel="x [m]", ylabel="y [m]")
    axes.grid(False)
    return image, plt.cm.ScalarMappable(plt.Normalize(0, largest), SAND)
