#include "workflows/paper/closure_distances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/solution_assessment.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "workflows/paper/claim_criteria.hpp"
#include "workflows/paper/claims.hpp"

namespace fpkcheck::paper {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A row of the error budget covers only the bins in which the density of its closure is positive. A
// closure with fewer positive bins in the tail than other closures is 0 in a part of the tail.
int tail_bin_count(const results::CaseResult& one, transform::StateVariable variable) {
  int most = 0;
  for (const auto& row : one.budget) {
    if (row.variable == variable) most = std::max(most, row.tail_bins);
  }
  return most;
}

// If the total distance refers to a Richardson limit, which is no solution of the case, the error
// estimate of the case's reference solution is used.
double reference_l1_error_estimate(const results::CaseResult& one,
                                   const compare::ErrorBudgetRow& row) {
  const auto* reference = one.find(row.reference);
  if (reference == nullptr) reference = one.reference_solution();
  return reference == nullptr ? kInfinity : compare::l1_error_estimate(*reference, row.variable);
}

}  // namespace

std::optional<ClosureDistanceFromSimulation> closure_distance_to_simulation(
    const results::CaseResult& one, int order, transform::StateVariable variable,
    std::string& missing_reason) {
  const auto row = std::ranges::find_if(one.budget, [&](const compare::ErrorBudgetRow& of) {
    return of.solution == paper_closure_id(order) && of.variable == variable;
  });
  if (row == one.budget.end()) {
    const auto* closure = one.find(paper_closure_id(order));
    missing_reason =
        closure != nullptr && closure->has_density()
            ? fmt::format("{} has no reference solution", one.name())
            : fmt::format("{} has no density of {}", one.name(), paper_closure_id(order));
    return std::nullopt;
  }
  ClosureDistanceFromSimulation distance{.l1 = row->total,
                                         .tail = row->total_tail,
                                         .l1_error = reference_l1_error_estimate(one, *row)};
  if (row->tail_bins < tail_bin_count(one, variable)) distance.tail = kInfinity;
  if (!row->parts.empty() && row->parts.back().is_reference_error()) {
    distance.tail_error = row->parts.back().tail;
  }
  if (!std::isfinite(distance.l1)) {
    missing_reason = fmt::format("the distance of {} in {} is not a number",
                                 paper_closure_id(order), one.name());
    return std::nullopt;
  }
  if (!(distance.l1_error <= kMaxReferenceErrorFraction * kMaxL1OfClaimedAgreement)) {
    missing_reason =
        fmt::format("the reference of {} has an error of up to L1 {:.2g}: simulate longer",
                    one.name(), distance.l1_error);
    return std::nullopt;
  }
  return distance;
}

ClosureDistanceFromSimulation componentwise_maximum(const ClosureDistanceFromSimulation& one,
                                                    const ClosureDistanceFromSimulation& other) {
  const auto larger = [](double a, double b) { return std::isnan(a) || a > b ? a : b; };
  return {.l1 = std::max(one.l1, other.l1),
          .tail = larger(one.tail, other.tail),
          .l1_error = std::max(one.l1_error, other.l1_error),
          .tail_error = std::max(one.tail_error, other.tail_error)};
}

double l1_to_equivalent_linearisation(const results::DensityCurve& curve,
                                      const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  const bool is_y = curve.variable == transform::StateVariable::y;
  const double sigma = is_y ? linear.displacement_deviation : linear.velocity_deviation;
  // The density of y or y' follows from the density of z or z', where both z and -z have the image
  // y = |z|.
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
