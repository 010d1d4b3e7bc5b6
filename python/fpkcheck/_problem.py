"""Problems: an oscillator and its excitation."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Mapping
from numbers import Integral, Real
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck
from ._formula import VARIABLES, formula_of_function

Value = Union[float, int, str, bool, Callable[..., Any]]
Settings = Mapping[str, Union[Value, Mapping[str, Value]]]


def _text(key: str, value: Any, constants: Collection[str]) -> str:
    """The text of a value in the notation of case files; numbers have all digits, and functions are formulas."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if callable(value) and key in VARIABLES:
        return formula_of_function(value, key, constants)
    function = ", or a function" if key in VARIABLES else ""
    raise TypeError(f"'{key}' has the type {type(value).__name__} (must be a number, a text or a bool{function})")


def _full_key(name: str) -> str:
    """The key of a parameter with its section: "system.damping" for "damping".

    An unknown name is returned unchanged; the library then reports the unknown name.
    """
    return next((key for key in _fpkcheck.keys() if key.split(".")[1] == name), name)


def _pairs(settings: Settings | None, by_name: Mapping[str, Value]) -> list[str]:
    """The settings as texts, such as "system.damping=0.1"."""
    values: list[tuple[str, Any]] = []
    for key, value in {**(settings or {}), **by_name}.items():
        if isinstance(value, Mapping):
            values += [(f"{key}.{name}", each) for name, each in value.items()]
        else:
            values.append((_full_key(key), value))
    constants = {key.partition(".")[2] for key, _ in values if key.startswith("parameters.")}
    return [f"{key}={_text(key, value, constants)}" for key, value in values]


class Problem:
    """An oscillator and its impulses, whose stationary density is sought. A problem is immutable.

    Parameters
    ----------
    settings : mapping, optional
        The settings of a case file by key: ``{"system.damping": 0.1}``, ``{"system": {"damping": 0.1}}``, or
        ``{"damping": 0.1}``.
    name : str
        Name of the case in tables and files.
    **parameters
        The same settings as keyword arguments: ``damping``, ``stiffness``, ``cubic``, ``restitution``, ``rate``,
        ``law``, ``intensity``, ``mean`` (default 0). Instead of coefficients, ``force`` is a formula of ``y`` and
        ``v``, with the constants ``parameters``; ``wall`` and ``noise`` are dicts. A formula is a text, or a function
        with the parameters ``(y, v)``, then names of constants. The function is called once with symbols, and its
        operations are recorded as a text (docs/python.md).

    Raises
    ------
    ValueError
        If a key is missing, unknown or given twice, or if its value is out of range. The message contains the key and
        the admissible range.
    TypeError
        If a value has a wrong type, or if an operation of a function cannot be recorded.

    Examples
    --------
    >>> Problem(damping=0.1, stiffness=1, cubic=0.1, restitution=0.98, rate=1, law="gaussian", intensity=0.1)
    <fpkcheck.Problem mine: c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1, ...>
    >>> Problem(force="c*v*abs(v) + y", parameters={"c": 0.2}, wall={"none": True}, noise={"intensity": 0.2})
    <fpkcheck.Problem mine: f = c*v*abs(v) + y, c = 0.2, no wall; 2D = 0.2>
    >>> Problem(force=lambda y, v: 0.2*v*np.abs(v) + y, wall={"none": True}, noise={"intensity": 0.2})["force"]
    '0.2*v*abs(v) + y'
    """

    __slots__ = ("_native",)
    _native: _fpkcheck.Problem

    def __init__(self, settings: Settings | None = None, /, *, name: str = "mine", **parameters: Value) -> None:
        self._native = _fpkcheck.problem_of(name, _pairs(settings, parameters))

    @classmethod
    def _of(cls, native: _fpkcheck.Problem) -> Problem:
        problem = cls.__new__(cls)
        problem._native = native
        return problem

    @classmethod
    def case(
        cls, name_or_path: str | os.PathLike[str], settings: Settings | None = None, /, **parameters: Value
    ) -> Problem:
        """The problem of a case: a case of the paper, "case1" to "case4", an example system, or a case file.

        Parameters
        ----------
        name_or_path : str or path
            One of ``Problem.case_names()``, or a case file.
        settings, **parameters
            Settings that replace settings of the case, as in `Problem`.

        Raises
        ------
        ValueError
            If there is no such case, or if a setting is invalid (as in `Problem`).
        """
        return cls._of(_fpkcheck.load_case(os.fspath(name_or_path), _pairs(settings, parameters)))

    @staticmethod
    def case_names() -> list[str]:
        """The names of the built-in cases."""
        return _fpkcheck.case_names()

    @staticmethod
    def keys() -> list[str]:
        """The keys of all settings of a case: "system.damping", ..."""
        return _fpkcheck.keys()

    @property
    def name(self) -> str:
        """The name of the problem: the name of its case and the replaced settings, as "case1, r = 0.95"."""
        return self._native.name

    @property
    def settings(self) -> dict[str, dict[str, Any]]:
        """The settings of the problem: a dict for each section, such as "system" and "impulse"."""
        return self._native.sections

    def __getitem__(self, key: str) -> Any:
        """The value of a setting by its key, "system.damping" or "damping"; KeyError for an unknown key."""
        section, _, parameter = _full_key(key).partition(".")
        try:
            return self.settings[section][parameter]
        except KeyError:
            raise KeyError(key) from None

    def bins(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Edges of the bins of y and of y' over which `Run.marginals` are averages: shapes (141,), (141,).

        With less than one impulse per decay time, the bins at 0 are divided: shapes (144,), (147,).
        """
        return _fpkcheck.axes_of(self._native)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Problem):
            return NotImplemented
        return self.name == other.name and self.settings == other.settings

    def __hash__(self) -> int:
        return hash((self.name, str(self.settings)))

    def __repr__(self) -> str:
        return f"<fpkcheck.Problem {self.name}: {self._native.text}>"


def load_case(path: str | os.PathLike[str], settings: Settings | None = None, /, **parameters: Value) -> Problem:
    """The problem of a case or case file, as `Problem.case`."""
    return Problem.case(path, settings, **parameters)
