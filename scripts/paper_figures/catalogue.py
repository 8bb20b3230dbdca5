"""All figures, in the order of the paper."""

from . import flume, hbar, layers, piles

FIGURES = [piles.FIGURE, hbar.FIGURE, flume.FIGURE_A, flume.FIGURE_B, layers.FIGURE]
