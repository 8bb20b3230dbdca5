"""What several figures say of their runs."""

from .model import Claim

FRAME = 1 / 30                         # [s] a frame of the paper's films is taken to be
VOLUME = 1e-6                          # largest relative error of the volume in float32


def stage(report, name):
    """Seconds of a stage in all; 0 without it."""
    return sum(entry["seconds"] for entry in report["stages"] if entry["name"] == name)


def per_frame(report, name):
    """Milliseconds of a stage for FRAME of simulated time."""
    return 1e3 * stage(report, name) * FRAME / report["simulated_time"]


def kept(report):
    """The claim that a run keeps its volume and comes to rest."""
    error, rest = abs(report["volume_error"]), report["at_rest"]
    return Claim("(not stated) volume is kept, and the sand comes to rest",
                 f"volume error {error:.1e}; " + (f"at rest from {report['stop_time']:.2f} s" if rest else
                                                  f"still moving at {report['simulated_time']:.2f} s"),
                 f"error at most {VOLUME:g} and at rest", error <= VOLUME and rest)
