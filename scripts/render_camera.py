"""A perspective camera that looks at things from a side and frames them."""

from dataclasses import dataclass

import numpy as np

ANGLE = 30.0        # [deg] field of view across the picture: a long lens, so that little is distorted
STEEPEST = 89.99    # [deg]
MARGIN = 1.06       # room about what is framed


@dataclass(frozen=True)
class Camera:
    """Where the camera is and looks. All lengths in the units of what it frames; z is up."""

    location: np.ndarray
    look_at: np.ndarray
    aspect: float               # width over height of the picture
    angle: float = ANGLE        # [deg]

    @property
    def distance(self):
        return float(np.linalg.norm(self.look_at - self.location))

    @property
    def azimuth(self):
        """[deg] of the side on which the camera stands."""
        away = self.location - self.look_at
        return float(np.degrees(np.arctan2(away[1], away[0])))

    def pixel(self, width):
        """Side of a pixel at the point looked at, for a picture that is `width` pixels wide."""
        return 2 * self.distance * np.tan(np.radians(self.angle) / 2) / width


def axes(azimuth, elevation):
    """Right, up and forward of a camera that stands at an azimuth and an elevation [deg] seen from what it looks at.

    Azimuth 0 is on the side of +x, 90 on that of +y; elevation 90 looks straight down, with +y up for azimuth -90.
    """
    # Straight down, the azimuth would be lost with which side of the picture is up.
    azimuth, elevation = np.radians(azimuth), np.radians(np.clip(elevation, -STEEPEST, STEEPEST))
    back = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    return right, np.cross(back, right), -back


def framed(points, view, aspect, zoom=1.0, look_at=None, distance=None):
    """The camera for which points (n, 3) just fill the picture, from a view (azimuth, elevation).

    `zoom` 2 shows things twice as large. `look_at` and `distance` replace what framing finds.
    """
    right, up, forward = axes(*view)
    across = np.tan(np.radians(ANGLE) / 2) / MARGIN
    above = across / aspect
    middle = (points.min(axis=0) + points.max(axis=0)) / 2 if look_at is None else np.asarray(look_at, dtype=float)
    for _ in range(20):         # perspective shifts the middle of the picture: centre it, then measure again
        r, u, f = ((points - middle) @ axis for axis in (right, up, forward))
        away = max(np.max(np.abs(r) / across - f), np.max(np.abs(u) / above - f))
        if look_at is not None:
            break
        seen = np.stack([r / (away + f), u / (away + f)])
        shift = away * (seen.min(axis=1) + seen.max(axis=1)) / 2
        middle = middle + shift[0] * right + shift[1] * up
    away = (away if distance is None else distance) / zoom
    return Camera(middle - away * forward, middle, aspect)
