"""What a figure draws with: its results, its folder, and the ray tracer where there is one."""

import shutil
import subprocess

from PIL import Image

from plotting import ROOT, plt
from sandsim_series import Series

RENDER = ROOT / "scripts/render"
JPEG_QUALITY = 88
GAP = 6                        # [pixels] between pictures side by side


class DrawingFailed(Exception):
    """A program that draws ended with an error. The message is its own."""


class Studio:
    """Given to Figure.draw. Pictures go to `folder`; what was missing is kept in `missing`."""

    def __init__(self, figure, runs, folder):
        self.figure, self.folder, self.missing = figure, folder, []
        self._runs = runs
        self._by_name = {run.name: run for run in figure.planned}
        folder.mkdir(parents=True, exist_ok=True)

    @staticmethod
    def tools():
        """What is there to draw with, as part of a figure's hash."""
        renderer = [path.read_bytes() for path in sorted((ROOT / "scripts").glob("render*"))]
        return [f"povray: {shutil.which('povray') is not None}", *renderer]

    def result(self, name):
        """The folder of one of the figure's runs."""
        return self._runs.result(self._by_name[name])

    def series(self, name):
        """A Series of one of the figure's runs."""
        return Series(self.result(name))

    def save(self, figure, name, dpi=110):
        """Writes a matplotlib figure; returns its file name."""
        figure.savefig(self.folder / name, dpi=dpi)
        plt.close(figure)
        return name

    def trace(self, run, name, *options, times=()):
        """A ray-traced picture of a run, or without POV-Ray a shaded relief from above. Returns its file name."""
        result, drawn = self.result(run), self.folder / f"{name}.png"
        times = ["--time", *map(str, times)] if times else []
        if shutil.which("povray"):
            command = [str(RENDER), str(result), "-o", str(drawn), *times, *map(str, options)]
        else:
            self._miss("povray (apt-get install povray): pictures of the scenes are shaded reliefs from above instead")
            command = ["/usr/bin/python3", str(ROOT / "scripts/plot_relief.py"), str(result), "-o", str(drawn), *times]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise DrawingFailed(f"{' '.join(command)}\n{done.stderr.strip()}")
        Image.open(drawn).convert("RGB").save(drawn.with_suffix(".jpg"), quality=JPEG_QUALITY)
        drawn.unlink()
        return f"{name}.jpg"

    def beside(self, names, name, columns):
        """One picture of several of the same size, left to right and down; they go. Returns its file name."""
        parts = [Image.open(self.folder / part) for part in names]
        width, height = parts[0].size
        whole = Image.new("RGB", (columns * (width + GAP) - GAP, -(-len(parts) // columns) * (height + GAP) - GAP),
                          "white")
        for number, part in enumerate(parts):
            row, column = divmod(number, columns)
            whole.paste(part, (column * (width + GAP), row * (height + GAP)))
        whole.save(self.folder / name, quality=JPEG_QUALITY)
        for part in names:
            (self.folder / part).unlink()
        return name

    def _miss(self, text):
        if text not in self.missing:
            self.missing.append(text)
