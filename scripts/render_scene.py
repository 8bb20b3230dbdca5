"""Sand and ground of a result for POV-Ray: height fields with cut sides, which POV-Ray reads in milliseconds.

Lengths in its scene are hundredths of the domain's longer side, from the middle of its floor, so that a sand box and a
mountain come to the same numbers, and these are large beside POV-Ray's tolerance of 1e-3. z is up.
"""

from itertools import product

import numpy as np

import povray
from render_look import vector

# Sand thinner than this is drawn as ground: the contour of the paper's surface (its section 7, h = 0.1 dL).
CLIP = 0.1                     # [cells]
ROW_WIDTH = 0.2                # a scene of one row of cells is drawn as a flume this wide, in parts of its length
PLINTH = 0.035                 # thickness of the board under the lowest ground, in parts of the longer side

UNITS = 100                    # of the scene, along the longer side
INSET = 0.3                    # [units] of the core of the block behind its sides


class Domain:
    """The block of ground and sand that is drawn, the same for all frames of a result."""

    def __init__(self, series, frames):
        """`frames` are those whose sand the block is high enough for."""
        west, east, south, north = series.extent
        if series.one_dimensional:
            south, north = 0.0, ROW_WIDTH * (east - west)
        self.sides = (west, east, south, north)                                       # [m]
        self.span = max(east - west, north - south)                                   # [m]
        self.scale = UNITS / self.span                                                # [units/m]
        self.clip = CLIP * series.spacing                                             # [m]
        self.bed = rows(series.bed.astype(float))                                     # (y, x) [m]
        surfaces = [self.bed, *(series.surface(frame).astype(float) for frame in frames)]
        # Single cells throw sand far up ahead of what pushes it: they do not decide how far away the camera is.
        highest = max(float(np.percentile(surface, 99.8)) for surface in surfaces)
        self.is_rocky = has_raster(series.scene) and not series.one_dimensional
        self.floor = float(self.bed.min()) - PLINTH * self.span                       # [m]
        self.centre = np.array([(west + east) / 2, (south + north) / 2, self.floor])  # [m]
        self.low = self.local([west, south, self.floor])
        self.high = self.local([east, north, highest])

    def corners(self):
        """(8, 3) in the scene's units."""
        return np.array(list(product(*zip(self.low, self.high))))

    def local(self, points):
        """Points of the result [m] (..., 3) in the scene's units."""
        return (np.asarray(points, dtype=float) - self.centre) * self.scale

    def placement(self):
        """POV-Ray's transformation of what is given in metres."""
        return f"translate {vector(-self.centre)} scale {self.scale:.9g}"


def has_raster(scene):
    """Whether the ground is a landscape from a file, and no board."""
    parts = scene.get("terrain") or []
    return any(part.get("type") == "raster" for part in (parts if isinstance(parts, list) else [parts]))


def rows(field):
    """A field of one row as a field of two, which has a width."""
    return np.repeat(field, 2, axis=0) if field.shape[0] == 1 else field


def refine(field):
    """Values at the middles and corners of cells from those at their middles: (n, m) -> (2n + 1, 2m + 1).

    Between neighbours by cubic interpolation, never beyond the two: no waves beside cliffs.
    """
    for _ in range(2):
        padded = np.pad(field, ((2, 2), (0, 0)), mode="edge")
        before, after = padded[1:-2], padded[2:-1]
        between = (9 * (before + after) - padded[:-3] - padded[3:]) / 16
        fine = np.empty((2 * field.shape[0] + 1, field.shape[1]))
        fine[::2] = np.clip(between, np.minimum(before, after), np.maximum(before, after))
        fine[1::2] = field
        field = fine.T
    return field


def drawn_surface(bed, depth, clip):
    """The surface of the sand, (y, x) [m].

    Where the depth is below `clip` it goes on with the slope of the sand beside, under the ground: so the edge of a
    heap runs smoothly between the cells, and no sand hangs on a cliff.
    """
    dry = depth < clip
    surface = bed + np.minimum(depth, 2 * (depth - clip))
    padded = np.pad(np.where(dry, np.nan, surface), 2, mode="edge")
    near = [padded[2:-2, 3:-1], padded[2:-2, 1:-3], padded[3:-1, 2:-2], padded[1:-3, 2:-2]]
    far = [padded[2:-2, 4:], padded[2:-2, :-4], padded[4:, 2:-2], padded[:-4, 2:-2]]
    onward = np.array([2 * n - f for n, f in zip(near, far)])              # NaN where there is no slope to go on with
    count = np.count_nonzero(np.isfinite(onward), axis=0)
    under = np.where(count > 0, np.nansum(onward, axis=0) / np.maximum(count, 1), bed - 2 * clip)
    return np.where(dry, np.minimum(under, bed - 0.2 * clip), surface)


def ground(folder, domain):
    """The text of the ground, and its file bed.pgm."""
    bed = refine(domain.bed)
    texture = "Rock" if domain.is_rocky else "Board"
    # The block is hollow: a core keeps light from leaking through where its sides meet the floor.
    core = (domain.low + INSET, [*(domain.high[:2] - INSET), domain.local([0, 0, domain.bed.min()])[2] - INSET])
    return (height_field(folder, "bed", domain, bed, texture)
            + f"box {{ {vector(core[0])}, {vector(core[1])} texture {{ BoardSide }} }}\n"
            + sides(domain, np.full_like(bed, domain.floor), bed, texture + "Side"))


def sand(folder, name, domain, depth, lowered=0.0):
    """The text of the sand and its file NAME.pgm; `depth` (y, x) [m]; lowered [m] by what is drawn on it."""
    surface = refine(drawn_surface(domain.bed, rows(depth) - lowered, domain.clip))
    bed = refine(domain.bed)
    if not np.any(surface > bed):
        return ""
    return (height_field(folder, name, domain, surface, "Sand")
            + sides(domain, bed, np.maximum(surface, bed), "SandSide"))


def colour_map(folder, name, domain, colours):
    """Textures that colour the sand from above: Sand and SandSide; colours (y, x, 3) in 0..1."""
    povray.write_ppm(folder / f"{name}.ppm", rows(colours))
    west, east, south, north = domain.sides
    # The cut sides lie on the very edge of the map, beyond which it has no colours.
    size = 1.001 * np.array([east - west, north - south, domain.span]) * domain.scale
    return f"""#declare Sand = texture {{ pigment {{ image_map {{ ppm "{name}.ppm" gamma srgb interpolate 2 once }}
  translate -0.5 scale {vector(size)} }} }}
#declare SandSide = texture {{ Sand }}
"""


def height_field(folder, name, domain, heights, texture):
    west, east, south, north = domain.sides
    low = float(heights.min())
    high = max(float(heights.max()), low + 1e-3 * domain.span)          # a plane has a height too
    povray.write_pgm(folder / f"{name}.pgm", heights, low, high)
    # POV-Ray's height fields lie in the unit cube over its x-z plane.
    x, y, z = domain.local([west, south, low])
    along_x, along_y, along_z = np.array([east - west, north - south, high - low]) * domain.scale
    return f"""height_field {{ pgm "{name}.pgm" smooth
  matrix <{along_x:.9g},0,0, 0,0,{along_z:.9g}, 0,{along_y:.9g},0, {x:.9g},{y:.9g},{z:.9g}> texture {{ {texture} }} }}
"""


def sides(domain, low, high, texture):
    """The four vertical faces between two height fields."""
    west, east, south, north = domain.sides
    x, y = np.linspace(west, east, low.shape[1]), np.linspace(south, north, low.shape[0])
    points, triangles, first = [], [], 0
    for lower, upper, along_x, along_y in ((low[0], high[0], x, np.full_like(x, south)),
                                           (low[-1], high[-1], x, np.full_like(x, north)),
                                           (low[:, 0], high[:, 0], np.full_like(y, west), y),
                                           (low[:, -1], high[:, -1], np.full_like(y, east), y)):
        for line in (lower, upper):
            points.append(domain.local(np.column_stack([along_x, along_y, line])))
        n = lower.size
        thick = (upper - lower)[:-1] + (upper - lower)[1:] > 1e-6 * domain.span
        for k in first + np.flatnonzero(thick):
            triangles += [(k, k + 1, k + n + 1), (k, k + n + 1, k + n)]
        first += 2 * n
    return f"{mesh(np.concatenate(points), triangles)} texture {{ {texture} }} }}\n" if triangles else ""


def mesh(points, triangles):
    """POV-Ray's mesh of triangles (m, 3) between points (n, 3), open for a texture or a transformation."""
    return (f"mesh2 {{ vertex_vectors {{ {len(points)}, {','.join(map(vector, points))} }}\n"
            f"face_indices {{ {len(triangles)}, {','.join('<%d,%d,%d>' % tuple(t) for t in triangles)} }}")
