"""A problem: equation, parameters, source, exact law where one is known, and reference values."""

from __future__ import annotations

import configparser
import csv
import functools
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Optional

import numpy as np

from ._quadrature import CubicSpline

VARIABLES = ("y", "ydot")
MOMENTS = {"E[y]": ("y", 1), "E[y^2]": ("y", 2), "E[y^4]": ("y", 4), "E[y'^2]": ("ydot", 2), "E[y'^4]": ("ydot", 4)}
DATA = Path(__file__).parent / "data"
_CASES = Path(__file__).parent / "cases"


@dataclass(frozen=True)
class Value:
    """A reference value.

    at: the point of the quantity (frequency, lag, initial state), or None. error: largest expected absolute error.
    origin: `exact` (a formula) or `computed` (finite volumes). check, check_error: the value by an independent
    simulation with its standard error, or None.
    """

    quantity: str
    at: Optional[float]
    value: float
    error: float
    origin: str
    check: Optional[float] = None
    check_error: Optional[float] = None


class BinnedDensity:
    """A density as averages over bins, by finite volumes. Calls interpolate the distribution function by a spline."""

    def __init__(self, edges, averages):
        self.edges, self._averages = np.asarray(edges, dtype=float), np.asarray(averages, dtype=float)
        self.lower, self.upper = self.edges[0], self.edges[-1]

    @functools.cached_property
    def _distribution(self):
        return CubicSpline(self.edges, np.concatenate([[0], np.cumsum(self._averages * np.diff(self.edges))]))

    def __call__(self, x):
        x = np.asarray(x, dtype=float)
        inside = (x >= self.lower) & (x <= self.upper)
        return np.where(inside, self._distribution.derivative(x), 0.0)

    def averages(self, edges):
        """The averages over the bins between edges, shape (len(edges) - 1,)."""
        edges = np.asarray(edges, dtype=float)
        if np.array_equal(edges, self.edges):
            return self._averages
        return np.diff(self._distribution(np.clip(edges, self.lower, self.upper))) / np.diff(edges)


@dataclass(frozen=True)
class Problem:
    """A problem with its reference solution.

    name: key of the problem; title: one line; equation: LaTeX; source: publications of the equation or of the law.
    exact: whether the densities are closed forms or integrals of closed forms.
    """

    name: str
    title: str
    equation: str
    source: str
    _densities: Callable[[], dict] = field(default=dict, repr=False)
    _exact_values: Callable[[], list] = field(default=list, repr=False)

    @property
    def ini(self) -> str:
        """The case file of fpkcheck for this problem."""
        return (_CASES / f"{self.name}.ini").read_text()

    @property
    def parameters(self) -> dict:
        """The keys of the case file, for example parameters["system.damping"]; numbers as float."""
        parser = configparser.ConfigParser(inline_comment_prefixes=(";",))
        parser.read_string(self.ini)
        result = {}
        for section in parser.sections():
            for key, text in parser[section].items():
                try:
                    result[f"{section}.{key}"] = float(text)
                except ValueError:
                    result[f"{section}.{key}"] = text
        return result

    @property
    def walls(self) -> tuple:
        """The positions of the walls, infinite where there is none; without keys of walls there is one wall, at 0."""
        keys = self.parameters
        if "wall.none" in keys:
            return -math.inf, math.inf
        if "wall.left" in keys or "wall.right" in keys:
            return keys.get("wall.left", -math.inf), keys.get("wall.right", math.inf)
        return 0.0, math.inf

    @functools.cached_property
    def exact_densities(self) -> dict:
        """The exact densities: a dictionary with the keys "y" and "ydot", one of them or none."""
        return self._densities()

    @property
    def exact(self) -> bool:
        """Whether an exact density is known."""
        return bool(self.exact_densities)

    @functools.cached_property
    def densities(self) -> dict:
        """Reference densities: functions p(y) and p(y') under the keys "y" and "ydot"; exact where known.

        The densities exclude the probability of rest in contact with a wall.
        """
        return {**_tables().get(self.name, {}), **self.exact_densities}

    def density(self, variable: str):
        """The reference density of "y" or "ydot", a vectorised function with the methods lower, upper and averages.

        Raises ValueError for a variable without a reference density.
        """
        if variable not in self.densities:
            raise ValueError(f"{self.name} has no reference density of '{variable}'; it has {sorted(self.densities)}")
        return self.densities[variable]

    @functools.cached_property
    def values(self) -> tuple:
        """All reference values, from data/values.csv."""
        return tuple(_values().get(self.name, ()))

    def value(self, quantity: str, at: Optional[float] = None) -> Value:
        """The reference value of a quantity, for example "E[y^2]". Raises ValueError for an unknown quantity."""
        for value in self.values:
            if value.quantity == quantity and value.at == at:
                return value
        point = "" if at is None else f" at {at}"
        raise ValueError(f"{self.name} has no '{quantity}'{point}; it has {sorted({v.quantity for v in self.values})}")

    def exact_values(self) -> list:
        """The exact values from their formulas: the rows of data/values.csv with the origin `exact`."""
        result = [Value(q, None, float(self.exact_densities[variable].moment(order)), 1e-10, "exact")
                  for q, (variable, order) in MOMENTS.items() if variable in self.exact_densities]
        given = [Value(quantity, at, float(value), error, "exact")
                 for quantity, at, value, error in self._exact_values()]
        keys = {(v.quantity, v.at) for v in given}
        return [v for v in result if (v.quantity, v.at) not in keys] + given


@functools.lru_cache(maxsize=None)
def _values():
    result = {}
    with open(DATA / "values.csv", newline="") as file:
        for row in csv.DictReader(file):
            at, check, check_error = (float(row[k]) if row[k] else None for k in ("at", "check", "check_error"))
            value = Value(row["quantity"], at, float(row["value"]), float(row["error"]), row["origin"], check,
                          check_error)
            result.setdefault(row["problem"], []).append(value)
    return result


@functools.lru_cache(maxsize=None)
def _tables():
    bins = {}
    with open(DATA / "densities.csv", newline="") as file:
        for row in csv.DictReader(file):
            bins.setdefault((row["problem"], row["variable"]), []).append(
                [float(row[k]) for k in ("lower", "upper", "density")])
    result = {}
    for (name, variable), rows in bins.items():
        lower, upper, density = np.array(rows).T
        result.setdefault(name, {})[variable] = BinnedDensity(np.append(lower, upper[-1]), density)
    return result
