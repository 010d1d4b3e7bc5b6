"""A simple simulation with NumPy: many trajectories in parallel, Runge-Kutta steps of order 4. All
impulses of a step act at its end. A step that ends beyond the wall is reflected at its end.

    simulation.py STEP TIME        TIME: total time of all 4000 trajectories
"""

import sys
import time

import numpy as np

from problem import DAMPING, PROBLEMS, V_EDGES, Y_EDGES, force, print_result

TRAJECTORIES = 4000


def main():
    step, total = float(sys.argv[1]), float(sys.argv[2])
    problem = PROBLEMS["impulses"]
    begin = time.process_time()
    random = np.random.default_rng(1)
    y = np.abs(random.normal(0, 0.6, TRAJECTORIES))
    v = random.normal(0, 0.7, TRAJECTORIES)
    counts_y, counts_v = np.zeros(len(Y_EDGES) - 1), np.zeros(len(V_EDGES) - 1)
    samples = 0
    burn_in, every = 60.0, 0.5

    def slope(y, v):
        return v, -DAMPING * v - force(y)

    steps = int((burn_in + total / TRAJECTORIES) / step)
    for k in range(steps):
        k1 = slope(y, v)
        k2 = slope(y + step / 2 * k1[0], v + step / 2 * k1[1])
        k3 = slope(y + step / 2 * k2[0], v + step / 2 * k2[1])
        k4 = slope(y + step * k3[0], v + step * k3[1])
        y = y + step / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
        v = v + step / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
        hit = y < 0
        y[hit] *= -problem.restitution
        v[hit] *= -problem.restitution
        number = random.poisson(problem.rate * step, TRAJECTORIES)
        kicked = number > 0
        v[kicked] += random.normal(0, problem.deviation * np.sqrt(number[kicked]))
        if k * step > burn_in and k % max(1, round(every / step)) == 0:
            counts_y += np.histogram(y, Y_EDGES)[0]
            counts_v += np.histogram(v, V_EDGES)[0]
            samples += TRAJECTORIES
    seconds = time.process_time() - begin
    print_result(counts_y / samples / np.diff(Y_EDGES), counts_v / samples / np.diff(V_EDGES), seconds)


main()
