#!/usr/bin/python3
"""Writes a toy car as a closed OBJ mesh, in metres: a body and four wheels that reach into it.

    make_car_mesh.py car.obj [--length 0.3]

The origin lies on the ground in the middle of the car, which looks along +x. Each part is closed; parts overlap.
"""

import argparse

import numpy as np

# Side view of the body (x, z), in units of the length, counterclockwise seen from -y: bonnet, cabin, boot.
BODY = [(-0.50, 0.12), (0.50, 0.12), (0.50, 0.25), (0.26, 0.28), (0.14, 0.42), (-0.24, 0.42), (-0.36, 0.28),
        (-0.50, 0.26)]
HALF_WIDTH = 0.22
WHEEL = 0.11                # radius
TYRE = (0.13, 0.235)        # inner and outer side, from the middle plane
AXLES = (-0.31, 0.31)
SIDES = 24                  # of a wheel


def prism(outline, y_from, y_to):
    """Corners (n, 3) and triangles of a prism along y over an outline (x, z), star-shaped about its mean."""
    outline = np.asarray(outline, dtype=float)
    count = len(outline)
    middle = outline.mean(axis=0)
    ring = [[(x, y, z) for x, z in outline] for y in (y_from, y_to)]
    corners = ring[0] + ring[1] + [(middle[0], y_from, middle[1]), (middle[0], y_to, middle[1])]
    triangles = []
    for k in range(count):
        after = (k + 1) % count
        triangles += [(k, after, 2 * count), (count + after, count + k, 2 * count + 1),
                      (after, k, count + k), (after, count + k, count + after)]
    return np.array(corners), triangles


def car():
    """Corners and triangles of the whole car, of length 1."""
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    parts = [prism(BODY, -HALF_WIDTH, HALF_WIDTH)]
    for axle in AXLES:
        circle = np.column_stack([axle + WHEEL * np.cos(angles), WHEEL + WHEEL * np.sin(angles)])
        parts += [prism(circle, TYRE[0], TYRE[1]), prism(circle, -TYRE[1], -TYRE[0])]
    return parts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", help="file to write (.obj)")
    parser.add_argument("--length", type=float, default=0.3, help="of the car, in metres")
    options = parser.parse_args()
    first = 1
    with open(options.output, "w", encoding="ascii", newline="\n") as file:
        file.write("# A toy car, in metres; scripts/make_car_mesh.py wrote it.\n")
        for corners, triangles in car():
            for corner in options.length * corners:
                file.write("v {:.5f} {:.5f} {:.5f}\n".format(*corner))
            for triangle in triangles:
                file.write("f {} {} {}\n".format(*(first + k for k in triangle)))
            first += len(corners)


if __name__ == "__main__":
    main()
