"""Objects of a scene as POV-Ray's solids: shapes as in scenes/FORMAT.md, poses as in series.h5."""

from itertools import product
from pathlib import Path

import h5py
import numpy as np

from render_look import METAL, paint, vector, wood
from render_scene import mesh
from sandsim_series import rotation_matrix

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254}

HEADROOM = 30              # [units of the scene] room above the sand for objects
LEFT_OUT = "--no-objects leaves objects out"


class Bodies:
    """The objects of a result: their solids are declared once, and placed in every frame. Raises ValueError."""

    def __init__(self, folder, domain, objects):
        """`objects` are those of the resolved scene."""
        self.folder = folder
        self.reach = 2 * domain.span               # [m] where half spaces end
        self.placement = domain.placement()
        materials = [material(item["shape"], k) for k, item in enumerate(objects)]
        self.endless = {item["name"]: look for item, look in zip(objects, materials)
                        if item["shape"]["type"] == "half_space"}
        self.room = f"box {{ {vector(domain.low)}, {vector(domain.high + [0, 0, HEADROOM])} }}"
        self.functions = []                        # of level sets
        solids = [solid(item["shape"], self) for item in objects]
        self.names = {item["name"]: k for k, item in enumerate(objects)}
        self.corners = [corners for _, corners in solids]
        self.text = "\n".join([*self.functions, *(
            f"#declare Body{k} = object {{ {body} {look} }}"
            for k, ((body, _), look) in enumerate(zip(solids, materials)))]) + "\n"

    def placed(self, poses):
        """The text of the bodies that are there; poses: {name: (position [m], rotation matrix)}."""
        text = []
        for name, (position, turn) in poses.items():
            body = f"object {{ Body{self.names[name]} {matrix(turn, position)} {self.placement} }}"
            text.append(f"intersection {{ {body} {self.room} {self.endless[name]} }}" if name in self.endless else body)
        return "\n".join(text)

    def boxes(self, poses):
        """Corners of boxes around the bodies that are there (n, 3) [m]."""
        return np.concatenate([np.empty((0, 3)), *(self.corners[self.names[name]] @ turn.T + position
                                                   for name, (position, turn) in poses.items())])


def material(shape, k):
    """Sticks and blocks are of wood, what is put together of sheet metal, all else is painted."""
    if shape["type"] == "box":
        return wood(numbers(shape["size"]))
    if shape["type"] == "brush":
        radius = number(shape["radius"])
        return wood([2 * radius, 2 * radius, number(shape["height"])])
    return METAL if shape["type"] == "csg" else paint(k)


def number(quantity):
    """A resolved quantity, such as "0.05 m", in SI units."""
    return float(str(quantity).split()[0])


def numbers(quantities):
    return np.array([number(q) for q in quantities])


def about(axis, angle):
    """The rotation about an axis of any length by an angle [rad]."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    return rotation_matrix([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])


def turned(rotation):
    """The matrix of a scene's `rotation`."""
    if not rotation:
        return np.eye(3)
    if "quaternion" in rotation:
        return rotation_matrix(numbers(rotation["quaternion"]))
    if "euler" in rotation:
        roll, pitch, yaw = numbers(rotation["euler"])
        return about([0, 0, 1], yaw) @ about([0, 1, 0], pitch) @ about([1, 0, 0], roll)
    return about(numbers(rotation["axis"]), number(rotation["angle"]))


def matrix(turn, position):
    """POV-Ray's transformation x -> turn x + position."""
    return f"matrix {vector((*turn.T.ravel(), *position))}"


def solid(shape, bodies):
    """A shape in its body's frame [m]: POV-Ray's object without its texture, and corners of boxes around it (n, 3)."""
    text, corners = SHAPES[shape["type"]](shape, bodies)
    turn, position = turned(shape.get("rotation")), numbers(shape.get("position", (0, 0, 0)))
    return f"{text} {matrix(turn, position)} }}", corners @ turn.T + position


def box_corners(low, high):
    return np.array(list(product(*zip(low, high))))


def upright(radius, half):
    """Corners of the box about something round along z."""
    return box_corners((-radius, -radius, -half), (radius, radius, half))


# Each of these leaves its text open, for the transformation that follows.

def sphere(shape, _):
    radius = number(shape["radius"])
    return f"sphere {{ 0, {radius:.9g}", upright(radius, radius)


def box(shape, _):
    half = numbers(shape["size"]) / 2
    return f"box {{ -{vector(half)}, {vector(half)}", box_corners(-half, half)


def capsule(shape, _):
    radius, half = number(shape["radius"]), number(shape["length"]) / 2
    axis = half - radius
    text = (f"merge {{ cylinder {{ -z * {axis:.9g}, z * {axis:.9g}, {radius:.9g} }} "
            f"sphere {{ -z * {axis:.9g}, {radius:.9g} }} sphere {{ z * {axis:.9g}, {radius:.9g} }}")
    return text, upright(radius, half)


def cylinder(shape, _):
    radius, half = number(shape["radius"]), number(shape["height"]) / 2
    return f"cylinder {{ -z * {half:.9g}, z * {half:.9g}, {radius:.9g}", upright(radius, half)


def cone(shape, _):
    radius, half = number(shape["radius"]), number(shape["height"]) / 2
    return f"cone {{ -z * {half:.9g}, {radius:.9g}, z * {half:.9g}, 0", upright(radius, half)


def brush(shape, _):
    radius, height = number(shape["radius"]), number(shape["height"])
    return (f"cylinder {{ 0, z * {height:.9g}, {radius:.9g}",
            box_corners((-radius, -radius, 0), (radius, radius, height)))


def ellipsoid(shape, _):
    radii = numbers(shape["radii"])
    return f"sphere {{ 0, 1 scale {vector(radii)}", box_corners(-radii, radii)


def half_space(shape, bodies):
    """As large as matters here, and without corners: it has no end."""
    reach = f"{bodies.reach:.9g}"
    return (f"intersection {{ plane {{ {vector(numbers(shape['normal']))}, 0 }} box {{ -{reach}, {reach} }}",
            np.empty((0, 3)))


def csg(shape, bodies):
    parts = [solid(part, bodies) for part in shape["parts"]]
    return (f"{shape['operation']} {{ {' '.join(text for text, _ in parts)}",
            np.concatenate([corners for _, corners in parts]))


def mesh_file(shape, _):
    try:
        import meshio                   # only scenes with meshes need it
    except ImportError:
        raise ValueError("meshio is missing, which reads meshes of objects. Install it: "
                         "sudo apt-get install python3-meshio") from None
    try:
        read = meshio.read(shape["file"])
    except (OSError, meshio.ReadError) as error:
        raise ValueError(f"the mesh {shape['file']} cannot be read: {error} ({LEFT_OUT})") from error
    points = UNITS[shape.get("unit", "m")] * float(shape.get("scale", 1)) * read.points
    fans = [cells.data[:, [0, k, k + 1]] for cells in read.cells for k in range(1, cells.data.shape[1] - 1)]
    return mesh(points, np.concatenate(fans)), box_corners(points.min(axis=0), points.max(axis=0))


def level_set(shape, bodies):
    """A sampled signed distance; POV-Ray finds its surface. Its samples go into a .df3 file of 16 bits."""
    distance, origin, spacing = read_distance(shape)
    band = 8 * spacing                       # beyond it only the sign counts
    levels = np.round((0.5 + np.clip(distance / (2 * band), -0.5, 0.5)) * 65535).astype(">u2")
    name = f"LevelSet{len(bodies.functions)}"
    count = np.array(levels.shape[::-1])
    (bodies.folder / f"{name}.df3").write_bytes(count.astype(">u2").tobytes() + levels.tobytes())
    bodies.functions.append(
        f'#declare {name} = function {{ pattern {{ density_file df3 "{name}.df3" interpolate 1 }} }}')
    # Sample k lies at k / n of POV-Ray's unit cube; beyond the last one it would go on with the first.
    size = spacing * count
    steepest = 1.5 * size.max() / (2 * band)
    text = (f"isosurface {{ function {{ {name}(x, y, z) - 0.5 }} "
            f"contained_by {{ box {{ {vector(0.01 / count)}, {vector(1 - 1.01 / count)} }} }} "
            f"accuracy 0.0005 max_gradient {steepest:.6g} scale {vector(size)} translate {vector(origin)}")
    inside = np.argwhere(distance < 0)[:, ::-1]             # the surface lies within a sample of these
    return text, origin + spacing * box_corners(inside.min(axis=0) - 1, inside.max(axis=0) + 1)


def read_distance(shape):
    """(z, y, x) [m], origin [m], spacing [m] of a signed distance from a file."""
    path = Path(shape["file"])
    origin, spacing = (0.0, 0.0, 0.0), 0.0
    try:
        if path.suffix == ".npy":
            distance = np.load(path)
        elif path.suffix == ".h5":
            with h5py.File(path, "r") as file:
                data = file["distance"]
                distance = data[:]
                if "spacing" in data.attrs:
                    origin = [float(data.attrs[f"origin_{axis}"]) for axis in "xyz"]
                    spacing = float(data.attrs["spacing"])
        else:                                # SDFGen's text: counts, origin, spacing, samples with x fastest
            words = path.read_text().split()
            origin, spacing = [float(word) for word in words[3:6]], float(words[6])
            distance = np.array(words[7:], dtype=float).reshape([int(word) for word in words[2::-1]])
    except (OSError, KeyError) as error:
        raise ValueError(f"the signed distance {path} cannot be read: {error} ({LEFT_OUT})") from error
    spacing = number(shape["spacing"]) if "spacing" in shape else spacing
    origin = numbers(shape["origin"]) if "origin" in shape else np.array(origin)
    scale = float(shape.get("scale", 1))
    return scale * distance, scale * origin, scale * spacing


SHAPES = {"sphere": sphere, "box": box, "capsule": capsule, "cylinder": cylinder, "cone": cone, "ellipsoid": ellipsoid,
          "half_space": half_space, "brush": brush, "csg": csg, "mesh": mesh_file, "sdf": level_set}
