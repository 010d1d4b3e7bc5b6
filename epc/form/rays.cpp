#include "epc/form/rays.hpp"

#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

namespace fpkcheck::epc {

const std::vector<Direction>& scan_directions() {
  constexpr int kDirections = 1440;
  static const std::vector<Direction> table = [] {
    std::vector<Direction> all;
    for (int k = 0; k < kDirections; ++k) {
      const double half_turns = 2.0 * k / kDirections;
      all.push_back({boost::math::cos_pi(half_turns), boost::math::sin_pi(half_turns)});
    }
    return all;
  }();
  return table;
}

std::size_t distinct_direction_count(const Polynomial& q) {
  const bool even = std::ranges::all_of(
      q.terms(), [](const Term& term) { return (term.x1 + term.x2) % 2 == 0 || term.a == 0; });
  return even ? scan_directions().size() / 2 : scan_directions().size();
}

RayCoefficients restrict_to_ray(const Polynomial& q, const StandardDeviations& sigma,
                                const Direction& direction) {
  RayCoefficients coefficients =
      q.restriction_to_ray(sigma.x1 * direction.x1, sigma.x2 * direction.x2);
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  return coefficients;
}

}  // namespace fpkcheck::epc
