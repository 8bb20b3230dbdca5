"""Runs that are kept as long as nothing that they depend on changes."""

import hashlib
import os
import shutil
import subprocess
import time
from pathlib import Path

import yaml

from plotting import ROOT


BUSY = "busy.txt"              # beside a timed run: what busy() gave before it
SAMPLE = 0.3                   # [s] over which busy() looks


class RunFailed(Exception):
    """A run ended with an error. The message is the program's own."""


def digest(*parts):
    """Hexadecimal SHA-256 of texts and bytes."""
    total = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode()
        total.update(str(len(data)).encode() + b":" + data)
    return total.hexdigest()


def busy():
    """Processors that are busy just now; 0 where the system does not say."""
    def ticks():
        fields = [int(word) for word in Path("/proc/stat").read_text().splitlines()[0].split()[1:9]]
        return sum(fields), fields[3] + fields[4]           # all, and those idle or waiting for the disk
    try:
        before = ticks()
        time.sleep(SAMPLE)
        after = ticks()
    except (OSError, ValueError, IndexError):
        return 0.0
    return os.cpu_count() * (1 - (after[1] - before[1]) / max(after[0] - before[0], 1))


def texts(value):
    """All texts in a YAML document."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [text for item in value for text in texts(item)]
    return [value] if isinstance(value, str) else []


def files_of(scene):
    """Files that a scene names and that are there."""
    named = (scene.parent / text for text in texts(yaml.safe_load(scene.read_text())))
    return [path for path in named if path.is_file()]


class Runs:
    """Results in a folder, one for each run, found again by the hash of all that they depend on.

    `retime`: timed runs are made once more, since the machine may have been busy.
    """

    def __init__(self, folder, program, say, retime=False):
        self.folder, self.program, self.say = Path(folder), Path(program), say
        self._old = set(self.folder.glob("*")) if retime else set()
        self._written = set()                # scenes whose files are there
        self.made, self.found = 0, 0
        self._program = hashlib.sha256(self.program.read_bytes()).hexdigest()

    def key(self, run):
        """Hash of scene, input files, settings and program."""
        scene = ROOT / "scenes" / run.scene
        files = [part for path in files_of(scene) for part in (path.name, path.read_bytes())]
        return digest(self._program, scene.read_bytes(), *files, "settings", *run.settings, "options", *run.options,
                      run.timed)

    def write_inputs(self, runs):
        """Writes the files of scenes that name a script for them, once."""
        scenes = sorted({str(ROOT / "scenes" / run.scene) for run in runs} - self._written)
        if scenes:
            done = subprocess.run([str(ROOT / "scripts/make_files"), *scenes], capture_output=True, text=True)
            if done.returncode != 0:
                raise RunFailed(done.stderr.strip())
            self._written.update(scenes)

    def result(self, run):
        """The folder of a result; runs the scene unless it is there."""
        folder = self.folder / f"{run.name}-{self.key(run)[:16]}"
        if (folder / "run.json").is_file() and not (run.timed and folder in self._old):
            self.found += 1
            return folder
        for old in self.folder.glob(f"{run.name}-" + "[0-9a-f]" * 16):
            shutil.rmtree(old)
        unfinished = self.folder / f"{run.name}.unfinished"
        command = [str(self.program), "run", str(ROOT / "scenes" / run.scene), "-o", str(unfinished), "--overwrite",
                   "-q", *run.options]
        for setting in run.settings:
            command += ["--set", setting]
        self.say(f"  running {run.name}")
        others = busy() if run.timed else 0.0
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise RunFailed(f"{run.name}: sandsim ended with {done.returncode}\n{done.stderr.strip()}")
        if run.timed:
            for path in unfinished.iterdir():
                if path.name != "run.json":
                    path.unlink()
            (unfinished / BUSY).write_text(f"{others:.2f}\n")
        unfinished.rename(folder)
        self._old.discard(folder)
        self.made += 1
        return folder
