"""The two problems that all solve, their common bins, and what they are measured against.

Both are the paper's oscillator of case 1, y'' + 0.1 y' + y + 0.1 y^3 = excitation with a wall at
y = 0: `white` under white noise with restitution 1, whose density is known; `impulses` under
Gaussian impulses of rate 1 with restitution 0.98.
"""

import csv
import sys
from dataclasses import dataclass

import numpy as np

DAMPING, CUBIC, INTENSITY = 0.1, 0.1, 0.1
Y_MAX, V_MAX, BINS = 4.2, 4.48, 70


@dataclass(frozen=True)
class Problem:
    name: str
    restitution: float
    rate: float  # of impulses; 0: white noise

    @property
    def diffusion(self):
        """D of D p_vv."""
        return INTENSITY / 2

    @property
    def deviation(self):
        """Of an impulse."""
        return np.sqrt(INTENSITY / self.rate)


PROBLEMS = {p.name: p for p in (Problem("white", 1.0, 0.0), Problem("impulses", 0.98, 1.0))}

Y_EDGES = np.linspace(0, Y_MAX, BINS + 1)
V_EDGES = np.linspace(-V_MAX, V_MAX, BINS + 1)


def force(y):
    return y + CUBIC * y**3


def exact_white():
    """Bin averages of p(y), p(y') for `white`: p ~ exp(-(c/D) H), Gauss-Legendre in each bin."""
    strength = DAMPING / (INTENSITY / 2)

    def averages(edges, potential):
        x, w = np.polynomial.legendre.leggauss(12)
        half = np.diff(edges) / 2
        points = (edges[:-1] + half)[:, None] + half[:, None] * x
        density = np.exp(-strength * potential(points)) @ w / 2
        return density / np.sum(density * np.diff(edges))

    return (averages(Y_EDGES, lambda y: y**2 / 2 + CUBIC * y**4 / 4),
            averages(V_EDGES, lambda v: v**2 / 2))


def joined(edges, density, wanted):
    """Averages over the wanted bins of a density given as averages over others that divide them."""
    cumulative = np.concatenate(([0], np.cumsum(density * np.diff(edges))))
    at = np.interp(wanted, edges, cumulative)  # exact where edges coincide
    return np.diff(at) / np.diff(wanted)


def say(y, v, seconds):
    """What every peer prints: bin averages, and its processor time without what it imports."""
    out = csv.writer(sys.stdout)
    out.writerow(["seconds", seconds])
    for name, density in (("y", y), ("v", v)):
        out.writerow([name, *density])
