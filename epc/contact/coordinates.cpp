#include "epc/contact/coordinates.hpp"

#include <boost/math/tools/roots.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "epc/amplitude/half_circle.hpp"
#include "problem/features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::epc::contact {

using half_plane::QuadraturePoints;
using half_plane::QuadratureRule;

bool is_pressed_on_one_wall(const problem::Problem& problem) {
  const auto features = problem::features(problem);
  const auto& system = problem.system;
  return features.rests_in_contact && !features.two_walls &&
         problem::sign_changes_between_walls(system.restoring_force(), system).empty();
}

Coordinates::Coordinates(const problem::Problem& problem)
    : potential_(problem.system.restoring_force().antiderivative()),
      force_(problem.system.restoring_force()),
      atom_weight_(2 * std::log(1 / problem.system.restitution()) /
                   problem.impulses.arrival_rate()) {}

double Coordinates::displacement(double w) const {
  if (w == 0) return 0;
  const double energy = w * w / 2;
  double beyond = energy / force_(0.0);
  while (potential_(beyond) < energy) beyond *= 2;
  constexpr int kDigits = std::numeric_limits<double>::digits - 2;
  std::uintmax_t iterations = 100;
  return boost::math::tools::newton_raphson_iterate(
      [&](double y) {
        return std::pair{potential_(y) - energy, force_(y)};
      },
      std::min(beyond, energy / force_(0.0)), 0.0, beyond, kDigits, iterations);
}

QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                   const half_plane::QuadratureSize& size) {
  const QuadratureRule rho = half_plane::gauss_legendre_rule(size.s, 0, rho_max);
  const QuadratureRule theta =
      half_plane::gauss_legendre_rule(size.t, -std::numbers::pi / 2, std::numbers::pi / 2);
  QuadraturePoints points = QuadraturePoints::zeros(rho.nodes.size() * theta.nodes.size() + 1);
  Eigen::Index k = 0;
  for (Eigen::Index i = 0; i < rho.nodes.size(); ++i) {
    for (Eigen::Index j = 0; j < theta.nodes.size(); ++j, ++k) {
      const double w = rho.nodes[i] * std::cos(theta.nodes[j]);
      points.s[k] = rho.nodes[i];
      points.t[k] = rho.nodes[i] * std::sin(theta.nodes[j]);
      points.y[k] = coordinates.displacement(w);
      points.v[k] = points.t[k];
      points.energy[k] = amplitude::energy_of_amplitude(rho.nodes[i]);
      // dy dv = (w / g) dw dv = (w / g) rho drho dtheta
      points.weight[k] = rho.weight[i] * theta.weight[j] * rho.nodes[i] * w /
                         coordinates.restoring_force(points.y[k]) *
                         Coordinates::density_prefactor(rho.nodes[i]);
    }
  }
  points.weight[k] = coordinates.atom_weight();  // the last point is the corner
  return points;
}

}  // namespace fpkcheck::epc::contact
