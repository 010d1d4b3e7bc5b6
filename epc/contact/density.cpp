#include "epc/contact/density.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::contact {
namespace {

// Cell edges from 0 to `end`. The first cell has the width first * end. The next cells have widths
// proportional to the distance from 0, and the last cells have equal widths.
std::vector<double> edges_graded_to_zero(double end, double first, double growth) {
  constexpr int kEven = 120;
  std::vector<double> edges{0};
  for (double at = first * end; at < end; at += std::min((growth - 1) * at, end / kEven)) {
    edges.push_back(at);
  }
  if (end - edges.back() < end / (2 * kEven)) edges.pop_back();
  edges.push_back(end);
  return edges;
}

std::vector<double> with_mirror_image(const std::vector<double>& edges) {
  std::vector<double> all;
  for (auto at = edges.rbegin(); at + 1 != edges.rend(); ++at) all.push_back(-*at);
  all.insert(all.end(), edges.begin(), edges.end());
  return all;
}

}  // namespace

transform::SmoothDensity density_from_exponent(const Polynomial& q, const Coordinates& coordinates,
                                               double support,
                                               const half_plane::Confinement& confinement,
                                               double log_constant) {
  const double largest = amplitude::amplitude_of_energy(support);
  return {.value =
              [q, coordinates, largest, confinement, log_constant](double y, double v) {
                if (y < 0) return 0.0;
                const double rho = coordinates.amplitude_of(y, v);
                if (rho > largest) return 0.0;
                return Coordinates::density_prefactor(rho) *
                       std::exp(q(rho, v) + confinement(amplitude::energy_of_amplitude(rho)) +
                                log_constant);
              },
          .y_max = coordinates.displacement(largest),
          .v_max = largest};
}

transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density) {
  // Near the corner y is of the order of v^2: the first cell in y has the relative width kFirst^2.
  // The probability in the first cells is of the order of kFirst.
  constexpr double kFirst = 1e-6, kGrowth = 1.3;
  return transform::average_over_cells(
      density, edges_graded_to_zero(density.y_max, kFirst * kFirst, kGrowth * kGrowth),
      with_mirror_image(edges_graded_to_zero(density.v_max, kFirst, kGrowth)));
}

}  // namespace fpkcheck::epc::contact
