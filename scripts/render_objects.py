"""Objects of a scene as POV-Ray's solids: shapes as in scenes/FORMAT.md, poses as in series.h5."""

from pathlib import Path

import h5py
import numpy as np

from render_look import vector
from render_scene import mesh

# What things are made of: a stick and a block of wood, painted cars, sheet metal for what is put together.
WOOD = """texture {{ pigment {{ wood turbulence 0.08 scale {scale} rotate <3, 3, 0> {turn}
  color_map {{ [0 srgb <0.72, 0.53, 0.35>] [0.7 srgb <0.64, 0.45, 0.28>] [1 srgb <0.52, 0.35, 0.21>] }} }} }}"""
METAL = "texture { pigment { srgb <0.46, 0.52, 0.58> } finish { specular 0.35 roughness 0.03 } }"
PAINT = "texture {{ pigment {{ srgb {colour} }} finish {{ specular 0.3 roughness 0.02 }} }}"
PAINTS = ((0.72, 0.16, 0.13), (0.13, 0.30, 0.58), (0.20, 0.46, 0.26), (0.85, 0.60, 0.13), (0.45, 0.24, 0.50))


class Bodies:
    """The objects of a result: their solids are declared once, and placed in every frame. Raises ValueError."""

    def __init__(self, folder, domain, objects):
        """`objects` are those of the scene that have poses, in the order of the poses."""
        self.folder = folder
        self.reach = 2 * domain.span               # [m] where half spaces end
        self.placement = domain.placement()
        self.functions = []                        # of level sets
        solids = [solid(item["shape"], self) for item in objects]
        paints = iter(range(len(objects)))
        self.text = "\n".join([*self.functions, *(
            f"#declare Body{k} = object {{ {body} {material(item['shape'], paints)} }}"
            for k, (item, body) in enumerate(zip(objects, solids)))]) + "\n"

    def placed(self, poses):
        """The text of the bodies that are there; poses: (position [m], quaternion) or None for each."""
        return "".join(f"object {{ Body{k} {matrix(rotation_matrix(pose[1]), pose[0])} {self.placement} }}\n"
                       for k, pose in enumerate(poses) if pose is not None)


def material(shape, paints):
    kind = shape["type"]
    if kind in ("box", "brush"):
        # The grain runs along the longest side.
        size = numbers(shape["size"]) if kind == "box" else np.array([0, 0, number(shape["height"])])
        turn = ("rotate 90 * y", "rotate 90 * x", "")[int(np.argmax(size))]
        return WOOD.format(scale=f"{0.12 * size[size > 0].min() if kind == 'box' else 0.4 * number(shape['radius']):.6g}",
                           turn=turn)
    return METAL if kind == "csg" else PAINT.format(colour=vector(PAINTS[next(paints) % len(PAINTS)]))


def number(quantity):
    """A resolved quantity, such as "0.05 m", in SI units."""
    return float(str(quantity).split()[0])


def numbers(quantities):
    return np.array([number(q) for q in quantities])


def rotation_matrix(quaternion):
    """The rotation of a quaternion (w, x, y, z) of any length."""
    w, x, y, z = np.asarray(quaternion, dtype=float) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def about(axis, angle):
    """The rotation about an axis of any length by an angle [rad]."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    return rotation_matrix([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])


def turned(rotation):
    """The matrix of a scene's `rotation`."""
    if not rotation:
        return np.eye(3)
    if "quaternion" in rotation:
        return rotation_matrix([float(q) for q in rotation["quaternion"]])
    if "euler" in rotation:
        roll, pitch, yaw = numbers(rotation["euler"])
        return about([0, 0, 1], yaw) @ about([0, 1, 0], pitch) @ about([1, 0, 0], roll)
    return about([float(a) for a in rotation["axis"]], number(rotation["angle"]))


def matrix(turn, position):
    """POV-Ray's transformation x -> turn x + position."""
    return f"matrix {vector((*turn.T.ravel(), *position))}"


def solid(shape, space):
    """A shape as POV-Ray's object in the frame of its body [m], without its texture. Raises ValueError."""
    body = SHAPES[shape["type"]](shape, space)
    return body + matrix(turned(shape.get("rotation")), numbers(shape.get("position", (0, 0, 0)))) + " }"


def csg(shape, space):
    return f"{shape['operation']} {{ {' '.join(solid(part, space) for part in shape['parts'])} "


def box(shape, _):
    half = vector(numbers(shape["size"]) / 2)
    return f"box {{ -{half}, {half} "


def capsule(shape, _):
    radius = number(shape["radius"])
    half = number(shape["length"]) / 2 - radius
    return (f"merge {{ cylinder {{ -z * {half:.9g}, z * {half:.9g}, {radius:.9g} }} "
            f"sphere {{ -z * {half:.9g}, {radius:.9g} }} sphere {{ z * {half:.9g}, {radius:.9g} }} ")


def cone(shape, _):
    half = number(shape["height"]) / 2
    return f"cone {{ -z * {half:.9g}, {number(shape['radius']):.9g}, z * {half:.9g}, 0 "


def cylinder(shape, _):
    half = number(shape["height"]) / 2
    return f"cylinder {{ -z * {half:.9g}, z * {half:.9g}, {number(shape['radius']):.9g} "


def brush(shape, _):
    return f"cylinder {{ 0, z * {number(shape['height']):.9g}, {number(shape['radius']):.9g} "


def sphere(shape, _):
    return f"sphere {{ 0, {number(shape['radius']):.9g} "


def ellipsoid(shape, _):
    return f"sphere {{ 0, 1 scale {vector(numbers(shape['radii']))} "


def half_space(shape, space):
    """Cut off at the reach of the scene."""
    normal = vector(map(float, shape["normal"]))
    return f"intersection {{ plane {{ {normal}, 0 }} box {{ -{space.reach:.9g}, {space.reach:.9g} }} "


def mesh_file(shape, _):
    import meshio                       # only scenes with meshes need it

    factor = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254}[shape.get("unit", "m")] * float(shape.get("scale", 1))
    try:
        read = meshio.read(shape["file"])
    except (OSError, meshio.ReadError) as error:
        raise ValueError(f"the mesh {shape['file']} cannot be read: {error}") from error
    fans = [cells.data[:, [0, k, k + 1]] for cells in read.cells for k in range(1, cells.data.shape[1] - 1)]
    return mesh(factor * read.points, np.concatenate(fans), "").rstrip().removesuffix("}")


def level_set(shape, space):
    """A sampled signed distance; POV-Ray finds its surface. Its samples go into a .df3 file of 16 bits."""
    distance, origin, spacing = read_distance(shape)
    band = 8 * spacing                       # beyond it only the sign counts
    levels = np.round((0.5 + np.clip(distance / (2 * band), -0.5, 0.5)) * 65535).astype(">u2")
    name = f"LevelSet{len(space.functions)}"
    count = np.array(levels.shape[::-1])
    (space.folder / f"{name}.df3").write_bytes(count.astype(">u2").tobytes() + levels.tobytes())
    space.functions.append(
        f'#declare {name} = function {{ pattern {{ density_file df3 "{name}.df3" interpolate 1 }} }}')
    # Sample k lies at k / n of POV-Ray's unit cube.
    size = spacing * count
    steepest = 1.5 * size.max() / (2 * band)
    return (f"isosurface {{ function {{ {name}(x, y, z) - 0.5 }} contained_by {{ box {{ 0, {vector(1 - 1 / count)} }} }} "
            f"accuracy 0.0005 max_gradient {steepest:.6g} scale {vector(size)} translate {vector(origin)} ")


def read_distance(shape):
    """(z, y, x) [m], origin [m], spacing [m] of a signed distance from a file."""
    path = Path(shape["file"])
    origin, spacing = (0.0, 0.0, 0.0), None
    try:
        if path.suffix == ".npy":
            distance = np.load(path)
        elif path.suffix == ".h5":
            with h5py.File(path, "r") as file:
                data = file["distance"]
                distance = data[:]
                if "spacing" in data.attrs:
                    origin = [data.attrs[f"origin_{axis}"] for axis in "xyz"]
                    spacing = data.attrs["spacing"]
        else:                                # SDFGen's text
            words = path.read_text().split()
            count = [int(word) for word in words[:3]]
            origin, spacing = [float(word) for word in words[3:6]], float(words[6])
            distance = np.array(words[7:], dtype=float).reshape(count[::-1])
    except (OSError, KeyError) as error:
        raise ValueError(f"the signed distance {path} cannot be read: {error}") from error
    spacing = number(shape["spacing"]) if "spacing" in shape else spacing
    origin = numbers(shape["origin"]) if "origin" in shape else np.array(origin)
    scale = float(shape.get("scale", 1))
    return scale * distance, scale * origin, scale * float(spacing)


SHAPES = {"sphere": sphere, "box": box, "capsule": capsule, "cylinder": cylinder, "cone": cone, "ellipsoid": ellipsoid,
          "half_space": half_space, "brush": brush, "csg": csg, "mesh": mesh_file, "sdf": level_set}
