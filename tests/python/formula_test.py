"""Settings given as Python functions: the recorded formula has the values of the function.

    formula_test.py                 with the package on PYTHONPATH; exit code 77 (skipped) without NumPy
"""

import functools
import math
import operator
import pathlib
import re
import sys
import tempfile
import types
import unittest

try:
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import fpkcheck as fpk
from fpkcheck import _formula

FREE = {"wall": {"none": True}, "noise": {"intensity": 0.2}}
EVALUATED = {"max": np.maximum, "min": np.minimum, "atan": np.arctan, "number": np.float64}
EVALUATED.update({f: getattr(np, f) for f in "abs sign sqrt exp log sin cos tan sinh cosh tanh".split()})


def recorded(function, key="system.force", constants=()):
    return _formula.formula_of_function(function, key, constants)


def text_values(text, **values):
    """The values of a formula. With ** for ^, Python has the grammar and the precedence of formulas."""
    numbers = re.sub(r"(?<![\w.])\d[\d.]*(e[+-]?\d+)?", r"number(\g<0>)", text)
    return eval(numbers.replace("^", "**"), {"__builtins__": {}}, {**EVALUATED, **values})


def value_in_library(function, y, v):
    """The value of the formula in the library, from the message for a restitution above 1; None if not finite."""
    wall = {"left": 0, "left_restitution": lambda u, a, b: function(a, b) + 1000}
    try:
        fpk.Problem({**FREE, "wall": wall, "parameters": {"a": y, "b": v}}, force="y + 0.1*v + 0*(a + b)")
    except ValueError as error:
        if "not finite" in str(error) or "division by zero" in str(error):
            return None
        return float(re.search(r"left_restitution = (\S+)", str(error))[1]) - 1000
    raise AssertionError("accepted")


UNARY = [np.abs, np.sign, np.sqrt, np.exp, np.log, np.sin, np.cos, np.tan, np.arctan, np.sinh, np.cosh, np.tanh]
UNARY += [np.negative, np.square, np.reciprocal, np.positive, np.fabs, operator.neg, abs]
UNARY += [lambda x: x**3, lambda x: x**-2.0, lambda x: x**1]
BINARY = [operator.add, operator.sub, operator.mul, operator.truediv, np.maximum, np.minimum]
BINARY += [np.add, np.subtract, np.multiply, np.divide]
POWERS = [operator.pow, np.power, np.float_power]


def random_function(draw, depth):
    """A random function of y and v from the operations of formulas."""
    if depth == 0 or draw.random() < 0.1:
        leaf = draw.integers(4)
        constant = float(draw.choice([2, -3, 0.1, -1 / 3, 1, 0]))
        return [lambda y, v: y, lambda y, v: v, lambda y, v: constant, lambda y, v: np.float64(constant)][leaf]
    a, b = (random_function(draw, depth - 1) for _ in range(2))
    unary, binary, power = (choices[draw.integers(len(choices))] for choices in (UNARY, BINARY, POWERS))
    kind = draw.integers(10)
    if kind < 3:
        return lambda y, v: unary(a(y, v))
    if kind < 5:
        return lambda y, v: power(np.abs(y - b(y, v)), a(y, v))
    return lambda y, v: binary(a(y, v), b(y, v))


class Recording(unittest.TestCase):
    @np.errstate(all="ignore")
    def test_random_functions_have_equal_values(self):
        draw = np.random.default_rng(7)
        y, v = np.array([0.3, -1.7, 2.5]), np.array([-0.6, 0.9, 1.1])
        compared = in_library = 0
        for _ in range(1000):
            function = random_function(draw, int(draw.integers(1, 6)))
            try:
                expected = function(y, v) + 0 * y
                text = recorded(function)
            except (ValueError, ZeroDivisionError):  # an operation on two constants
                continue
            if re.search(r"/0(?![.\d])", text):
                continue  # refused by the library
            # The operations are the same, in the same order: no rounding differs except for powers.
            values, finite = text_values(text, y=y, v=v) + 0 * y, np.isfinite(expected)
            np.testing.assert_allclose(values[finite], expected[finite], rtol=1e-13, err_msg=text)
            compared += 1
            value = value_in_library(function, y[0], v[0]) if abs(expected[0]) < 500 else None
            if value is not None:
                self.assertAlmostEqual(value, expected[0], delta=2e-6, msg=text)
                in_library += 1
        self.assertGreater(compared, 700)
        self.assertGreater(in_library, 400)

    def test_precedence_follows_the_grammar(self):
        for function, text, value in (  # the value at y = 2, v = 3
            (lambda y, v: y - (v - y), "y - (v - y)", 1),
            (lambda y, v: y + (v - y), "y + (v - y)", 3),
            (lambda y, v: y / (v * y), "y/(v*y)", 1 / 3),
            (lambda y, v: y * (v / y), "y*(v/y)", 3),
            (lambda y, v: -(y**2), "-y^2", -4),
            (lambda y, v: (-y) ** 2, "(-y)^2", 4),
            (lambda y, v: -(y * v) / y, "-y*v/y", -3),
            (lambda y, v: (-(y + v)) ** 2, "(-(y + v))^2", 25),
            (lambda y, v: y**-v, "y^(-v)", 1 / 8),
            (lambda y, v: (y**v) ** y, "(y^v)^y", 64),
            (lambda y, v: y**v**y, "y^(v^y)", 512),
            (lambda y, v: y * -v, "y*(-v)", -6),
            (lambda y, v: y - -2 * v, "y + 2*v", 8),
            (lambda y, v: y + -2 * v, "y - 2*v", -4),
            (lambda y, v: -(-y), "--y", 2),
            (lambda y, v: y - -(-v), "y + -v", -1),
            (lambda y, v: 0 - y, "-y", -2),
            (lambda y, v: 0 * y + 1 * v, "v", 3),
            (lambda y, v: sum(c * y**k for k, c in enumerate([0, 1, 0, 0.2])), "y + 0.2*y^3", 3.6),
        ):
            self.assertEqual(recorded(function), text)
            self.assertAlmostEqual(text_values(text, y=2.0, v=3.0), value, 12, text)
            self.assertAlmostEqual(value_in_library(function, 2, 3), value, 6, text)

    def test_numbers_have_all_digits(self):
        for number, text in (
            (1 / 3, "0.3333333333333333"), (np.float64(0.1), "0.1"), (np.float32(0.1), "0.10000000149011612"),
            (np.int64(7), "7"), (1e22, "1e+22"), (1.5e-300, "1.5e-300"), (np.array(2.5), "2.5"),
            (2**53 - 1, "9007199254740991"), (math.pi, repr(math.pi)),
        ):
            self.assertEqual(recorded(lambda y, v: number), text)
            self.assertEqual(recorded(lambda y, v: number * y), text + "*y")
            self.assertEqual(recorded(lambda y, v: np.multiply(-number, y)), f"-{text}*y")
            self.assertEqual(recorded(lambda y, v: y ** (-number)), f"y^(-{text})")

    def test_functions_are_those_of_the_library(self):
        with self.assertRaisesRegex(ValueError, "known functions: ") as raised:
            fpk.Problem(FREE, force="nothing(y)")
        listed = str(raised.exception).split("known functions: ")[1].split(", ")
        self.assertEqual(set(_formula.FUNCTIONS.values()), set(listed))
        self.assertEqual(recorded(lambda y, v: np.fmax(y, v) - np.fmin(y, v)), "max(y, v) - min(y, v)")
        erf = types.SimpleNamespace(__name__="erf")  # the ufunc of SciPy, which is no requirement
        self.assertEqual(recorded(lambda y, v: y.__array_ufunc__(erf, "__call__", y)), "erf(y)")

    def test_operations_that_formulas_lack_are_refused(self):
        condition = "formulas have no conditions (comparison, if, and, or, min(), max()); use np.maximum"
        for function, expected in (
            (lambda y, v: y if y else v, condition),
            (lambda y, v: max(y, 0), condition),
            (lambda y, v: y * (v >= 0), condition),
            (lambda y, v: y == v, condition),
            (lambda y, v: np.where(y > 0, y, v), condition),
            (lambda y, v: np.where(y, 1, v), "no function where; use np.maximum"),
            (lambda y, v: np.clip(y, 0, 1), "no function clip"),
            (lambda y, v: np.floor(y), "no function floor; use np.maximum"),
            (lambda y, v: np.add(y, v, dtype=float), "no function add with these arguments"),
            (lambda y, v: math.sin(y), "functions of math need numbers; use np.sin"),
            (lambda y, v: y * np.ones(3), "combines a symbol with the type ndarray"),
            (lambda y, v: np.ones(3) * y, "combines a symbol with the type ndarray"),
            (lambda y, v: 1j * y, "combines a symbol with the type complex"),
            (lambda y, v: None, "returns the type NoneType; use formulas and real numbers"),
            (lambda y: y, "too few parameters (1); use (y, v)"),
            (lambda v, y: y, "the parameter 'v' of the function is misplaced; begin with (y, v)"),
            (lambda y, mu: y, "the parameter 'mu' of the function is misplaced"),
            (lambda y, v, t: y, "the parameter 't' of the function is misplaced"),
            (lambda a, b, v: y, "the parameter 'v' of the function is misplaced"),
        ):
            with self.assertRaises(TypeError, msg=expected) as raised:
                recorded(function, constants=("mu",))
            self.assertRegex(str(raised.exception), "^system.force: .*" + re.escape(expected))
        for number in (math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, f"^system.force: the function contains the number {number}"):
                recorded(lambda y, v: number * y)

    def test_large_formulas_are_refused_as_they_grow(self):
        def repeated(operation, times):
            return lambda y, v: functools.reduce(lambda x, _: operation(x), range(times), y + v)

        for operation in (lambda x: x * x, lambda x: np.maximum(x, x), lambda x: x + 0.123, np.sin, operator.neg):
            with self.assertRaisesRegex(ValueError, "system.force: the recorded formula exceeds 4000 characters"):
                recorded(repeated(operation, 10**6))
        self.assertEqual(len(recorded(repeated(operator.neg, 3993))), 4000)
        with self.assertRaisesRegex(ValueError, "more than 100 nested operations"):
            fpk.Problem(FREE, force=repeated(np.sin, 100))


class Settings(unittest.TestCase):
    def test_every_form_of_settings_accepts_functions(self):
        def force(y, v, mu):
            return 0.1 * v + 0.05 * np.tanh(20 * v) + y + mu * y**3

        text = "0.1*v + 0.05*tanh(20*v) + y + mu*y^3"
        given = fpk.Problem(FREE, force=text, parameters={"mu": 0.1})
        for problem in (
            fpk.Problem(FREE, force=force, parameters={"mu": 0.1}),
            fpk.Problem({**FREE, "system.force": force, "parameters.mu": 0.1}),
            fpk.Problem(FREE, force=lambda y, v, *, mu: force(y, v, mu), parameters={"mu": 0.1}),
            fpk.Problem(FREE, force=lambda y, v, mu=5: force(y, v, mu), parameters={"mu": 0.1}),
        ):
            self.assertEqual(problem, given)
            self.assertEqual(problem["force"], text)
        self.assertEqual(recorded(functools.partial(force, mu=0.1)), text.replace("mu", "0.1"))
        self.assertEqual(fpk.Problem.case("hertz", force=lambda y, v, k: v + k * y)["force"], "v + k*y")
        with self.assertRaisesRegex(ValueError, "unknown name 'q'; known names: "):
            fpk.Problem.case("hertz", force=lambda y, v, q: v + q * y)

        noise = {"intensity": 0.2, "factor": lambda y, v: np.sqrt(1 + v**2 / 4), "interpretation": "ito"}
        wall = {"left": 0, "left_restitution": lambda u: 1 - 0.3 * np.minimum(1, u) ** 0.2}
        impulse = {"rate": 1, "law": "gaussian", "intensity": 0.5, "factor": lambda y: 1 + 0.4 * y}
        problem = fpk.Problem({"noise": noise, "wall": wall, "impulse": impulse}, force=lambda y, v: v + y)
        self.assertEqual(problem["noise.factor"], "sqrt(1 + v^2/4)")
        self.assertEqual(problem["impulse.factor"], "1 + 0.4*y")
        self.assertEqual(problem["left_restitution"], "1 - 0.3*min(1, v)^0.2")
        self.assertEqual(recorded(lambda t: 1 + np.sin(t), "time.rate"), "1 + sin(t)")

        for call, expected in (
            (lambda: fpk.Problem(damping=lambda y: y), "'system.damping' has the type function"),
            (lambda: fpk.Problem(force=[1]), "'system.force' has the type list .*or a function"),
            (lambda: fpk.Problem({"wall": {"left_restitution": lambda y, v: y}}), "restitution: the parameter 'y'"),
            (lambda: fpk.Problem({"impulse": {"factor": lambda y, v: y}}), "impulse.factor: the parameter 'v'"),
        ):
            with self.assertRaisesRegex(TypeError, expected):
                call()

    def test_solutions_equal_those_of_the_text(self):
        # The polynomial has the coefficients, and therefore the closure, of the text.
        polynomial = fpk.Problem(FREE, force=lambda y, v: 0.1 * v + y * (1 + 0.1 * y**2))
        same = fpk.Problem(FREE, damping=0.1, stiffness=1, cubic=0.1)
        one, other = (fpk.solve(each, "fd-white,epc-moment-n4", bounds=False).solutions for each in (polynomial, same))
        for id in ("fd-white", "epc-moment-n4"):
            self.assertEqual((one[id].status, one[id].moments), ("ok", other[id].moments))

    def test_solution_has_the_exact_law(self):
        def force(y, v, zeta):  # Caughey and Ma in Ito's sense: E[y^2] = E[v^2] = 0.6
            return 2 * zeta * v * (1 + (y**2 + v**2) / 2) + y

        run = fpk.solve("caughey_ma", "fd-white", force=force, bounds=False)
        for moment in ("y2", "v2"):
            self.assertAlmostEqual(run.solutions["fd-white"].moments[moment], 0.6, 5)
        with tempfile.TemporaryDirectory() as folder:
            run.save(folder)
            self.assertEqual(fpk.load(folder).problem, run.problem)
            self.assertIn("2*zeta*v*(1 + (y^2 + v^2)/2) + y", pathlib.Path(folder, "summary.json").read_text())


if __name__ == "__main__":
    unittest.main()
