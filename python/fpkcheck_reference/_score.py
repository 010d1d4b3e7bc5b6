"""Distances of a density from the reference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Union

import numpy as np

from ._catalogue import problem as problem_of_name
from ._problem import MOMENTS, VARIABLES, Problem
from ._quadrature import CubicSpline, panel_rule


@dataclass(frozen=True)
class Distance:
    """L1 distance of a density from the reference, the L1 error of the reference, and the integral of the density."""

    l1: float
    reference_error: float
    mass: float


@dataclass(frozen=True)
class MomentError:
    """A moment of the density, its reference value with the error of that value, and the difference."""

    moment: float
    reference: float
    reference_error: float

    @property
    def difference(self) -> float:
        return self.moment - self.reference


@dataclass(frozen=True)
class Score:
    """Errors of a density: distances under the keys "y" and "ydot", moment errors under names such as "E[y^2]"."""

    problem: str
    distances: dict
    moments: dict

    def __str__(self):
        lines = [f"{self.problem}: L1 of p({v}) {d.l1:.2g} +- {d.reference_error:.1g}, mass {d.mass:.8g}"
                 for v, d in self.distances.items()]
        lines += [f"{self.problem}: {q} {m.moment:.8g}, reference {m.reference:.8g} +- {m.reference_error:.1g}, "
                  f"difference {m.difference:+.2g}" for q, m in self.moments.items()]
        return "\n".join(lines)


def score(problem: Union[str, Problem], p: Any) -> Score:
    """The L1 distances and the errors of moments of a density.

    p: a density of y, or a mapping with the keys "y" and "ydot" (p(y) and p(y')), or one of these keys. A density is
    - a vectorised function, evaluated between the walls in the range of `problem.density(variable)` and, for a
      reference by finite volumes, up to half of this range beyond; or
    - a pair of n increasing points and n values, n >= 4: interpolated by a cubic spline, 0 outside the points; or
    - a pair of n + 1 increasing edges and n averages over the bins between the edges, n >= 4.
    The density is not normalised. The L1 distance is int |p - p_ref|. For edges and averages, and where the reference
    consists of averages over bins, it is the sum over these bins, which is at most the integral.
    Raises ValueError for an unknown problem, a variable without a reference density, or other contents.
    """
    if isinstance(problem, str):
        problem = problem_of_name(problem)
    if not isinstance(p, Mapping):
        p = {"y": p}
    unknown = set(p) - set(VARIABLES)
    if unknown or not p:
        raise ValueError(f"the keys are {sorted(p)}; use 'y', 'ydot' or both")
    distances, moments = {}, {}
    for variable, density in p.items():
        reference = problem.density(variable)
        distances[variable], moment = _compare(problem, variable, reference, density)
        for quantity, (of, order) in MOMENTS.items():
            if of == variable and any(v.quantity == quantity for v in problem.values):
                value = problem.value(quantity)
                moments[quantity] = MomentError(moment(order), value.value, value.error)
    return Score(problem.name, distances, moments)


def _compare(problem, variable, reference, density):
    """The Distance, and the function that returns the moment of an order."""
    where = f"{problem.name}, density of {variable}"
    exact = variable in problem.exact_densities
    lower, upper = reference.lower, reference.upper
    panels = reference.edges
    bins = None
    if callable(density):
        function = density
        if not exact:
            # The table ends where the density is below about 1e-6 of its peak, unless it ends at a wall.
            walls = problem.walls if variable == "y" else (-np.inf, np.inf)
            width = upper - lower
            below = np.linspace(max(lower - width / 2, walls[0]), lower, 51)
            above = np.linspace(upper, min(upper + width / 2, walls[1]), 51)
            panels = np.unique(np.concatenate([below, panels, above]))
    else:
        abscissae, values = _checked_arrays(where, density)
        if len(abscissae) == len(values):
            spline = CubicSpline(abscissae, values)

            def function(x):
                return np.where((x >= abscissae[0]) & (x <= abscissae[-1]), spline(x), 0.0)
        else:
            bins = abscissae, values
            function = CubicSpline(abscissae, np.concatenate([[0], np.cumsum(values * np.diff(abscissae))])).derivative
        panels = abscissae if bins is not None else np.union1d(abscissae, panels)
    nodes, weights = panel_rule(panels)
    sampled = np.asarray(function(nodes.ravel()), dtype=float)
    if sampled.shape != nodes.ravel().shape:
        raise ValueError(f"{where}: the function returns the shape {sampled.shape} for {nodes.size} points; "
                         "use a vectorised function")
    if not np.all(np.isfinite(sampled)):
        at = nodes.ravel()[~np.isfinite(sampled)][0]
        raise ValueError(f"{where}: the value at {at:.6g} is not finite; return 0 where the density is negligible")
    sampled = sampled.reshape(nodes.shape)
    mass = float(np.sum(weights * sampled))
    if bins is not None:
        edges, values = bins
        inside = np.sum(np.abs(values - reference.averages(edges)) * np.diff(edges))
        l1 = inside + _probability_outside(reference, edges[0], edges[-1])
    elif exact:
        l1 = np.sum(weights * np.abs(sampled - reference(nodes)))
    else:
        masses = np.sum(weights * sampled, axis=1)
        of_bin = np.searchsorted(reference.edges, (panels[1:] + panels[:-1]) / 2) - 1
        within = (of_bin >= 0) & (of_bin < len(reference.edges) - 1)
        summed = np.bincount(of_bin[within], masses[within], len(reference.edges) - 1)
        probabilities = reference.averages(reference.edges) * np.diff(reference.edges)
        outside = np.sum(np.sum(weights * np.abs(sampled), axis=1)[~within])
        l1 = np.sum(np.abs(summed - probabilities)) + outside
    error = 1e-10 if exact else problem.value(f"l1_error_{variable}").value
    return (Distance(float(l1), error, mass), lambda order: float(np.sum(weights * nodes**order * sampled)))


def _probability_outside(reference, lower, upper):
    parts = [(reference.lower, min(lower, reference.upper)), (max(upper, reference.lower), reference.upper)]
    return sum(float(reference.averages([a, b])[0]) * (b - a) for a, b in parts if b > a)


def _checked_arrays(where, density):
    try:
        abscissae, values = (np.asarray(part, dtype=float) for part in density)
    except (TypeError, ValueError):
        raise ValueError(f"{where}: neither a function nor a pair of arrays") from None
    if abscissae.ndim != 1 or values.ndim != 1 or len(abscissae) - len(values) not in (0, 1):
        raise ValueError(f"{where}: the shapes are {abscissae.shape} and {values.shape}; "
                         "use n points and n values, or n + 1 edges and n averages")
    if len(values) < 4:
        raise ValueError(f"{where}: {len(values)} values; use at least 4")
    if not (np.all(np.isfinite(abscissae)) and np.all(np.isfinite(values)) and np.all(np.diff(abscissae) > 0)):
        raise ValueError(f"{where}: use finite values at increasing points")
    return abscissae, values
