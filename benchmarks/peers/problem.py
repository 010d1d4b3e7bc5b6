"""The two test problems, their common bins, and the exact solution of one.

Both are the paper's oscillator of case 1, y'' + 0.1 y' + y + 0.1 y^3 = excitation with a wall at
y = 0. `white`: white noise with restitution coefficient 1, whose density is known. `impulses`:
Gaussian impulses of rate 1 with restitution coefficient 0.98.
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
    rate: float  # impulse rate; 0 for white noise

    @property
    def diffusion(self):
        """The coefficient D of D p_vv."""
        return INTENSITY / 2

    @property
    def deviation(self):
        """Standard deviation of an impulse."""
        return np.sqrt(INTENSITY / self.rate)


PROBLEMS = {p.name: p for p in (Problem("white", 1.0, 0.0), Problem("impulses", 0.98, 1.0))}

Y_EDGES = np.linspace(0, Y_MAX, BINS + 1)
V_EDGES = np.linspace(-V_MAX, V_MAX, BINS + 1)


def force(y):
    return y + CUBIC * y**3


def exact_white():
    """Bin averages of p(y), p(y') for `white`, p ~ exp(-(c/D) H), by Gauss-Legendre quadrature."""
    strength = DAMPING / (INTENSITY / 2)

    def averages(edges, potential):
        x, w = np.polynomial.legendre.leggauss(12)
        half = np.diff(edges) / 2
        points = (edges[:-1] + half)[:, None] + half[:, None] * x
        density = np.exp(-strength * potential(points)) @ w / 2
        return density / np.sum(density * np.diff(edges))

    return (averages(Y_EDGES, lambda y: y**2 / 2 + CUBIC * y**4 / 4),
            averages(V_EDGES, lambda v: v**2 / 2))


def rebin(edges, density, wanted):
    """Averages over the bins `wanted` of a density given as averages over finer bins."""
    cumulative = np.concatenate(([0], np.cumsum(density * np.diff(edges))))
    at = np.interp(wanted, edges, cumulative)  # exact where edges coincide
    return np.diff(at) / np.diff(wanted)


def print_result(y, v, seconds):
    """Prints the result of a program: bin averages, and processor time without imports."""
    out = csv.writer(sys.stdout)
    out.writerow(["seconds", seconds])
    for name, density in (("y", y), ("v", v)):
        out.writerow([name, *density])
