"""A simple finite-volume solver with SciPy: central fluxes of second order on a uniform grid of
y >= 0. At the wall, the flux that leaves at y = 0 with v < 0 enters at -r v. Impulses are a matrix of
Gaussian probabilities. The stationary solution is computed by splu, or by solve_ivp with BDF.

    differences.py PROBLEM CELLS direct|bdf
"""

import sys
import time

import numpy as np
import scipy.sparse as sparse
from scipy.integrate import solve_ivp
from scipy.sparse.linalg import splu
from scipy.special import ndtr

from problem import DAMPING, PROBLEMS, V_EDGES, V_MAX, Y_EDGES, Y_MAX, force, rebin, print_result


def overlap(from_edges, to_edges):
    """Fractions of source bins in target bins, shape (targets, sources)."""
    low = np.maximum(to_edges[:-1, None], from_edges[None, :-1])
    high = np.minimum(to_edges[1:, None], from_edges[None, 1:])
    return np.clip(high - low, 0, None) / np.diff(from_edges)[None, :]


def generator(problem, cells):
    """The matrix A of dP/dt = A P, with P the masses of the cells; y is the slow index."""
    y_edges, v_edges = np.linspace(0, Y_MAX, cells + 1), np.linspace(-V_MAX, V_MAX, cells + 1)
    dy, dv = y_edges[1], v_edges[1] - v_edges[0]
    y, v = (y_edges[:-1] + y_edges[1:]) / 2, (v_edges[:-1] + v_edges[1:]) / 2
    one_y, one_v = sparse.identity(cells), sparse.identity(cells)

    def difference_of_fluxes(inner):
        """-(flux above - flux below), with fluxes `inner` through inner faces and none at the ends."""
        below = sparse.eye(cells, cells - 1, 0)
        above = sparse.eye(cells, cells - 1, -1)
        return (above - below) @ inner

    mean = sparse.diags([0.5, 0.5], [0, 1], shape=(cells - 1, cells))
    slope = sparse.diags([-1, 1], [0, 1], shape=(cells - 1, cells))

    # Transport v p_y. At the wall: outflow with v < 0 by extrapolation, inflow with -r v.
    along_y = sparse.kron(difference_of_fluxes(mean), sparse.diags(v)) / dy
    falling = np.where(v < 0, -v, 0) / dy
    out = sparse.csr_matrix(([1.5, -0.5], ([0, 0], [0, 1])), shape=(cells, cells))
    target = overlap(np.sort(-problem.restitution * v_edges), v_edges)[:, ::-1]
    bounced = sparse.csr_matrix(np.where(target > 1e-14, target, 0) - np.eye(cells))
    wall = sparse.kron(out, bounced @ sparse.diags(falling))

    # Transport ((-c v - g) p)_v.
    faces = v_edges[1:-1]
    damping = sparse.kron(one_y, difference_of_fluxes(sparse.diags(-DAMPING * faces) @ mean)) / dv
    pulling = sparse.kron(sparse.diags(-force(y)), difference_of_fluxes(mean)) / dv
    a = along_y + wall + damping + pulling
    if problem.rate == 0:
        return a + problem.diffusion * sparse.kron(one_y, difference_of_fluxes(-slope)) / dv**2
    # Gaussian increments from the centres of cells; mass beyond the grid stays in the outermost cells.
    probability = ndtr((v_edges[:, None] - v[None, :]) / problem.deviation)
    probability[0], probability[-1] = 0, 1
    kick = np.diff(probability, axis=0)
    kick[kick < 1e-14] = 0
    return a + problem.rate * sparse.kron(one_y, sparse.csr_matrix(kick) - one_v)


def direct(a):
    n = a.shape[0]
    lil = a.tolil()
    lil[n // 2 + int(np.sqrt(n)) // 2] = 1  # normalisation of the mass in place of one equation
    right = np.zeros(n)
    right[n // 2 + int(np.sqrt(n)) // 2] = 1
    return splu(lil.tocsc()).solve(right)


def integrate_in_time(a, cells):
    y = (np.arange(cells) + 0.5) * Y_MAX / cells
    v = -V_MAX + (np.arange(cells) + 0.5) * 2 * V_MAX / cells
    start = np.exp(-(y[:, None] ** 2) - v[None, :] ** 2).ravel()
    a = a.tocsc()
    answer = solve_ivp(lambda t, p: a @ p, (0, 300), start / start.sum(), method="BDF", jac=a,
                       rtol=1e-4, atol=1e-10)
    return answer.y[:, -1]


def main():
    problem, cells, stepper = PROBLEMS[sys.argv[1]], int(sys.argv[2]), sys.argv[3]
    begin = time.process_time()
    a = generator(problem, cells)
    masses = (direct(a) if stepper == "direct" else integrate_in_time(a, cells)).reshape(cells, cells)
    masses /= masses.sum()
    seconds = time.process_time() - begin
    y_edges, v_edges = np.linspace(0, Y_MAX, cells + 1), np.linspace(-V_MAX, V_MAX, cells + 1)
    print_result(rebin(y_edges, masses.sum(axis=1) / np.diff(y_edges), Y_EDGES),
        rebin(v_edges, masses.sum(axis=0) / np.diff(v_edges), V_EDGES), seconds)


main()
