#include "dual/bounds/functional_enclosure.hpp"

#include <cmath>

#include "dual/backward/impulse_table.hpp"
#include "dual/spline/bezier.hpp"

namespace fpkcheck::dual {
namespace {

Coefficients bin_on(const SmoothBin& bin, const Interval& from, const Interval& to, int degree) {
  const double middle = (from.lower() + to.upper()) / 2;
  Coefficients b(degree + 1, Interval(0));
  const SplineBasis basis({bin.knots.begin(), bin.knots.end()}, 3);
  double overhang = 0, slope = 0, shortest = HUGE_VAL;
  for (int i = 0; i < 4; ++i) shortest = std::min(shortest, bin.knots[i + 1] - bin.knots[i]);
  if (middle <= bin.knots.front()) {
    overhang = (to - bin.knots.front()).upper();
  } else if (middle >= bin.knots.back()) {
    overhang = (bin.knots.back() - from).upper();
  } else {
    const int span = basis.span_of(middle);
    const auto rows = bezier_rows<Interval>(basis, span, from, to);
    const Coefficients bin_function(rows.row(3 - span).begin(), rows.row(3 - span).end());
    b = elevated(bin_function, degree);
    overhang = std::max((bin.knots[span] - from).upper(), (to - bin.knots[span + 1]).upper());
    for (const Interval& d : derivative(bin_function)) slope = std::max(slope, magnitude(d));
    slope = (slope / Interval((to - from).lower())).upper();
  }
  if (overhang > 0) {  // as in functions_on: |f'| <= 3 / shortest knot interval
    const double error = (overhang * (slope + 3.1 / Interval(shortest))).upper();
    for (Interval& c : b) c += plus_minus(error);
  }
  return b;
}

}  // namespace

Coefficients integrand_on(const Functional& functional, const problem::Problem& problem,
                          const Interval& from, const Interval& to, int degree) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    return bin_on(*bin, from, to, degree);
  }
  std::vector<double> powers;
  if (const PowerMean* const mean = std::get_if<PowerMean>(&functional)) {
    powers.assign(mean->power + 1, 0.0);
    powers.back() = 1;
  } else {
    const problem::SystemCoefficients& c = problem.system.coefficients();
    powers = {0.0, c.stiffness, 0.0, c.cubic};
  }
  return elevated(on_segment(powers, Interval(0), from, to), degree);
}

Interval largest_integrand(const Functional& functional, const Interval& y, const Interval& v,
                           const Interval& force) {
  if (std::holds_alternative<SmoothBin>(functional)) return 1;
  if (const PowerMean* const mean = std::get_if<PowerMean>(&functional)) {
    return power(mean->axis == Axis::displacement ? y : v, mean->power);
  }
  return force;
}

Enclosure functional_value(const Functional& functional, const problem::Problem& problem,
                           const Enclosure& mean) {
  Interval value = interval(mean);
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    value *= 4.0 / (Interval(bin->knots.back()) - bin->knots.front());
  } else if (std::holds_alternative<ImpactMomentum>(functional)) {
    const Interval rate = problem.impulses.arrival_rate();
    value = (value - rate * moment_enclosure(problem.impulses.law(), 1)) /
            (1.0 + Interval(problem.system.restitution()));
  }
  return enclosure(value);
}

}  // namespace fpkcheck::dual
