"""External densities: functions, samples and files."""

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
    """An external joint density p(y, y') on y >= 0, given as a function.

    The function is evaluated once, before any method runs, at the Gauss-Legendre points of cells. The cells extend to
    10 standard deviations of equivalent linearisation. The comparison uses the averages of the density over these
    cells.

    Parameters
    ----------
    function : callable
        The density ``p(y, v)``. The arguments are two arrays of shape (601, 600). The result must have the same shape
        or broadcast to that shape. If the call raises TypeError or ValueError, the function is called point by point
        with two floats.
    equation : {"kf", "km4", "km4-pade", "white"}, optional
        The equation that the density approximates. A density with an equation is a closure: the result contains its
        status, its residual-based error estimate against the full problem, and its error budget. For a density
        without an equation the result contains only distances from the other solutions.
    impact : {"map", "delta"}
        Impact condition of the equation: exact, or to first order in 1 - r.
    normalise : bool
        Whether to divide the density by its integral. If not, an integral other than 1 gives the status
        ``inadmissible``.
    accuracy : float
        Largest L1 error estimate of p(y) and of p(y') with which a closure is ``ok``. A closure with a larger error
        estimate is ``inaccurate``.
    vectorised : bool, optional
        Whether the function accepts arrays. By default the function is called with arrays first.
    order : int, optional
        Order of the closure. Densities whose labels end with their orders (``"chi-n2"``, ``"chi-n4"``) form a family.
    """

    function: Function
    equation: str | None = None
    impact: str = "map"
    normalise: bool = True
    accuracy: float = 0.02
    vectorised: bool | None = None
    order: int | None = None

    def _values(self, label: str, y: Array, v: Array) -> Array:
        """The values of the density at all points, shape (len(y), len(v))."""
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
    """An external density, given as samples of (y, y') or of y, or as a sampler.

    Parameters
    ----------
    source : array of shape (n, 2) or (n,), or callable
        Array with y and y' of each sample, or with y alone; or a function ``sampler(rng, n)`` that returns such an array, where
        ``rng`` is a `numpy.random.Generator`.
    equation, impact, order
        The equation, impact condition and order of the closure, as in `Density`. Samples have sampling errors, but no
        residual-based error estimate.
    n : int
        Number of samples that the sampler must draw.
    seed : int
        Seed of the random number generator for the sampler.
    independent : float, optional
        Effective number of independent samples, from which the sampling errors are computed. The default is the
        number of samples.
    series : bool
        Whether the samples are successive states of one trajectory at equal time intervals. A block bootstrap then
        computes the sampling errors of the correlated samples.
    reference : bool
        Whether the density of the samples is the reference of the comparison.
    """

    source: Union[Sampler, Array, Any]
    equation: str | None = None
    impact: str = "map"
    n: int = 100_000
    seed: int = 1
    independent: float | None = None
    order: int | None = None
    series: bool = False
    reference: bool = False

    def _method(self, label: str, problem: _fpkcheck.Problem, place: int) -> _fpkcheck.Method:
        drawn = self.source(np.random.default_rng(self.seed), self.n) if callable(self.source) else self.source
        samples = np.asarray(drawn, dtype=float)
        if samples.ndim != 1 and (samples.ndim != 2 or samples.shape[1] != 2):
            raise ValueError(f"samples '{label}': shape {samples.shape} (must be (n, 2): y and y'; or (n,): y)")
        y, v = (samples, samples[:0]) if samples.ndim == 1 else np.ascontiguousarray(samples.T)
        return _fpkcheck.samples_method(
            y,
            v,
            label,
            self.equation,
            self.impact,
            self.order,
            self.independent or 0,
            self.series,
            self.reference,
            place,
        )


@dataclass(frozen=True)
class File:
    """An external density from a file (docs/external.md).

    Parameters
    ----------
    path : str or path
        Name of the file. The file contains columns of a marginal density or of a joint density, a joint density as
        netCDF-4, or a closed form as JSON; or the file is the ``summary.json`` or ``joint.nc`` of a run.
    equation, impact
        The equation and impact condition, as in `Density`. The impact condition may also be ``"exact"``.
    order : int, optional
        Order of the closure.
    solution, case : str, optional
        Id of the solution and name of the case to use, if the file is from a run.
    """

    path: str | os.PathLike[str]
    equation: str | None = None
    impact: str | None = None
    order: int | None = None
    solution: str | None = None
    case: str | None = None
    samples: str | None = None
    role: str | None = None

    def _argument(self, label: str) -> str:
        """The argument of the option `--against` of `fpkcheck run` for this file."""
        said = {key: getattr(self, key) for key in ("equation", "impact", "order", "solution", "case", "samples", "role")}
        settings = "".join(f",{key}={value}" for key, value in said.items() if value is not None)
        return f"{os.fspath(self.path)}:{label}{settings}"


def _is_sampler(function: Callable[..., Any]) -> bool:
    """Whether a function is a sampler: its first parameter has a name such as "rng" or "seed"."""
    try:
        names = list(inspect.signature(function).parameters)
    except (TypeError, ValueError):
        return False
    return bool(names) and names[0] in ("rng", "seed", "random", "generator")


def _as_external(what: Any) -> Density | Samples | None:
    """Converts a function or an array to `Density` or `Samples`; returns None for the name of a file."""
    if isinstance(what, (Density, Samples)):
        return what
    if callable(what):
        return Samples(what) if _is_sampler(what) else Density(what)
    if isinstance(what, np.ndarray):
        return Samples(what)
    return None
