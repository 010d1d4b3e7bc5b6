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
    """The families of methods by increasing trust: a dict from the name of a family to its meaning."""
    return {name: meaning for name, meaning, _ in _fpkcheck.method_families()}


def options(methods: str) -> dict[str, dict[str, Any]]:
    """The options of the methods that a comma-separated list selects, by the id of the method.

    Raises
    ------
    ValueError
        If an item of the list selects no method.
    """
    return _fpkcheck.options_of(methods)


def _problems(case: Any, parameters: Mapping[str, Value]) -> list[Problem]:
    if isinstance(case, (Problem, str, os.PathLike)):
        case = [case]
    if parameters and any(isinstance(each, Problem) for each in case):
        raise TypeError("parameters apply only to cases given by name; use Problem.case(.., damping=..)")
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

    The call releases the interpreter lock, so that other Python threads continue. Ctrl-C raises KeyboardInterrupt and
    abandons the operations in progress. Abandoned operations may use processors for some more seconds.

    Parameters
    ----------
    case : str, path, Problem, or several in a list
        The cases to solve. A text or path is the name of a case or a case file, as in `Problem.case`.
    methods : str or list of str, optional
        Solvers (``"epc"``), families (``"epc-moment"``) or ids (``"fd-kf"``), separated by commas. The default is all
        solvers.
    against : mapping, optional
        External densities by label. A density is a `Density`, a `Samples`, a function, an array of samples, a `File`,
        the name of a file, or a list of two files, with the marginals of y and of y' (docs/external.md). External
        densities require a single case.
    options : mapping, optional
        Options of the solvers: ``{"mcs.seed": 3, "fd.max_seconds": 5}``. An option without the name of a solver
        applies to all solvers with an option of that name. The function `options` returns all options.
    threads : int
        Number of threads; 0 for one thread per processor that is available to the process.
    max_seconds : float, optional
        Limit of the wall-clock time of the call, in seconds.
    bounds : bool
        Whether to compute guaranteed bounds of moments, and residual-based error estimates of the moments of each
        density. This computation takes two or three seconds per case.
    progress : callable, optional
        Function that is called a few times a second with the progress of the run: a dict with ``done``, ``total``,
        ``case``, ``method``, ``fraction`` and ``note``. An exception of this function ends the call.
    **parameters
        Settings that replace settings of the cases, as ``restitution=0.9``, or a function as ``force`` (`Problem`).
        Only for cases given by name or file.

    Returns
    -------
    Run
        The solutions and their comparison. If a solver finds no solution, the solution has a status other than ok,
        and no exception is raised.

    Raises
    ------
    ValueError
        If the input is invalid. The message has one line.
    TimeoutError
        If the run takes longer than ``max_seconds``.
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
