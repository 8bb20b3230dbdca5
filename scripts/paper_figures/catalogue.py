"""All figures, in the order of the paper."""

from . import avalanche, flume, hbar, layers, piles, sampling, stamp

FIGURES = [avalanche.FIGURE_1A, piles.FIGURE, hbar.FIGURE, sampling.FIGURE, stamp.FIGURE, flume.FIGURE_A,
           flume.FIGURE_B, layers.FIGURE, avalanche.FIGURE_17]
