#include "workflows/paper/linearisation_distance.hpp"

#include <cmath>
#include <numbers>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::paper {

double l1_to_linearisation(const results::Curve& curve, const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  const bool is_y = curve.variable == transform::Variable::y;
  const double sigma = is_y ? linear.displacement_deviation : linear.velocity_deviation;
  // The probability of an interval of y or y', from the density of z or z': both z and -z map to y.
  const auto probability = [&](double from, double to) {
    const double scale = 1 / (std::numbers::sqrt2 * sigma);
    return (is_y ? 1.0 : 0.5) * (std::erf(to * scale) - std::erf(from * scale));
  };
  const auto widths = results::bin_widths(curve);
  double l1 = 0;
  for (std::size_t k = 0; k < curve.abscissa.size(); ++k) {
    const double from = curve.abscissa[k] - widths[k] / 2, to = curve.abscissa[k] + widths[k] / 2;
    l1 += std::abs(curve.density[k] * widths[k] - probability(from, to));
  }
  return l1;
}

}  // namespace fpkcheck::paper
