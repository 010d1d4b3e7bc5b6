#include "epc/polar/coordinates.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "epc/amplitude/half_circle.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {

using half_plane::QuadraturePoints;
using half_plane::QuadratureRule;

namespace {

// Stiffness K of Coordinates.
double coordinate_stiffness(const problem::Problem& problem) {
  constexpr double kLeastStiffnessRatio = 0.1;  // lower limit, relative to the linearised stiffness
  return std::max(problem.system.stiffness(),
                  kLeastStiffnessRatio * problem::equivalent_linearisation(problem).stiffness);
}

// The polynomial factor * polynomial / y^power, whose constant term is replaced by `constant`.
numerics::Polynomial divide_by_power(const numerics::Polynomial& polynomial, std::size_t power,
                                     double factor, double constant) {
  numerics::Polynomial::Coefficients a{};
  for (std::size_t n = power; n < a.size(); ++n) {
    a[n - power] = factor * polynomial.coefficient(n);
  }
  a[0] = constant;
  return numerics::Polynomial(a);
}

// Gauss-Legendre rule on [0, end] with one panel between successive breaks. The number of points of
// a panel is proportional to the width of the panel, plus a constant.
QuadratureRule legendre_panels(double end, const std::vector<double>& breaks, int points) {
  if (breaks.empty()) return half_plane::gauss_legendre_rule(points, 0, end);
  QuadratureRule all;
  double from = 0;
  const auto add = [&](double to) {
    const int composite_gauss_points = static_cast<int>(points * (0.2 + (to - from) / end)) + 2;
    const QuadratureRule panel = half_plane::gauss_legendre_rule(composite_gauss_points, from, to);
    const Eigen::Index before = all.nodes.size();
    for (auto [whole, part] : {std::pair{&all.nodes, &panel.nodes}, {&all.weight, &panel.weight}}) {
      whole->conservativeResize(before + composite_gauss_points);
      whole->tail(composite_gauss_points) = *part;
    }
    from = to;
  };
  for (const double at : breaks) add(at);
  add(end);
  return all;
}

}  // namespace

Coordinates::Coordinates(const problem::Problem& problem)
    : potential_ratio_(
          divide_by_power(problem.system.potential(), 2, 2, coordinate_stiffness(problem))),
      potential_slope_ratio_(
          divide_by_power(problem.system.restoring_force(), 1, 1, coordinate_stiffness(problem))),
      force_ratio_(
          divide_by_power(problem.system.restoring_force(), 1, 1, problem.system.stiffness())) {}

double Coordinates::displacement_bound(double w) const {
  // If one positive term of 2 V(y) equals w^2 at a displacement y, then 2 V(y) is at least w^2.
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n <= potential_ratio_.degree(); ++n) {
    if (!(potential_ratio_.coefficient(n) > 0)) continue;
    const double power = static_cast<double>(n) + 2;
    least = std::min(least, std::pow(w / std::sqrt(potential_ratio_.coefficient(n)), 2 / power));
  }
  return least;
}

double Coordinates::displacement(double w) const {
  if (w == 0) return 0;
  const auto excess = [&](double y) {
    return std::pair{this->potential_speed(y) - w, potential_speed_slope(y)};
  };
  const double guess = displacement_bound(w);
  double beyond = 2 * guess;
  while (this->potential_speed(beyond) < w) beyond *= 2;
  constexpr int kDigits = std::numeric_limits<double>::digits - 2;
  std::uintmax_t iterations = 100;
  return boost::math::tools::newton_raphson_iterate(excess, guess, 0.0, beyond, kDigits,
                                                    iterations);
}

QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                   const std::vector<double>& breaks,
                                   const half_plane::QuadratureSize& size) {
  const QuadratureRule rho = legendre_panels(rho_max, breaks, size.s);
  const QuadratureRule theta =
      half_plane::gauss_legendre_rule(size.t, -std::numbers::pi / 2, std::numbers::pi / 2);
  QuadraturePoints points = QuadraturePoints::zeros(rho.nodes.size() * theta.nodes.size());
  Eigen::Index k = 0;
  for (Eigen::Index i = 0; i < rho.nodes.size(); ++i) {
    for (Eigen::Index j = 0; j < theta.nodes.size(); ++j, ++k) {
      points.s[k] = rho.nodes[i];
      points.t[k] = theta.nodes[j];
      points.y[k] = coordinates.displacement(rho.nodes[i] * std::cos(theta.nodes[j]));
      points.v[k] = rho.nodes[i] * std::sin(theta.nodes[j]);
      points.energy[k] = amplitude::energy_of_amplitude(rho.nodes[i]);
      // dy dv = dw dv / w'(y) = rho drho dtheta / w'(y)
      points.weight[k] = rho.weight[i] * theta.weight[j] * rho.nodes[i] /
                         coordinates.potential_speed_slope(points.y[k]);
    }
  }
  return points;
}

}  // namespace fpkcheck::epc::polar
