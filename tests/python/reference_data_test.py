"""Reference data (python/fpkcheck_reference): exact laws against balances and quadrature, tables, scores.

    reference_data_test.py    with python/ on PYTHONPATH, or the package installed; exit code 77 (skipped) without NumPy
"""

import math
import sys
import unittest

try:
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import fpkcheck_reference as reference
from fpkcheck_reference import _laws
from fpkcheck_reference._problem import MOMENTS
from fpkcheck_reference._quadrature import CubicSpline


def simpson(function, lower, upper, panels=2000):
    """Simpson's rule, which has other nodes than the rule of the package, and a node at the middle."""
    x = np.linspace(lower, upper, 2 * panels + 1)
    f = function(x)
    return (f[0] + f[-1] + 4 * np.sum(f[1::2]) + 2 * np.sum(f[2:-1:2])) * (x[1] - x[0]) / 3


def derivative(function, x, step=1e-3):
    """Central difference of order 4."""
    near, far = function(x + step) - function(x - step), function(x + 2 * step) - function(x - 2 * step)
    return (8 * near - far) / (12 * step)


def exact_densities():
    """Pairs (problem, variable) with an exact density."""
    for name in reference.problems():
        problem = reference.problem(name)
        for variable in problem.exact_densities:
            yield problem, variable


class ExactLaws(unittest.TestCase):
    def test_integrate_to_one(self):
        for problem, variable in exact_densities():
            p = problem.density(variable)
            with self.subTest(problem=problem.name, variable=variable):
                self.assertAlmostEqual(simpson(p, p.lower, p.upper), 1, delta=1e-9)
                self.assertTrue(np.all(p(np.linspace(p.lower, p.upper, 501)) >= -1e-13))
                self.assertEqual(p(p.upper + 1), 0)

    def test_densities_have_the_moments_of_the_table(self):
        for problem, variable in exact_densities():
            p = problem.density(variable)
            for quantity, (of, order) in MOMENTS.items():
                if of == variable:
                    with self.subTest(problem=problem.name, quantity=quantity):
                        value = problem.value(quantity).value
                        quadrature = simpson(lambda x: x**order * p(x), p.lower, p.upper)
                        self.assertAlmostEqual(quadrature, value, delta=1e-8 * max(1, abs(value)))

    # d E[y v] / dt = 0: E[v^2] = E[y g(y)] - lambda E[Y] E[y], for walls at y = 0 too. d H / dt = 0: E[v f(v)] = I / 2.
    def test_moment_equations(self):
        forces = {"duffing": lambda y: y + 0.5 * y**3, "bistable": lambda y: y**3 - y, "ring": lambda y: y,
                  "ball_white": lambda y: 1 + 0 * y, "softening": lambda y: np.tanh(y) + 0.05 * y,
                  "multiplicative_duffing": lambda y: y**3 - y, "caughey_ma": lambda y: y, "dimentberg": lambda y: y,
                  "linear": lambda y: y - 0.1, "linear_wall_white": lambda y: y, "linear_overdamped": lambda y: y,
                  "poisson_maxwell": lambda y: y + 0.5 * y**3}
        for name, force in forces.items():
            problem = reference.problem(name)
            y, v = problem.density("y"), problem.density("ydot")
            with self.subTest(problem=name):
                virial = simpson(lambda x: x * force(x) * y(x), y.lower, y.upper)
                self.assertAlmostEqual(virial, simpson(lambda x: x * x * v(x), v.lower, v.upper), delta=1e-8)
        powers = {"duffing": (lambda v: 0.2 * v, 0.4), "linear_wall_white": (lambda v: 0.1 * v, 0.2),
                  "linear_overdamped": (lambda v: 3 * v, 1.0), "box_laplace": (lambda v: 0.25 * v, 0.5),
                  "box_laplace_rare": (lambda v: 0.5 * v, 0.5), "box_cubic": (lambda v: v**3, 0.2),
                  "box_friction": (lambda v: 0.2 * np.sign(v), 0.2),
                  "poisson_maxwell": (lambda v: _laws.poisson_maxwell_damping(v, 1, 0.5, 1), 0.25)}
        for name, (damping, intensity) in powers.items():
            v = reference.problem(name).density("ydot")
            with self.subTest(problem=name):
                end = min(v.upper, 7.5) if name == "poisson_maxwell" else v.upper  # exp(v^2/2) is finite
                dissipated = simpson(lambda x: x * damping(x) * v(x), -end, end)
                self.assertAlmostEqual(dissipated, intensity / 2, delta=1e-8)

    # The probability flux in v of a density of the energy vanishes: (f - D g g_v [Stratonovich]) p + D (g^2 p)_v = 0.
    def test_energy_laws_have_no_flux(self):
        def flux(law, damping, diffusion, stratonovich):
            p = lambda v: law((y * y + v * v) / 2)
            drift = damping(y, v) - (derivative(lambda w: diffusion(y, w), v) / 2 if stratonovich else 0)
            return drift * p(v) + derivative(lambda w: diffusion(y, w) * p(w), v), abs(drift * p(v))

        cases = {
            "ring": (_laws.ring_energy_function(0.4), lambda y, v: (y * y + v * v - 1) * v,
                     lambda y, v: 0.2 + 0 * v, False),
            "caughey_ma": (_laws.caughey_ma_energy_function, lambda y, v: 0.1 * v * (1 + (y * y + v * v) / 2),
                           lambda y, v: 0.1 * (1 + (y * y + v * v) / 4), False),
            "dimentberg": (_laws.dimentberg_energy_function(0.1, 0.1, 1.0, 0.1),
                           lambda y, v: 0.2 * v + 0.1 * v * (y * y + v * v),
                           lambda y, v: 0.1 * (1 + 0.4 * (y * y + v * v)), True)}
        for name, arguments in cases.items():
            for y, v in ((0.3, 0.5), (1.0, -0.7), (0.1, 1.4)):
                with self.subTest(problem=name, y=y, v=v):
                    total, part = flux(*arguments)
                    self.assertLess(abs(total), 1e-8 * max(part, 1e-3))

    # d(R p)/dv + lambda (int p(v - x) f(x) dx - p(v)) = 0 for a density of v alone.
    def test_laws_under_impulses_are_stationary(self):
        x = np.linspace(-12, 12, 48001)
        normal = np.exp(-x * x / 0.5) / math.sqrt(0.5 * math.pi)
        laplace = np.exp(-np.abs(x) / 0.5)
        laplace /= np.sum(laplace) * (x[1] - x[0])
        cases = {"poisson_maxwell": (lambda v: _laws.poisson_maxwell_damping(v, 1, 0.5, 1), normal),
                 "box_laplace": (lambda v: 0.25 * v, laplace), "box_laplace_rare": (lambda v: 0.5 * v, laplace)}
        for name, (damping, law) in cases.items():
            p = reference.problem(name).density("ydot")
            for v in (0.25, 0.8, 1.7):
                with self.subTest(problem=name, v=v):
                    convolution = np.sum(p(v - x) * law) * (x[1] - x[0])
                    balance = derivative(lambda w: damping(w) * p(w), np.array(v)) + convolution - p(v)
                    self.assertLess(abs(balance), 2e-6)

    def test_linear_oscillators(self):
        linear = _laws.LinearOscillator(0.2, 1.0, rate=1.0, intensity=0.1, mean=0.1, noise_intensity=0.1)
        self.assertAlmostEqual(linear.cumulant("y", 1), 0.1, delta=1e-12)  # lambda E[Y] / k
        self.assertAlmostEqual(linear.cumulant("y", 2), 0.5, delta=1e-12)  # I / 2ck
        variance = simpson(linear.spectral_density, 0, 400, 100000)
        self.assertAlmostEqual(variance, 0.5, delta=1e-8)
        self.assertAlmostEqual(linear.eigenvalue(1, 1).real, -0.2)
        overdamped = _laws.LinearOscillator(3.0, 1.0, rate=4.0, intensity=1.0)
        # int h^4 dt by partial fractions of h = (e^-bt - e^-at)/(a - b)
        b, a = (x.real for x in overdamped.decay_rates)
        fourth = 1 / (4 * b) - 4 / (3 * b + a) + 6 / (2 * b + 2 * a) - 4 / (b + 3 * a) + 1 / (4 * a)
        self.assertAlmostEqual(overdamped.cumulant("y", 4), 4 * 3 * 0.25**2 * fourth / (a - b) ** 4, delta=1e-12)

    # R(0) = E[y^2] - E[y]^2, and R(t) = R(0) - E[v^2] t^2 / 2 + O(t^3)
    def test_autocovariance_at_an_elastic_wall(self):
        at_zero = _laws.elastic_wall_autocovariance(0.1, 1.0, 2.5, 0)
        self.assertAlmostEqual(at_zero, 2.5, delta=1e-12)
        lag = 1e-3
        decrease = at_zero - _laws.elastic_wall_autocovariance(0.1, 1.0, 2.5, lag)
        self.assertAlmostEqual(decrease / (2.5 * lag**2 / 2), 1, delta=2e-3)

    def test_inelastic_ball(self):
        for speed in (0.3, 1.5):  # the density of the speed at the return
            total = simpson(np.vectorize(lambda x: math.exp(x) * _laws.return_speed_kernel(math.exp(x), speed)),
                              math.log(1e-7), math.log(80), 250)
            self.assertAlmostEqual(total, 1, delta=1e-9)
        ball = _laws.inelastic_ball(0.5)  # impact speeds with the density e^-u
        for order in (1, 2, 3, 4, 5):
            self.assertAlmostEqual(ball.speed_moment(order) / math.factorial(order), 1, delta=1e-8)
        self.assertAlmostEqual(ball.impact_rate(), 2 / 3, delta=1e-8)
        self.assertAlmostEqual(ball.fourth_velocity_moment(), 13.5, delta=1e-6)
        ball = _laws.inelastic_ball(0.7)  # power balance
        self.assertAlmostEqual(ball.speed_moment(2) * 0.3 / ball.speed_moment(1), 1, delta=1e-8)
        self.assertAlmostEqual(ball.mean_height(), 4.0524874, delta=1e-7)

    def test_printed_values(self):
        printed = {("inelastic_ball_03", "impact_rate", None): 1.879489, ("inelastic_ball_03", "E[y]", None): 0.9185948,
                   ("inelastic_ball_03", "E[y'^4]", None): 6.44045, ("inelastic_ball_08", "E[y]", None): 9.4819530,
                   ("inelastic_ball_08", "E[y'^4]", None): 420.0940,
                   ("inelastic_ball", "mean_return_time", 0.5): 1.576239,
                   ("inelastic_ball", "mean_return_time", 1.0): 2.633170,
                   ("inelastic_ball", "mean_return_time", 2.0): 4.659963,
                   ("random_acceleration_exit", "mean_exit_time", 0.5): 1.456442,
                   ("random_acceleration_exit", "mean_exit_time", 0.25): 1.358260,
                   ("random_acceleration_exit", "exit_probability_right", 0.25): 0.425818,
                   ("box_cubic", "E[y'^2]", None): 0.675978 * math.sqrt(0.1)}
        for (name, quantity, at), value in printed.items():
            self.assertAlmostEqual(reference.problem(name).value(quantity, at).value / value, 1, delta=1e-6)


class Tables(unittest.TestCase):
    def test_problems_are_described(self):
        self.assertGreaterEqual(len(reference.problems()), 30)
        for name in reference.problems():
            problem = reference.problem(name)
            with self.subTest(problem=name):
                self.assertTrue(problem.title and problem.source and problem.values)
                self.assertEqual(problem.equation.count("{"), problem.equation.count("}"))
                self.assertTrue({"system.damping", "system.force"} & set(problem.parameters))

    # test_printed_values tests the two omitted problems.
    def test_exact_values_are_those_of_the_formulas(self):
        for name in reference.problems():
            if name in ("inelastic_ball_03", "inelastic_ball_08"):
                continue
            for exact in reference.problem(name).exact_values():
                with self.subTest(problem=name, quantity=exact.quantity, at=exact.at):
                    value = reference.problem(name).value(exact.quantity, exact.at)
                    self.assertEqual(value.origin, "exact")
                    self.assertAlmostEqual(value.value, exact.value, delta=max(exact.error, 1e-10 * abs(exact.value)))

    def test_computed_values_agree_with_the_simulation(self):
        tested = 0
        for name in reference.problems():
            for v in reference.problem(name).values:
                if v.check_error:
                    tested += 1
                    with self.subTest(problem=name, quantity=v.quantity):
                        self.assertLess(abs(v.value - v.check), 4.5 * v.check_error + v.error)
        self.assertGreater(tested, 80)

    def test_densities_have_the_moments_and_the_mass_of_the_table(self):
        tested = 0
        for name in reference.problems():
            problem = reference.problem(name)
            rest = sum(v.value for v in problem.values if v.quantity == "rest_probability")
            for variable, p in problem.densities.items():
                if variable in problem.exact_densities:
                    continue
                tested += 1
                error = problem.value(f"l1_error_{variable}").value
                with self.subTest(problem=name, variable=variable):
                    self.assertEqual(p.averages([p.upper, p.upper + 1])[0], 0)
                    mass = np.sum(p.averages(p.edges) * np.diff(p.edges))
                    self.assertAlmostEqual(mass, 1 - rest, delta=error + 1e-9)
                    if variable == "ydot":
                        centres = (p.edges[1:] + p.edges[:-1]) / 2
                        square = np.sum(np.diff(p.edges) * p.averages(p.edges) * centres**2)
                        square -= np.mean(np.diff(p.edges)) ** 2 / 12  # Sheppard's correction
                        value = problem.value("E[y'^2]")
                        self.assertAlmostEqual(square, value.value, delta=5 * value.error + 30 * value.value * error)
        self.assertGreater(tested, 30)

    def test_unknown_names(self):
        with self.assertRaisesRegex(ValueError, "no problem 'case9'"):
            reference.problem("case9")
        with self.assertRaisesRegex(ValueError, r"no 'E\[y\^3\]'"):
            reference.problem("duffing").value("E[y^3]")
        with self.assertRaisesRegex(ValueError, "no reference density"):
            reference.problem("random_acceleration_exit").density("y")


def normal(x, mean=0.0, deviation=1.0):
    return np.exp(-(((x - mean) / deviation) ** 2) / 2) / (deviation * math.sqrt(2 * math.pi))


class Scores(unittest.TestCase):
    def test_of_the_reference_is_zero(self):
        for name in ("duffing", "ring", "linear", "box_laplace", "case1", "gap"):
            problem = reference.problem(name)
            result = reference.score(problem, problem.densities)
            for variable, distance in result.distances.items():
                with self.subTest(problem=name, variable=variable):
                    self.assertLess(distance.l1, 1e-9 + distance.reference_error)
                    self.assertAlmostEqual(distance.mass, 1, delta=1e-9 + distance.reference_error)
            for quantity, moment in result.moments.items():
                # The tables end where the density is negligible.
                self.assertLess(abs(moment.difference), 1e-4 * max(moment.reference, 1), (name, quantity))

    # The L1 distance of two normal densities shifted by d is 2 erf(d / (2 sqrt(2) s)).
    def test_of_a_shifted_density(self):
        shift = 0.1
        expected = 2 * math.erf(shift / (2 * math.sqrt(2)))
        points = np.linspace(-9, 9, 301)
        edges = np.linspace(-9, 9, 601)
        distribution = np.array([(1 + math.erf((x - shift) / math.sqrt(2))) / 2 for x in edges])
        averages = np.diff(distribution) / np.diff(edges)
        forms = {"function": lambda v: normal(v, shift), "points": (points, normal(points, shift)),
                 "averages": (edges, averages)}
        for form, density in forms.items():
            with self.subTest(form=form):
                result = reference.score("duffing", {"ydot": density})  # p(v) is the standard normal density
                # The sum over bins omits the change of sign inside one bin.
                self.assertAlmostEqual(result.distances["ydot"].l1, expected, delta=1e-5)
                self.assertAlmostEqual(result.moments["E[y'^2]"].moment, 1 + shift**2, delta=1e-6)
                self.assertAlmostEqual(result.moments["E[y'^2]"].difference, shift**2, delta=1e-6)
                self.assertAlmostEqual(result.distances["ydot"].mass, 1, delta=1e-7)

    def test_counts_probability_where_the_reference_ends(self):
        problem = reference.problem("case1")
        p = problem.density("ydot")
        far = p.upper + (p.upper - p.lower) / 4
        result = reference.score(problem, {"ydot": lambda v: 0.99 * p(v) + 0.01 * normal(v, far, 0.05)})
        self.assertAlmostEqual(result.distances["ydot"].l1, 0.02, delta=1e-5)
        edges = p.edges[p.edges < 0]
        half = reference.score(problem, {"ydot": (edges, p.averages(edges))})
        self.assertAlmostEqual(half.distances["ydot"].l1, 1 - half.distances["ydot"].mass, delta=1e-5)

    def test_a_density_alone_is_that_of_y(self):
        result = reference.score("ball_white", lambda y: np.exp(-y))
        self.assertEqual(list(result.distances), ["y"])
        self.assertLess(result.distances["y"].l1, 1e-10)
        self.assertIn("ball_white: L1 of p(y)", str(result))

    def test_refuses_other_contents(self):
        points = np.linspace(-3, 3, 50)
        for density, message in (({"x": normal}, "keys"), ({}, "keys"), ((points, points[:9]), "shapes"),
                                 ((points[:3], points[:3]), "at least 4"), ((points[::-1], points), "increasing"),
                                 (lambda y: 1.0, "vectorised"), (lambda y: np.log(y), "not finite"), (3, "neither")):
            with self.subTest(message=message), np.errstate(invalid="ignore"):
                with self.assertRaisesRegex(ValueError, message):
                    reference.score("duffing", density)


class Splines(unittest.TestCase):
    def test_reproduce_cubic_polynomials(self):
        x = np.array([0, 0.3, 0.7, 1.6, 2, 3.1])
        cubic = np.polynomial.Polynomial([1, -2, 0.5, 0.25])
        spline = CubicSpline(x, cubic(x))
        t = np.linspace(0, 3.1, 37)
        np.testing.assert_allclose(spline(t), cubic(t), atol=1e-13)
        np.testing.assert_allclose(spline.derivative(t), cubic.deriv()(t), atol=1e-12)

    def test_converge_with_order_four(self):
        errors = []
        for n in (20, 40):
            x, t = np.linspace(0, 3, n + 1), np.linspace(0, 3, 1000)
            errors.append(np.max(np.abs(CubicSpline(x, np.sin(x))(t) - np.sin(t))))
        self.assertGreater(errors[0] / errors[1], 12)


if __name__ == "__main__":
    unittest.main()
