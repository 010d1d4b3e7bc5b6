"""Solving."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck
from ._own import Density, File, Samples, _as_own
from ._problem import Problem, Value
from ._run import Run

Against = Union[str, "os.PathLike[str]", Sequence[Any], Density, File, Samples, NDArray[np.float64], Callable[..., Any]]


def methods() -> dict[str, str]:
    """Families of methods, by increasing trust, and what each is."""
    return {name: meaning for name, meaning, _ in _fpkcheck.method_families()}


def options(methods: str) -> dict[str, dict[str, Any]]:
    """What a list of methods would be solved with: options by id of each.

    Raises
    ------
    ValueError
        For an item that is no method.
    """
    return _fpkcheck.options_of(methods)


def _problems(case: Any, parameters: Mapping[str, Value]) -> list[Problem]:
    if isinstance(case, (Problem, str, os.PathLike)):
        case = [case]
    if parameters and any(isinstance(each, Problem) for each in case):
        raise TypeError("parameters by name are of cases given by their name (use Problem.case(.., damping=..))")
    return [each if isinstance(each, Problem) else Problem.case(each, **parameters) for each in case]


def _brought_along(against: Mapping[str, Against], problem: Problem) -> list[_fpkcheck.Method]:
    all_own: list[_fpkcheck.Method] = []
    for label, what in against.items():
        own = _as_own(what)
        if own is not None:
            all_own.append(own._method(label, problem._native, len(all_own)))
        else:
            files = what if isinstance(what, (list, tuple)) else [what]
            each = [file if isinstance(file, File) else File(file) for file in files]
            all_own += _fpkcheck.file_methods([file._argument(label) for file in each], problem.name)
    return all_own


def solve(
    case: str | os.PathLike[str] | Problem | Iterable[str | Problem],
    methods: str | Iterable[str] | None = None,
    *,
    against: Mapping[str, Against] | None = None,
    options: Mapping[str, Any] | None = None,
    threads: int = 0,
    max_seconds: float | None = None,
    bounds: bool = True,
    progress: Callable[[dict[str, Any]], object] | None = None,
    **parameters: Value,
) -> Run:
    """Solve a case, or several, by each of some methods, and compare: what ``fpkcheck run`` does.

    The interpreter is free meanwhile: other threads go on. Ctrl-C raises KeyboardInterrupt; what was being solved
    is given up, and may use processors for some seconds more.

    Parameters
    ----------
    case : str, path, Problem, or several in a list
        What is solved; a name or a file as of `Problem.case`.
    methods : str or list of str, optional
        Solvers (``"epc"``), families (``"epc-moment"``) or ids (``"fd-kf"``), separated by commas. All solvers,
        unless given.
    against : mapping, optional
        Densities of one's own by the label that they get: a `Density`, a `Samples`, a function, an array of
        samples, a `File`, or the name of one (or a list of two, of y and of y'; docs/foreign.md). Of one case.
    options : mapping, optional
        Options of the solvers: ``{"mcs.seed": 3, "fd.max_seconds": 5}``; without the solver's name, of all that
        have one of that name. `options` lists them.
    threads : int
        Processors to use; 0 for all that the process may.
    max_seconds : float, optional
        Gives up after so long.
    bounds : bool
        Guaranteed bounds of moments, and the error of each density by its residuals; two or three seconds a case.
    progress : callable, optional
        Told where it stands, a few times a second: a dict with ``done``, ``total``, ``case``, ``method``,
        ``fraction`` and ``note``. What it raises ends the solving.
    **parameters
        Of cases given by their name: what replaces what the case says, ``restitution=0.9``.

    Returns
    -------
    Run
        Not to reach a solution is no exception but the status of that solution.

    Raises
    ------
    ValueError
        For input that cannot be used, in one line.
    TimeoutError
        After ``max_seconds``.
    """
    problems = _problems(case, parameters)
    if against and len(problems) != 1:
        raise ValueError(f"against with {len(problems)} cases (a density is of one case)")
    brought_along = _brought_along(against, problems[0]) if against else []
    listed = methods if methods is None or isinstance(methods, str) else ",".join(methods)
    told = [problem.name for problem in problems]
    return Run(
        _fpkcheck.solve(
            [problem._native for problem in problems],
            listed,
            {name: _plain(value) for name, value in (options or {}).items()},
            brought_along,
            threads,
            max_seconds,
            bounds,
            progress,
            f"fpkcheck.solve({told if len(told) > 1 else told[0]!r}, {listed!r})",
        )
    )


def _plain(value: Any) -> Any:
    """A NumPy number as Python's."""
    return value.item() if isinstance(value, np.generic) else value
