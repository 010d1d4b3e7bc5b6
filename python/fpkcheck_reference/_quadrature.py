"""Gauss-Legendre quadrature on panels, and cubic splines."""

import numpy as np

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)


def panel_rule(edges):
    """Nodes and weights of the ten-point Gauss-Legendre rule on each panel.

    edges: increasing, shape (n + 1,). Returns two arrays of the shape (n, 10).
    """
    edges = np.asarray(edges, dtype=float)
    half = np.diff(edges)[:, None] / 2
    centre = (edges[1:] + edges[:-1])[:, None] / 2
    return centre + half * _NODES, half * _WEIGHTS


def integral(function, edges):
    """The integral of a vectorised function over all panels."""
    nodes, weights = panel_rule(edges)
    return float(np.sum(weights * function(nodes)))


class CubicSpline:
    """Cubic spline through points, with the not-a-knot condition at both ends (de Boor 1978).

    points: increasing, shape (n,) with n >= 4; values: shape (n,).
    """

    def __init__(self, points, values):
        x, f = np.asarray(points, dtype=float), np.asarray(values, dtype=float)
        h, n = np.diff(x), len(x)
        slope = np.diff(f) / h
        # Equations of the second derivatives m at the inner points. The not-a-knot condition
        # m[0] = (1 + q) m[1] - q m[2] with q = h[0] / h[1], and its mirror image, eliminate the ends.
        lower, diagonal, upper = h[:-1].copy(), 2 * (h[:-1] + h[1:]), h[1:].copy()
        first, last = h[0] / h[1], h[-1] / h[-2]
        diagonal[0] += h[0] * (1 + first)
        upper[0] -= h[0] * first
        diagonal[-1] += h[-1] * (1 + last)
        lower[-1] -= h[-1] * last
        right = 6 * np.diff(slope)
        for i in range(1, n - 2):
            factor = lower[i] / diagonal[i - 1]
            diagonal[i] -= factor * upper[i - 1]
            right[i] -= factor * right[i - 1]
        m = np.zeros(n)
        m[n - 2] = right[-1] / diagonal[-1]
        for i in range(n - 4, -1, -1):
            m[i + 1] = (right[i] - upper[i] * m[i + 2]) / diagonal[i]
        m[0] = (1 + first) * m[1] - first * m[2]
        m[-1] = (1 + last) * m[-2] - last * m[-3]
        self.points = x
        # f(x) = f_i + t (b_i + t (m_i / 2 + t d_i)) with t = x - x_i
        self._coefficients = f[:-1], slope - h * (2 * m[:-1] + m[1:]) / 6, m[:-1] / 2, np.diff(m) / (6 * h)

    def _panel(self, x):
        return np.clip(np.searchsorted(self.points, x, side="right") - 1, 0, len(self.points) - 2)

    def __call__(self, x):
        """The spline at x; the first and the last polynomial continue it beyond the points."""
        x = np.asarray(x, dtype=float)
        i = self._panel(x)
        f, b, a, d = (c[i] for c in self._coefficients)
        t = x - self.points[i]
        return f + t * (b + t * (a + t * d))

    def derivative(self, x):
        """The first derivative of the spline at x."""
        x = np.asarray(x, dtype=float)
        i = self._panel(x)
        _, b, a, d = (c[i] for c in self._coefficients)
        t = x - self.points[i]
        return b + t * (2 * a + t * 3 * d)
