"""Runs POV-Ray without a display: a scene in, a picture out."""

import shutil
import subprocess

import matplotlib.pyplot as plt
import numpy as np


class RenderError(Exception):
    """POV-Ray refused a scene."""


def require(program, purpose):
    """Ends with what to install if a program is not there; its package has the same name."""
    if shutil.which(program) is None:
        raise SystemExit(f"error: {program} is missing, which {purpose}. Install it: sudo apt-get install {program}")


def trace(folder, name, scene, size, options=(), threads=None):
    """The picture of a scene: (height, width, 3) uint8. Files that it names lie in the folder; NAME.* are removed."""
    width, height = size
    (folder / f"{name}.pov").write_text(scene)
    command = ["povray", f"+I{name}.pov", f"+O{name}.png", "+FN", f"+W{width}", f"+H{height}", "-D", "-GA", "+GF",
               *options]
    if threads:
        command.append(f"+WT{threads}")
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        said = [line for line in (done.stdout + done.stderr).splitlines() if "error" in line.lower()]
        raise RenderError("POV-Ray: " + ("; ".join(said) or f"it ended with {done.returncode}"))
    picture = np.round(255 * plt.imread(folder / f"{name}.png")[..., :3]).astype(np.uint8)
    for file in folder.glob(f"{name}.*"):          # a movie of many particles would fill the disk
        file.unlink()
    return picture


def write_pgm(path, heights, low, high):
    """A height field of 16 bits, its first row at the largest y, as POV-Ray wants it. (y, x) -> PGM"""
    levels = np.round((heights[::-1] - low) / (high - low) * 65535).astype(">u2")
    path.write_bytes(b"P5\n%d %d\n65535\n" % levels.shape[::-1] + levels.tobytes())


def write_ppm(path, colours):
    """Colours in 0..1, their first row at the largest y. (y, x, 3) -> PPM"""
    pixels = np.round(255 * np.clip(colours[::-1], 0, 1)).astype(np.uint8)
    path.write_bytes(b"P6\n%d %d\n255\n" % pixels.shape[1::-1] + pixels.tobytes())
