"""First passages, spectra, sensitivities and densities over time: exact laws, and the files of the program.

    functionals_test.py FPKCHECK        with the package on PYTHONPATH
"""

import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import fpkcheck as fpk

PROGRAM = sys.argv.pop(1)
LINEAR = fpk.Problem(damping=0.2, stiffness=1, wall={"none": True}, noise={"intensity": 0.2}, name="linear")


def files_of_the_program(command, *arguments):
    """The JSON and the rows of the CSV that a command of the program writes."""
    stem = "over_time" if command == "run" else command
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, command, *arguments, "--quiet", "--out", folder], stderr=subprocess.DEVNULL)
        rows = list(csv.DictReader(io.StringIO(pathlib.Path(folder, stem + ".csv").read_text())))
        return json.loads(pathlib.Path(folder, stem + ".json").read_text()), rows


class Functionals(unittest.TestCase):
    def assert_same(self, one, other, at=""):
        """Compares JSON objects, except computing times. A simulation repeats its numbers up to rounding errors."""
        if isinstance(one, dict):
            self.assertEqual(set(one), set(other), at)
            for key in set(one) - {"seconds"}:
                self.assert_same(one[key], other[key], f"{at}.{key}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), at)
            for k, (a, b) in enumerate(zip(one, other)):
                self.assert_same(a, b, f"{at}[{k}]")
        elif isinstance(one, float) and isinstance(other, float):
            self.assertTrue(math.isclose(one, other, rel_tol=1e-7, abs_tol=1e-9), (at, one, other))
        else:
            self.assertEqual(one, other, at)

    def test_the_spectral_density_of_the_linear_oscillator_is_exact(self):
        # G = 2D |H|^2 / pi with H = 1/(k - w^2 + i c w) (docs/functionals.md)
        results = fpk.spectrum(LINEAR, frequencies=(0, 2, 40), methods=["fd-white", "mcs-white"], time=1e5)
        w = np.linspace(0, 2, 41)
        exact = 0.2 / np.pi / ((1 - w**2) ** 2 + 0.2**2 * w**2)
        self.assertEqual(list(results), ["fd-white", "mcs-white"])
        fd, mcs = results["fd-white"], results["mcs-white"]
        self.assertEqual((fd.status, fd.variable, fd.error_kind), ("ok", "y", "discretisation error"))
        np.testing.assert_allclose(fd.frequency, w, rtol=1e-12)
        np.testing.assert_allclose(fd.density, exact, atol=1e-3 * exact.max())
        self.assertLess(np.abs(mcs.density - exact).max() / mcs.density_error.max(), 5)
        # R(t) = 0.5 exp(-c t/2) (cos(f t) + c/(2 f) sin(f t)) with f^2 = k - c^2/4
        f, t = math.sqrt(0.99), fd.lag
        covariance = 0.5 * np.exp(-0.1 * t) * (np.cos(f * t) + 0.1 / f * np.sin(f * t))
        np.testing.assert_allclose(fd.autocovariance, covariance, atol=1e-3)
        self.assertAlmostEqual(fd.variance, 0.5, 4)
        self.assertAlmostEqual(fd.modes[0]["decay_rate"], 0.1, 4)
        self.assertAlmostEqual(fd.peak["frequency"], math.sqrt(0.98), 1)

    def test_the_mean_over_time_of_the_forced_linear_oscillator_is_exact(self):
        def force(t):
            return 0.3 * np.cos(t)

        # m'' + c m' + k m = 0.3 cos t at rest: the particular solution at resonance is (0.3/c) sin t
        problem = fpk.Problem(LINEAR.settings, time={"force": force})
        self.assertEqual(problem["time.force"], "0.3*cos(t)")
        results = fpk.densities_over_time(problem, 3, snapshots=3, methods="fd-white")
        fd = results["fd-white"]
        f, t = math.sqrt(0.99), fd.times
        exact = 1.5 * (np.sin(t) - np.exp(-0.1 * t) * np.sin(f * t) / f)
        np.testing.assert_allclose(t, np.arange(4), atol=1e-12)
        np.testing.assert_allclose(fd.moments["y1"], exact, atol=1e-3)
        width = fd.abscissa["y"][1] - fd.abscissa["y"][0]
        self.assertEqual(fd.density["y"].shape, (4, len(fd.abscissa["y"])))
        np.testing.assert_allclose(fd.density["y"] @ fd.abscissa["y"] * width, exact, atol=2e-3)
        self.assertIsNone(fd.lower)
        for refused in (fpk.solve, fpk.spectrum, fpk.sensitivity, fpk.passage):
            with self.assertRaisesRegex(ValueError, r"the section \[time\] .* use densities_over_time\(\)"):
                refused(problem)
        with self.assertRaisesRegex(ValueError, r"the section \[time\]"):
            problem.bins()

    def test_first_passages_agree_with_the_program(self):
        one, _ = files_of_the_program(
            "passage", "case1", "--set", "system.restitution=0.9", "--displacement", "1", "--start", "0.5,-1",
            "--times", "5,20", "--methods", "fd,mcs", "--time", "2e5", "--seed", "3", "--threads", "1",
            "--accuracy", "0.1", "--max-seconds", "60")
        results = fpk.passage("case1", displacement=1, start=(0.5, -1), times=[5, 20], methods="fd,mcs", time=2e5,
                              seed=3, threads=1, accuracy=0.1, max_seconds=60, restitution=0.9)
        self.assert_same(one["cases"], results.record["cases"])
        self.assertEqual(list(results), ["fd-kf", "mcs", "rice"])
        record = one["cases"][0]["passage"]["solutions"]
        for k, (id, result) in enumerate(results.items()):
            self.assertEqual(result.record["solution"], id)
            for name, value in result.values.items():
                expected = record[k][name]
                self.assertTrue(math.isnan(value) if expected is None else math.isclose(value, expected, rel_tol=1e-7))
        fd, mcs, rice = results.values()
        self.assertEqual(set(fd.values), {"hazard", "mean_from_start", "mean_from_stationary", "rice_rate",
                                          "probability_below"})
        self.assertLess(abs(fd.values["mean_from_stationary"] - mcs.values["mean_from_stationary"]),
                        5 * mcs.errors["mean_from_stationary"] + fd.errors["mean_from_stationary"])
        np.testing.assert_array_equal(fd.times, [5, 20])
        for start in ("from_start", "from_stationary"):
            np.testing.assert_allclose(fd.survival[start], [at[start] for at in record[0]["survival"]], rtol=1e-7)
            np.testing.assert_allclose(mcs.survival_errors[start], [at[start] for at in record[1]["error"]["survival"]],
                                       rtol=1e-6)
        self.assertEqual((mcs.error_kind, rice.error_kind, fd.mean_bounds), ("standard error", None, None))
        self.assertTrue(np.isnan(rice.survival_errors["from_stationary"]).all())
        self.assertIn("first passage of y above 1", str(results))

    def test_bounds_of_the_mean_time_enclose_the_mean_time(self):
        results = fpk.passage("case1", displacement=1, methods="bounds,fd", accuracy=0.3, max_seconds=60)
        lower, upper = results["bounds"].mean_bounds
        self.assertTrue(lower < results["fd-kf"].values["mean_from_rest"] < upper)
        self.assertEqual(results["bounds"].error_kind, "guaranteed bound")

    def test_sensitivities_satisfy_the_exact_identities(self):
        results = fpk.sensitivity("case1", methods=["fd", "epc-polar-n4"], accuracy=0.1, max_seconds=60, cubic=0.2)
        fd, closure = results["fd-kf"], results["epc-polar-n4"]
        for moment, power in (("E[y^2]", 2), ("E[y^4]", 4)):
            e = fd.elasticities[moment]
            # Scaling of displacement, and of time (generator.md); both hold for every restitution coefficient.
            self.assertAlmostEqual(e["impulse.intensity"], power / 2 + e["system.cubic"], 4)
            self.assertAlmostEqual(e["system.damping"] + 2 * e["system.stiffness"] + 2 * e["system.cubic"]
                                   + e["impulse.rate"] + 3 * e["impulse.intensity"], 0, 3)
            self.assertAlmostEqual(fd.derivatives[moment]["system.cubic"] * 0.2 / fd.moments[moment],
                                   e["system.cubic"], 9)
            self.assertAlmostEqual(closure.elasticities[moment]["system.cubic"], e["system.cubic"], 2)
        density = fd.densities["y"]
        edges, _ = results.problem.bins()
        width = np.diff(edges)
        for key, derivative in density.derivatives.items():
            self.assertEqual(derivative.shape, density.abscissa.shape)
            self.assertAlmostEqual(float(derivative @ width), 0, 4, key)
            self.assertAlmostEqual(float(derivative @ (density.abscissa**2 * width)), fd.derivatives["E[y^2]"][key], 2)
        self.assertEqual(dict(closure.densities), {})
        one, rows = files_of_the_program("sensitivity", "case1", "--set", "system.cubic=0.2", "--parameters",
                                         "system.damping", "--methods", "fd", "--accuracy", "0.1",
                                         "--max-seconds", "60")
        again = fpk.sensitivity("case1", methods="fd", parameters=["system.damping"], accuracy=0.1, max_seconds=60,
                                cubic=0.2)
        self.assert_same(one["cases"], again.record["cases"])
        expected = [float(row["derivative"]) for row in rows if row["of"] == "p(y')"]
        np.testing.assert_allclose(again["fd-kf"].densities["ydot"].derivatives["system.damping"], expected, atol=1e-9)

    def test_densities_over_time_agree_with_the_program(self):
        one, rows = files_of_the_program(
            "run", "case1", "--until", "1", "--snapshots", "3", "--start-mean-y", "1", "--methods",
            "fd,epc-polar-n4,mcs", "--time", "1e4", "--seed", "2", "--threads", "1", "--max-seconds", "60")
        results = fpk.densities_over_time("case1", 1, snapshots=3, start_mean_y=1, methods="fd,epc-polar-n4,mcs",
                                          time=1e4, seed=2, threads=1, max_seconds=60)
        self.assert_same(one["cases"], results.record["cases"])
        for record in one["cases"][0]["over_time"]:
            result = results[record["solution"]]
            np.testing.assert_allclose(result.moments["v4"], [at["v4"] for at in record["moments"]], rtol=1e-7)
            for variable in ("y", "ydot"):
                own = [row for row in rows if (row["solution"], row["variable"]) == (result.id, variable)]
                for name, table in (("density", result.density), ("lower", result.lower), ("upper", result.upper)):
                    if table is None:
                        self.assertNotEqual(result.id, "mcs")
                        continue
                    self.assertEqual(table[variable].shape, (4, len(result.abscissa[variable])))
                    expected = [float(row[name]) for row in own]
                    np.testing.assert_allclose(table[variable].ravel(), expected, atol=1e-9)
                expected = [float("nan") if at is None else at[variable] for at in record["l1"]]
                np.testing.assert_allclose(result.l1[variable], expected, rtol=1e-6)
        self.assertEqual(results["mcs"].reference, "fd-kf")
        self.assertTrue(np.isnan(results["fd-kf"].l1["y"]).all())
        self.assertGreater(results["mcs"].moment_errors["y2"][1], 0)

    def test_passage_of_two_barriers_has_the_exact_values(self):
        # Random acceleration process: Masoliver and Porra 1995; Bicout and Burkhardt 2000
        wall = {"left": -1, "left_restitution": 0.5, "right": 2, "right_restitution": 0.5}
        problem = fpk.Problem({"system": {"damping": 0, "stiffness": 0}, "noise": {"intensity": 1}, "wall": wall})
        found = fpk.passage(
            problem, displacement=(0, 1), start=(0.25, 0), methods="fd-white", times=[1], max_seconds=100
        )["fd-white"]
        self.assertEqual(found.status, "ok")
        self.assertAlmostEqual(found.values["mean_from_start"], 1.358260, delta=1e-3)
        self.assertAlmostEqual(found.values["upper_exit_probability_from_start"], 0.425818, delta=1e-3)

    def test_invalid_input_is_refused_in_words_of_python(self):
        for call, expected in (
            (lambda: fpk.passage("case1"), "no barrier; give one, e.g. displacement=1.5 or energy=1"),
            (lambda: fpk.passage("case1", displacement=1, energy=1), "give either displacement or energy"),
            (lambda: fpk.passage("case1", displacement=1, times=[-1]), "times='-1.0' (must be numbers >= 0"),
            (lambda: fpk.passage("case1", displacement=1, accuracy=-1), "accuracy = -1 (must be a positive number)"),
            (lambda: fpk.passage("case1", displacement="high"), "displacement='high' (must be a barrier B"),
            (lambda: fpk.spectrum("case1", of="z"), "of = 'z' (must be one of y, ydot)"),
            (lambda: fpk.spectrum("case1", frequencies=(0, 1)), "frequencies='0:1' (must be FROM:TO:N"),
            (lambda: fpk.spectrum("case1", methods="epc"), "methods: 'epc' is no method"),
            (lambda: fpk.spectrum("case1", threads=-1), "threads = -1 (must be"),
            (lambda: fpk.sensitivity("case1", parameters="system.mass"), "'system.mass' is no parameter"),
            (lambda: fpk.densities_over_time("case1", -1), "until = -1 (must be a positive number)"),
            (lambda: fpk.densities_over_time("case9", 1), "no case 'case9'"),
        ):
            with self.assertRaises(ValueError) as caught:
                call()
            self.assertIn(expected, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(TypeError):
            fpk.passage("case1", displacement=1, time={"rate": "1"})


if __name__ == "__main__":
    unittest.main()
