#!/usr/bin/python3
"""Draws the table of scripts/error_vs_time.py: error of the flume's deposit against the solver's time, log-log."""

import csv
from pathlib import Path

from plotting import COLOURS, ROOT, arguments, plt, save

MARKERS = {"float32": ("o-", {}), "float64": ("o:", {"mfc": "w"})}


def draw(rows, path):
    policies = list(dict.fromkeys(row["hbar"] for row in rows))
    schemes = list(dict.fromkeys(row["scheme"] for row in rows))
    figure, axes = plt.subplots(1, len(policies), figsize=(5.4 * len(policies) + 2, 4.6), sharey=True, squeeze=False)
    figure.suptitle("Flume deposit: error against run time, spacing 4 cm to 1.25 mm")
    for panel, policy in zip(axes[0], policies):
        for colour, scheme in zip(COLOURS, schemes):
            for precision, (style, look) in MARKERS.items():
                chosen = [row for row in rows
                          if (row["hbar"], row["scheme"], row["precision"]) == (policy, scheme, precision)]
                panel.loglog([float(row["seconds"]) for row in chosen], [float(row["error"]) for row in chosen], style,
                             color=colour, ms=4, label=f"{scheme}, {precision}", **look)
        panel.axhline(1e-2, color="0.6", lw=0.8)
        panel.set(title=f"hbar = {policy}", xlabel="time of the solver, one thread [s]")
    axes[0][0].set_ylabel("relative L1 error of the deposit [-]")
    axes[0][-1].legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    save(figure, path)


def main():
    parser = arguments(__doc__, result=False)
    parser.add_argument("table", type=Path, nargs="?", default=ROOT / "results/error_vs_time/table.csv")
    options = parser.parse_args()
    with options.table.open(newline="") as file:
        draw(list(csv.DictReader(file)), options.output or options.table.parent / "error_vs_time.png")


if __name__ == "__main__":
    main()
