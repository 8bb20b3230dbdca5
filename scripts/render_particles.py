"""Particles of sand as spheres for POV-Ray, each with a tone of its own that it keeps."""

import numpy as np

from render_look import GRAINS, srgb

TONES = 24                      # different tones between dark and light grains
RADIUS = 0.55                   # [particle spacings]
# The rounds of splitmix64 (Steele, Lea and Flood, OOPSLA 2014): shift, factor.
MIXING = ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB))


def tones_of(ids):
    """The tone of each particle, 0 to TONES - 1: the same for an identity in every frame, and like noise over them."""
    mixed = ids.astype(np.uint64)
    for shift, factor in MIXING:
        mixed = (mixed ^ (mixed >> np.uint64(shift))) * np.uint64(factor)
    return ((mixed >> np.uint64(33)) % np.uint64(TONES)).astype(int)


def particles(domain, positions, ids, radius, grains):
    """The text of all particles: positions (n, 3) [m], ids (n), radius [m]."""
    text = []
    tones = tones_of(ids)
    places = domain.local(positions)
    colours = tone_colours(grains)
    for tone in range(TONES):
        own = places[tones == tone]
        if own.size:
            spheres = b"sphere{<%.5f,%.5f,%.5f>,R}\n" * len(own) % tuple(own.ravel().tolist())
            text.append(f"union {{\n{spheres.decode()}pigment {{ {srgb(colours[tone])} }} }}\n")
    return f"#declare R = {radius * domain.scale:.9g};\n" + "".join(text)


def side_by_side(positions, ids, width, across):
    """Particles of a row of cells `width` wide [m], repeated with other tones until they fill `across` [m]."""
    copies = max(round(across / width), 1)
    shifts = width * np.repeat(np.arange(copies), len(ids))
    repeated = np.tile(positions.astype(float), (copies, 1))
    repeated[:, 1] = (repeated[:, 1] + shifts) * (across / (copies * width))
    return repeated, np.tile(ids, copies) + np.repeat(np.arange(copies), len(ids)) * (1 << 32)


def tone_colours(grains):
    """(TONES, 3) in 0..255 from dark to light grains; lighter than the surface, for spheres shade each other."""
    dark, _, light = (np.array(colour, dtype=float) for colour in GRAINS[grains])
    share = np.linspace(0.15, 0.95, TONES)[:, None]
    return np.clip(1.1 * (dark * (1 - share) + light * share), 0, 255)
