"""What the plots share: their look, their command line, running a scene, and writing a picture."""

import argparse
import json
import os
import subprocess
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.colors import LightSource, LinearSegmentedColormap  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
SAND = LinearSegmentedColormap.from_list("sand", ["#f5e6c4", "#e3b96f", "#b9782f", "#6e3b12"])
BARE = "#9aa0a6"
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


def shaded(surface, depth, spacing, largest, exaggeration, dry):
    """An RGB picture (y, x, 3) of a height field: sand coloured by depth, bare ground grey, lit from north-west."""
    colours = SAND(depth / largest if largest > 0 else depth)[..., :3]
    colours[depth <= dry] = matplotlib.colors.to_rgb(BARE)
    light = LightSource(azdeg=315, altdeg=40)
    return light.shade_rgb(colours, surface, blend_mode="soft", vert_exag=exaggeration, dx=spacing, dy=spacing)


def show_field(axes, series, frame, largest=None, exaggeration=1.0, dry=None):
    """A shaded map of one frame; returns the picture and the colour scale of its depth."""
    depth = series.depth(frame).astype(float)
    largest = float(depth.max()) if largest is None else largest
    dry = 1e-3 * series.spacing if dry is None else dry
    picture = shaded(series.surface(frame).astype(float), depth, series.spacing, largest, exaggeration, dry)
    image = axes.imshow(picture, origin="lower", extent=series.extent, interpolation="nearest")
    axes.set(xlabel="x [m]", ylabel="y [m]")
    axes.grid(False)
    return image, plt.cm.ScalarMappable(plt.Normalize(0, largest), SAND)
