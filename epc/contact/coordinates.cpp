#include "epc/contact/coordinates.hpp"

#include <boost/math/tools/roots.hpp>
#include <cassert>
#include <limits>
#include <utility>

#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::epc::contact {

bool spring_presses_on_single_wall(const problem::Problem& problem) {
  const auto features = problem::problem_features(problem);
  const auto& system = problem.system;
  return features.rests_in_contact && !features.two_walls &&
         problem::polynomial_sign_changes_between_walls(system.restoring_force(), system).empty();
}

AmplitudeVelocityCoordinates::AmplitudeVelocityCoordinates(const problem::Problem& problem)
    : potential_(problem.system.restoring_force().antiderivative()),
      force_(problem.system.restoring_force()),
      restitution_(problem.system.restitution()),
      atom_weight_(2 * std::log(1 / problem.system.restitution()) /
                   problem.impulses.arrival_rate()) {
  assert(spring_presses_on_single_wall(problem));
}

double AmplitudeVelocityCoordinates::displacement(double w) const {
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

amplitude::CoordinateTimeDerivatives AmplitudeVelocityCoordinates::coordinate_time_derivatives(
    const problem::System& system, double y, double rho, double v) const {
  const double damping =
      (system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v) * v;
  return {-v * damping / rho, -(damping + force_(y))};
}

}  // namespace fpkcheck::epc::contact
