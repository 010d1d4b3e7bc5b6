"""First passages, spectral densities, sensitivities and densities over time."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Generic, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck
from ._problem import Problem, Value
from ._run import _number, _numbers
from ._solve import _plain, _problems

Array = NDArray[np.float64]
Case = Union[str, "os.PathLike[str]", Problem]
Rows = Sequence[Mapping[str, str]]


@dataclass(frozen=True)
class _MethodResult:
    """The result of one method."""

    id: str  #: id of the method, such as "fd-kf"
    status: str  #: "ok", "inaccurate", "inadmissible", "not_converged", "failed" or "not_offered"
    reason: str  #: reason for a status other than ok, in one sentence; else empty
    seconds: float  #: wall-clock time of the method
    #: "standard error", "standard error plus error of the kick interval", "discretisation error" or "guaranteed bound";
    #: None without errors
    error_kind: str | None
    record: Mapping[str, Any] = field(repr=False)  #: the JSON object of the method in the file of the command


@dataclass(frozen=True)
class FirstPassage(_MethodResult):
    """First passage above a barrier by one method, with the estimated errors of all values.

    The keys of `values` and `errors` are "hazard", "mean_from_rest" ("mean_from_start" with a given start),
    "mean_from_stationary", "rice_rate" and "probability_below". A value that the method does not compute is NaN.
    """

    values: Mapping[str, float]  #: hazard, mean times of passage, rate of upcrossings, probability below the barrier
    errors: Mapping[str, float]  #: errors of `values`; NaN without an estimate
    mean_bounds: tuple[float, float] | None  #: guaranteed bounds of the mean time from the start, if computed
    times: Array  #: times of the survival probabilities, shape (n,)
    survival: Mapping[str, Array]  #: P(tau > t) of the starts "from_rest" or "from_start", and "from_stationary"
    survival_errors: Mapping[str, Array]  #: errors of `survival`


@dataclass(frozen=True)
class Spectrum(_MethodResult):
    """Spectral density and autocovariance of y or y' by one method. The arrays of a failed method are empty."""

    variable: str  #: "y" or "ydot"
    frequency: Array  #: angular frequencies w >= 0, shape (n,)
    density: Array  #: one-sided spectral density G(w), whose integral over w >= 0 is the variance
    density_error: Array  #: errors of `density`
    variance: float  #: variance of the variable
    variance_error: float  #: error of `variance`
    lag: Array  #: times of the autocovariance, shape (m,)
    autocovariance: Array  #: autocovariance R(lag)
    autocovariance_error: Array  #: errors of `autocovariance`
    peak: Mapping[str, float] | None  #: "frequency", "density" and "half_width" of the largest peak, if any
    #: slowest modes: "decay_rate", "frequency", their errors "decay_rate_error", "frequency_error", and "share", the
    #: share of the variance
    modes: Sequence[Mapping[str, float]]


@dataclass(frozen=True)
class MarginalDerivatives:
    """Derivatives of a marginal density with respect to parameters, as averages over n bins."""

    abscissa: Array  #: centres of the bins, shape (n,)
    derivatives: Mapping[str, Array]  #: derivatives of the density by the key of the parameter
    errors: Mapping[str, Array]  #: errors of `derivatives`


@dataclass(frozen=True)
class Sensitivities(_MethodResult):
    """Derivatives of stationary moments and densities with respect to parameters, by one method.

    The first key of the mappings is a moment, such as "E[y^2]"; the second key is a parameter, such as
    "system.damping". The mappings of a failed method are empty.
    """

    moments: Mapping[str, float]  #: the moments
    derivatives: Mapping[str, Mapping[str, float]]  #: derivatives, with all other parameters fixed
    elasticities: Mapping[str, Mapping[str, float]]  #: relative change per relative change of the parameter
    errors: Mapping[str, Mapping[str, float]]  #: errors of `derivatives`
    densities: Mapping[str, MarginalDerivatives]  #: derivatives of p(y) and p(y') as "y", "ydot"; only finite volumes


@dataclass(frozen=True)
class DensitiesOverTime(_MethodResult):
    """Densities p(y, t) and p(y', t) by one method, at the times that the method reached.

    The keys of `moments` are y1, y2, y4, v1, v2, v4. The keys of the other mappings are the variables "y" and "ydot".
    """

    times: Array  #: times, shape (n,)
    moments: Mapping[str, Array]  #: E[y], E[y^2], .., E[y'^4], shape (n,)
    moment_errors: Mapping[str, Array]  #: errors of the moments; NaN without an estimate
    abscissa: Mapping[str, Array]  #: centres of the bins, shape (m,)
    density: Mapping[str, Array]  #: averages of the density over the bins, shape (n, m)
    lower: Mapping[str, Array] | None  #: lower ends of the 95 % confidence intervals of a simulation, shape (n, m)
    upper: Mapping[str, Array] | None  #: upper ends of the 95 % confidence intervals of a simulation, shape (n, m)
    l1: Mapping[str, Array]  #: L1 distances to the reference, shape (n,); NaN for the reference
    l1_error: Mapping[str, Array]  #: L1 error estimates of this solution, shape (n,)
    reference: str | None  #: id of the reference; None if no method reached the end time
    mean_over_period: Mapping[str, float] | None  #: means of the moments over the period of a periodic state


Result = TypeVar("Result", bound=_MethodResult)


class MethodResults(Mapping[str, Result], Generic[Result]):
    """The results of several methods for one case: a mapping from the ids of methods to their results.

    ``print(results)`` prints the table of the command.
    """

    def __init__(self, problem: Problem, results: Mapping[str, Result], record: Mapping[str, Any], table: str) -> None:
        self.problem = problem  #: the problem of the case
        self.record = MappingProxyType(record)  #: contents of the JSON file of the command
        self._results = results
        self._table = table

    def __getitem__(self, id: str) -> Result:
        return self._results[id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._results)

    def __len__(self) -> int:
        return len(self._results)

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<fpkcheck.MethodResults {', '.join(f'{each.id} {each.status}' for each in self.values())}>"


def _array(values: Iterable[float | None] | None) -> Array:
    return np.array([_number(value) for value in values or ()])


def _column(rows: Rows, name: str) -> Array:
    return np.array([float(row[name] or "nan") for row in rows])


def _common(record: Mapping[str, Any], error_kind: str | None) -> dict[str, Any]:
    return {
        "id": record["solution"],
        "status": record["status"],
        "reason": record["reason"],
        "seconds": _number(record["seconds"]),
        "error_kind": error_kind,
        "record": MappingProxyType(record),
    }


def _first_passages(records: Mapping[str, Any], rows: Rows) -> list[FirstPassage]:
    found = []
    for record in records["solutions"]:
        error = record["error"]
        names = [name for name in error if name != "survival"]
        start = next(name for name in names if name not in ("hazard", "mean_from_stationary"))
        bounds = record.get(start + "_bounds")
        starts = (start.replace("mean_", ""), "from_stationary")

        def columns(each: Any) -> Mapping[str, Array]:
            return MappingProxyType({name: _array(at.get(name) for at in each) for name in starts})

        found.append(
            FirstPassage(
                **_common(record, record["error_is"]),
                values=MappingProxyType({name: _number(record[name]) for name in names}),
                errors=MappingProxyType({name: _number(error[name]) for name in names}),
                mean_bounds=(bounds["lower"], bounds["upper"]) if bounds else None,
                times=_array(at["time"] for at in record["survival"]),
                survival=columns(record["survival"]),
                survival_errors=columns(error.get("survival", [{}] * len(record["survival"]))),
            )
        )
    return found


def _spectra(records: Sequence[Mapping[str, Any]], rows: Rows) -> list[Spectrum]:
    return [
        Spectrum(
            **_common(record, record["error_is"]),
            variable=record["of"],
            frequency=_array(record["frequency"]),
            density=_array(record["density"]),
            density_error=_array(record["error"]),
            variance=_number(record["variance"]),
            variance_error=_number(record["variance_error"]),
            lag=_array(record["autocovariance"]["lag"]),
            autocovariance=_array(record["autocovariance"]["value"]),
            autocovariance_error=_array(record["autocovariance"]["error"]),
            peak=MappingProxyType(_numbers(record["peak"])) if record["peak"] else None,
            modes=tuple(MappingProxyType(_numbers(mode)) for mode in record["modes"]),
        )
        for record in records
    ]


def _sensitivities(records: Sequence[Mapping[str, Any]], rows: Rows) -> list[Sensitivities]:
    found = []
    for id in dict.fromkeys(record["solution"] for record in records):
        own = [record for record in records if record["solution"] == id]
        moments = [record for record in own if "derivatives" in record]

        def by_moment(key: str) -> Mapping[str, Mapping[str, float]]:
            return MappingProxyType({each["of"]: MappingProxyType(_numbers(each[key])) for each in moments})

        densities = {}
        for variable, symbol in (("y", "p(y)"), ("ydot", "p(y')")):
            by_parameter: dict[str, list[Mapping[str, str]]] = {}
            for row in rows:
                if row["solution"] == id and row["of"] == symbol:
                    by_parameter.setdefault(row["parameter"], []).append(row)
            if by_parameter:
                densities[variable] = MarginalDerivatives(
                    _column(next(iter(by_parameter.values())), "abscissa"),
                    MappingProxyType({key: _column(each, "derivative") for key, each in by_parameter.items()}),
                    MappingProxyType({key: _column(each, "error") for key, each in by_parameter.items()}),
                )
        found.append(
            Sensitivities(
                **_common(own[0], own[0].get("error_is")),
                moments=MappingProxyType({each["of"]: _number(each["value"]) for each in moments}),
                derivatives=by_moment("derivatives"),
                elasticities=by_moment("elasticities"),
                errors=by_moment("error"),
                densities=MappingProxyType(densities),
            )
        )
    return found


def _densities_over_time(records: Sequence[Mapping[str, Any]], rows: Rows) -> list[DensitiesOverTime]:
    found = []
    for record in records:
        has_standard_errors = "standard_errors" in record
        errors = record["standard_errors" if has_standard_errors else "error"]
        times = _array(record["times"])
        abscissa, tables = {}, {"density": {}, "lower": {}, "upper": {}}
        for variable in ("y", "ydot"):
            own = [row for row in rows if row["solution"] == record["solution"] and row["variable"] == variable]
            bins = len(own) // max(len(times), 1)
            abscissa[variable] = _column(own[:bins], "abscissa")
            for name, table in tables.items():
                table[variable] = _column(own, name).reshape(len(times), bins)

        def columns(each: Sequence[Mapping[str, Any] | None], names: Sequence[str]) -> Mapping[str, Array]:
            return MappingProxyType({name: _array(at[name] if at else None for at in each) for name in names})

        moments, variables = ("y1", "y2", "y4", "v1", "v2", "v4"), ("y", "ydot")
        mean = record["mean_over_period"]
        lower, upper = (MappingProxyType(tables[name]) if has_standard_errors else None for name in ("lower", "upper"))
        found.append(
            DensitiesOverTime(
                **_common(record, "standard error" if has_standard_errors else "discretisation error"),
                times=times,
                moments=columns(record["moments"], moments),
                moment_errors=columns(errors, moments),
                abscissa=MappingProxyType(abscissa),
                density=MappingProxyType(tables["density"]),
                lower=lower,
                upper=upper,
                l1=columns(record["l1"], variables),
                l1_error=columns(record["l1_error"], variables),
                reference=record["reference"],
                mean_over_period=MappingProxyType(_numbers(mean)) if mean else None,
            )
        )
    return found


def _option(value: Any) -> Any:
    """The value of an option: a list of numbers or names becomes a text with commas."""
    if isinstance(value, (str, Mapping)) or not isinstance(value, Iterable):
        return _plain(value)
    return ",".join(repr(float(each)) if not isinstance(each, str) else each for each in value)


def _with_keyword_arguments(message: str) -> str:
    """A message of the program with keyword arguments in place of options: "times=1" for "--times 1"."""
    return re.sub(
        r"--([a-z-]+)( (?=['\d.-]))?", lambda at: at[1].replace("-", "_") + ("=" if at[2] else ""), message
    )


def _compute(
    name: str,
    key: str,
    make: Callable[[Any, Rows], Sequence[Result]],
    case: Case,
    settings: Mapping[str, Value],
    **options: Any,
) -> MethodResults[Result]:
    (problem,) = _problems([case], settings)
    if options["threads"] == 0:
        options["threads"] = None
    given = {option: _option(value) for option, value in options.items() if value is not None}
    call = "".join(f", {option}={value!r}" for option, value in given.items())
    try:
        texts = getattr(_fpkcheck, name)(problem._native, given, f"fpkcheck.{name}({problem.name!r}{call})")
    except ValueError as error:
        raise ValueError(_with_keyword_arguments(str(error))) from None
    record = json.loads(texts[0])
    rows = list(csv.DictReader(io.StringIO(texts[1])))
    results = make(record["cases"][0][key], rows)
    return MethodResults(problem, {each.id: each for each in results}, record, texts[2])


def passage(
    case: Case,
    *,
    displacement: float | tuple[float, float] | None = None,
    energy: float | None = None,
    start: tuple[float, float] | None = None,
    times: Iterable[float] | None = None,
    methods: str | Iterable[str] | None = None,
    accuracy: float | None = None,
    max_seconds: float | None = None,
    time: float | None = None,
    seed: int | None = None,
    threads: int = 0,
    **parameters: Value,
) -> MethodResults[FirstPassage]:
    """Compute the first passage of the displacement or of the energy above a barrier, as ``fpkcheck passage`` does.

    The call releases the interpreter lock. Ctrl-C raises KeyboardInterrupt within about half a second. The system is
    non-dimensional. The formulas are in docs/functionals.md.

    Parameters
    ----------
    case : str, path or Problem
        The case, as in `solve`.
    displacement : float or (float, float), optional
        Barrier of y: the passage time is the first time at which y exceeds this value. Two values are a lower and an
        upper barrier: the passage time is the first time at which y leaves the interval between them.
    energy : float, optional
        In place of ``displacement``: barrier of the energy y'^2/2 + U(y).
    start : (float, float), optional
        Displacement and velocity at the start. The default is a start at rest.
    times : list of float, optional
        Times of the survival probabilities. The default is ten times up to three mean times of passage.
    methods : str or list of str, optional
        Ids of methods, as for the option ``--methods`` of the command. The default is "fd-kf,mcs".
    accuracy : float, optional
        Largest relative error for the status ok (default 0.01).
    max_seconds : float, optional
        Time limit of each deterministic method in seconds (default 10). The method then states its present error.
    time : float, optional
        Simulated time. The default follows from the required standard error.
    seed : int, optional
        Seed of the simulation (default 1).
    threads : int
        Number of threads of the simulation; 0 for one thread per processor that is available to the process.
    **parameters
        Settings that replace settings of the case, as in `solve`.

    Returns
    -------
    MethodResults of FirstPassage
        The results by the ids of methods, with "rice", the approximation by independent upcrossings.

    Raises
    ------
    ValueError
        If the input is invalid. The message has one line.
    """
    if displacement is not None and not isinstance(displacement, str):
        barriers = displacement if isinstance(displacement, Iterable) else [displacement]
        displacement = _option([float(each) for each in barriers])
    return _compute(
        "passage", "passage", _first_passages, case, parameters,
        displacement=displacement, energy=energy, start=start, times=times, methods=methods, accuracy=accuracy,
        max_seconds=max_seconds, time=time, seed=seed, threads=threads,
    )


def spectrum(
    case: Case,
    *,
    of: str | None = None,
    frequencies: tuple[float, float, int] | None = None,
    methods: str | Iterable[str] | None = None,
    accuracy: float | None = None,
    max_seconds: float | None = None,
    time: float | None = None,
    seed: int | None = None,
    threads: int = 0,
    **parameters: Value,
) -> MethodResults[Spectrum]:
    """Compute the one-sided spectral density of the stationary y or y', as ``fpkcheck spectrum`` does.

    Parameters
    ----------
    case, methods, max_seconds, time, seed, threads, **parameters
        As in `passage`.
    of : {"y", "ydot"}
        The variable (default "y").
    frequencies : (float, float, int), optional
        First and last angular frequency and number of intervals. The default is 0 to four mean frequencies in 200
        intervals.
    accuracy : float, optional
        Largest error relative to the largest density for the status ok (default 0.01).

    Returns
    -------
    MethodResults of Spectrum
        The results by the ids of methods.

    Raises
    ------
    ValueError
        If the input is invalid. The message has one line.
    """
    if frequencies is not None and not isinstance(frequencies, str):
        frequencies = ":".join(str(_plain(each)) for each in frequencies)  # type: ignore[assignment]
    return _compute(
        "spectrum", "spectra", _spectra, case, parameters,
        of=of, frequencies=frequencies, methods=methods, accuracy=accuracy, max_seconds=max_seconds, time=time,
        seed=seed, threads=threads,
    )


def sensitivity(
    case: Case,
    *,
    parameters: str | Iterable[str] | None = None,
    methods: str | Iterable[str] | None = None,
    accuracy: float | None = None,
    max_seconds: float | None = None,
    time: float | None = None,
    seed: int | None = None,
    threads: int = 0,
    **settings: Value,
) -> MethodResults[Sensitivities]:
    """Compute derivatives of stationary moments and densities, as ``fpkcheck sensitivity`` does.

    Parameters
    ----------
    case, methods, max_seconds, time, seed, threads, **settings
        As in `passage`. The methods may be closures, such as "epc-polar-n6".
    parameters : str or list of str, optional
        Keys of the parameters with respect to which the derivatives are computed, as "system.damping". The default is
        all numbers of the case. ``impulse.rate`` changes at a fixed intensity.
    accuracy : float, optional
        Largest error of an elasticity, and largest L1 error of theta dp/dtheta, for the status ok (default 0.01).

    Returns
    -------
    MethodResults of Sensitivities
        The results by the ids of methods.

    Raises
    ------
    ValueError
        If the input is invalid. The message has one line.
    """
    return _compute(
        "sensitivity", "sensitivities", _sensitivities, case, settings,
        parameters=parameters, methods=methods, accuracy=accuracy, max_seconds=max_seconds, time=time, seed=seed,
        threads=threads,
    )


def densities_over_time(
    case: Case,
    until: float,
    *,
    snapshots: int | None = None,
    periodic: bool = False,
    start_y: float | None = None,
    start_v: float | None = None,
    start_mean_y: float | None = None,
    start_mean_v: float | None = None,
    methods: str | Iterable[str] | None = None,
    accuracy: float | None = None,
    max_seconds: float | None = None,
    time: float | None = None,
    seed: int | None = None,
    threads: int = 0,
    **parameters: Value,
) -> MethodResults[DensitiesOverTime]:
    """Compute the densities p(y, t) and p(y', t) from a Gaussian density at t = 0, as ``fpkcheck run --until`` does.

    Parameters
    ----------
    case, time, seed, threads, **parameters
        As in `passage`. The excitation may change in time: ``Problem.case("case1", {"time.rate": "1+0.8*cos(t)"})``.
    until : float
        End time, or the period of the excitation for a periodic state.
    snapshots : int, optional
        Number of intervals between the times of the densities (default 20).
    periodic : bool
        Whether to compute the periodic state of an excitation with the period ``until``.
    start_y, start_v, start_mean_y, start_mean_v : float, optional
        Standard deviations and means of y and y' at t = 0. The default standard deviations are about half of the
        stationary ones.
    methods : str or list of str, optional
        Ids of methods, also of closures. The default is "fd-kf,epc-polar-n6,epc-moment-n6,mcs".
    accuracy : float, optional
        Largest L1 error of p(y) and p(y') for the status ok (default 0.01).
    max_seconds : float, optional
        Time limit of each method other than the simulation in seconds (default 20).

    Returns
    -------
    MethodResults of DensitiesOverTime
        The results by the ids of methods.

    Raises
    ------
    ValueError
        If the input is invalid. The message has one line.
    """
    return _compute(
        "densities_over_time", "over_time", _densities_over_time, case, parameters,
        until=until, snapshots=snapshots, periodic=periodic, start_y=start_y, start_v=start_v,
        start_mean_y=start_mean_y, start_mean_v=start_mean_v, methods=methods, accuracy=accuracy,
        max_seconds=max_seconds, time=time, seed=seed, threads=threads,
    )
