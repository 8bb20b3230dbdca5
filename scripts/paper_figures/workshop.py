"""Makes figures: only those whose runs, settings, scripts or program have changed since the last call."""

import importlib
import json
import shutil
import sys
import time
from pathlib import Path

from plotting import ROOT

from . import page
from .model import Claim, Outcome
from .runs import digest
from .studio import Studio

SCRIPTS = ROOT / "scripts"


def sources(module, seen=None):
    """The files of a module and of all modules under scripts/ that it names, sorted."""
    seen = {} if seen is None else seen
    file = getattr(module, "__file__", None)
    if file and SCRIPTS in Path(file).parents and module.__name__ not in seen:
        seen[module.__name__] = Path(file)
        for value in list(vars(module).values()):
            owner = value if type(value) is type(sys) else sys.modules.get(getattr(value, "__module__", None) or "")
            if owner is not None:
                sources(owner, seen)
    return sorted(seen.values())


class Workshop:
    """Figures in a folder, one subfolder each with its pictures and figure.json."""

    def __init__(self, folder, runs, say):
        self.folder, self.runs, self.say = Path(folder), runs, say
        self.made, self.found, self.missing = [], [], []

    def key(self, figure):
        """Hash of all that a figure depends on: its runs, its scripts, and the tools that draw it."""
        code = [path.read_bytes() for path in sources(importlib.import_module(figure.draw.__module__))]
        return digest(figure.name, *[self.runs.key(run) for run in figure.planned], *code, *Studio.tools())

    def record(self, figure):
        """The record of a figure that was made before, or None."""
        path = self.folder / figure.name / "figure.json"
        if not path.is_file():
            return None
        record = json.loads(path.read_text())
        outcome = record["outcome"]
        record["outcome"] = Outcome(**{**outcome, "claims": [Claim(**claim) for claim in outcome["claims"]]})
        return record

    def stale(self, figure):
        """Whether a figure was made before something changed that it depends on."""
        record = self.record(figure)
        return record is not None and record["key"] != self.key(figure)

    def make(self, figure, anew=False):
        """Makes a figure unless it is there."""
        self.runs.write_inputs(figure.planned)
        key, record = self.key(figure), self.record(figure)
        pictures = record["outcome"].pictures if record else []
        if (record and record["key"] == key and not anew
                and all((self.folder / figure.name / name).is_file() for name, _ in pictures)):
            self.found.append(figure.name)
            self.say(f"{figure.title}: nothing has changed")
            return
        self.say(figure.title)
        start = time.monotonic()
        shutil.rmtree(self.folder / figure.name, ignore_errors=True)
        studio = Studio(figure, self.runs, self.folder / figure.name)
        outcome = figure.draw(studio)
        self.missing += [text for text in studio.missing if text not in self.missing]
        page.save_record(self.folder / figure.name / "figure.json",
                         {"key": key, "seconds": round(time.monotonic() - start, 1), "outcome": outcome})
        self.made.append(figure.name)
