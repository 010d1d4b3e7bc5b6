"""All problems, with their exact laws and exact values."""

import csv
import math

import numpy as np

from . import _laws
from ._problem import DATA, MOMENTS, VARIABLES, Problem

def _boltzmann(potential, temperature, lower, upper):
    return lambda: {"y": _laws.boltzmann_density(potential, temperature, lower, upper),
                    "ydot": _laws.normal_density(temperature)}


def _radial(function_of_energy, end):
    def densities():
        density = _laws.radial_density(function_of_energy, end)
        return {"y": density, "ydot": density}
    return densities


def _box(velocity_density):
    return lambda: {"y": _laws.uniform_density(-1, 1), "ydot": velocity_density()}


def _damping_box(potential_of_damping, diffusion, end, kinks=()):
    return _box(lambda: _laws.ExactDensity(lambda v: np.exp(-potential_of_damping(v) / diffusion), -end, end, kinks))


def _wall_rate(potential, temperature, upper):
    """Impact rate on an elastic wall at y = 0 of a Boltzmann density: p(0) E[v; v > 0]."""
    def values():
        density = _laws.boltzmann_density(potential, temperature, 0, upper)
        return [("impact_rate", None, float(density(0.0)) * math.sqrt(temperature / (2 * math.pi)), 1e-10)]
    return values


def _upcrossing_rate(potential, temperature, end):
    """Rate of upcrossings of y = 0 of a Boltzmann density (Rice)."""
    def values():
        density = _laws.boltzmann_density(potential, temperature, -end, end)
        return [("upcrossing_rate", 0.0, float(density(0.0)) * math.sqrt(temperature / (2 * math.pi)), 1e-10)]
    return values


def _linear_moments(oscillator):
    return [(q, None, oscillator.moment(variable, order), 1e-10) for q, (variable, order) in MOMENTS.items()]


def _linear():
    return _laws.LinearOscillator(0.2, 1.0, rate=1.0, intensity=0.1, mean=0.1, noise_intensity=0.1)


def _modes(oscillator, orders):
    """Decay rates and frequencies -(n1 l1 + n2 l2) of eigenfunctions of the generator, numbered from 1."""
    result = []
    for i, (n1, n2) in enumerate(orders):
        eigenvalue = oscillator.eigenvalue(n1, n2)
        result += [("mode_decay_rate", i + 1.0, -eigenvalue.real, 1e-12),
                   ("mode_frequency", i + 1.0, abs(eigenvalue.imag), 1e-12)]
    return result


def _linear_values():
    oscillator = _linear()
    result = _linear_moments(oscillator)
    result += [("spectral_density", w, oscillator.spectral_density(w), 1e-10) for w in (0.0, 0.5, 1.0, 1.5)]
    result += _modes(oscillator, [(0, 1), (0, 2), (1, 1)])
    return result


def _overdamped():
    return _laws.LinearOscillator(3.0, 1.0, rate=4.0, intensity=1.0)


def _linear_wall():
    return _laws.LinearOscillator(0.1, 1.0, rate=1.0, intensity=0.1)


def _linear_wall_densities():
    density = _linear_wall().density("y")
    return {"y": _laws.ExactDensity(lambda y: 2 * density(y), 0, density.upper)}


def _linear_wall_values():
    # |z| and z' sgn z of the oscillator without a wall
    oscillator = _linear_wall()
    return [(q, None, oscillator.moment(variable, order), 1e-10)
            for q, (variable, order) in MOMENTS.items() if order != 1]


def _linear_wall_white_values():
    result = [("impact_rate", None, 1 / math.pi, 1e-12)]
    result += [("autocovariance", lag, _laws.elastic_wall_autocovariance(0.1, 1.0, 1.0, lag) - 2 / math.pi, 1e-10)
               for lag in (1.0, 2.0, 4.0, 8.0)]
    # With the wall n1 + n2 is even, and the rates do not depend on the excitation.
    return result + _modes(_linear_wall(), [(1, 1), (0, 2)])


def _laplace_values(scale, squares):
    return lambda: [("E[y'^2]", None, squares[0] * scale**2, 1e-12), ("E[y'^4]", None, squares[1] * scale**4, 1e-12)]


def _inelastic_ball_values(restitution):
    def values():
        if restitution == 0.5:  # the density of the impact speeds is e^-u
            result = [("impact_rate", None, 2 / 3, 1e-12), ("E[y]", None, 1.5, 1e-12), ("E[y'^2]", None, 1.5, 1e-12),
                      ("E[y'^4]", None, 13.5, 1e-12)]
            return result + [("mean_return_time", speed, _laws.mean_return_time(speed), 1e-10)
                             for speed in (0.5, 1.0, 2.0)]
        ball, error = _laws.inelastic_ball(restitution), 3e-8
        return [("impact_rate", None, ball.impact_rate(), error),
                ("E[y]", None, ball.mean_height(), error * ball.mean_height()),
                ("E[y'^2]", None, ball.mean_height(), error * ball.mean_height()),
                ("E[y'^4]", None, ball.fourth_velocity_moment(), error * ball.fourth_velocity_moment())]
    return values


def _exit_values():
    result = [("mean_exit_time", x, _laws.random_acceleration_exit_time(x), 1e-10) for x in (0.5, 0.25)]
    return result + [("exit_probability_right", x, _laws.random_acceleration_exit_probability(x), 1e-10)
                     for x in (0.5, 0.25)]


def _mean_square_velocity(intensity, damping):
    """Power balance: E[v^2] = I / 2c for linear damping without losses at impacts, I = lambda E[Y^2] + 2D."""
    return lambda: [("E[y'^2]", None, intensity / (2 * damping), 1e-12)]


def _zero_mean(values=list):
    """E[y] = 0 for a symmetric problem."""
    return lambda: [("E[y]", None, 0.0, 1e-15), *values()]


def _duffing(stiffness, cubic):
    return lambda y: stiffness * y * y / 2 + cubic * y**4 / 4


def _softening(y):
    return np.log(np.cosh(y)) + 0.025 * y * y


def _gravity(y):
    return y


# Name: functions that return the exact densities, and exact values (quantity, at, value, error) besides their moments
_EXACT = {
    "duffing": (_boltzmann(_duffing(1, 0.5), 1.0, -6, 6), _zero_mean(_upcrossing_rate(_duffing(1, 0.5), 1.0, 6))),
    "bistable": (_boltzmann(_duffing(-1, 1), 0.25, -4, 4), _zero_mean(_upcrossing_rate(_duffing(-1, 1), 0.25, 4))),
    "tilted": (dict, _mean_square_velocity(0.1, 0.2)),
    "ring": (_radial(_laws.ring_energy_function(0.4), 3.6), _zero_mean()),
    "van_der_pol": (dict, _zero_mean()),
    "linear": (lambda: {v: _linear().density(v) for v in VARIABLES}, _linear_values),
    "ball_white": (_boltzmann(_gravity, 1.0, 0, 40), _wall_rate(_gravity, 1.0, 40)),
    "stops": (dict, _zero_mean()),
    "coulomb": (dict, _zero_mean()),
    "smoothed_coulomb": (dict, _zero_mean()),
    "quadratic_damping": (dict, _zero_mean()),
    "bilinear": (dict, _mean_square_velocity(0.2, 0.1)),
    "hertz": (dict, _mean_square_velocity(0.2, 0.1)),
    "relaxation": (dict, _zero_mean()),
    "rayleigh": (dict, _zero_mean()),
    "softening": (_boltzmann(_softening, 0.5, -18, 18), _zero_mean(_upcrossing_rate(_softening, 0.5, 18))),
    "multiplicative_duffing": (_boltzmann(_duffing(-1, 1), 0.25, -4, 4),
                               _zero_mean(_upcrossing_rate(_duffing(-1, 1), 0.25, 4))),
    "caughey_ma": (_radial(_laws.caughey_ma_energy_function, 7), lambda: [
        ("E[y]", None, 0, 1e-15), ("E[y^2]", None, 0.6, 1e-12), ("E[y^4]", None, 1.05, 1e-12),
        ("E[y'^2]", None, 0.6, 1e-12), ("E[y'^4]", None, 1.05, 1e-12)]),
    "dimentberg": (_radial(_laws.dimentberg_energy_function(0.1, 0.1, 1.0, 0.1), 5.5), _zero_mean()),
    "linear_wall_white": (_boltzmann(_duffing(1, 0), 1.0, 0, 9), _linear_wall_white_values),
    "linear_wall": (_linear_wall_densities, _linear_wall_values),
    "linear_overdamped": (lambda: {v: _overdamped().density(v) for v in VARIABLES},
                          _zero_mean(lambda: _linear_moments(_overdamped())[1:])),
    "box_laplace": (_box(lambda: _laws.laplace_box_density(0.5, 4)), _zero_mean(_laplace_values(0.5, (4, 72)))),
    "box_laplace_rare": (_box(lambda: _laws.laplace_box_density(0.5, 2)), _zero_mean(_laplace_values(0.5, (2, 24)))),
    "box_cubic": (_damping_box(lambda v: v**4 / 4, 0.1, 2.0), _zero_mean()),
    "box_friction": (_damping_box(lambda v: 0.2 * np.abs(v), 0.1, 20.0, [0]),
                     _zero_mean(lambda: [("E[y'^2]", None, 0.5, 1e-12), ("E[y'^4]", None, 1.5, 1e-12)])),
    "poisson_maxwell": (_boltzmann(_duffing(1, 0.5), 1.0, 0, 6), _wall_rate(_duffing(1, 0.5), 1.0, 6)),
    "inelastic_ball": (dict, _inelastic_ball_values(0.5)),
    "inelastic_ball_03": (dict, _inelastic_ball_values(0.3)),
    "inelastic_ball_07": (dict, _inelastic_ball_values(0.7)),
    "inelastic_ball_08": (dict, _inelastic_ball_values(0.8)),
    "random_acceleration_exit": (dict, _exit_values),
}


def _load_problems():
    with open(DATA / "problems.csv", newline="") as file:
        return {row["problem"]: Problem(row["problem"], row["title"], row["equation"], row["source"],
                                        *_EXACT.get(row["problem"], ()))
                for row in csv.DictReader(file)}


_PROBLEMS = _load_problems()


def problems() -> list[str]:
    """The names of all problems."""
    return list(_PROBLEMS)


def problem(name: str) -> Problem:
    """The problem of a name. Raises ValueError for an unknown name."""
    if name not in _PROBLEMS:
        raise ValueError(f"no problem '{name}'; the problems are {', '.join(_PROBLEMS)}")
    return _PROBLEMS[name]
