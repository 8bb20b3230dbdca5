"""What a figure draws with: its results, its folder, and the ray tracer where there is one."""

import shutil
import subprocess

from plotting import ROOT, plt
from sandsim_series import Series

RENDER = ROOT / "scripts/render"


class Studio:
    """Given to Figure.draw. Pictures go to `folder`; what was missing is kept in `missing`."""

    def __init__(self, figure, runs, folder):
        self.figure, self.folder, self.missing = figure, folder, []
        self._runs = runs
        self._by_name = {run.name: run for run in figure.runs}
        folder.mkdir(parents=True, exist_ok=True)

    @staticmethod
    def tools():
        """What is there to draw with, as part of a figure's hash."""
        return [f"{tool}: {shutil.which(tool) is not None}" for tool in ("povray", "ffmpeg")]

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

    def script(self, script, *arguments):
        """Calls one of the plot scripts; returns what it prints."""
        command = ["/usr/bin/python3", str(ROOT / "scripts" / script), *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout
