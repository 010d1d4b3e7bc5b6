#include "backward/bounds/functional_enclosure.hpp"

#include <cmath>

#include "backward/generator/impulse_table.hpp"
#include "numerics/splines/bezier_extraction.hpp"

namespace fpkcheck::backward {
namespace {

numerics::BernsteinCoefficients bin_enclosure(const SmoothBin& bin, const numerics::Interval& from,
                                              const numerics::Interval& to, int degree) {
  const double middle = (from.lower() + to.upper()) / 2;
  numerics::BernsteinCoefficients b(degree + 1, numerics::Interval(0));
  const numerics::SplineBasis basis({bin.knots.begin(), bin.knots.end()}, 3);
  double overhang = 0, slope = 0, shortest = HUGE_VAL;
  for (int i = 0; i < 4; ++i) shortest = std::min(shortest, bin.knots[i + 1] - bin.knots[i]);
  if (middle <= bin.knots.front()) {
    overhang = (to - bin.knots.front()).upper();
  } else if (middle >= bin.knots.back()) {
    overhang = (bin.knots.back() - from).upper();
  } else {
    const int span = basis.span_containing(middle);
    const auto rows = numerics::bezier_extraction<numerics::Interval>(basis, span, from, to);
    const numerics::BernsteinCoefficients bin_function(rows.row(3 - span).begin(),
                                                       rows.row(3 - span).end());
    b = elevate_degree(bin_function, degree);
    overhang = std::max((bin.knots[span] - from).upper(), (to - bin.knots[span + 1]).upper());
    for (const numerics::Interval& d : bernstein_derivative(bin_function))
      slope = std::max(slope, magnitude(d));
    slope = (slope / numerics::Interval((to - from).lower())).upper();
  }
  if (overhang > 0) {  // bound of basis_functions_on_piece(): |f'| <= 3 / shortest knot interval
    const double error = (overhang * (slope + 3.1 / numerics::Interval(shortest))).upper();
    for (numerics::Interval& c : b) c += numerics::symmetric_interval(error);
  }
  return b;
}

}  // namespace

numerics::BernsteinCoefficients integrand_enclosure(const Functional& functional,
                                                    const problem::Problem& problem,
                                                    const numerics::Interval& from,
                                                    const numerics::Interval& to, int degree) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    return bin_enclosure(*bin, from, to, degree);
  }
  std::vector<double> powers;
  if (const PowerMoment* const mean = std::get_if<PowerMoment>(&functional)) {
    powers.assign(mean->power + 1, 0.0);
    powers.back() = 1;
  } else {
    const problem::SystemCoefficients& c = problem.system.coefficients();
    powers = {0.0, c.stiffness, 0.0, c.cubic};
  }
  return elevate_degree(bernstein_on_segment(powers, numerics::Interval(0), from, to), degree);
}

numerics::Interval integrand_magnitude_bound(const Functional& functional,
                                             const numerics::Interval& y,
                                             const numerics::Interval& v,
                                             const numerics::Interval& force) {
  if (std::holds_alternative<SmoothBin>(functional)) return 1;
  if (const PowerMoment* const mean = std::get_if<PowerMoment>(&functional)) {
    return power(mean->axis == Axis::displacement ? y : v, mean->power);
  }
  return force;
}

numerics::Enclosure enclose_functional(const Functional& functional,
                                       const problem::Problem& problem,
                                       const numerics::Enclosure& mean) {
  numerics::Interval value = interval_from_enclosure(mean);
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    value *= 4.0 / (numerics::Interval(bin->knots.back()) - bin->knots.front());
  } else if (std::holds_alternative<ImpactMomentum>(functional)) {
    const numerics::Interval rate = problem.impulses.arrival_rate();
    value = (value - rate * moment_enclosure(problem.impulses.law(), 1)) /
            (1.0 + numerics::Interval(problem.system.restitution()));
  }
  return enclosure_from_interval(value);
}

}  // namespace fpkcheck::backward
