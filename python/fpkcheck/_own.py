"""Densities of one's own."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck

Array = NDArray[np.float64]
Function = Callable[[Any, Any], Any]
Sampler = Callable[[np.random.Generator, int], Any]


@dataclass(frozen=True)
class Density:
    """A joint density p(y, y') on y >= 0 as a function.

    It is called once, before anything is solved, at the Gauss-Legendre points of cells that reach 10 deviations of
    equivalent linearisation far; what is compared are its averages over these cells.

    Parameters
    ----------
    function : callable
        ``p(y, v)``. It is given two arrays of shape (601, 600) and may return any that has, or broadcasts to, that
        shape. Where it raises TypeError or ValueError, it is called point by point with two floats.
    equation : {"kf", "km4", "km4-pade", "white"}, optional
        What it is meant to solve: then it is a closure, with a status, an error of its own (by its residuals
        against the full problem) and an error budget. Without it nothing is known, and it has distances alone.
    impact : {"map", "delta"}
        That of the equation: exact, or to first order in 1 - r.
    normalise : bool
        Divide by the integral. Otherwise one that is not 1 makes it ``inadmissible``.
    accuracy : float
        Largest error of p(y) and of p(y') in L1 with which a closure is ``ok``; above it is ``inaccurate``.
    vectorised : bool, optional
        Whether it takes arrays; otherwise that is tried.
    order : int, optional
        Where it stands among closures. Densities whose labels end with their orders (``"chi-n2"``, ``"chi-n4"``) make
        a family.
    """

    function: Function
    equation: str | None = None
    impact: str = "map"
    normalise: bool = True
    accuracy: float = 0.02
    vectorised: bool | None = None
    order: int | None = None

    def _values(self, label: str, y: Array, v: Array) -> Array:
        """At all points: shape (len(y), len(v))."""
        shape = (len(y), len(v))
        if self.vectorised is not False:
            ys, vs = np.meshgrid(y, v, indexing="ij")
            try:
                values = np.asarray(self.function(ys, vs), dtype=float)
            except (TypeError, ValueError):
                if self.vectorised:
                    raise
            else:
                try:
                    return np.ascontiguousarray(np.broadcast_to(values, shape))
                except ValueError:
                    raise ValueError(
                        f"density '{label}': values of shape {values.shape} at points of shape {shape}"
                    ) from None
        return np.array([[float(self.function(a, b)) for b in v.tolist()] for a in y.tolist()])

    def _method(self, label: str, problem: _fpkcheck.Problem, place: int) -> _fpkcheck.Method:
        values = self._values(label, *_fpkcheck.points_of(problem))
        return _fpkcheck.function_method(
            problem, values, label, self.equation, self.impact, self.order, self.normalise, self.accuracy, place
        )


@dataclass(frozen=True)
class Samples:
    """Samples of (y, y'), or what draws them.

    Parameters
    ----------
    source : array of shape (n, 2), or callable
        y and y' of each sample; or ``sampler(rng, n)`` that returns such an array, with ``rng`` a
        `numpy.random.Generator`.
    equation, impact, order
        As of `Density`: what the samples are meant to solve. Samples have no residuals; what they state is their
        error by chance.
    n : int
        How many a sampler is asked for.
    seed : int
        Of the generator that it is given.
    independent : float, optional
        How many independent samples they are worth, for their errors by chance: those along a trajectory are worth
        fewer than there are. All of them, unless given.
    """

    source: Union[Sampler, Array, Any]
    equation: str | None = None
    impact: str = "map"
    n: int = 100_000
    seed: int = 1
    independent: float | None = None
    order: int | None = None

    def _method(self, label: str, problem: _fpkcheck.Problem, place: int) -> _fpkcheck.Method:
        drawn = self.source(np.random.default_rng(self.seed), self.n) if callable(self.source) else self.source
        samples = np.asarray(drawn, dtype=float)
        if samples.ndim != 2 or samples.shape[1] != 2:
            raise ValueError(f"samples '{label}': shape {samples.shape} (must be (n, 2): y and y')")
        y, v = np.ascontiguousarray(samples.T)
        return _fpkcheck.samples_method(
            y, v, label, self.equation, self.impact, self.order, self.independent or 0, place
        )


@dataclass(frozen=True)
class File:
    """A density in a file (docs/foreign.md), with what is said of it.

    Parameters
    ----------
    path : str or path
        Columns of a marginal or of a joint density, netCDF-4, a closed form as JSON, or the ``summary.json`` or
        ``joint.nc`` of a run.
    equation, impact
        As of `Density`; ``"exact"`` too.
    order : int, optional
        Where it stands among closures.
    solution, case : str, optional
        Of a file of a run: which density.
    """

    path: str | os.PathLike[str]
    equation: str | None = None
    impact: str | None = None
    order: int | None = None
    solution: str | None = None
    case: str | None = None

    def _argument(self, label: str) -> str:
        """As `fpkcheck run --against` has it."""
        said = {key: getattr(self, key) for key in ("equation", "impact", "order", "solution", "case")}
        settings = "".join(f",{key}={value}" for key, value in said.items() if value is not None)
        return f"{os.fspath(self.path)}:{label}{settings}"


def _is_sampler(function: Callable[..., Any]) -> bool:
    """By the names of its arguments: (rng, n), (seed, size), ..."""
    try:
        names = list(inspect.signature(function).parameters)
    except (TypeError, ValueError):
        return False
    return bool(names) and names[0] in ("rng", "seed", "random", "generator")


def _as_own(what: Any) -> Density | Samples | None:
    """What a user brings along as what it is; None for files."""
    if isinstance(what, (Density, Samples)):
        return what
    if callable(what):
        return Samples(what) if _is_sampler(what) else Density(what)
    if isinstance(what, np.ndarray):
        return Samples(what)
    return None
