"""The Python package: its results agree with those of the program.

    package_test.py FPKCHECK        with the package on PYTHONPATH; exit code 77 (skipped) without xarray
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    import numpy as np
    import xarray
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import fpkcheck as fpk

PROGRAM = sys.argv.pop(1)
METHODS = "epc-gaussian-n4,epc-gaussian-n6,fd-km4,fd-kf,mcs"


def error_message(call, *arguments, **keywords):
    """The text of the ValueError that a call raises."""
    try:
        call(*arguments, **keywords)
    except ValueError as error:
        return str(error)
    return "accepted"


class RunOfTheProgram(unittest.TestCase):
    """A run of the program, and the same run from Python."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.directory = pathlib.Path(cls.folder.name, "run")
        subprocess.run(
            [PROGRAM, "run", "case1", "--set", "system.restitution=0.95", "--methods", METHODS, "--seed", "3"]
            + ["--time", "2e4", "--quiet", "--out", str(cls.directory)]
        )  # epc-gaussian-n4 is inadmissible: exit code 1
        cls.summary = json.loads((cls.directory / "summary.json").read_text())
        cls.run_ = fpk.solve(
            "case1", METHODS.split(","), restitution=0.95, options={"mcs.seed": 3, "mcs.time": 20_000}
        )

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def assert_same(self, one, other, at=""):
        """Compares numbers to 1e-7, relative and absolute: iteration counts may differ by one."""
        timed = ("seconds", "_seconds", "milliseconds")
        if isinstance(one, dict):
            self.assertEqual(set(one), set(other), at)
            for key in one:
                if not key.endswith(timed):
                    self.assert_same(one[key], other[key], f"{at}.{key}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), at)
            for k, (a, b) in enumerate(zip(one, other)):
                self.assert_same(a, b, f"{at}[{k}]")
        elif isinstance(one, float) and isinstance(other, float):
            self.assertTrue(math.isclose(one, other, rel_tol=1e-7, abs_tol=1e-9), (at, one, other))
        else:
            self.assertEqual(one, other, at)

    def test_agrees_with_the_package(self):
        # The width of bounds depends on their time limit.
        for key in ("system", "impulse", "comparisons", "budget", "reference", "limits"):
            self.assert_same(self.summary["cases"][0][key], self.run_.case.record[key], key)
        for one, other in zip(self.summary["cases"][0]["solutions"], self.run_.solutions.values()):
            for key in ("id", "status", "reason", "moments", "mass", "options", "equation", "impact"):
                self.assert_same(one[key], other.record[key], f"{one['id']}.{key}")

    def test_solutions_agree_with_the_summary(self):
        kf = self.run_.solutions["fd-kf"]
        self.assertEqual((kf.status, kf.reason, kf.is_ok), ("ok", "", True))
        self.assertEqual(list(kf.moments), ["y1", "y2", "y4", "v1", "v2", "v4"])
        self.assertLess(kf.error.y_l1, 1e-3)
        self.assertAlmostEqual(kf.mass, 1, 6)
        n4 = self.run_.solutions["epc-gaussian-n4"]
        self.assertEqual(n4.status, "inadmissible")
        self.assertIn("peak", n4.reason)
        self.assertEqual(self.run_.reference, self.summary["cases"][0]["reference"])
        self.assertGreater(self.run_.solutions["mcs"].standard_errors["y2"], 0)
        lower, upper = self.run_.bounds["E[y^2]"]
        # Bounds may be narrower than the error of the finite volumes, depending on the time limit.
        slack = 2 * kf.error.moments["y2"]
        self.assertTrue(lower - slack < kf.moments["y2"] < upper + slack)
        self.assertLess(upper - lower, 1e-3)

    def test_loading_restores_a_saved_run(self):
        loaded = fpk.load(self.directory)
        self.assertEqual(loaded.summary["cases"], self.summary["cases"])
        self.assertEqual(loaded.problem, self.run_.problem)
        with tempfile.TemporaryDirectory() as folder:
            self.run_.save(pathlib.Path(folder, "again"))
            again = fpk.load(pathlib.Path(folder, "again"))
            for file in ("report.html", "summary.json", "marginals.csv", "smooth.csv", "joint.nc", "figures"):
                self.assertTrue(pathlib.Path(folder, "again", file).exists(), file)
            xarray.testing.assert_equal(again.marginals, self.run_.marginals)
            xarray.testing.assert_equal(again.smooth, self.run_.smooth)
            xarray.testing.assert_equal(again.joint, self.run_.joint)
            xarray.testing.assert_equal(again.distances, self.run_.distances)
            xarray.testing.assert_equal(again.budget, self.run_.budget)
            self.assertEqual(again.solutions, self.run_.solutions)
            self.assertEqual(again.table(), self.run_.table())
            check = subprocess.run([PROGRAM, "report", str(pathlib.Path(folder, "again"))], capture_output=True)
            self.assertEqual(check.returncode, 0, check.stderr)

    def test_tables_have_the_named_axes(self):
        marginals, joint = self.run_.marginals, self.run_.joint
        ids = METHODS.split(",")
        self.assertEqual(list(marginals.solution.values), ids)
        self.assertEqual(marginals.p_y.dims, ("solution", "y"))
        self.assertEqual(marginals.p_y.shape, (5, 140))
        self.assertTrue(np.isfinite(marginals.p_y_lower.sel(solution="mcs")).all())
        self.assertTrue(np.isnan(marginals.p_y_lower.sel(solution="fd-kf")).all())
        edges = self.run_.problem.bins()[0]
        self.assertAlmostEqual(float(marginals.p_y.sel(solution="fd-kf").values @ np.diff(edges)), 1, 6)
        self.assertEqual(joint.dims, ("solution", "y", "ydot"))
        area = (joint.y_upper - joint.y_lower) * (joint.ydot_upper - joint.ydot_lower)
        self.assertAlmostEqual(float((joint.sel(solution="fd-kf") * area).sum()), 1, 5)
        curve = self.run_.curve("fd-kf", "ydot")
        np.testing.assert_array_equal(curve.density, marginals.p_ydot.sel(solution="fd-kf"))
        self.assertIsNone(curve.lower)
        self.assertEqual(set(self.run_.error_sources), {"y2", "v2"})
        self.assertIn("mcs", self.run_.smooth.solution)

    def test_distances_and_budget_are_those_of_the_summary(self):
        case = self.summary["cases"][0]
        distances, budget = self.run_.distances, self.run_.budget
        for pair in case["comparisons"]:
            at = dict(solution=pair["a"], reference=pair["b"], variable=pair["variable"])
            self.assertAlmostEqual(float(distances.l1.sel(at)), pair["l1"], 8)
        self.assertEqual(set(self.run_.l1("fd-kf", "mcs")), {"y", "ydot"})
        self.assertEqual(list(budget.part.values)[:2], ["closure + impact", "truncation"])
        for row in case["budget"]:
            own = budget.sel(solution=row["solution"], variable=row["variable"])
            self.assertAlmostEqual(float(own.total), row["total"], 8)
            self.assertLessEqual(float(own.total), float(own.l1.sum()) + 1e-12)

    def test_the_table_agrees_with_the_program(self):
        saved = subprocess.run([PROGRAM, "report", str(self.directory)], capture_output=True, text=True).stdout
        self.assertEqual(fpk.load(self.directory).table(100).splitlines()[0], saved.splitlines()[0])
        self.assertIn("error budget", str(self.run_))


class Input(unittest.TestCase):
    one_line = dict(damping=0.1, stiffness=1, cubic=0, restitution=1, rate=1, law="gaussian", intensity=1)

    def test_is_refused_with_the_programs_message(self):
        solve, case = fpk.solve, fpk.Problem.case
        for got, expected in (
            (error_message(case, "case1", restitution=-1), "case case1: system.restitution = -1 (must be"),
            (error_message(case, "case9"), "no case 'case9'"),
            (error_message(case, "case1", dampin=1), "unknown key 'dampin'; known keys: system.{damping"),
            (error_message(fpk.Problem, damping=0.1), "key 'system.stiffness' is missing"),
            (error_message(solve, "case1", "fd-nonsense"), "--methods: unknown method 'fd-nonsense'"),
            (error_message(solve, "case1", "fd-kf", options={"mcs.sed": 1}), "unknown option 'mcs.sed'; use mcs."),
            (error_message(solve, "case1", "mcs", options={"mcs.time": "x"}), "options: mcs.time = 'x'"),
            (error_message(solve, "case1", "mcs", options={"mcs.time": -1}), "must be"),
            (error_message(solve, "case1", "epc-gaussian-n6", options={"epc.order": 4}), "epc-gaussian-n4"),
            (error_message(solve, ["case1", "case2"], "fd-kf", against={"a": "b.csv"}), "2 cases"),
            (error_message(solve, "case1", "fd-kf", against={"fd-own": lambda y, v: y}), "is the name of a method"),
            (error_message(solve, "case1", "fd-kf", against={"lab": "nowhere.csv"}), "nowhere.csv"),
            (error_message(fpk.Problem.case, "case1", law="cauchy"), "impulse.law = 'cauchy' (must be one of gaussian"),
            (error_message(fpk.Problem, self.one_line, name="a\nb"), "the name of the case, taken from its file, contains control"),
            (error_message(fpk.Problem, self.one_line, name="a" * 101), "has 101 bytes"),
            (error_message(fpk.load, "/nowhere"), "/nowhere"),
            (error_message(fpk.solve("case1", "fd-white", bounds=False).save, "/proc/nowhere"), "/proc/nowhere"),
        ):
            self.assertIn(expected, got)
            self.assertNotIn("\n", got)
        with self.assertRaises(TypeError):
            fpk.Problem(damping=[1])
        with self.assertRaises(TypeError):
            solve("case1", "fd-kf", options={"fd.order": object()})

    def test_problems_have_the_given_settings(self):
        keywords = dict(damping=0.2, stiffness=1, cubic=0.3, restitution=0.9, rate=2, law="laplace", intensity=0.1)
        one = fpk.Problem(**keywords)
        nested = {"system": {k: keywords[k] for k in ("damping", "stiffness", "cubic", "restitution")}}
        nested["impulse"] = {k: keywords[k] for k in ("rate", "law", "intensity")}
        self.assertEqual(one, fpk.Problem(nested))
        rest = {name: value for name, value in keywords.items() if name != "damping"}
        self.assertEqual(one, fpk.Problem({"system.damping": np.float64(0.2)}, **rest))
        self.assertIn("given twice", error_message(fpk.Problem, {"system.damping": 0.2}, **keywords))
        self.assertEqual(one["impulse.law"], "laplace")
        self.assertEqual(one["mean"], 0)
        self.assertEqual(fpk.Problem.case("case1", restitution=1 / 3)["restitution"], 1 / 3)
        with tempfile.NamedTemporaryFile("w", suffix=".ini") as file:
            file.write("".join(f"[{s}]\n" + "".join(f"{k} = {v}\n" for k, v in p.items()) for s, p in nested.items()))
            file.flush()
            self.assertEqual(fpk.load_case(file.name).settings, one.settings)

    def test_formulas_are_settings(self):
        noise = {"intensity": 0.2, "factor": "sqrt(1 + v^2/4)", "interpretation": "ito"}
        wall = {"left": 0, "left_restitution": "1 - 0.3*min(1, v)^0.2"}
        constants = {"c": 0.1, "mu": 0.2}
        one = fpk.Problem(force="c*v + y + mu*y^3", parameters=constants, noise=noise, wall=wall)
        self.assertEqual((one["force"], one["parameters.mu"]), ("c*v + y + mu*y^3", 0.2))
        self.assertEqual((one["noise.factor"], one["left_restitution"]), (noise["factor"], wall["left_restitution"]))
        self.assertEqual(fpk.Problem.case("hertz", {"parameters.k": 20})["parameters.k"], 20)
        unused = error_message(fpk.Problem.case, "hertz", {"parameters.q": 20})
        self.assertIn("no formula of the case uses q", unused)
        polynomial = {"wall": {"none": True}, "noise": {"intensity": 0.2}}
        formula = fpk.Problem(polynomial, force="c*v + y", parameters={"c": 0.1})
        coefficients = fpk.Problem(polynomial, damping=0.1, stiffness=1)
        one, other = (fpk.solve(p, "fd-kf", bounds=False).solutions["fd-kf"] for p in (formula, coefficients))
        self.assertEqual(one.moments, other.moments)

    def test_methods_and_options_are_listed(self):
        self.assertIn("epc-moment", fpk.methods())
        self.assertIn("seed", fpk.options("mcs")["mcs"])


def half_normal_l1(one, other):
    """L1 distance of two centred normal densities, and of their halves, by erf at the crossing point."""
    at = one * other * math.sqrt(2 * math.log(other / one) / (other**2 - one**2))
    return 2 * (math.erf(at / one / math.sqrt(2)) - math.erf(at / other / math.sqrt(2)))


class ExternalDensities(unittest.TestCase):
    """At r = 1 white noise has the density exp(-(c/D2) (v^2/2 + U(y))), here with c/D2 = 2, U = y^2/2."""

    problem = fpk.Problem.case("case1", restitution=1, cubic=0)
    exact = math.sqrt(0.5)

    def normal(self, factor):
        return lambda y, v: np.exp(-(y**2 + v**2) / 2 / (factor * self.exact) ** 2)

    def test_functions_have_the_exact_distance(self):
        far = half_normal_l1(self.exact, 1.1 * self.exact)
        run = fpk.solve(
            self.problem,
            "fd-white,fd-kf",
            against={
                "exact": fpk.Density(self.normal(1), equation="white", accuracy=1),
                "wide": fpk.Density(self.normal(1.1), equation="white"),
                "nobody": self.normal(1.1),
            },
        )
        for variable in ("y", "ydot"):
            self.assertLess(run.l1("exact", "fd-white")[variable], 1e-4)
            # The distance of bin averages is smaller, since the densities cross within a bin.
            self.assertAlmostEqual(run.l1("exact", "wide")[variable], far, delta=3e-4)
            self.assertAlmostEqual(run.l1("nobody", "fd-white")[variable], far, 3)
            budget = run.budget.sel(variable=variable)
            self.assertAlmostEqual(float(budget.l1.sel(solution="wide", part="closure")), far, 3)
            self.assertLess(float(budget.l1.sel(solution="exact", part="closure")), 1e-4)
            self.assertGreater(float(budget.l1.sel(solution="exact", part="white noise")), 0.005)
        exact = run.solutions["exact"]
        self.assertEqual((exact.status, exact.equation, exact.impact), ("ok", "white", "map"))
        self.assertAlmostEqual(exact.moments["y2"], 0.5, 8)
        self.assertAlmostEqual(exact.moments["v4"], 0.75, 7)
        self.assertAlmostEqual(exact.mass, 1, 9)
        self.assertAlmostEqual(exact.record["normalised_by"], math.pi / 2, 8)
        self.assertLess(abs(exact.energy_residual), 1e-8)
        # The error estimate is the error of the white-noise model.
        distance = run.l1("exact", "fd-kf")["y"]
        self.assertTrue(distance < exact.error.y_l1 < 1.7 * distance)
        wide, nobody = run.solutions["wide"], run.solutions["nobody"]
        self.assertEqual(wide.status, "inaccurate")
        self.assertIn("requested accuracy: 0.02", wide.reason)
        self.assertEqual((nobody.status, nobody.equation, nobody.impact), ("ok", "given", "-"))
        self.assertNotIn("nobody", run.budget.solution)
        with tempfile.TemporaryDirectory() as folder:
            run.save(folder)
            self.assertEqual(fpk.load(folder).solutions, run.solutions)
            # External densities cannot be solved again.
            check = subprocess.run(
                [PROGRAM, "check", str(pathlib.Path(folder, "summary.json"))], capture_output=True, text=True
            )
            self.assertEqual(check.returncode, 0, check.stdout + check.stderr)
            self.assertIn("wide", check.stdout + check.stderr)

    def test_orders_form_a_family(self):
        against = {
            f"chi-n{n}": fpk.Density(self.normal(factor), equation="white", order=n)
            for n, factor in ((2, 1.1), (4, 1.01))
        }
        against["drawn-n2"] = fpk.Samples(np.abs(np.random.default_rng(1).normal(size=(1000, 2))), order=2)
        run = fpk.solve(self.problem, "fd-white,fd-kf", against=against, bounds=False)
        records = {name: solution.record for name, solution in run.solutions.items()}
        self.assertEqual([records[f"chi-n{n}"]["identity"]["order"] for n in (2, 4)], [2, 4])
        self.assertEqual([records[f"chi-n{n}"]["identity"]["family"] for n in (2, 4)], ["chi", "chi"])
        self.assertEqual(records["drawn-n2"]["identity"]["order"], 2)
        self.assertNotEqual(records["drawn-n2"]["identity"]["family"], "drawn")
        self.assertIn("order = 0 (must be 1 or more)", error_message(fpk.solve, "case1", "fd-kf", against={
            "own": fpk.Density(self.normal(1), order=0)}))

    def test_scalar_functions_are_accepted(self):
        def scalar(y, v):
            return math.exp(-(y**2) - v**2) if y >= 0 else 0.0

        run = fpk.solve(self.problem, "fd-white", against={"a": scalar, "b": self.normal(1)}, bounds=False)
        self.assertLess(max(run.l1("a", "b").values()), 1e-14)

    def test_inadmissible_functions_have_a_reason(self):
        def solved(function, **how):
            density = fpk.Density(function, equation="white", **how)
            run = fpk.solve(self.problem, "fd-white", against={"own": density}, bounds=False)
            return run.solutions["own"]

        self.assertIn("negative", solved(lambda y, v: (1 - y) * np.exp(-(y**2) - v**2)).reason)
        self.assertIn("cut off", solved(lambda y, v: 1 + 0 * y).reason)
        off = solved(self.normal(1), normalise=False)
        self.assertEqual(off.status, "inadmissible")
        self.assertIn("the integral is 1.5708", off.reason)
        for function, expected in (
            (lambda y, v: np.log(y), "must be a finite number"),
            (lambda y, v: -np.exp(-(y**2) - v**2), "the integral is"),
            (lambda y, v: np.ones(7), "shape (7,)"),
        ):
            with np.errstate(divide="ignore"):
                self.assertIn(expected, error_message(solved, function))
        self.assertIn("equation 'km5'", error_message(fpk.solve, "case1", "fd-kf", against={
            "own": fpk.Density(self.normal(1), equation="km5")}))
        self.assertIn("impact 'exact' (must be one of map, delta)", error_message(fpk.solve, "case1", "fd-kf", against={
            "own": fpk.Density(self.normal(1), equation="kf", impact="exact")}))
        with self.assertRaises(ZeroDivisionError):
            solved(lambda y, v: 1 / 0)

    def test_samplers_estimate_their_sampling_error(self):
        def sampler(rng, n):
            return np.abs(rng.normal(0, self.exact, (n, 2))) * np.stack([np.ones(n), rng.choice([-1, 1], n)], axis=1)

        run = fpk.solve(
            self.problem,
            "fd-white",
            against={
                "drawn": fpk.Samples(sampler, equation="white", n=40_000),
                "few": sampler(np.random.default_rng(2), 4000),
                "worth_less": fpk.Samples(sampler, equation="white", n=40_000, independent=4000),
            },
            bounds=False,
        )
        for id, number in (("drawn", 40_000), ("few", 4000)):
            solution, distance = run.solutions[id], run.l1(id, "fd-white")
            for variable in ("y", "ydot"):
                expected = solution.sampling_l1[variable]
                self.assertLess(expected, distance[variable] * 1.35)
                self.assertGreater(expected, distance[variable] / 1.35)
            self.assertLess(abs(solution.moments["y2"] - 0.5), 4 * solution.standard_errors["y2"])
            self.assertAlmostEqual(solution.standard_errors["y2"], 0.5 * math.sqrt(2 / number), delta=0.001)
        ratio = run.solutions["worth_less"].sampling_l1["y"] / run.solutions["drawn"].sampling_l1["y"]
        self.assertAlmostEqual(ratio, math.sqrt(10), 6)
        inside = run.marginals.p_y.sel(solution="fd-white")
        own = run.marginals.sel(solution="drawn")
        within = ((own.p_y_lower <= inside) & (inside <= own.p_y_upper))[:50]
        self.assertGreater(float(within.mean()), 0.85)
        series = fpk.Samples(np.abs(np.random.default_rng(3).normal(size=500)), series=True, reference=True)
        displacement_alone = fpk.solve(self.problem, "fd-white", against={"lab": series})
        self.assertIn("Reference: lab", str(displacement_alone))
        self.assertTrue(math.isnan(displacement_alone.solutions["lab"].moments["v2"]))
        for samples, expected in ((np.zeros((5, 2)), "must be at least 100"), (np.zeros((300, 3)), "shape (300, 3)"),
                                  (-np.ones((200, 2)), "y >= 0"), (np.full((200, 2), np.nan), "finite")):
            self.assertIn(expected, error_message(fpk.solve, self.problem, "fd-white", against={"own": samples}))

    def test_files_are_compared(self):
        run = fpk.solve(self.problem, "fd-white", bounds=False)
        curve = run.curve("fd-white")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "lab.csv")
            np.savetxt(file, np.stack([curve.abscissa, curve.density], axis=1), header="y p(y)")
            again = fpk.solve(self.problem, "fd-white", against={"lab": file}, bounds=False)
        self.assertLess(again.l1("lab", "fd-white")["y"], 1e-3)
        self.assertEqual(set(again.l1("lab", "fd-white")), {"y"})
        self.assertTrue(np.isnan(again.marginals.p_ydot.sel(solution="fd-white")).sum() == 0)


class Solving(unittest.TestCase):
    def test_requires_xarray_only_for_named_axes(self):
        program = """if True:
            import sys
            sys.modules["xarray"] = None
            import fpkcheck
            run = fpkcheck.solve("case1", "fd-white", bounds=False)
            print(run.curve("fd-white").density.shape, run.solutions["fd-white"].status)
            try:
                run.marginals
            except ImportError as error:
                print("require xarray" in str(error))
            """
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual(done.stdout, "(140,) ok\nTrue\n", done.stderr)

    def test_releases_the_interpreter_lock(self):
        count, stop = 0, threading.Event()

        def counting():
            nonlocal count
            while not stop.is_set():
                count += 1
                time.sleep(0.001)

        thread = threading.Thread(target=counting)
        thread.start()
        before = count
        fpk.solve("case1", "mcs", options={"mcs.time": 1e6, "mcs.controlled": False}, threads=1, bounds=False)
        during = count - before
        stop.set()
        thread.join()
        # If solve() held the interpreter lock, there would be at most one, before or after.
        self.assertGreater(during, 10)

    def test_reports_progress_and_respects_the_time_limit(self):
        told = []
        fpk.solve("case1", "fd-white,fd-kf", progress=told.append, bounds=False)
        self.assertTrue(told)
        self.assertEqual(told[-1]["total"], 2)
        self.assertEqual(told[-1]["case"], "case1")
        begin = time.monotonic()
        with self.assertRaisesRegex(TimeoutError, "not solved in 0.5 s: 0 of 1 solutions, last mcs"):
            fpk.solve("case1", "mcs", options={"mcs.time": 1e9}, max_seconds=0.5)
        self.assertLess(time.monotonic() - begin, 3)

        def refuse(at):
            raise LookupError(at["method"])

        with self.assertRaisesRegex(LookupError, "fd-kf"):
            fpk.solve("case1", "fd-kf", progress=refuse)

    def test_several_cases_are_selected_by_name(self):
        run = fpk.solve(["case1", fpk.Problem.case("case4")], "epc-moment-n4", bounds=False)
        self.assertEqual(list(run), ["case1", "case4"])
        self.assertNotEqual(run["case1"].problem, run["case4"].problem)
        self.assertIn("select run[", error_message(lambda: run.solutions))
        self.assertEqual(run["case4"].joint.attrs["case"], "case4")

    def test_threads_may_solve_concurrently(self):
        found = {}

        def solving(name):
            found[name] = fpk.solve(name, "fd-white", bounds=False)

        threads = [threading.Thread(target=solving, args=(f"case{k}",)) for k in (1, 2, 3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual({name: run.solutions["fd-white"].status for name, run in found.items()},
                         {"case1": "ok", "case2": "ok", "case3": "ok"})


if __name__ == "__main__":
    unittest.main()
