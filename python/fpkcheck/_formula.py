"""Formulas of case files, recorded from Python functions.

A function is called once with symbols as arguments. Python operators and NumPy functions of symbols build the text of a
formula in the grammar of case files (problem/expression/expression.hpp). The parser of the library checks the text.
"""

from __future__ import annotations

import inspect
import math
import operator
from collections.abc import Callable, Collection, Mapping
from numbers import Real
from typing import Any, NoReturn

import numpy as np

#: The settings that are formulas, and the variables of their functions in order.
VARIABLES: Mapping[str, tuple[str, ...]] = {
    "system.force": ("y", "v"),
    "noise.factor": ("y", "v"),
    "impulse.factor": ("y",),
    "wall.left_restitution": ("v",),
    "wall.right_restitution": ("v",),
    "time.rate": ("t",),
    "time.intensity": ("t",),
    "time.force": ("t",),
}

#: The functions of formulas (kFunctions in problem/expression/functions.hpp) by the name of the NumPy or SciPy ufunc.
FUNCTIONS: Mapping[str, str] = {
    **{name: name for name in ("sign", "sqrt", "exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh")},
    **{name: name for name in ("erf", "erfc")},
    **{"absolute": "abs", "fabs": "abs", "arctan": "atan"},
    **{"maximum": "max", "fmax": "max", "minimum": "min", "fmin": "min"},
}

#: The ufuncs that are operators of formulas.
OPERATORS: Mapping[str, Callable[..., Any]] = {
    **{"add": operator.add, "subtract": operator.sub, "multiply": operator.mul, "divide": operator.truediv},
    **{"power": operator.pow, "float_power": operator.pow, "negative": operator.neg, "positive": operator.pos},
    **{"square": lambda x: x**2, "reciprocal": lambda x: 1 / x},
}

# Expression::kMaxLength. The length is limited during recording, since the length of `x = x * x` doubles each time.
_MAX_LENGTH = 4000

# Ranks of formulas: the rules of the grammar from the weakest to the strongest binding. A formula with a leading minus
# sign has the rank of a product.
_SUM, _PRODUCT, _POWER, _ATOM = range(4)


def _unsupported(key: str, what: str) -> TypeError:
    return TypeError(f"{key}: formulas have no {what}; use np.maximum, np.minimum, np.abs, np.sign, np.exp, np.sin ..")


def _expression(key: str, value: Any, verb: str) -> SymbolicExpression:
    """The value as an expression; the verb describes in error messages what the function does with the value."""
    if isinstance(value, np.ndarray) and value.shape == ():
        value = value.item()
    if isinstance(value, SymbolicExpression):
        return value
    if not isinstance(value, (Real, np.bool_)):
        raise TypeError(f"{key}: the function {verb} the type {type(value).__name__}; use formulas and real numbers")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{key}: the function contains the number {number}; numbers must be finite")
    text = repr(number).removesuffix(".0")
    return SymbolicExpression(key, text, _PRODUCT if text.startswith("-") else _ATOM)


def _methods(record: Callable[[Any, Any], Any]) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """The methods of a binary operator: for a symbol on the left, and for a symbol on the right of another operand."""
    return lambda self, other: record(self, self.operand(other)), lambda self, other: record(self.operand(other), self)


class SymbolicExpression:
    """A formula under construction: a variable, a named constant, or operations on them. Immutable.

    Parameters
    ----------
    key : str
        The key of the setting, the beginning of error messages.
    text : str
        The formula.
    rank : int
        The rank of the outermost rule of the grammar in `text`.
    """

    __slots__ = ("key", "text", "rank")

    def __init__(self, key: str, text: str, rank: int) -> None:
        if len(text) > _MAX_LENGTH:
            raise ValueError(
                f"{key}: the recorded formula exceeds {_MAX_LENGTH} characters, with intermediate results written out; "
                "simplify the function"
            )
        self.key = key
        self.text = text
        self.rank = rank

    def operand(self, other: Any) -> SymbolicExpression:
        """Another operand as an expression; TypeError unless the operand is an expression or a real number."""
        return _expression(self.key, other, "combines a symbol with")

    def enclosed(self, rank: int) -> str:
        """The text for a rule of this rank, in parentheses if necessary."""
        return self.text if self.rank >= rank else f"({self.text})"

    # -- operations, in the order of the function, so that the rounding is the same

    def _plus(self, other: SymbolicExpression, sign: str) -> SymbolicExpression:
        if other.text == "0":
            return self
        if self.text == "0":  # the start of sum()
            return other if sign == "+" else -other
        text = other.enclosed(_PRODUCT)
        if text.startswith("-"):  # a + -b = a - b
            sign, text = "-" if sign == "+" else "+", text[1:]
        return SymbolicExpression(self.key, f"{self.text} {sign} {text}", _SUM)

    def _times(self, other: SymbolicExpression, sign: str) -> SymbolicExpression:
        if other.text == "1" or (sign == "*" and self.text == "0"):
            return self
        if sign == "*" and (self.text == "1" or other.text == "0"):
            return other
        return SymbolicExpression(self.key, self.enclosed(_PRODUCT) + sign + other.enclosed(_POWER), _PRODUCT)

    def _raised(self, exponent: SymbolicExpression) -> SymbolicExpression:
        if exponent.text == "1":
            return self
        return SymbolicExpression(self.key, f"{self.enclosed(_ATOM)}^{exponent.enclosed(_ATOM)}", _POWER)

    def _call(self, name: str, *others: SymbolicExpression) -> SymbolicExpression:
        arguments = ", ".join(each.text for each in (self, *others))
        return SymbolicExpression(self.key, f"{name}({arguments})", _ATOM)

    def __neg__(self) -> SymbolicExpression:
        # The text -a*b means (-a)*b, which equals -(a*b) without rounding.
        return SymbolicExpression(self.key, "-" + self.enclosed(_PRODUCT), _PRODUCT)

    def __pos__(self) -> SymbolicExpression:
        return self

    def __abs__(self) -> SymbolicExpression:
        return self._call("abs")

    __add__, __radd__ = _methods(lambda a, b: a._plus(b, "+"))
    __sub__, __rsub__ = _methods(lambda a, b: a._plus(b, "-"))
    __mul__, __rmul__ = _methods(lambda a, b: a._times(b, "*"))
    __truediv__, __rtruediv__ = _methods(lambda a, b: a._times(b, "/"))
    __pow__, __rpow__ = _methods(lambda a, b: a._raised(b))

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **keywords: Any) -> Any:
        name = ufunc.__name__
        if method == "__call__" and not keywords:
            arguments = [self.operand(each) for each in inputs]
            if name in FUNCTIONS:
                return arguments[0]._call(FUNCTIONS[name], *arguments[1:])
            if name in OPERATORS:
                return OPERATORS[name](*arguments)
        raise _unsupported(self.key, f"function {name}" + (" with these arguments" if keywords else ""))

    # -- refusals

    def __array_function__(self, function: Any, types: Any, arguments: Any, keywords: Any) -> NoReturn:
        raise _unsupported(self.key, f"function {getattr(function, '__name__', 'of NumPy')}")

    def _refuse_condition(self, other: object = None) -> NoReturn:
        raise _unsupported(self.key, "conditions (comparison, if, and, or, min(), max())")

    __bool__ = __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _refuse_condition
    __hash__ = None  # type: ignore[assignment]

    def __float__(self) -> NoReturn:
        raise TypeError(f"{self.key}: functions of math need numbers; use np.sin, np.exp .. of the symbols")

    def __repr__(self) -> str:
        return f"<formula {self.text}>"


def formula_of_function(function: Callable[..., Any], key: str, constants: Collection[str] = ()) -> str:
    """The text of the formula that a function computes, recorded by one call of the function.

    Parameters
    ----------
    function : callable
        The function, with the parameters ``VARIABLES[key]``, then named constants. A parameter with a default value is
        a named constant only if `constants` contains its name.
    key : str
        The key of the setting, the beginning of error messages.
    constants : collection of str
        The known names of constants.

    Raises
    ------
    TypeError
        If the parameters or the returned value of the function are not admissible, or if an operation cannot be
        recorded.
    ValueError
        If the formula is too long, or contains a number that is not finite.
    """
    variables = VARIABLES[key]
    expected = f"({', '.join(variables)})"
    try:
        parameters = inspect.signature(function).parameters.values()
    except ValueError:
        raise TypeError(f"{key}: the function has no known parameters; use a def or a lambda with {expected}") from None
    named = [each for each in parameters if each.kind not in (each.VAR_POSITIONAL, each.VAR_KEYWORD)]
    if len(named) < len(variables):
        raise TypeError(f"{key}: the function has too few parameters ({len(named)}); use {expected}")
    for place, name in enumerate(each.name for each in named):
        is_misplaced = variables[place : place + 1] != (name,)
        if is_misplaced and (name in ("y", "v", "t") or (name in constants and place < len(variables))):
            raise TypeError(f"{key}: the parameter '{name}' of the function is misplaced; begin with {expected}")
    if any(each.kind == each.POSITIONAL_ONLY for each in named[len(variables) :]):
        raise TypeError(f"{key}: the function has named constants before the separator /; move / after the variables")
    by_name = {
        each.name: SymbolicExpression(key, each.name, _ATOM)
        for each in named[len(variables) :]
        if each.default is each.empty or each.name in constants
    }
    result = function(*(SymbolicExpression(key, name, _ATOM) for name in variables), **by_name)
    return _expression(key, result, "returns").text
