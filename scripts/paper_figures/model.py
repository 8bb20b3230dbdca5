"""What a figure is made of: its runs, its pictures, and the claims that are judged."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Run:
    """A run of a scene. `scene` is relative to scenes/; `settings` are --set, `options` other options."""
    name: str
    scene: str
    settings: tuple = ()
    options: tuple = ()
    timed: bool = False        # only run.json is kept, and beside it how busy the machine was before


@dataclass
class Claim:
    """A statement beside what was measured. `agrees`: None where the two cannot be compared."""
    stated: str
    measured: str
    criterion: str
    agrees: bool | None
    why: str = ""              # what it comes from, if they do not agree; or what limits the comparison
    printed: bool = False      # about the equations as they are printed, not about what the paper claims

    def __post_init__(self):
        self.agrees = None if self.agrees is None else bool(self.agrees)      # NumPy has a bool of its own


@dataclass
class Outcome:
    """What drawing a figure gives."""
    pictures: list = field(default_factory=list)     # (file name, caption)
    claims: list = field(default_factory=list)
    tables: list = field(default_factory=list)       # (caption, header, rows), all text
    notes: list = field(default_factory=list)        # sentences


@dataclass(frozen=True)
class Figure:
    """A figure of the paper. `draw(studio)` returns an Outcome."""
    name: str
    title: str
    says: str                                        # what the paper says of it
    draw: object
    runs: object = ()                                # a tuple of Run, or a function that returns one

    @property
    def planned(self):
        """The runs."""
        return self.runs() if callable(self.runs) else self.runs


def verdict(claims):
    """One word for a list of claims; empty where there are none."""
    answers = [claim.agrees for claim in claims if claim.agrees is not None]
    if not answers:
        return "not comparable" if claims else ""
    return "agrees" if all(answers) else "does not agree" if not any(answers) else "agrees in part"
