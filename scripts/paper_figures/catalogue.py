"""All figures, in the order of the paper."""

from . import avalanche, column, flume, grains, hbar, layers, piles, sampling, shows, stamp, table1

FIGURES = [avalanche.FIGURE_1A, shows.FIGURE_1B, piles.FIGURE, hbar.FIGURE, sampling.FIGURE, stamp.FIGURE,
           shows.FIGURE_9,
           grains.FIGURE, flume.FIGURE_A, flume.FIGURE_B, layers.FIGURE, shows.FIGURE_13, shows.FIGURE_14,
           column.FIGURE,
           shows.FIGURE_16, avalanche.FIGURE_17, table1.FIGURE]
