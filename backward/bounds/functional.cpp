#include "backward/bounds/functional.hpp"

#include <fmt/format.h>

#include <cmath>

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

const char* symbol(Axis axis) { return axis == Axis::displacement ? "y" : "y'"; }

double bin_value(const SmoothBin& bin, double x) {
  if (x <= bin.knots.front() || x >= bin.knots.back()) return 0;
  const numerics::SplineBasis basis({bin.knots.begin(), bin.knots.end()}, 3);
  const int span = basis.span_containing(x);
  return basis.basis_derivatives(x, span, 0)(
      0, 3 - span);  // the function on all five knots has index 3
}

}  // namespace

SmoothBin SmoothBin::with_equidistant_knots(Axis axis, double centre, double spacing) {
  SmoothBin bin{axis, {}};
  for (int i = 0; i < 5; ++i) bin.knots[i] = centre + (i - 2) * spacing;
  return bin;
}

std::vector<Functional> default_functionals() {
  return {PowerMoment{Axis::displacement, 1}, PowerMoment{Axis::displacement, 2},
          PowerMoment{Axis::velocity, 2},     PowerMoment{Axis::displacement, 4},
          PowerMoment{Axis::velocity, 4},     ImpactMomentum{}};
}

std::string name(const Functional& functional) {
  return std::visit(
      Overloaded{[](const PowerMoment& m) {
                   return m.power == 1 ? fmt::format("E[{}]", symbol(m.axis))
                                       : fmt::format("E[{}^{}]", symbol(m.axis), m.power);
                 },
                 [](const SmoothBin& b) {
                   return fmt::format("p({}) near {:.4g}", symbol(b.axis), b.knots[2]);
                 },
                 [](const ImpactMomentum&) { return std::string("w1"); }},
      functional);
}

double integrand(const Functional& functional, const problem::Problem& problem, double y,
                 double v) {
  return std::visit(
      Overloaded{
          [&](const PowerMoment& m) {
            return std::pow(m.axis == Axis::displacement ? y : v, m.power);
          },
          [&](const SmoothBin& b) { return bin_value(b, b.axis == Axis::displacement ? y : v); },
          [&](const ImpactMomentum&) { return problem.system.restoring_force()(y); }},
      functional);
}

std::vector<double> non_smooth_points(const Functional& functional) {
  const SmoothBin* const bin = std::get_if<SmoothBin>(&functional);
  return bin == nullptr ? std::vector<double>{}
                        : std::vector<double>(bin->knots.begin(), bin->knots.end());
}

Axis axis_of(const Functional& functional) {
  return std::visit(Overloaded{[](const PowerMoment& m) { return m.axis; },
                               [](const SmoothBin& b) { return b.axis; },
                               [](const ImpactMomentum&) { return Axis::displacement; }},
                    functional);
}

void validate(const Functional& functional) {
  if (const PowerMoment* const m = std::get_if<PowerMoment>(&functional)) {
    if (m->power < 1 || m->power > 4) {
      throw InputError(fmt::format("{} cannot be bounded: use powers 1 to 4", name(functional)));
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
    if (b->axis == Axis::displacement && b->knots[0] < 0) {
      throw InputError(fmt::format("a smooth bin of p(y) begins at {:.4g} < 0", b->knots[0]));
    }
  }
}

}  // namespace fpkcheck::backward
