"""Compares the series of two runs bit for bit: scripts/compare_runs.py RESULT RESULT.

Every dataset of series.h5 has to be the same but `wall_time`. Says what differs; exits with 1 if anything does.
"""

import sys
from pathlib import Path

import h5py
import numpy as np

IGNORED = {"wall_time"}


def differences(first, second):
    """What differs between two result folders or series.h5, one line a dataset; empty if nothing does."""
    with h5py.File(_file(first), "r") as a, h5py.File(_file(second), "r") as b:
        names, others = _datasets(a), _datasets(b)
        lines = [f"{name}: only in {where}" for missing, where in ((names - others, first), (others - names, second))
                 for name in sorted(missing)]
        for name in sorted(names & others - IGNORED):
            found = _difference(a[name], b[name])
            if found:
                lines.append(f"{name}: {found}")
        return lines


def _file(path):
    path = Path(path)
    return path / "series.h5" if path.is_dir() else path


def _datasets(file):
    names = set()
    file.visititems(lambda name, item: names.add(name) if isinstance(item, h5py.Dataset) else None)
    return names


def _difference(a, b):
    """None if two datasets hold the same bits. NaNs count as what they are."""
    if a.shape != b.shape or a.dtype != b.dtype:
        return f"{a.shape} of {a.dtype} against {b.shape} of {b.dtype}"
    left, right = np.atleast_1d(a[()]), np.atleast_1d(b[()])
    if left.dtype.kind != "f":
        unequal = left != right
    else:
        bits = f"u{left.dtype.itemsize}"
        unequal = np.ascontiguousarray(left).view(bits) != np.ascontiguousarray(right).view(bits)
    places = np.argwhere(unequal)
    if len(places) == 0:
        return None
    where = tuple(int(k) for k in places[0])
    return f"{len(places)} of {left.size} values differ, first at {where}: {left[where]!r} against {right[where]!r}"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    lines = differences(*sys.argv[1:])
    print("\n".join(lines) or "the same, bit for bit")
    sys.exit(1 if lines else 0)


if __name__ == "__main__":
    main()
