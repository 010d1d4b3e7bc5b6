#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "workflows/check/case_quantities.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {
namespace {

using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using compare::SolutionPairDistances;

double standard_deviation(const transform::Solution* reference, transform::StateVariable variable) {
  if (reference == nullptr || !reference->has_density()) return 1;
  const auto& moments = reference->moments;
  return std::sqrt(variable == transform::StateVariable::y ? moments.y2 : moments.v2);
}

bool has_finite_divergence(const results::CaseResult& case_result,
                           const SolutionPairDistances& pair) {
  const auto* found =
      compare::find_pair_distances(case_result.pairs, pair.a, pair.b, pair.variable);
  return found == nullptr || std::isfinite(found->distances.kl);
}

void add_tail_distances(const compare::DensityDistances& d,
                        const SolutionPartQuantityAppender& pair, double allowed) {
  // The text quantity `bins` lists the decades of the density tail and the number of bins in each
  // decade. Two tail distances over different bins of the density are not compared.
  std::string bins;
  for (const auto& decade : d.log10_tail) {
    bins += fmt::format("{:.3g} to {:.3g}: {} and {}; ", decade.from, decade.to, decade.bins,
                        decade.omitted_bin_count);
  }
  const SolutionPartQuantityAppender tail{pair.quantities, pair.solution, "tail " + pair.name};
  tail.begin_part(CheckedQuantityKind::tail, bins, pair.name);
  for (const auto& decade : d.log10_tail) {
    tail.append_number_quantity(fmt::format("tail {:.0e} {}", decade.from, pair.name),
                                CheckedQuantityKind::tail, decade.mean_abs, allowed);
  }
}

void add_l1_standard_error(const SolutionPairDistances& pair, const transform::Solution& simulation,
                           const BaselineCheckTolerances& tolerances,
                           const SolutionPartQuantityAppender& part) {
  constexpr std::size_t kBothVariables = 2;
  part.append_number_quantity(
      "standard error of L1 " + part.name, CheckedQuantityKind::simulated_error,
      *pair.l1_standard_error,
      standard_error_change_tolerance(simulation, kBothVariables, 1, tolerances));
}

// Returns the reference and the names of the parts in a row of the error budget as text. Two budget
// rows with different references or parts are not compared.
std::string budget_chain_text(const ErrorBudgetRow& row) {
  std::string text = row.reference + ":";
  for (const ErrorBudgetPart& part : row.parts) {
    text += fmt::format(" {} ({} to {})", part.error_budget_part_name(), part.from, part.to);
  }
  return text;
}

/// @param simulation simulation to which the total distances of the budget row refer, if the two
///        compared runs differ by sampling; otherwise a null pointer
void add_budget_row_quantities(const ErrorBudgetRow& row, const transform::Solution* simulation,
                               const BaselineCheckTolerances& tolerances,
                               CheckedQuantities& quantities) {
  const SolutionPartQuantityAppender part{
      quantities, row.solution, fmt::format("budget {}", marginal_density_symbol(row.variable))};
  const auto add = [&](const std::string& name, double number) -> CheckedQuantity& {
    return part.append_number_quantity(part.name + ' ' + name, CheckedQuantityKind::budget, number,
                                       tolerances.deterministic);
  };
  const auto add_l1 = [&](const std::string& name, double l1, bool to_reference) {
    CheckedQuantity& quantity = add(name, l1);
    if (!to_reference || simulation == nullptr) return;
    set_tolerance_from_sampling_error(
        quantity, transform::smallest_known_sampling_errors(*simulation), row.variable, tolerances);
  };
  const auto add_tail = [&](const std::string& name, double tail) {
    // Largest accepted ratio of the tail distances from two simulations of the same case. Each of
    // two simulations resolves different bins of the density tail. The file docs/checking.md has
    // the measurement of the factor 5 between tail distances.
    constexpr double kMaxTailFactor = 5;
    CheckedQuantity& quantity = add(name, tail);
    quantity.allowed = simulation == nullptr ? tolerances.tail_tolerance() : kMaxTailFactor - 1;
    if (simulation != nullptr) quantity.kind = CheckedQuantityKind::simulated_error;
  };
  const auto add_error_metric = [&](const std::string& name, const std::optional<double>& l1,
                                    bool of_the_simulation) {
    CheckedQuantity& quantity = add(name, l1.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (simulation == nullptr || !of_the_simulation) return;
    quantity.kind = CheckedQuantityKind::simulated_error;
    quantity.allowed = standard_error_change_tolerance(*simulation, 2, 1, tolerances);
  };
  part.begin_part(CheckedQuantityKind::budget, budget_chain_text(row));
  add_l1("total", row.total, true);
  add_tail("tail of total", row.total_tail);
  add("tail from", row.tail_from);
  add("tail to", row.tail_to);
  add_tail("bins of tail", row.tail_bins);
  for (const ErrorBudgetPart& step : row.parts) {
    const std::string name = step.error_budget_part_name();
    add_l1(name, step.l1, step.to == row.reference);
    add_tail("tail of " + name, step.tail);
    add_error_metric("uncertainty " + name, step.uncertainty, false);
    add_error_metric("expected " + name, step.expected, true);
    add_error_metric("in_99 " + name, step.quantile_99, true);
    add_error_metric("standard error of " + name, step.standard_error, true);
  }
}

}  // namespace

CheckedQuantities distance_quantities(const results::CaseResult& case_result,
                                      const results::CaseResult& case_in_other_run,
                                      const BaselineCheckTolerances& tolerances) {
  CheckedQuantities quantities;
  for (const SolutionPairDistances& pair : case_result.pairs) {
    const auto *a = case_result.find(pair.a), *b = case_result.find(pair.b);
    const auto& d = pair.distances;
    const SolutionPartQuantityAppender part{
        quantities, pair.a,
        fmt::format("{} to {}", marginal_density_symbol(pair.variable), pair.b)};
    const auto add = [&](const char* symbol, double distance, double scale) -> CheckedQuantity& {
      return part.append_number_quantity(fmt::format("{} {}", symbol, part.name),
                                         CheckedQuantityKind::distance, distance,
                                         tolerances.deterministic, scale);
    };
    part.begin_part(CheckedQuantityKind::distance);
    CheckedQuantity& l1 = add("L1", d.l1, 1);
    for (const auto* end : {a, b}) {
      if (end == nullptr) continue;
      const bool measured = pair.l1_standard_error.has_value();
      set_tolerance_from_sampling_error(
          l1, measured ? transform::smallest_known_sampling_errors(*end) : end->sampling,
          pair.variable, tolerances);
    }
    const bool has_sampling_error = l1.kind == CheckedQuantityKind::simulated_l1;
    const auto* measure = b != nullptr && b->smooth_sampling ? b : a;
    if (pair.l1_standard_error && measure != nullptr) {
      add_l1_standard_error(pair, *measure, tolerances, part);
    }
    if (has_sampling_error) continue;
    const double unit = 1 / standard_deviation(b, pair.variable);
    add("L2", d.l2, std::sqrt(unit));
    add("sup", d.sup, unit);
    add("Hellinger", d.hellinger, 1);
    if (has_finite_divergence(case_result, pair) && has_finite_divergence(case_in_other_run, pair))
      add("KL", d.kl, 1);
    add_tail_distances(d, part, tolerances.tail_tolerance());
  }
  return quantities;
}

CheckedQuantities budget_quantities(const results::CaseResult& case_result,
                                    const results::CaseResult& case_in_other_run,
                                    const BaselineCheckTolerances& tolerances) {
  CheckedQuantities quantities;
  for (const ErrorBudgetRow& row : case_result.budget) {
    const auto *end = case_result.find(row.reference),
               *again = case_in_other_run.find(row.reference);
    const bool has_sampling_error =
        end != nullptr && again != nullptr && have_independent_sampling_errors(*end, *again);
    add_budget_row_quantities(row, has_sampling_error ? end : nullptr, tolerances, quantities);
  }
  return quantities;
}

}  // namespace fpkcheck::check
