#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/statistics.hpp"
#include "workflows/check/case_quantities.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {
namespace {

using results::DensityCurve;
using transform::Solution;

// Largest half-width of a bin's 95 % confidence interval relative to the density in the bin. A bin
// with a wider confidence interval than kMaxRelativeHalfWidth has few samples, and contributes only
// to the L1 distance.
constexpr double kMaxRelativeHalfWidth = 0.5;

bool has_same_bins(const DensityCurve& one, const DensityCurve& other) {
  constexpr double kAbscissaTolerance = 1e-9;
  if (one.abscissa.size() != other.abscissa.size() || one.abscissa.empty()) return false;
  const double extent = std::abs(one.abscissa.back());
  return std::ranges::equal(one.abscissa, other.abscissa, [&](double x, double y) {
    return std::abs(x - y) <= kAbscissaTolerance * extent;
  });
}

base::Value bin_range_text(const DensityCurve* curve) {
  if (curve == nullptr) return "missing";
  return fmt::format("{} bins to {:.6g}", curve->abscissa.size(),
                     curve->abscissa.empty() ? 0 : curve->abscissa.back());
}

bool has_narrow_confidence_interval(const DensityCurve& curve, std::size_t k) {
  return curve.density[k] > 0 &&
         curve.upper[k] - curve.density[k] <= kMaxRelativeHalfWidth * curve.density[k];
}

double bin_standard_error(const DensityCurve& curve, std::size_t k) {
  return (curve.upper[k] - curve.density[k]) / numerics::kNormal95;
}

// Returns the bin of a marginal density with the largest change between two runs. For simulations
// only bins with sufficiently narrow confidence intervals in the two runs are compared.
CheckedQuantityChange compare_density_bins(CheckedQuantityChange quantity_change,
                                           const DensityCurve& was, const DensityCurve& is,
                                           bool has_sampling_error,
                                           const BaselineCheckTolerances& tolerances) {
  const double peak = std::ranges::max(was.density);
  std::size_t compared = 0;
  quantity_change.change = -1;
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    if (has_sampling_error &&
        !(has_narrow_confidence_interval(was, k) && has_narrow_confidence_interval(is, k)))
      continue;
    const double difference = std::abs(is.density[k] - was.density[k]);
    const double scale = has_sampling_error
                             ? std::hypot(bin_standard_error(was, k), bin_standard_error(is, k))
                             : peak;
    const double change = difference == 0 ? 0 : difference / scale;
    ++compared;
    if (change <= quantity_change.change) continue;
    quantity_change.name =
        fmt::format("{} at {:.4g}", marginal_density_symbol(was.variable), was.abscissa[k]);
    quantity_change.baseline = was.density[k];
    quantity_change.now = is.density[k];
    quantity_change.change = std::isnan(change) ? kInfinity : change;
  }
  quantity_change.change = std::max(quantity_change.change, 0.0);
  quantity_change.kind =
      has_sampling_error ? CheckedQuantityKind::simulated_bin : CheckedQuantityKind::marginal;
  quantity_change.allowed =
      has_sampling_error ? tolerances.bonferroni_threshold(compared) : tolerances.deterministic;
  return quantity_change;
}

double l1_distance(const DensityCurve& was, const DensityCurve& is) {
  const auto widths = results::bin_widths(was);
  double sum = 0;
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    sum += std::abs(is.density[k] - was.density[k]) * widths[k];
  }
  return sum;
}

CheckedQuantities l1_distance_quantity(const Solution& simulation, const DensityCurve& curve,
                                       double l1, const BaselineCheckTolerances& tolerances) {
  CheckedQuantities quantities;
  CheckedQuantity& quantity =
      SolutionPartQuantityAppender{quantities, curve.solution, kWholeSolutionPart}
          .append_number_quantity(
              fmt::format("L1 {} to baseline", marginal_density_symbol(curve.variable)),
              CheckedQuantityKind::simulated_l1, l1, 0);
  set_tolerance_from_sampling_error(quantity, simulation.sampling, curve.variable, tolerances);
  return quantities;
}

}  // namespace

std::vector<CheckedQuantityChange> marginal_changes(const results::CaseResult& baseline,
                                                    const results::CaseResult& now,
                                                    const BaselineCheckTolerances& tolerances) {
  std::vector<CheckedQuantityChange> changes;
  const auto change_of_curve = [&](const DensityCurve& curve) {
    return CheckedQuantityChange{
        .case_name = baseline.name(),
        .solution = curve.solution,
        .name = marginal_density_symbol(curve.variable),
        .kind = CheckedQuantityKind::marginal,
        .baseline = bin_range_text(baseline.marginal_curve(curve.solution, curve.variable)),
        .now = bin_range_text(now.marginal_curve(curve.solution, curve.variable)),
        .change = kInfinity,
        .allowed = 0};
  };
  for (const DensityCurve& was : baseline.curves) {
    const Solution *one = baseline.find(was.solution), *other = now.find(was.solution);
    const DensityCurve* is = now.marginal_curve(was.solution, was.variable);
    if (is == nullptr || !has_same_bins(was, *is)) {
      changes.push_back(change_of_curve(was));
      // If only one of two compared runs has a marginal density, solution_quantities() reports this
      // difference.
    } else if (one != nullptr && other != nullptr) {
      const bool has_sampling_error =
          one->standard_errors && !was.upper.empty() && !is->upper.empty();
      changes.push_back(
          compare_density_bins(change_of_curve(was), was, *is, has_sampling_error, tolerances));
      if (has_sampling_error) {
        const auto compared = compare_quantities(
            baseline.name(), l1_distance_quantity(*one, was, 0, tolerances),
            l1_distance_quantity(*other, *is, l1_distance(was, *is), tolerances));
        changes.push_back(compared.front());
      }
    }
  }
  for (const DensityCurve& is : now.curves) {
    if (baseline.marginal_curve(is.solution, is.variable) == nullptr)
      changes.push_back(change_of_curve(is));
  }
  return changes;
}

}  // namespace fpkcheck::check
