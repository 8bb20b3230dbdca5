"""All figures, in the order of the paper."""

from . import piles

FIGURES = [piles.FIGURE]
