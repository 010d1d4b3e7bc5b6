"""Exact stationary laws, mean times and spectra: formulas with their sources.

All quantities are non-dimensional. v is the velocity y'.
"""

import functools
import math

import numpy as np

from ._quadrature import CubicSpline, integral, panel_rule

erf = np.vectorize(math.erf, otypes=[float])


class ExactDensity:
    """A one-dimensional probability density on an interval.

    Calls return the density at points, and 0 outside the interval. The probability beyond the ends of the interval is
    negligible (below 1e-12), unless the ends are walls.
    """

    def __init__(self, function, lower, upper, kinks=(), panels=200):
        """function: positive, vectorised, not necessarily normalised; kinks: points without a continuous derivative."""
        self.lower, self.upper = float(lower), float(upper)
        inner = [x for x in kinks if lower < x < upper]
        self.edges = np.unique(np.concatenate([np.linspace(lower, upper, panels + 1), inner]))
        self._function = function
        self._factor = 1 / integral(function, self.edges)

    def __call__(self, x):
        x = np.asarray(x, dtype=float)
        inside = (x >= self.lower) & (x <= self.upper)
        return np.where(inside, self._factor * self._function(np.where(inside, x, self.edges[0])), 0.0)

    def moment(self, order):
        """The integral of x**order times the density."""
        return integral(lambda x: x**order * self(x), self.edges)

    def averages(self, edges):
        """The averages over the bins between edges, shape (len(edges) - 1,)."""
        edges = np.asarray(edges, dtype=float)
        # Panels end at the edges of the bins, at kinks and at the ends of the support.
        panels = np.unique(np.concatenate([edges, self.edges[(self.edges > edges[0]) & (self.edges < edges[-1])]]))
        nodes, weights = panel_rule(panels)
        of_bin = np.searchsorted(edges, (panels[1:] + panels[:-1]) / 2) - 1
        return np.bincount(of_bin, np.sum(weights * self(nodes), axis=1), len(edges) - 1) / np.diff(edges)


def normal_density(variance):
    """The normal density of mean 0."""
    end = 9 * math.sqrt(variance)
    return ExactDensity(lambda x: np.exp(-x * x / (2 * variance)), -end, end)


def boltzmann_density(potential, temperature, lower, upper):
    """p(y) ~ exp(-U(y) / T) between the walls or far ends `lower` and `upper`.

    With linear damping c v and white noise of intensity 2D, T = D/c, elastic walls or none:
    p(y, v) ~ exp(-(v^2/2 + U(y)) / T) (Kramers 1940; Caughey 1963).
    """
    samples = np.linspace(lower, upper, 2001)
    minimum = np.min(potential(samples))
    return ExactDensity(lambda y: np.exp(-(potential(y) - minimum) / temperature), lower, upper)


def uniform_density(lower, upper):
    """The uniform density between two walls."""
    return ExactDensity(np.ones_like, lower, upper, panels=8)


def radial_density(function_of_energy, end):
    """The marginal density p(y) = p(v) of p(y, v) = C f(H), H = (y^2 + v^2) / 2, with f negligible at |y| = end."""
    nodes, weights = panel_rule(np.linspace(0, end, 61))
    nodes, weights = nodes.ravel(), weights.ravel()

    def marginal(y):
        return 2 * np.sum(weights * function_of_energy((np.asarray(y)[..., None] ** 2 + nodes**2) / 2), axis=-1)

    return ExactDensity(marginal, -end, end)


def ring_energy_function(noise_intensity):
    """f of p = C f(H) for y'' + (y^2 + y'^2 - 1) y' + y = sqrt(2D) W: exp((H - H^2) / D) (Caughey).

    noise_intensity: 2D.
    """
    diffusion = noise_intensity / 2
    return lambda energy: np.exp((energy - energy**2 - 0.25) / diffusion)


def dimentberg_energy_function(a, b, eta_diffusion, zeta_diffusion):
    """f of p = C f(H) for an oscillator with noise in damping and stiffness (Dimentberg 1982).

    y'' + 2a y' (1 + eta) + b y' (y^2 + y'^2) + y (1 + xi) = zeta, in the sense of Stratonovich, with independent white
    noises of the intensities 2 D_eta, 2 D_xi, 2 D_zeta and D_xi = 4 a^2 D_eta. With s = 8 a^2 D_eta,
    A = 2a + 4 a^2 D_eta and B = 2b: f(H) = (D_zeta + s H)^(-A/s + B D_zeta / s^2) exp(-B H / s).
    """
    s = 8 * a * a * eta_diffusion
    first, second = 2 * a + s / 2, 2 * b
    power = -first / s + second * zeta_diffusion / s**2
    return lambda energy: (zeta_diffusion + s * energy) ** power * np.exp(-second * energy / s)


def caughey_ma_energy_function(energy):
    """f of p = C f(H) for damping 2 zeta (1 + H) v and noise sqrt(2D (1 + H/2)) W in the sense of Ito, D = 2 zeta.

    Stationarity of the probability flux in v: (1 + H) f + d/dH((1 + H/2) f) = 0, hence f = (1 + H/2) exp(-2H).
    """
    return (1 + energy / 2) * np.exp(-2 * energy)


def laplace_box_density(scale, rate_over_damping):
    """p(v) in an elastic box without spring under impulses with a Laplace law of the scale b and damping c v.

    The characteristic function is (1 + b^2 u^2)^(-lambda / 2c). Densities for lambda = 2c and lambda = 4c.
    """
    end = 40 * scale
    if rate_over_damping == 2:
        return ExactDensity(lambda v: np.exp(-np.abs(v) / scale), -end, end, kinks=[0])
    if rate_over_damping == 4:
        return ExactDensity(lambda v: (1 + np.abs(v) / scale) * np.exp(-np.abs(v) / scale), -end, end, kinks=[0])
    raise ValueError(f"rate_over_damping = {rate_over_damping}: no closed form; use 2 or 4")


def poisson_maxwell_damping(v, rate, deviation, inverse_temperature):
    """The damping R(v) for which p = C exp(-k (v^2/2 + U)) under normal impulses of mean 0 (after Vasta 1995).

    R(v) = lambda sqrt(pi / 2k) e^(k v^2 / 2) (erf(v sqrt(k/2)) - erf(v sqrt(k/2) / sqrt(1 + k s^2))) with the inverse
    temperature k and the deviation s of the impulses, for any spring and elastic walls.
    """
    k = inverse_temperature
    argument = np.asarray(v) * math.sqrt(k / 2)
    difference = erf(argument) - erf(argument / math.sqrt(1 + k * deviation**2))
    return rate * math.sqrt(math.pi / (2 * k)) * np.exp(argument**2) * difference


class LinearOscillator:
    """y'' + c y' + k y under normal impulses and white noise of intensity 2D, without walls (Campbell's theorem).

    The characteristic function of a y + b y' is exp(int_0^inf (lambda (M(u g(t)) - 1) - D u^2 g(t)^2) dt) with the
    impulse response h, g = a h + b h', and the characteristic function M of the impulses.
    """

    def __init__(self, damping, stiffness, rate, intensity, mean=0.0, noise_intensity=0.0):
        """intensity: lambda E[Y^2]; mean: E[Y]; noise_intensity: 2D."""
        self.damping, self.stiffness = damping, stiffness
        self.rate, self.mean, self.variance = rate, mean, intensity / rate - mean**2
        self.noise_intensity = noise_intensity
        root = np.sqrt(complex(damping**2 - 4 * stiffness))
        self.decay_rates = (damping - root) / 2, (damping + root) / 2
        slowest = min(x.real for x in self.decay_rates)
        fastest = max(abs(x) for x in self.decay_rates)
        end = 40 / slowest
        nodes, weights = panel_rule(np.linspace(0, end, int(end * fastest / 1.5) + 2))
        self._times, self._weights = nodes.ravel(), weights.ravel()

    def impulse_response(self, time):
        """h(t) and h'(t); needs c^2 != 4k."""
        first, second = self.decay_rates
        difference = second - first
        h = (np.exp(-first * time) - np.exp(-second * time)) / difference
        slope = (second * np.exp(-second * time) - first * np.exp(-first * time)) / difference
        return h.real, slope.real

    def impulse_moment(self, order):
        """E[Y^n] of the normal amplitude, n <= 4."""
        m, s2 = self.mean, self.variance
        return (1, m, m**2 + s2, m**3 + 3 * m * s2, m**4 + 6 * m**2 * s2 + 3 * s2**2)[order]

    def cumulant(self, variable, order):
        """The cumulant lambda E[Y^n] int h^n dt of y, or of y' with h', plus 2D int h^2 dt for n = 2."""
        g = self.impulse_response(self._times)[variable == "ydot"]
        noise = self.noise_intensity if order == 2 else 0
        return (self.rate * self.impulse_moment(order) + noise) * float(np.sum(self._weights * g**order))

    def moment(self, variable, order):
        """E[y^n] or E[y'^n] for n = 1, 2, 4."""
        k1, k2, k3, k4 = (self.cumulant(variable, n) for n in (1, 2, 3, 4))
        if order == 4:
            return k4 + 4 * k3 * k1 + 3 * k2**2 + 6 * k2 * k1**2 + k1**4
        return {1: k1, 2: k2 + k1**2}[order]

    def characteristic_function(self, variable, u):
        """E[exp(i u y)] or E[exp(i u y')] at the points u, shape (n,)."""
        g = self.impulse_response(self._times)[variable == "ydot"]
        result = np.empty(len(u), dtype=complex)
        for i, x in enumerate(u):
            a = x * g
            jumps = np.exp(1j * self.mean * a - self.variance * a * a / 2) - 1
            exponent = np.sum(self._weights * (self.rate * jumps - self.noise_intensity / 2 * a * a))
            result[i] = np.exp(exponent)
        return result

    def density(self, variable):
        """p(y) or p(y') by Fourier inversion with the trapezoidal rule."""
        mean, deviation = self.cumulant(variable, 1), math.sqrt(self.cumulant(variable, 2))
        # The moments of order 4 beyond 20 deviations are below 1e-10 for the problems of this package (tests).
        end, step = 20 * deviation, math.pi / (22 * deviation)
        values, block = [], 256
        while not values or np.max(np.abs(values[-1][-8:])) > 1e-14:
            start = len(values) * block
            values.append(self.characteristic_function(variable, step * np.arange(start, start + block)))
        phi = np.concatenate(values)
        u = step * np.arange(len(phi))
        phi[0] /= 2

        def density(x):
            x = np.asarray(x, dtype=float)
            blocks = np.array_split(x.ravel(), 1 + x.size // 1000)  # for a matrix of moderate size
            sums = [(np.exp(-1j * block[:, None] * u) @ phi).real for block in blocks]
            return step / math.pi * np.concatenate(sums).reshape(x.shape)

        return ExactDensity(density, mean - end, mean + end)

    def spectral_density(self, frequency):
        """One-sided spectral density of y: (2D + lambda E[Y^2]) / (pi ((k - w^2)^2 + c^2 w^2))."""
        total = self.noise_intensity + self.rate * self.impulse_moment(2)
        c, k, w = self.damping, self.stiffness, frequency
        return total / (math.pi * ((k - w * w) ** 2 + (c * w) ** 2))

    def eigenvalue(self, first, second):
        """The eigenvalue -(n1 l1 + n2 l2) of the generator, complex.

        With an elastic wall at 0 and a symmetric law n1 + n2 is even.
        """
        l1, l2 = self.decay_rates
        return -(first * l1 + second * l2)


def elastic_wall_autocovariance(damping, stiffness, variance, lag):
    """E[y(0) y(t)] of a linear oscillator with an elastic wall at y = 0 under white noise.

    (2 s^2 / pi) (sqrt(1 - q^2) + q arcsin q) with the correlation q of the oscillator without a wall and its variance
    s^2 = D / (c k). The formula is that of E|X X'| of two normal variables with the correlation q.
    """
    w = math.sqrt(stiffness - damping**2 / 4)
    q = math.exp(-damping * lag / 2) * (math.cos(w * lag) + damping / (2 * w) * math.sin(w * lag))
    return 2 * variance / math.pi * (math.sqrt(max(0.0, 1 - q * q)) + q * math.asin(max(-1.0, min(1.0, q))))


@functools.lru_cache(maxsize=None)
def _erf_table():
    """A spline of erf on (0, 6) with an error below 1e-13."""
    x = np.linspace(0, 6, 6001)
    return CubicSpline(x, erf(x))


def return_speed_kernel(a, b):
    """McKean's density K(a, b) of the speed a at the first return to 0 from the speed b (McKean 1963).

    The particle falls with g = 1 under white noise of intensity 2D = 1:
    K(a, b) = int_0^inf sqrt(3) a / (pi t^2) exp(-2 (a^2 - a b + b^2) / t + a + b - t/2) erf(sqrt(6 a b / t)) dt.
    a is a positive number or an array, b a positive number. The trapezoidal rule in log t has an error below 1e-12.
    """
    a = np.asarray(a, dtype=float)[..., None]
    square, linear = 2 * (a * a - a * b + b * b), a + b
    # The exponent is below -45 outside half of this range of t.
    half = 45 + linear
    root = np.sqrt(np.maximum(half * half - 2 * square, 0))
    start, end = np.log(square / (2 * (half + root))), np.log(2 * (half + root))
    count = int(np.max(end - start) / 0.12) + 1
    step = (end - start) / count
    t = np.exp(start + step * np.arange(count + 1))
    terms = np.exp(linear - square / t - t / 2) * _erf_table()(np.minimum(np.sqrt(6 * a * b / t), 6)) / t
    return math.sqrt(3) / math.pi * np.sum(a * step * terms, axis=-1)


class InelasticBall:
    """An undamped ball under gravity g and white noise 2D on an inelastic floor, in units with g = 2D = 1.

    The density q of the impact speeds solves q(a) = int K(a, r u) q(u) du (Burkhardt and Kotsev 2006); q = e^-u for
    r = 1/2. The balances of v, y v and v^n give the impact rate and the moments. The trapezoidal rule in log u has an
    error of about 1e-8 for 0.3 <= r <= 0.8.
    """

    def __init__(self, restitution):
        self.restitution = r = restitution
        # q u decays as u^(2 - beta) at u = 0, at least as u^0.3 for r >= 0.3.
        beta = wall_exponent(r)
        step = 0.12
        u = np.exp(np.arange(math.log(1e-9) / (2 - beta), math.log(-math.log(1e-9) * 2 / (1 - r)), step))
        chain = np.array([u * return_speed_kernel(u, r * b) for b in u]).T
        chain /= chain.sum(axis=0)
        n = len(u)
        self._speeds = u
        self._masses = np.linalg.solve(np.eye(n) - chain + 1 / n, np.full(n, 1 / n))

    def speed_moment(self, order):
        """E[u^n] of the impact speeds u."""
        return float(np.sum(self._masses * self._speeds**order))

    def impact_rate(self):
        """Impacts per unit time, 1 / ((1 + r) E[u])."""
        return 1 / ((1 + self.restitution) * self.speed_moment(1))

    def mean_height(self):
        """E[y] = E[v^2] = nu (1 + r^3) E[u^3] / 3."""
        return self.impact_rate() * (1 + self.restitution**3) * self.speed_moment(3) / 3

    def fourth_velocity_moment(self):
        """E[v^4] from the balances of v^4 and v^5."""
        r, rate = self.restitution, self.impact_rate()
        third = (6 * self.mean_height() - rate * (1 - r**4) * self.speed_moment(4)) / 4
        return (10 * third + rate * (1 + r**5) * self.speed_moment(5)) / 5


inelastic_ball = functools.lru_cache(maxsize=None)(InelasticBall)


def wall_exponent(restitution):
    """The exponent beta of p(0, -u) ~ u^-beta at an inelastic wall under white noise.

    r^(beta - 2) = 2 sin((2 beta + 1) pi / 6) (Cornell, Swift and Bray 1998; Burkhardt 2000). The root beta = 2 exists
    for every r and is spurious; the other root is the only change of sign below the maximum.
    """
    def excess(beta):
        return (2 - beta) * math.log(restitution) + math.log(2 * math.sin((2 * beta + 1) * math.pi / 6))

    below, above = 0.0, 3 / math.pi * math.atan2(math.pi / 3, math.log(restitution)) - 0.5
    for _ in range(60):
        middle = (below + above) / 2
        below, above = (middle, above) if excess(middle) < 0 else (below, middle)
    return (below + above) / 2


def mean_return_time(speed):
    """Mean time of the first return to 0 of the ball of InelasticBall from the speed v0: v0 + int a K(a, v0) da."""
    a = np.exp(np.arange(math.log(1e-6), math.log(60 + 4 * speed), 0.06))
    return speed + 0.06 * float(np.sum(a * a * return_speed_kernel(a, speed)))


def random_acceleration_exit_time(position):
    """Mean time in which x'' = xi with 2D = 1 leaves (0, 1) from rest at X (Masoliver and Porra 1995).

    D^(-1/3) (4/3)^(1/6) / Gamma(7/3) (X (1 - X))^(1/6) (F(X) + F(1 - X)) with F(X) = 2F1(1, -1/3; 7/6; X).
    """
    def series(x):
        total, term, n = 0.0, 1.0, 0
        while abs(term) > 1e-17:
            total += term
            term *= (n - 1 / 3) / (n + 7 / 6) * x
            n += 1
        return total

    product = position * (1 - position)
    factor = 2 ** (1 / 3) * (4 / 3) ** (1 / 6) / math.gamma(7 / 3)
    return factor * product ** (1 / 6) * (series(position) + series(1 - position))


def random_acceleration_exit_probability(position):
    """Probability that x'' = xi leaves (0, 1) at 1 from rest at X: I_X(1/6, 1/6) (Bicout and Burkhardt 2000)."""
    def incomplete_beta(x):
        # int_0^x t^(-5/6) (1 - t)^(-5/6) dt with t = s^6: 6 int_0^(x^(1/6)) (1 - s^6)^(-5/6) ds, x <= 1/2
        return 6 * integral(lambda s: (1 - s**6) ** (-5 / 6), np.linspace(0, x ** (1 / 6), 21))

    total = 2 * incomplete_beta(0.5)
    if position <= 0.5:
        return incomplete_beta(position) / total
    return 1 - incomplete_beta(1 - position) / total
