"""Problems: an oscillator and its excitation."""

from __future__ import annotations

import os
from collections.abc import Mapping
from numbers import Integral, Real
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _fpkcheck

Value = Union[float, int, str]
Settings = Mapping[str, Union[Value, Mapping[str, Value]]]


def _text(key: str, value: Any) -> str:
    """A value in the notation of case files, with all digits of numbers."""
    if isinstance(value, str):
        return value
    if isinstance(value, Integral) and not isinstance(value, bool):
        return str(int(value))
    if isinstance(value, Real) and not isinstance(value, bool):
        return repr(float(value))
    raise TypeError(f"'{key}' has the type {type(value).__name__} (must be a number or a text)")


def _full_key(name: str) -> str:
    """ "system.damping" for "damping"; unknown names are returned unchanged, for the error message of the library."""
    return next((key for key in _fpkcheck.keys() if key.split(".")[1] == name), name)


def _pairs(settings: Settings | None, by_name: Mapping[str, Value]) -> list[str]:
    """ "system.damping=0.1" for every setting."""
    pairs = []
    for key, value in {**(settings or {}), **by_name}.items():
        if isinstance(value, Mapping):
            pairs += [f"{key}.{name}={_text(name, each)}" for name, each in value.items()]
        else:
            pairs.append(f"{_full_key(key)}={_text(key, value)}")
    return pairs


class Problem:
    """A stationary problem: an oscillator and its impulses. Immutable.

    Parameters
    ----------
    settings : mapping, optional
        The keys and values of case files: ``{"system.damping": 0.1}``, ``{"system": {"damping": 0.1}}``, or
        ``{"damping": 0.1}``.
    name : str
        Name of the case in tables and files.
    **parameters
        The same settings as keyword arguments: ``damping``, ``stiffness``, ``cubic``, ``restitution``, ``rate``,
        ``law``, ``intensity``, ``mean`` (default 0).

    Raises
    ------
    ValueError
        For a key that is missing, unknown, given twice or out of range; the message contains the key and its range.

    Examples
    --------
    >>> Problem(damping=0.1, stiffness=1, cubic=0.1, restitution=0.98, rate=1, law="gaussian", intensity=0.1)
    <fpkcheck.Problem mine: c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1, ...>
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
        """A case of the paper, "case1" to "case4", a shipped system, or the case of an ini file, with changes.

        Parameters
        ----------
        name_or_path : str or path
            One of ``Problem.case_names()``, or a case file.
        settings, **parameters
            Settings that replace those of the case, as in `Problem`.

        Raises
        ------
        ValueError
            When there is no such case, and as in `Problem`.
        """
        return cls._of(_fpkcheck.load_case(os.fspath(name_or_path), _pairs(settings, parameters)))

    @staticmethod
    def case_names() -> list[str]:
        """The names of the built-in cases."""
        return _fpkcheck.case_names()

    @staticmethod
    def keys() -> list[str]:
        """The keys of all settings: "system.damping", ..."""
        return _fpkcheck.keys()

    @property
    def name(self) -> str:
        """The name of the case, followed by changes to a loaded case: "case1, r = 0.95"."""
        return self._native.name

    @property
    def settings(self) -> dict[str, dict[str, Any]]:
        """The settings of the problem: a dict for each section, such as "system" and "impulse"."""
        return self._native.sections

    def __getitem__(self, key: str) -> Any:
        """The value of a key, "system.damping" or "damping"; KeyError when there is none."""
        section, _, parameter = _full_key(key).partition(".")
        try:
            return self.settings[section][parameter]
        except KeyError:
            raise KeyError(key) from None

    def bins(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Edges of the bins of y and of y', as in `Run.marginals`: shapes (141,), (141,).

        Below one impulse per decay time, the bins at 0 are divided: shapes (144,), (147,).
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
    """The problem of a case, as `Problem.case`."""
    return Problem.case(path, settings, **parameters)
