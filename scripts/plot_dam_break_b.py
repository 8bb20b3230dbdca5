#!/usr/bin/python3
"""Figure 12: the dam break on a layer of depth B (eq. 35) for several B, with hbar = h and with hbar = 0.2 m.

Runs the cases into results/dam_break_layer_*, then draws h - B while it flows and how far each case is from that of
B = 0.3 m. Writes the numbers beside the picture.
"""

import numpy as np

from plotting import ROOT, arguments, plt, run, save
from sandsim_series import Series

LAYERS = (0.1, 0.3, 1, 3, 10)                                   # B [m]
REFERENCE = 0.3                                                 # [m] the layer against which the paper compares
POLICIES = {"full": ("{policy: full}", "hbar = h"),
            "constant": ("{policy: constant, depth: 20 cm}", "hbar = 0.2 m")}
MOMENT = 0.1                                                    # [s] at which the profiles are drawn
INTERVAL = 0.01                                                 # [s] frame interval of the scene


def run_case(options, policy, layer):
    """h - B over time (time, x) [m], continued at rest to the end of the slowest case, and x [m]."""
    setting, label = POLICIES[policy]
    output = options.results / f"dam_break_layer_{policy}_B{layer:g}"
    run(ROOT / "scenes/dam_break_layer/scene.yaml", output, reuse=options.reuse,
        settings=[f"title=Dam break on a layer, B = {layer:g} m, {label}", f"sand.hbar={setting}",
                  f"sand.initial.0.depth={layer:g} m"])
    with Series(output) as series:
        moments = np.arange(0, 1, INTERVAL)
        return np.array([series.depth(series.frame_at(time))[0] - layer for time in moments]), series.x


def deviation(case, reference):
    """Root mean square over x of the difference of h - B [m], for each moment."""
    return np.sqrt(np.mean((case.astype(float) - reference) ** 2, axis=1))


def main():
    parser = arguments(__doc__, result=False)
    parser.add_argument("--results", type=lambda text: ROOT / text, default=ROOT / "results", help="folder of results")
    parser.add_argument("--reuse", action="store_true", help="draw the results that are there")
    options = parser.parse_args()

    figure, axes = plt.subplots(1, 3, figsize=(14, 4.3))
    figure.suptitle("Dam break on a layer of depth B (eq. 35, Fig. 12 of the paper)")
    colours = plt.cm.viridis(np.linspace(0, 0.9, len(LAYERS)))
    others = [layer for layer in LAYERS if layer != REFERENCE]
    table = {layer: [] for layer in others}
    for panel, (policy, (_, label)) in zip(axes, POLICIES.items()):
        panel.plot([0, 1, 1, 2], [0.4, 0.4, 0, 0], color="0.7", label="released")
        cases = {}
        for colour, layer in zip(colours, LAYERS):
            cases[layer], x = run_case(options, policy, layer)
            panel.plot(x, cases[layer][round(MOMENT / INTERVAL)], color=colour, label=f"B = {layer:g} m")
        panel.set(title=f"{label}, t = {MOMENT:g} s", xlabel="x [m]", ylabel="height above the layer h - B [m]",
                  ylim=(-0.02, 0.44))
        panel.legend()
        for layer in others:
            over_time = deviation(cases[layer], cases[REFERENCE])
            table[layer] += [over_time.max(), over_time[-1]]
        largest, at_rest = np.array([table[layer][-2:] for layer in others]).T
        line, = axes[2].loglog(others, largest, "o-", label=f"{label}: largest of the run")
        axes[2].loglog(others, at_rest, "o--", color=line.get_color(), mfc="w", label=f"{label}: at rest")
    axes[2].set(title="deviation from B = 0.3 m", xlabel="B [m]", ylabel="RMS of the difference of h - B [m]")
    axes[2].legend()
    picture = options.output or options.results / "dam_break_layer.png"
    save(figure, picture)
    columns = [f"{label}, {what} [m]" for _, label in POLICIES.values() for what in ("largest", "at rest")]
    lines = ["| B [m] | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    lines += [f"| {layer:g} | " + " | ".join(f"{value:.2e}" for value in row) + " |" for layer, row in table.items()]
    picture.with_suffix(".md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
