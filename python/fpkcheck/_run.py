"""The result of a run."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck
from ._problem import Problem

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]
VARIABLES = ("y", "ydot")


def _xarray() -> Any:
    try:
        import xarray
    except ImportError as error:
        raise ImportError(f"tables with named axes require xarray: {error}") from error
    return xarray


def _number(value: float | None) -> float:
    """The float for a number of a JSON file; NaN for null, which represents numbers that are not finite."""
    return float("nan") if value is None else float(value)


def _numbers(values: Mapping[str, float | None] | None) -> dict[str, float]:
    return {name: _number(value) for name, value in (values or {}).items()}


@dataclass(frozen=True)
class StatedError:
    """The error estimate that a method states for its solution, without sampling errors."""

    y_l1: float  #: error estimate of p(y) in L1
    ydot_l1: float  #: error estimate of p(y') in L1
    moments: Mapping[str, float]  #: absolute error estimates of the moments, by the names of Solution.moments


@dataclass(frozen=True)
class Curve:
    """A marginal density as averages over bins; all arrays have the shape (n,)."""

    abscissa: Array  #: centres of the bins
    density: Array  #: averages of the density over the bins
    lower: Array | None  #: lower ends of the 95 % confidence intervals, if any
    upper: Array | None  #: upper ends of the 95 % confidence intervals, if any


@dataclass(frozen=True)
class Solution:
    """The solution of a problem by one method."""

    id: str  #: id of the solution, such as "fd-kf"
    method: str  #: name of the solver, such as "fd"
    equation: str  #: equation: "kf", "km4", "km4-pade" or "white"; "given" if unknown
    impact: str  #: impact condition: "map", "delta" or "exact"; "-" if unknown
    status: str  #: "ok", "inaccurate", "inadmissible", "not_converged", "ill_posed", "failed" or "not_offered"
    reason: str  #: reason for a status other than ok, in one sentence; else empty
    seconds: float  #: wall-clock time of the solution
    moments: Mapping[str, float]  #: E[y], E[y^2], .., E[y'^4] as y1, y2, y4, v1, v2, v4; empty without a density
    mass: float  #: integral of the density plus the probabilities of rest in contact
    min_density: float  #: smallest value of the density relative to its largest value
    energy_residual: float  #: relative residual of the balance of power
    error: StatedError | None  #: error estimate, if any
    standard_errors: Mapping[str, float]  #: standard errors of the moments of a simulation or of samples; else empty
    #: L1 sampling errors of the marginals: expected values "y", "ydot"; 99 % quantiles "y_99", "ydot_99"
    sampling_l1: Mapping[str, float]
    options: Mapping[str, Any]  #: options of the method
    record: Mapping[str, Any] = field(repr=False)  #: the JSON object of the solution in summary.json

    @property
    def is_ok(self) -> bool:
        """Whether the status is "ok"."""
        return self.status == "ok"

    @property
    def has_density(self) -> bool:
        """Whether the solution has a density."""
        return bool(self.moments)

    @classmethod
    def _of(cls, record: Mapping[str, Any]) -> Solution:
        error = record.get("error")
        stated = None
        if isinstance(error, dict) and "y_l1" in error:
            stated = StatedError(_number(error["y_l1"]), _number(error["ydot_l1"]), _numbers(error["moments"]))
        return cls(
            id=record["id"],
            method=record["method"],
            equation=record["equation"],
            impact=record["impact"],
            status=record["status"],
            reason=record["reason"],
            seconds=_number(record["seconds"]),
            moments=MappingProxyType(_numbers(record["moments"])),
            mass=_number(record["mass"]),
            min_density=_number(record["min_density"]),
            energy_residual=_number(record["energy_residual"]),
            error=stated,
            standard_errors=MappingProxyType(_numbers(record.get("standard_errors"))),
            sampling_l1=MappingProxyType(dict(record.get("sampling_l1", {}))),
            options=MappingProxyType(record["options"]),
            record=MappingProxyType(record),
        )


class Case:
    """The result of a run for one case."""

    def __init__(self, native: _fpkcheck.Run, place: int, record: Mapping[str, Any]) -> None:
        self._native = native
        self._place = place
        self._record = record

    @property
    def name(self) -> str:
        """The name of the case."""
        return self._record["name"]

    @property
    def record(self) -> Mapping[str, Any]:
        """The JSON object of the case in summary.json: all results except densities (keys: docs/glossary.md)."""
        return MappingProxyType(dict(self._record))

    @cached_property
    def problem(self) -> Problem:
        """The problem of the case."""
        return Problem._of(self._native.problem(self._place))

    @cached_property
    def solutions(self) -> Mapping[str, Solution]:
        """The solutions of the case by id, in the order of increasing trust."""
        return MappingProxyType({each["id"]: Solution._of(each) for each in self._record["solutions"]})

    @property
    def reference(self) -> str | None:
        """Id of the reference solution; None if no solution of the full problem is ok."""
        return self._record["reference"]

    @property
    def limits(self) -> str:
        """One sentence on the largest error of each closure; empty without an error budget."""
        return self._record["limits"]

    @property
    def bounds(self) -> dict[str, tuple[float, float]]:
        """Guaranteed bounds by functional, such as "E[y^2]"; empty if no bounds were computed."""
        bounds = self._record.get("bounds", {"each": []})
        return {each["functional"]: (_number(each["lower"]), _number(each["upper"])) for each in bounds["each"]}

    @cached_property
    def _curves(self) -> dict[str, dict[tuple[str, str], Curve]]:
        return {
            kind: {
                (solution, variable): Curve(abscissa, density, lower, upper)
                for solution, variable, abscissa, density, lower, upper in curves
            }
            for kind, curves in (
                ("sharp", self._native.curves(self._place)),
                ("smooth", self._native.smooth(self._place)),
            )
        }

    def curve(self, solution: str, variable: str = "y", *, smooth: bool = False) -> Curve:
        """The marginal density of a solution.

        Parameters
        ----------
        solution : str
            Id of the solution.
        variable : {"y", "ydot"}
            The variable of the marginal.
        smooth : bool
            Whether the averages are over smooth bins (docs/simulation.md), over which the simulation is far more
            accurate.

        Raises
        ------
        KeyError
            If the solution is unknown or has no density.
        """
        return self._curves["smooth" if smooth else "sharp"][solution, variable]

    def _marginals(self, kind: str) -> xarray.Dataset:
        curves = self._curves[kind]
        ids = [each for each in self.solutions if any((each, variable) in curves for variable in VARIABLES)]
        tables: dict[str, Any] = {}
        coords: dict[str, Any] = {"solution": ids}
        for variable in VARIABLES:
            own = {each: curves[each, variable] for each in ids if (each, variable) in curves}
            if not own:
                continue
            coords[variable] = next(iter(own.values())).abscissa
            nothing = np.full(len(coords[variable]), np.nan)
            for name, values in (
                ("", {each: curve.density for each, curve in own.items()}),
                ("_lower", {each: curve.lower for each, curve in own.items() if curve.lower is not None}),
                ("_upper", {each: curve.upper for each, curve in own.items() if curve.upper is not None}),
            ):
                table = np.stack([values.get(each, nothing) for each in ids])
                tables[f"p_{variable}{name}"] = (("solution", variable), table)
        return _xarray().Dataset(tables, coords, {"case": self.name})

    @property
    def marginals(self) -> xarray.Dataset:
        """Marginal densities of all solutions, as averages over the comparison bins.

        The densities are ``p_y(solution, y)`` and ``p_ydot(solution, ydot)``. The ends of the 95 % confidence
        intervals are ``p_y_lower``, ``p_y_upper``, ``p_ydot_lower`` and ``p_ydot_upper``; NaN for a solution without
        confidence intervals. ``y`` and ``ydot`` are the centres of the bins.
        """
        return self._marginals("sharp")

    @property
    def smooth(self) -> xarray.Dataset:
        """Marginal densities of all solutions, as averages over smooth bins; empty without a smooth reference.

        Over smooth bins the simulation is far more accurate (docs/simulation.md).
        """
        return self._marginals("smooth")

    @property
    def joint(self) -> xarray.DataArray:
        """Joint densities ``p(solution, y, ydot)``, as averages over cells that all solutions share.

        ``y`` and ``ydot`` are the centres of the cells. ``y_lower``, ``y_upper``, ``ydot_lower`` and ``ydot_upper``
        are the edges of the cells.
        """
        return self._on_cells(self._native.joints(self._place), "p")

    @property
    def error_sources(self) -> dict[str, xarray.DataArray]:
        """The sources of the errors of E[y^2] and E[y'^2], by the names of these moments, ``y2`` and ``v2``.

        The values are contributions to the error per area, over the cells of `joint`. The integral of the values is
        the error of the moment.
        """
        found: dict[str, list[tuple[Any, ...]]] = {}
        for solution, moment, *rest in self._native.error_sources(self._place):
            found.setdefault(moment, []).append((solution, *rest))
        return {moment: self._on_cells(each, f"source_{moment}") for moment, each in found.items()}

    def _on_cells(self, each: Sequence[tuple[Any, ...]], name: str) -> xarray.DataArray:
        if not each:
            return _xarray().DataArray(
                np.empty((0, 0, 0)), {"solution": [], "y": [], "ydot": []}, ("solution", "y", "ydot"), name
            )
        _, y, v, _ = each[0]
        return _xarray().DataArray(
            np.stack([values for *_, values in each]),
            {
                "solution": [solution for solution, *_ in each],
                "y": (y[1:] + y[:-1]) / 2,
                "ydot": (v[1:] + v[:-1]) / 2,
                "y_lower": ("y", y[:-1]),
                "y_upper": ("y", y[1:]),
                "ydot_lower": ("ydot", v[:-1]),
                "ydot_upper": ("ydot", v[1:]),
            },
            ("solution", "y", "ydot"),
            name,
            {"case": self.name},
        )

    @property
    def moments(self) -> xarray.DataArray:
        """Moments of all solutions with a density.

        The dimensions are ``solution`` and ``moment`` (y1, y2, y4, v1, v2, v4).
        """
        own = {each.id: each.moments for each in self.solutions.values() if each.has_density}
        names = ["y1", "y2", "y4", "v1", "v2", "v4"]
        return _xarray().DataArray(
            np.array([[moments[name] for name in names] for moments in own.values()]).reshape(len(own), len(names)),
            {"solution": list(own), "moment": names},
            ("solution", "moment"),
            "moments",
        )

    def l1(self, one: str, other: str) -> dict[str, float]:
        """L1 distances of two solutions in the marginals "y" and "ydot", if both solutions have the marginal.

        Raises
        ------
        KeyError
            If an id belongs to no solution of this case.
        """
        for name in (one, other):
            self.solutions[name]
        return {
            each["variable"]: _number(each["l1"])
            for each in self._record["comparisons"]
            if {each["a"], each["b"]} == {one, other}
        }

    @property
    def distances(self) -> xarray.Dataset:
        """Distances of all pairs of solutions: ``l1``, ``l2``, ``sup``, ``hellinger``, ``kl``.

        The dimensions are ``solution``, ``reference`` and ``variable``. Here ``reference`` is the more trusted
        solution of a pair. Values in which ``reference`` is not the more trusted solution are NaN. ``kl`` is the
        Kullback-Leibler divergence KL(reference || solution).
        """
        pairs = self._record["comparisons"]
        ids = list(self.solutions)
        names = ("l1", "l2", "sup", "hellinger", "kl")
        tables = {name: np.full((len(ids), len(ids), len(VARIABLES)), np.nan) for name in names}
        for pair in pairs:
            at = ids.index(pair["a"]), ids.index(pair["b"]), VARIABLES.index(pair["variable"])
            for name in names:
                tables[name][at] = _number(pair[name])
            # The Kullback-Leibler divergence kl is the only distance that may be infinite.
            if pair["kl"] is None and pair["l1"] is not None:
                tables["kl"][at] = np.inf
        dims = ("solution", "reference", "variable")
        return _xarray().Dataset(
            {name: (dims, table) for name, table in tables.items()},
            {"solution": ids, "reference": ids, "variable": list(VARIABLES)},
            {"case": self.name},
        )

    @property
    def budget(self) -> xarray.Dataset:
        """The error budget of the closures (docs/budget.md).

        ``total(solution, variable)`` is the L1 distance of a closure from the last model in the chain of models.
        ``l1(solution, variable, part)`` are the parts of this distance by name ("closure", "impact", "truncation",
        ..). The sum of the parts is at least the total. ``total_tail`` and ``tail`` are the corresponding tail
        distances, in decades of the density. The values of parts that a budget does not have are NaN.
        """
        rows = self._record["budget"]
        closures = list(dict.fromkeys(row["solution"] for row in rows))
        parts: list[str] = []
        for row in rows:
            known = [part["name"] for part in row["parts"]]
            # A new name is inserted before the next name of the same row, which keeps the order of the chain of models.
            for place, name in reversed(list(enumerate(known))):
                if name not in parts:
                    later = [parts.index(each) for each in known[place + 1 :] if each in parts]
                    parts.insert(min(later, default=len(parts)), name)
        shape = (len(closures), len(VARIABLES))
        totals = {name: np.full(shape, np.nan) for name in ("total", "total_tail")}
        tables = {name: np.full((*shape, len(parts)), np.nan) for name in ("l1", "tail")}
        ends = np.full(shape, "", dtype=object)
        for row in rows:
            at = closures.index(row["solution"]), VARIABLES.index(row["variable"])
            for name, table in totals.items():
                table[at] = _number(row[name])
            ends[at] = row["reference"]
            for part in row["parts"]:
                for name, table in tables.items():
                    table[at[0], at[1], parts.index(part["name"])] = _number(part[name])
        dims = ("solution", "variable")
        data: dict[str, Any] = {name: (dims, table) for name, table in totals.items()}
        data.update({name: ((*dims, "part"), table) for name, table in tables.items()})
        return _xarray().Dataset(
            {**data, "reference": (dims, ends)},
            {"solution": closures, "variable": list(VARIABLES), "part": parts},
            {"case": self.name},
        )

    def __repr__(self) -> str:
        each = ", ".join(f"{solution.id} {solution.status}" for solution in self.solutions.values())
        return f"<fpkcheck.Case {self.name}: {each}>"


class Run(Mapping[str, Case]):
    """The result of a run: a mapping from the names of cases to the results of cases (`Case`).

    A run of a single case also has the attributes of its `Case`. ``print(run)`` prints the table of ``fpkcheck run``.
    """

    def __init__(self, native: _fpkcheck.Run) -> None:
        self._native = native

    @cached_property
    def summary(self) -> Mapping[str, Any]:
        """The contents of summary.json: all results except densities."""
        return MappingProxyType(json.loads(self._native.summary()))

    @cached_property
    def cases(self) -> Mapping[str, Case]:
        """The results of the cases by name, in the order of the run."""
        records = self.summary["cases"]
        return MappingProxyType({each["name"]: Case(self._native, k, each) for k, each in enumerate(records)})

    @property
    def stopped(self) -> str:
        """A sentence on the interruption of the run and its missing parts; empty for a complete run."""
        return self.summary.get("stopped", "")

    @property
    def case(self) -> Case:
        """The result of the only case.

        Raises
        ------
        ValueError
            If the run has several cases, or none.
        """
        if len(self.cases) != 1:
            raise ValueError(f"the run has {len(self.cases)} cases; select run['{next(iter(self.cases), 'case1')}']")
        return next(iter(self.cases.values()))

    # A Run with a single case has the attributes of this case.

    @property
    def problem(self) -> Problem:
        """`Case.problem` of the only case."""
        return self.case.problem

    @property
    def solutions(self) -> Mapping[str, Solution]:
        """`Case.solutions` of the only case."""
        return self.case.solutions

    @property
    def reference(self) -> str | None:
        """`Case.reference` of the only case."""
        return self.case.reference

    @property
    def limits(self) -> str:
        """`Case.limits` of the only case."""
        return self.case.limits

    @property
    def bounds(self) -> dict[str, tuple[float, float]]:
        """`Case.bounds` of the only case."""
        return self.case.bounds

    @property
    def marginals(self) -> xarray.Dataset:
        """`Case.marginals` of the only case."""
        return self.case.marginals

    @property
    def smooth(self) -> xarray.Dataset:
        """`Case.smooth` of the only case."""
        return self.case.smooth

    @property
    def joint(self) -> xarray.DataArray:
        """`Case.joint` of the only case."""
        return self.case.joint

    @property
    def error_sources(self) -> dict[str, xarray.DataArray]:
        """`Case.error_sources` of the only case."""
        return self.case.error_sources

    @property
    def moments(self) -> xarray.DataArray:
        """`Case.moments` of the only case."""
        return self.case.moments

    @property
    def distances(self) -> xarray.Dataset:
        """`Case.distances` of the only case."""
        return self.case.distances

    @property
    def budget(self) -> xarray.Dataset:
        """`Case.budget` of the only case."""
        return self.case.budget

    def curve(self, solution: str, variable: str = "y", *, smooth: bool = False) -> Curve:
        """`Case.curve` of the only case."""
        return self.case.curve(solution, variable, smooth=smooth)

    def l1(self, one: str, other: str) -> dict[str, float]:
        """`Case.l1` of the only case."""
        return self.case.l1(one, other)

    def table(self, width: int = 100) -> str:
        """The tables that ``fpkcheck run`` prints, with at most `width` characters per line."""
        return self._native.table(width)

    def save(self, directory: str | os.PathLike[str]) -> None:
        """Write the files of ``fpkcheck run --out``: report.html, summary.json, marginals.csv, joint.nc, figures/.

        The files of an earlier run in the directory are replaced all together or not at all. A figure that cannot be
        drawn, as without gnuplot, causes a warning.

        Raises
        ------
        ValueError
            If the directory cannot be used.
        RuntimeError
            If a file cannot be written.
        """
        for warning in self._native.save(os.fspath(directory)):
            warnings.warn(warning, stacklevel=2)

    def __getitem__(self, name: str) -> Case:
        return self.cases[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.cases)

    def __len__(self) -> int:
        return len(self.cases)

    def __str__(self) -> str:
        return self.table()

    def __repr__(self) -> str:
        return f"<fpkcheck.Run of {', '.join(map(repr, self.cases.values())) or 'nothing'}>"


def load(directory: str | os.PathLike[str]) -> Run:
    """Read the result of a run from a directory that `Run.save` or ``fpkcheck run --out`` wrote.

    Raises
    ------
    ValueError
        If the directory contains no run, or if a file is corrupt or belongs to another run. The message has one line.
    """
    return Run(_fpkcheck.load(os.fspath(directory)))
