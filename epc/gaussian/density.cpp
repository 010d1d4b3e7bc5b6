#include "epc/gaussian/density.hpp"

#include <algorithm>
#include <cmath>

#include "transform/zhuravlev.hpp"

namespace fpkcheck::epc::gaussian {

double log_normalising_constant(const DensitySupport& support) {
  return -support.peak_exponent() - std::log(support.integral_relative_to_peak());
}

transform::SmoothDensity density_from_exponent(const Polynomial& q, const DensitySupport& support,
                                               double log_constant) {
  const auto plane = [q, support, log_constant](double x1, double x2) {
    return support.contains(x1, x2) ? std::exp(q(x1, x2) + log_constant) : 0;
  };
  const bool even =
      std::ranges::all_of(q.terms(), [](const Term& t) { return (t.x1 + t.x2) % 2 == 0; });
  if (even) {  // the density has the same value at both points (z, z') of paper (5)
    return {[plane](double y, double v) { return 2 * plane(y, v); }, support.x1_max(),
            support.x2_max()};
  }
  return transform::physical_density(
      {.value = plane, .x1_max = support.x1_max(), .x2_max = support.x2_max()});
}

transform::SmoothDensity unfolded_density_from_exponent(const Polynomial& q,
                                                        const DensitySupport& support,
                                                        double log_constant) {
  return {.value =
              [q, support, log_constant](double y, double v) {
                return support.contains(y, v) ? std::exp(q(y, v) + log_constant) : 0;
              },
          .y_max = support.x1_max(),
          .v_max = support.x2_max(),
          .y_min = -support.x1_max()};
}

}  // namespace fpkcheck::epc::gaussian
