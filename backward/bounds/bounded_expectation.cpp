#include "backward/bounds/bounded_expectation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "backward/generator/impulse_mean_table.hpp"
#include "base/input_error.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

const char* variable_symbol(StateVariable variable) {
  return variable == StateVariable::y ? "y" : "y'";
}

// Returns the value at x of the cubic B-spline of a smooth bin, without the factor for integral 1.
double bin_spline_value(const SmoothBin& bin, double x) {
  if (x <= bin.knots.front() || x >= bin.knots.back()) return 0;
  const numerics::SplineBasis basis({bin.knots.begin(), bin.knots.end()}, 3);
  const int span = basis.knot_span_containing(x);
  // The B-spline whose support contains all five knots has the index 3.
  return basis.basis_derivatives(x, span, 0)(0, 3 - span);
}

}  // namespace

SmoothBin SmoothBin::with_equidistant_knots(StateVariable variable, double centre, double spacing) {
  SmoothBin bin{variable, {}};
  for (int i = 0; i < 5; ++i) bin.knots[i] = centre + (i - 2) * spacing;
  return bin;
}

std::vector<StationaryFunctional> default_functionals() {
  return {PowerMoment{StateVariable::y, 1},    PowerMoment{StateVariable::y, 2},
          PowerMoment{StateVariable::ydot, 2}, PowerMoment{StateVariable::y, 4},
          PowerMoment{StateVariable::ydot, 4}, ImpactMomentumFlux{}};
}

std::string functional_name(const StationaryFunctional& functional) {
  return std::visit(
      Overloaded{[](const PowerMoment& m) {
                   return m.power == 1
                              ? fmt::format("E[{}]", variable_symbol(m.variable))
                              : fmt::format("E[{}^{}]", variable_symbol(m.variable), m.power);
                 },
                 [](const SmoothBin& b) {
                   return fmt::format("p({}) near {:.4g}", variable_symbol(b.variable), b.knots[2]);
                 },
                 [](const ImpactMomentumFlux&) { return std::string("w1"); }},
      functional);
}

double evaluate_integrand(const StationaryFunctional& functional, const problem::Problem& problem,
                          double y, double v) {
  return std::visit(
      Overloaded{[&](const PowerMoment& m) {
                   return std::pow(m.variable == StateVariable::y ? y : v, m.power);
                 },
                 [&](const SmoothBin& b) {
                   return bin_spline_value(b, b.variable == StateVariable::y ? y : v);
                 },
                 [&](const ImpactMomentumFlux&) { return problem.system.restoring_force()(y); }},
      functional);
}

std::vector<double> integrand_breakpoints(const StationaryFunctional& functional) {
  const SmoothBin* const bin = std::get_if<SmoothBin>(&functional);
  return bin == nullptr ? std::vector<double>{}
                        : std::vector<double>(bin->knots.begin(), bin->knots.end());
}

StateVariable integrand_variable(const StationaryFunctional& functional) {
  return std::visit(Overloaded{[](const PowerMoment& m) { return m.variable; },
                               [](const SmoothBin& b) { return b.variable; },
                               [](const ImpactMomentumFlux&) { return StateVariable::y; }},
                    functional);
}

void require_valid_functional(const StationaryFunctional& functional) {
  if (const PowerMoment* const m = std::get_if<PowerMoment>(&functional)) {
    if (m->power < 1 || m->power > 4) {
      throw InputError(
          fmt::format("{} cannot be bounded: use powers 1 to 4", functional_name(functional)));
    }
  }
  if (const SmoothBin* const b = std::get_if<SmoothBin>(&functional)) {
    bool increasing = std::isfinite(b->knots[0]);
    for (int i = 0; i < 4; ++i) increasing = increasing && b->knots[i] < b->knots[i + 1];
    if (!increasing || !std::isfinite(b->knots[4])) {
      throw InputError(
          "the knots of a smooth bin do not increase: give a finite centre and a positive "
          "spacing");
    }
    if (b->variable == StateVariable::y && b->knots[0] < 0) {
      throw InputError(fmt::format("a smooth bin of p(y) begins at {:.4g} < 0", b->knots[0]));
    }
  }
}

namespace {

numerics::BernsteinCoefficients enclose_bin_spline(const SmoothBin& bin,
                                                   const numerics::Interval& from,
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
    const int span = basis.knot_span_containing(middle);
    const auto rows = numerics::bezier_extraction<numerics::Interval>(basis, span, from, to);
    const numerics::BernsteinCoefficients bin_function(rows.row(3 - span).begin(),
                                                       rows.row(3 - span).end());
    b = elevate_bernstein_degree(bin_function, degree);
    overhang = std::max((bin.knots[span] - from).upper(), (to - bin.knots[span + 1]).upper());
    for (const numerics::Interval& d : bernstein_derivative(bin_function))
      slope = std::max(slope, magnitude(d));
    slope = (slope / numerics::Interval((to - from).lower())).upper();
  }
  // The error bound of the polynomial equals that of basis_functions_on_piece(), with |f'| <= 3 /
  // shortest knot interval.
  if (overhang > 0) {
    const double error = (overhang * (slope + 3.1 / numerics::Interval(shortest))).upper();
    for (numerics::Interval& c : b) c += numerics::symmetric_interval(error);
  }
  return b;
}

}  // namespace

numerics::BernsteinCoefficients enclose_integrand(const StationaryFunctional& functional,
                                                  const problem::Problem& problem,
                                                  const numerics::Interval& from,
                                                  const numerics::Interval& to, int degree) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    return enclose_bin_spline(*bin, from, to, degree);
  }
  std::vector<double> powers;
  if (const PowerMoment* const moment = std::get_if<PowerMoment>(&functional)) {
    powers.assign(moment->power + 1, 0.0);
    powers.back() = 1;
  } else {
    const problem::SystemCoefficients& c = problem.system.coefficients();
    powers = {0.0, c.stiffness, 0.0, c.cubic};
  }
  return elevate_bernstein_degree(
      bernstein_coefficients_on_segment(powers, numerics::Interval(0), from, to), degree);
}

numerics::Interval integrand_magnitude_bound(const StationaryFunctional& functional,
                                             const numerics::Interval& y_bound,
                                             const numerics::Interval& v_bound,
                                             const numerics::Interval& force_bound) {
  if (std::holds_alternative<SmoothBin>(functional)) return 1;
  if (const PowerMoment* const moment = std::get_if<PowerMoment>(&functional)) {
    return power(moment->variable == StateVariable::y ? y_bound : v_bound, moment->power);
  }
  return force_bound;
}

numerics::Enclosure enclose_functional(const StationaryFunctional& functional,
                                       const problem::Problem& problem,
                                       const numerics::Enclosure& integrand_mean) {
  numerics::Interval value = interval_from_enclosure(integrand_mean);
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    value *= 4.0 / (numerics::Interval(bin->knots.back()) - bin->knots.front());
  } else if (std::holds_alternative<ImpactMomentumFlux>(functional)) {
    const numerics::Interval rate = problem.impulses.arrival_rate();
    value = (value - rate * enclose_amplitude_moment(problem.impulses.amplitude_law(), 1)) /
            (1.0 + numerics::Interval(problem.system.restitution()));
  }
  return enclosure_from_interval(value);
}

}  // namespace fpkcheck::backward
