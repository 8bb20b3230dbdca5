"""Reads what sandsim leaves behind. The one module that knows the files: series.h5, run.json, summary.h5.

    series = Series("results/flume")          # a result folder, a series.h5 or a series.h5.partial
    series.time, series.x, series.y           # [s], [m], [m]
    series.depth(-1)                          # (y, x) [m], the last frame
    series.numbers["kinetic_energy"]          # one value a frame
    series.report["volume_error"]             # run.json
    Summary("results/sweep")["runout"]        # a sweep: one value a case
"""

import json
from pathlib import Path

import h5py
import numpy as np
import yaml

NAMES = ("series.h5", "series.h5.partial")
NUMBERS = ("volume", "kinetic_energy", "max_speed", "time_step_min", "time_step_max", "steps", "wall_time",
           "moving_cells")
OVER_TIME = (*NUMBERS, "front", "reference_tip")


class Series:
    """A run's series of frames, read frame by frame on request. Also a context manager."""

    def __init__(self, path):
        path = Path(path)
        self.file = next((path / name for name in NAMES if (path / name).is_file()), None) if path.is_dir() else path
        if self.file is None or not self.file.is_file():
            raise FileNotFoundError(f"{path}: no {' or '.join(NAMES)} here")
        self.directory = self.file.parent
        self._h5 = _open(self.file)
        time = self._h5["time"][:]
        # `time` is written last: a frame without one was cut short.
        self.frames = int(np.count_nonzero(np.isfinite(time)))
        self.time = time[:self.frames]                      # [s]
        self.x = self._h5["x"][:]                           # [m] cell centres
        self.y = self._h5["y"][:]                           # [m] cell centres
        self.bed = self._static("bed", 0.0)                 # (y, x) [m]
        self.max_depth = self._static("max_depth")          # (y, x) [m], None without output.maxima
        self.max_speed = self._static("max_speed_over_time")  # (y, x) [m/s]
        self.max_pressure = self._static("max_pressure")    # (y, x) [Pa], None unless it was asked for
        self.arrival_time = self._static("arrival_time")    # (y, x) [s], NaN: never
        self.front_depths = self._read("front_depth")       # [m] thresholds that define the front
        self.fronts = self._read("front")                   # (time, front_depth) [m]
        self.reference_tip = self._read("reference_tip")    # (time) [m] exact tip
        self.probe_names = [_text(name) for name in self._read("probe_name", ())]
        self.numbers = {name: self._read(name) for name in NUMBERS if name in self._h5}
        self.attributes = {name: _text(value) for name, value in self._h5.attrs.items()}
        self.title = self.attributes.get("title", self.directory.name)
        self.scene = yaml.safe_load(self.attributes.get("scene", "")) or {}
        report = self.directory / "run.json"
        self.report = json.loads(report.read_text()) if report.is_file() else {}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._h5.close()

    @property
    def one_dimensional(self):
        return self.y.size == 1

    @property
    def has_fields(self):
        return "depth" in self._h5

    @property
    def spacing(self):
        """[m]"""
        return float(self.x[1] - self.x[0]) if self.x.size > 1 else float(self.y[1] - self.y[0])

    @property
    def extent(self):
        """[x_min, x_max, y_min, y_max] of the grid [m]."""
        half = self.spacing / 2
        return [self.x[0] - half, self.x[-1] + half, self.y[0] - half, self.y[-1] + half]

    def depth(self, frame):
        """(y, x) [m]"""
        return self.field("depth", frame)

    def velocity(self, frame):
        """(u, v), each (y, x) [m/s]"""
        return self.field("velocity_x", frame), self.field("velocity_y", frame)

    def surface(self, frame):
        """Depth plus bed, (y, x) [m]"""
        return self.depth(frame) + self.bed

    def field(self, name, frame):
        """Any (time, y, x) field of the file at a frame; negative frames count from the end."""
        if name not in self._h5:
            raise KeyError(f"{self.file}: no '{name}' here: ask for it with output.fields and output.frames")
        return self._h5[name][self._index(frame)]

    def objects(self, frame):
        """Objects that are there at a frame: {name: (position (3) [m], rotation matrix (3, 3))}; a point p of an object
        is at position + rotation @ p in the scene."""
        if not self.has_objects:
            return {}
        index = self._index(frame)
        there = self._h5["object_present"][index] != 0
        names = map(_text, self._h5["object_name"][:][there])
        rotations = map(rotation_matrix, self._h5["object_rotation"][index][there])
        return dict(zip(names, zip(self._h5["object_position"][index][there], rotations)))

    @property
    def has_objects(self):
        return "object_name" in self._h5

    @property
    def has_particles(self):
        return "particle_id" in self._h5

    def particles(self, frame):
        """The visible particles of a frame: positions (n, 3) [m], ids (n)."""
        index = self._index(frame)
        visible = self._h5["particle_visible"][index] != 0
        return self._h5["particle_position"][index][visible], self._h5["particle_id"][index][visible]

    def reference_depth(self, frame):
        """Exact depth at a frame (x) [m], or None where no exact solution is known."""
        if "reference_depth" not in self._h5:
            return None
        depth = self._h5["reference_depth"][self._index(frame)]
        return depth if np.isfinite(depth).any() else None

    def probe(self, name):
        """What a probe saw: {"depth", "velocity_x", "velocity_y"}, one value a frame."""
        column = self.probe_names.index(name)
        return {key: self._h5["probe_" + key][:self.frames, column]
                for key in ("depth", "velocity_x", "velocity_y") if "probe_" + key in self._h5}

    def frame_at(self, time):
        """The frame nearest to a time [s]."""
        return int(np.argmin(np.abs(self.time - time)))

    def errors(self):
        """The run's errors against its references, as in run.json."""
        errors = self.report.get("errors", self.report.get("error")) or []
        return errors if isinstance(errors, list) else [errors]

    def _index(self, frame):
        if not -self.frames <= frame < self.frames:
            raise IndexError(f"{self.file}: frame {frame} of {self.frames}")
        return frame % self.frames

    def _read(self, name, default=None):
        if name not in self._h5:
            return default
        return self._h5[name][:self.frames] if name in OVER_TIME else self._h5[name][:]

    def _static(self, name, default=None):
        if name in self._h5:
            return self._h5[name][:]
        return None if default is None else np.full((self.y.size, self.x.size), default)


class Summary:
    """The table of a sweep (summary.h5): columns by their names, one value a case."""

    def __init__(self, directory):
        self.directory = Path(directory)
        self.parameters = []                                # names of what was varied
        self.metrics = []                                   # names of what came of it
        self._columns, self._units = {}, {}
        with h5py.File(self.directory / "summary.h5", "r") as file:
            scene = Path(_text(file.attrs["scene_file"]))
            for name, column in file.items():
                values = column[:]
                self._columns[name] = values if values.dtype.kind in "fi" else np.array([_text(v) for v in values])
                self._units[name] = _text(column.attrs.get("units", ""))
                role = _text(column.attrs.get("role", ""))
                if role:
                    {"parameter": self.parameters, "metric": self.metrics}[role].append(name)
        self.title = scene.parent.name if scene.stem == "scene" else scene.stem

    def __getitem__(self, name):
        return self._columns[name]

    def units(self, name):
        return self._units[name]

    def label(self, name):
        """The name with its unit, for an axis."""
        units = self._units[name]
        return f"{name.replace('_', ' ')} [{units}]" if units not in ("", "1") else name.replace("_", " ")


def _open(path):
    """A finished file, or one that a run is still writing (single writer, many readers)."""
    if path.suffix != ".partial":
        return h5py.File(path, "r")
    return h5py.File(path, "r", libver="latest", swmr=True)


def rotation_matrix(quaternion):
    """The rotation of a quaternion (w, x, y, z) of any length: (3, 3)."""
    w, x, y, z = np.asarray(quaternion, dtype=float) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def _text(value):
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(-1)[0]
    return value.decode() if isinstance(value, bytes) else value


def read_table(path):
    """Columns of a CSV file by their names, e.g. {"x_m": ..., "depth_m": ...}; `#` starts a comment."""
    lines = [line.split("#")[0].strip() for line in Path(path).read_text().splitlines()]
    names, *rows = [[word.strip() for word in line.split(",")] for line in lines if line]
    return dict(zip(names, np.array(rows, dtype=float).T))
