"""Quadratic finite elements with FEniCS for white noise with restitution coefficient 1, where y = |z|
and z has no wall: the stationary Fokker-Planck equation on a rectangle of (z, z') with zero flux at
the boundary. One value is prescribed, and the mass is normalised to 1 afterwards.

    elements.py CELLS
"""

import sys
import time

import dolfin as fe
import numpy as np

from problem import CUBIC, DAMPING, INTENSITY, V_EDGES, V_MAX, Y_EDGES, Y_MAX, print_result


def main():
    cells = int(sys.argv[1])
    fe.set_log_level(30)
    fe.parameters["form_compiler"]["quadrature_degree"] = 6
    begin = time.process_time()
    mesh = fe.RectangleMesh(fe.Point(-Y_MAX, -V_MAX), fe.Point(Y_MAX, V_MAX), cells, cells,
                            "crossed")
    space = fe.FunctionSpace(mesh, "CG", 2)
    p, test = fe.TrialFunction(space), fe.TestFunction(space)
    z, v = fe.SpatialCoordinate(mesh)
    form = (p * (v * test.dx(0) + (-DAMPING * v - z - CUBIC * z**3) * test.dx(1))
            - INTENSITY / 2 * p.dx(1) * test.dx(1)) * fe.dx
    nothing = fe.Constant(0.0) * test * fe.dx
    at_rest = fe.DirichletBC(space, 1.0, lambda x, _: abs(x[0]) + abs(x[1]) < 1e-10, "pointwise")
    solution = fe.Function(space)
    fe.solve(form == nothing, solution, at_rest)

    # Gauss-Legendre quadrature in every bin, for both halves z < 0 and z > 0.
    x, w = np.polynomial.legendre.leggauss(3)

    def points(edges):
        half = np.diff(edges) / 2
        return ((edges[:-1] + half)[:, None] + half[:, None] * x).ravel()

    # Values at the quadrature points: sums over both halves, by y and v.
    values = np.array([[solution(s * y, u) + solution(-s * y, u) for u in points(V_EDGES)]
                       for s in (1,) for y in points(Y_EDGES)])
    weights = np.tile(w / 2, len(Y_EDGES) - 1)
    cell = (values * weights[:, None] * weights[None, :]).reshape(70, 3, 70, 3).sum(axis=(1, 3))
    seconds = time.process_time() - begin
    dy, dv = np.diff(Y_EDGES), np.diff(V_EDGES)
    mass = np.sum(cell * dy[:, None] * dv[None, :])
    print_result(cell @ dv / mass, dy @ cell / mass, seconds)


main()
