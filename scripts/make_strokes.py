#!/usr/bin/python3
"""Writes a scene in which a brush draws in level sand: one object a stroke, one after the other.

    make_strokes.py writing scenes/writing/scene.yaml          the characters for flying, paper Fig. 14
    make_strokes.py butterfly scenes/butterfly/scene.yaml      a butterfly, half of it flattened, paper Fig. 1
"""

import argparse

import numpy as np

# Simplified strokes on a square of 100 x 100 with y up, in the order of writing.
FEI = [[(10, 82), (60, 82), (61, 60), (64, 40), (72, 22), (84, 8), (91, 24)],     # across, down and the hook
       [(90, 80), (74, 66)],
       [(73, 64), (90, 48)]]
XIANG = [[(10, 94), (17, 80)], [(39, 94), (32, 80)],                              # 羊: two dots,
         [(6, 75), (43, 75)], [(9, 55), (40, 55)], [(3, 33), (46, 33)],           # three across,
         [(25, 75), (25, 33), (21, 17), (10, 3)],                                 # down and to the left
         [(53, 86), (72, 86), (72, 7), (64, 13)],                                 # 羽: a wing,
         [(55, 66), (63, 54)], [(52, 26), (66, 37)],
         [(79, 86), (98, 86), (98, 7), (90, 13)],                                 # and another
         [(81, 66), (89, 54)], [(78, 26), (92, 37)]]

WRITING = """\
# yaml-language-server: $schema=../scene.schema.json
# Fig. 14: a brush writes the characters 飞翔 (flying) in the sand. scripts/make_strokes.py wrote this file.
title: Writing in sand
grid: {cells: [400, 200], spacing: 4 mm, origin: [0 m, 0 m]}   # Table 1: 512 x 256
gravity: 9.8 m/s^2
sand:
  friction_angle: 30 deg
  hbar: {policy: constant, depth: 10 cells}
  initial: {type: layer, depth: 3 cm}
objects:
"""

BUTTERFLY = """\
# yaml-language-server: $schema=../scene.schema.json
# Fig. 1: a stick draws a butterfly, and a block is drawn over half of it. scripts/make_strokes.py wrote this file.
title: A butterfly in sand
grid: {cells: [200, 200], spacing: 1 cm, origin: [-1 m, -1 m]}   # Table 1: 256 x 256
gravity: 9.8 m/s^2
sand:
  friction_angle: 30 deg
  hbar: {policy: constant, depth: 10 cells}
  initial: {type: layer, depth: 6 cm}
objects:
"""

BLOCK = """\
  - name: block
    shape: {{type: box, size: [1.1 m, 20 cm, 20 cm]}}
    coupling: displace
    motion:                      # its underside 6 mm below the level of the bed
      type: keyframes
      keyframes:
        - {{time: {start:.2f} s, position: [50 cm, 88 cm, {z:g} cm]}}
        - {{time: {end:.2f} s, position: [50 cm, -85 cm, {z:g} cm]}}
    start: {start:.2f} s
    end: {end:.2f} s
"""


def stroke(name, points, start, speed, radius, tip):
    """YAML of a brush that runs along points [cm] at a speed [cm/s] with its tip at a height [cm]; and its end [s]."""
    points = np.asarray(points, dtype=float)
    times = start + np.concatenate([[0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))]) / speed
    lines = [f"  - name: {name}", f"    shape: {{type: brush, radius: {radius:g} cm, height: 20 cm}}",
             "    motion:", "      type: stroke", "      points:"]
    lines += [f"        - {{time: {time:.3f} s, position: [{x:.2f} cm, {y:.2f} cm, {tip:g} cm]}}"
              for time, (x, y) in zip(times, points)]
    lines += [f"    start: {times[0]:.3f} s", f"    end: {times[-1]:.3f} s"]
    return "\n".join(lines) + "\n", times[-1]


def drawing(strokes, speed, pause, radius, tip):
    """YAML of strokes one after the other, (name, points) each; and the end of the last one."""
    text, time = "", 0.0
    for name, points in strokes:
        part, time = stroke(name, points, time, speed, radius, tip)
        text, time = text + part, time + pause
    return text, time - pause


def writing():
    strokes = []
    for name, corner, character in (("fei", 9, FEI), ("xiang", 84, XIANG)):
        for number, points in enumerate(character, 1):
            # Characters of 67 cm.
            strokes.append((f"{name} {number}", [(corner + 0.67 * x, 6 + 0.67 * y) for x, y in points]))
    # As wide as in the paper, 5 cells.
    objects, end = drawing(strokes, speed=70, pause=0.05, radius=1, tip=2.1)
    return WRITING + objects + ending(end + 1)


def butterfly():
    """Wings: the butterfly curve r = e^cos t - 2 cos 4t (Fay 1989, one turn without its sine) where it is positive.

    The same curve, smaller, makes a spot in each wing; a straight body and two feelers.
    """
    strokes = []
    for name, middle, half, scale in (
            ("upper wings", 0, 90, 27), ("lower right wing", 135, 45, 27), ("lower left wing", 225, 45, 27),
            ("upper right spot", 46, 27, 16), ("upper left spot", -46, 27, 16),
            ("lower right spot", 135, 24, 15), ("lower left spot", 225, 24, 15)):
        angle = np.radians(np.linspace(middle - half, middle + half, 1 + 2 * half // 3))
        r = np.exp(np.cos(angle)) - 2 * np.cos(4 * angle)
        angle, r = angle[r > 0], r[r > 0]
        strokes.append((name, np.column_stack([scale * r * np.sin(angle), scale * r * np.cos(angle) - 12])))
    strokes.append(("body", [(0, 14), (0, -48)]))
    bend = np.radians(np.linspace(0, 80, 9))
    for name, side in (("left", -1), ("right", 1)):
        feeler = np.column_stack([side * 18 * np.sin(bend), 14 + 40 * (bend / bend[-1])])
        strokes.append((f"{name} feeler", feeler))
    objects, end = drawing(strokes, speed=150, pause=0.05, radius=2, tip=3.5)
    start, stop = end + 0.25, end + 3.25
    block = BLOCK.format(start=start, end=stop, z=15.4)
    return BUTTERFLY + objects + block + ending(stop + 1)


def ending(end):
    return (f"time: {{end: {np.ceil(end):g} s, frame_interval: 250 ms, stop_at_rest: true}}\n"
            "output: {fields: [depth, velocity]}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawing", choices=["writing", "butterfly"])
    parser.add_argument("output", help="scene file to write")
    options = parser.parse_args()
    with open(options.output, "w", encoding="utf-8", newline="\n") as file:
        file.write({"writing": writing, "butterfly": butterfly}[options.drawing]())


if __name__ == "__main__":
    main()
