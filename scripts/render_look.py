"""What pictures look like: light, sky, materials and how much work goes into them, as POV-Ray's text."""

from dataclasses import dataclass, replace

import numpy as np

SUN_HEIGHT = 33            # [deg] low enough that relief casts shadows
SUN_TURN = -118            # [deg] from the camera's azimuth: from the left and somewhat behind
FAR = 1e4                  # [units of the scene] of lights
SUN_RADIUS = 2.2           # [deg] seen from the sand: shadows are as soft as under a lamp

# sRGB in 0..255: dark, middle and light grains.
GRAINS = {"sand": ((174, 143, 103), (210, 183, 143), (236, 218, 187)),
          "snow": ((222, 230, 241), (237, 242, 250), (250, 252, 255))}
GRAIN = 1.25               # [pixels] size of a grain where the camera looks at: finer ones would not be seen
BUMPS = {"sand": 0.45, "snow": 0.2}
DIFFUSE = {"sand": 0.95, "snow": 0.75}
SIDE_DARKER = 0.92         # cut faces beside the surface
BOARD = (190, 190, 188)
ROCK = ((104, 98, 92), (128, 121, 113), (150, 143, 134))


METAL = "texture { pigment { srgb <0.46, 0.52, 0.58> } finish { specular 0.35 roughness 0.03 } }"
WOODS = ((184, 135, 89), (163, 115, 71), (133, 89, 54))
PAINTS = ((184, 41, 33), (33, 77, 148), (51, 117, 66), (217, 153, 33), (115, 61, 128))


@dataclass(frozen=True)
class Quality:
    """What a picture may cost."""

    radiosity: str             # POV-Ray's settings for light from the sky, with occlusion; none: an even sky
    sun_samples: int           # lights along a side of the sun; 1 casts sharp shadows
    options: tuple             # POV-Ray's for antialiasing


QUALITIES = {
    "draft": Quality("", 1, ("+A0.3", "+AM1", "+R2")),
    "good": Quality("pretrace_end 0.01 count 70 error_bound 0.7 nearest_count 5 low_error_factor 0.7 "
                    "minimum_reuse 0.012", 5, ("+A0.3", "+AM1", "+R2")),
    "best": Quality("pretrace_end 0.01 count 200 error_bound 0.5 nearest_count 8 low_error_factor 0.7 "
                    "minimum_reuse 0.01", 9, ("+A0.1", "+AM2", "+R3")),
}


def vector(values):
    """POV-Ray's vector."""
    return "<" + ",".join(f"{value:.15g}" for value in values) + ">"


def srgb(colour, factor=1.0):
    """A colour of 0..255."""
    return f"srgb {vector(factor * np.asarray(colour) / 255)}"


def with_even_sky(quality):
    """Without shadows from the sky: for crowds of small things, in whose every gap it would have to be found."""
    return replace(quality, radiosity="")


def settings(camera, quality):
    radiosity = ""
    if quality.radiosity:
        radiosity = ("radiosity { pretrace_start 0.08 recursion_limit 1 always_sample off "
                     f"gray_threshold 0.3 {quality.radiosity} }}")
    return f"""#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 4 {radiosity} }}
#default {{ finish {{ ambient 0 emission 0 diffuse 1 }} }}
camera {{ location {vector(camera.location)} sky z up z right {-camera.aspect:.9g} * x angle {camera.angle}
  look_at {vector(camera.look_at)} }}"""


def light(camera, quality, even=False):
    """A low sun and a bright sky, and a white floor; `even`: white light that changes colours little."""
    azimuth = np.radians(camera.azimuth + SUN_TURN)
    height = np.radians(55 if even else SUN_HEIGHT)
    sun = np.array([np.cos(height) * np.cos(azimuth), np.cos(height) * np.sin(azimuth), np.sin(height)])
    colour, sky = ("0.75", "<1, 1, 1> * 0.65") if even else ("<1.0, 0.955, 0.885> * 1.42", "<0.93, 0.97, 1.03>")
    area = ""
    if quality.sun_samples > 1:
        across = 2 * FAR * np.tan(np.radians(SUN_RADIUS))
        area = (f"area_light x * {across:.4g}, y * {across:.4g}, {quality.sun_samples}, {quality.sun_samples} "
                "adaptive 1 circular orient")
    text = f"light_source {{ {vector(FAR * sun)} rgb {colour} {area} parallel point_at 0 }}\n"
    if not quality.radiosity:
        # An even sky: from above, from where the camera stands, and from where the sun does not reach.
        away = camera.location - camera.look_at
        for place, share in (((0, 0, 1), 0.34), ((away[0], away[1], 0.35 * np.hypot(*away[:2])), 0.36),
                             ((-sun[0], -sun[1], 0.35), 0.32)):
            place = FAR * np.asarray(place) / np.linalg.norm(place)
            text += f"light_source {{ {vector(place)} rgb {sky} * {share} shadowless parallel point_at 0 }}\n"
    return text + f"""sky_sphere {{ pigment {{ gradient z color_map {{
  [0 rgb 0.95] [0.5 rgb <0.62, 0.75, 0.92> * 0.8] }} }} }}
plane {{ z, 0.1 pigment {{ rgb {1.2 if even else 0.86} }} }}"""


def materials(grains, grain):
    """Sand, SandSide, Board and Rock; `grain` is the size of a grain, a little more than a pixel."""
    dark, middle, bright = GRAINS[grains]
    sand = """#declare {name} = texture {{
  pigment {{ granite scale {patches:.6g}
    color_map {{ [0.1 {dark}] [0.42 {middle}] [0.6 {middle}] [0.9 {bright}] }} }}
  normal {{ bumps {bumps} scale {grain:.6g} }} finish {{ diffuse {diffuse} }} }}
"""
    text = "".join(sand.format(name=name, patches=3 * grain, grain=grain, bumps=BUMPS[grains], diffuse=DIFFUSE[grains],
                               dark=srgb(dark, factor), middle=srgb(middle, factor), bright=srgb(bright, factor))
                   for name, factor in (("Sand", 1.0), ("SandSide", SIDE_DARKER)))
    low, middle, high = map(srgb, ROCK)
    return text + f"""#declare Board = texture {{ pigment {{ {srgb(BOARD)} }} }}
#declare BoardSide = texture {{ Board }}
#declare Rock = texture {{
  pigment {{ wrinkles scale {30 * grain:.6g} color_map {{ [0.2 {low}] [0.5 {middle}] [0.8 {high}] }} }}
  normal {{ wrinkles 0.7 scale {14 * grain:.6g} }} }}
#declare RockSide = texture {{ pigment {{ {srgb(ROCK[1], SIDE_DARKER)} }} }}"""


def wood(size):
    """Wood whose grain runs along the longest of a piece's sides [m]."""
    size = np.asarray(size)
    along = ("rotate 90 * y", "rotate 90 * x", "")[int(np.argmax(size))]
    early, middle, late = map(srgb, WOODS)
    return (f"texture {{ pigment {{ wood turbulence 0.08 scale {0.15 * size.min():.6g} rotate <3, 3, 0> {along} "
            f"color_map {{ [0 {early}] [0.7 {middle}] [1 {late}] }} }} }}")


def paint(k):
    """The k-th paint; they come again."""
    return (f"texture {{ pigment {{ {srgb(PAINTS[k % len(PAINTS)])} }} finish {{ specular 0.3 roughness 0.02 }} }}")
