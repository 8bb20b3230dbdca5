"""All figures, in the order of the paper."""

from . import flume, hbar, layers, piles, sampling, stamp

FIGURES = [piles.FIGURE, hbar.FIGURE, sampling.FIGURE, stamp.FIGURE, flume.FIGURE_A, flume.FIGURE_B, layers.FIGURE]
