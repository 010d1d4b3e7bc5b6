"""Solving problems."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck
from ._external import Density, File, Samples, _as_external
from ._problem import Problem, Value
from ._run import Run

Against = Union[str, "os.PathLike[str]", Sequence[Any], Density, File, Samples, NDArray[np.float64], Callable[..., Any]]


def methods() -> dict[str, str]:
    """Families of methods, by increasing trust, with their meanings."""
    return {name: meaning for name, meaning, _ in _fpkcheck.method_families()}


def options(methods: str) -> dict[str, dict[str, Any]]:
    """The options of each method of a list, by id.

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
        raise TypeError("parameters are for cases given by their name; use Problem.case(.., damping=..)")
    return [each if isinstance(each, Problem) else Problem.case(each, **parameters) for each in case]


def _external_methods(against: Mapping[str, Against], problem: Problem) -> list[_fpkcheck.Method]:
    methods_of_densities: list[_fpkcheck.Method] = []
    for label, what in against.items():
        own = _as_external(what)
        if own is not None:
            methods_of_densities.append(own._method(label, problem._native, len(methods_of_densities)))
        else:
            files = what if isinstance(what, (list, tuple)) else [what]
            each = [file if isinstance(file, File) else File(file) for file in files]
            methods_of_densities += _fpkcheck.file_methods([file._argument(label) for file in each], problem.name)
    return methods_of_densities


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
    """Solve one or several cases with each of the methods, and compare the solutions, as ``fpkcheck run`` does.

    The call releases the interpreter lock: other threads continue. Ctrl-C raises KeyboardInterrupt and abandons the
    operations in progress, which may use processors for some more seconds.

    Parameters
    ----------
    case : str, path, Problem, or several in a list
        The cases to solve; a name or a file as in `Problem.case`.
    methods : str or list of str, optional
        Solvers (``"epc"``), families (``"epc-moment"``) or ids (``"fd-kf"``), separated by commas. Default: all
        solvers.
    against : mapping, optional
        External densities by label: a `Density`, a `Samples`, a function, an array of samples, a `File`, or the name
        of a file (or a list of two files, of y and of y'; docs/foreign.md). Requires a single case.
    options : mapping, optional
        Options of the solvers: ``{"mcs.seed": 3, "fd.max_seconds": 5}``. Without the solver's name, the option
        applies to all solvers that have it. `options` lists all options.
    threads : int
        Number of processors to use; 0 for all that are available to the process.
    max_seconds : float, optional
        Time limit.
    bounds : bool
        Compute guaranteed bounds of moments, and residual-based error estimates of the moments of each density; two
        or three seconds per case.
    progress : callable, optional
        Called a few times a second with the progress: a dict with ``done``, ``total``, ``case``, ``method``,
        ``fraction`` and ``note``. An exception from it ends the call.
    **parameters
        For cases given by their name: settings that replace those of the case, as ``restitution=0.9``.

    Returns
    -------
    Run
        A solver that finds no solution raises no exception: see the status of the solution.

    Raises
    ------
    ValueError
        For invalid input, with a message of one line.
    TimeoutError
        After ``max_seconds``.
    """
    problems = _problems(case, parameters)
    if against and len(problems) != 1:
        raise ValueError(f"against with {len(problems)} cases (must be a single case)")
    external_methods = _external_methods(against, problems[0]) if against else []
    listed = methods if methods is None or isinstance(methods, str) else ",".join(methods)
    told = [problem.name for problem in problems]
    return Run(
        _fpkcheck.solve(
            [problem._native for problem in problems],
            listed,
            {name: _plain(value) for name, value in (options or {}).items()},
            external_methods,
            threads,
            max_seconds,
            bounds,
            progress,
            f"fpkcheck.solve({told if len(told) > 1 else told[0]!r}, {listed!r})",
        )
    )


def _plain(value: Any) -> Any:
    """Converts a NumPy scalar to a Python number."""
    return value.item() if isinstance(value, np.generic) else value
