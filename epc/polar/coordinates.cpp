#include "epc/polar/coordinates.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <limits>
#include <utility>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {

namespace {

// Returns the stiffness K of the potential V(y) = U(y) + (K - k) y^2/2 in
// AmplitudePhaseCoordinates.
double coordinate_stiffness(const problem::Problem& problem) {
  // Smallest stiffness K of the potential V, relative to the stiffness of equivalent linearisation
  constexpr double kLeastStiffnessRatio = 0.1;
  return std::max(problem.system.stiffness(),
                  kLeastStiffnessRatio * problem::equivalent_linearisation(problem).stiffness);
}

numerics::Polynomial divide_by_power(const numerics::Polynomial& polynomial, std::size_t power,
                                     double factor, double constant) {
  numerics::Polynomial::Coefficients a{};
  for (std::size_t n = power; n < a.size(); ++n) {
    a[n - power] = factor * polynomial.coefficient(n);
  }
  a[0] = constant;
  return numerics::Polynomial(a);
}

}  // namespace

AmplitudePhaseCoordinates::AmplitudePhaseCoordinates(const problem::Problem& problem)
    : potential_ratio_(
          divide_by_power(problem.system.potential(), 2, 2, coordinate_stiffness(problem))),
      potential_slope_ratio_(
          divide_by_power(problem.system.restoring_force(), 1, 1, coordinate_stiffness(problem))),
      force_ratio_(
          divide_by_power(problem.system.restoring_force(), 1, 1, problem.system.stiffness())) {}

double AmplitudePhaseCoordinates::displacement_upper_bound(double w) const {
  // If one of the positive terms of 2 V(y), with the potential V, equals w^2 at a displacement y,
  // the sum 2 V(y) is at least w^2.
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n <= potential_ratio_.degree(); ++n) {
    if (!(potential_ratio_.coefficient(n) > 0)) continue;
    const double power = static_cast<double>(n) + 2;
    least = std::min(least, std::pow(w / std::sqrt(potential_ratio_.coefficient(n)), 2 / power));
  }
  return least;
}

double AmplitudePhaseCoordinates::displacement(double w) const {
  if (w == 0) return 0;
  const auto excess = [&](double y) {
    return std::pair{this->sqrt_twice_potential(y) - w, sqrt_twice_potential_slope(y)};
  };
  const double guess = displacement_upper_bound(w);
  double beyond = 2 * guess;
  while (this->sqrt_twice_potential(beyond) < w) beyond *= 2;
  constexpr int kDigits = std::numeric_limits<double>::digits - 2;
  std::uintmax_t iterations = 100;
  return boost::math::tools::newton_raphson_iterate(excess, guess, 0.0, beyond, kDigits,
                                                    iterations);
}

amplitude::CoordinateTimeDerivatives AmplitudePhaseCoordinates::coordinate_time_derivatives(
    const problem::System& system, double y, double rho, double theta) const {
  const double sine = std::sin(theta), cosine = std::cos(theta), damping = system.damping();
  const double slope = sqrt_twice_potential_slope(y), force = force_over_sqrt_twice_potential(y);
  return {-damping * rho * sine * sine + rho * cosine * (slope - force) * sine,
          -slope * sine * sine - force * cosine * cosine - damping * sine * cosine};
}

std::vector<double> AmplitudePhaseCoordinates::amplitude_break_points(
    const problem::ImpulseLaw& law, double rho_max) {
  std::vector<double> breaks;
  for (const auto& atom : law.amplitude_atoms()) {
    const double at = std::abs(atom.amplitude);
    if (at > 0 && at < rho_max) breaks.push_back(at);
  }
  std::ranges::sort(breaks);
  // Atoms of the impulse law at -a and at a give equal break points up to rounding.
  const auto near = [](double a, double b) { return b - a < 1e-9 * b; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), near), breaks.end());
  return breaks;
}

}  // namespace fpkcheck::epc::polar
