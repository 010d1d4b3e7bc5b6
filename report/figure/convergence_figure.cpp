#include "report/figure/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/case_solutions.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;
using transform::StateVariable;

/// A horizontal line of the convergence plot that shows the uncertainty of the reference: the L1
/// distance between the reference and another solution of the full problem, or the error estimate
/// of the reference.
struct ReferenceUncertaintyLine {
  std::string name;
  double l1;
  const char* dash;  ///< dash type of gnuplot
};

/// L1 distances of one marginal density from the reference solution of a case, grouped by solution
/// family and sorted by closure order. Members of a family are solutions of the case with a
/// positive distance from the reference solution.
struct ClosureDistancesByOrder {
  const results::CaseResult* case_result;
  const transform::Solution* reference;
  transform::StateVariable variable;
  std::vector<SolutionFamily> families;  ///< members sorted by order
  /// External densities that belong to no family of closures in the plot.
  std::vector<const transform::Solution*> external_densities;
  std::vector<ReferenceUncertaintyLine> uncertainty_lines;

  double l1(const transform::Solution& solution) const;
  std::pair<int, int> order_range() const;
};

int closure_order_of(const Solution* solution) { return *solution->identity.order; }

double ClosureDistancesByOrder::l1(const Solution& solution) const {
  return case_result->l1_distance(solution.id(), reference->id(), variable).value_or(0);
}

std::pair<int, int> ClosureDistancesByOrder::order_range() const {
  int first = closure_order_of(families.front().solutions.front()), last = first;
  const auto include = [&](const Solution* solution) {
    first = std::min(first, closure_order_of(solution));
    last = std::max(last, closure_order_of(solution));
  };
  for (const SolutionFamily& family : families) std::ranges::for_each(family.solutions, include);
  for (const Solution* external_density : external_densities) {
    if (external_density->identity.order) include(external_density);
  }
  return {first, last};
}

std::vector<ReferenceUncertaintyLine> make_uncertainty_lines(
    const ClosureDistancesByOrder& distances) {
  std::vector<ReferenceUncertaintyLine> all;
  for (const Solution* other : solutions_of_full_problem(*distances.case_result)) {
    const double l1 = distances.l1(*other);
    if (l1 > 0)
      all.push_back({fmt::format("distance of {} to {}", other->id(), distances.reference->id()),
                     l1, "(2,4)"});
  }
  const double error_estimate =
      compare::l1_error_estimate(*distances.reference, distances.variable);
  if (std::isfinite(error_estimate) && error_estimate > 0) {
    all.push_back({"error estimate of " + distances.reference->id(), error_estimate, "(8,4)"});
  }
  return all;
}

/// Returns the L1 distances of one marginal density from the reference, by family of closures and
/// closure order.
/// @return nothing if the case has no reference, or no family of closures with at least two orders
std::optional<ClosureDistancesByOrder> convergence_over_order(
    const results::CaseResult& case_result, transform::StateVariable variable) {
  const Solution* reference = case_result.reference_solution();
  if (reference == nullptr) return std::nullopt;
  ClosureDistancesByOrder distances{.case_result = &case_result,
                                    .reference = reference,
                                    .variable = variable,
                                    .families = {},
                                    .external_densities = {},
                                    .uncertainty_lines = {}};
  std::vector<const Solution*> by_order;
  for (const auto& solution : case_result.solutions) {
    if (!(distances.l1(solution) > 0)) continue;
    if (transform::differs_by_order_in_family(solution.identity)) {
      by_order.push_back(&solution);
    } else if (transform::is_external(solution.identity)) {
      distances.external_densities.push_back(&solution);
    }
  }
  distances.families = group_by_family(by_order);
  const bool has_several_orders = std::ranges::any_of(
      distances.families, [](const SolutionFamily& family) { return family.solutions.size() > 1; });
  if (!has_several_orders) return std::nullopt;
  for (SolutionFamily& family : distances.families)
    std::ranges::stable_sort(family.solutions, {}, closure_order_of);
  distances.uncertainty_lines = make_uncertainty_lines(distances);
  return distances;
}

std::string convergence_panel_title(StateVariable variable) {
  return variable == StateVariable::y ? "displacement" : "velocity";
}

FigureAxis distance_from_reference_axis(StateVariable variable, const Solution& reference,
                                        const std::vector<FigureSeries>& all) {
  return logarithmic_axis(
      fmt::format("{{/:Italic L}}_1 distance of {} to {}", density_in_enhanced_text(variable),
                  escape_enhanced_text(reference.id())),
      all, &FigurePoint::y);
}

std::string name_with_status(const Solution& solution) {
  return solution.has_status_ok() ? solution.id()
                                  : fmt::format("{} ({})", solution.id(), name(solution.status));
}

/// Makes the figure series of a solution family, without points. The plot style of a family's
/// series is the style of the middle solution of the family.
FigureSeries family_series(const SolutionFamily& family) {
  const auto& style = family.solutions[family.solutions.size() / 2]->identity.plot_style;
  return {.name = family.name,
          .group = "family " + family.name,
          .colour = style.colour,
          .symbol = style.symbol};
}

std::vector<FigureSeries> convergence_series(const ClosureDistancesByOrder& distances,
                                             const FigureAxis& x) {
  std::vector<FigureSeries> all;
  for (const auto& family : distances.families) {
    FigureSeries series = family_series(family);
    series.dash = "solid";
    for (const Solution* member : family.solutions) {
      series.points.push_back({.x = static_cast<double>(*member->identity.order),
                               .y = distances.l1(*member),
                               .open = !member->has_status_ok(),
                               .name = name_with_status(*member)});
    }
    all.push_back(series);
  }
  for (const Solution* external_density : distances.external_densities) {
    const auto& identity = external_density->identity;
    const double l1 = distances.l1(*external_density);
    FigureSeries series{.name = name_with_status(*external_density),
                        .group = "level " + identity.id,
                        .colour = identity.plot_style.colour};
    if (identity.order) {
      series.symbol = identity.plot_style.symbol;
      series.mark_size = 1.6;
      series.points = {{.x = static_cast<double>(*identity.order),
                        .y = l1,
                        .open = !external_density->has_status_ok(),
                        .name = series.name}};
    } else {
      series.dash = "(20,6)";
      series.points = {{.x = x.from, .y = l1}, {.x = x.to, .y = l1}};
    }
    all.push_back(series);
  }
  for (const auto& line : distances.uncertainty_lines) {
    all.push_back({.name = line.name,
                   .group = "level " + line.name,
                   .colour = "#555555",
                   .dash = line.dash,
                   .line_width = 1.5,
                   .points = {{.x = x.from, .y = line.l1}, {.x = x.to, .y = line.l1}}});
  }
  return all;
}

std::vector<FigureSeries> cost_series(const results::CaseResult& case_result,
                                      const Solution& reference, StateVariable variable) {
  const auto l1 = [&](const Solution& solution) {
    return case_result.l1_distance(solution.id(), reference.id(), variable).value_or(0);
  };
  std::vector<const Solution*> compared;
  for (const auto& solution : case_result.solutions) {
    if (l1(solution) > 0) compared.push_back(&solution);
  }
  std::vector<FigureSeries> all;
  for (const auto& family : group_by_family(compared)) {
    FigureSeries series = family_series(family);
    for (const Solution* member : family.solutions) {
      series.points.push_back({.x = member->seconds,
                               .y = l1(*member),
                               .open = !member->has_status_ok(),
                               .name = name_with_status(*member),
                               .label = transform::solution_name_within_family(member->identity),
                               .colour = member->identity.plot_style.colour});
    }
    all.push_back(series);
  }
  return all;
}

}  // namespace

Figure convergence_figure(const results::CaseResult& case_result) {
  Figure figure{.title = problem_title_parts(case_result.problem)};
  for (const StateVariable variable : transform::kVariables) {
    const auto distances = convergence_over_order(case_result, variable);
    if (!distances) continue;
    const auto [first, last] = distances->order_range();
    const FigureAxis x{"order {/:Italic n} of the closure", first - 0.5, last + 0.5, false, 2};
    const auto series = convergence_series(*distances, x);
    figure.panels.push_back(
        {.id = fmt::format("order-{}", name(variable)),
         .title = convergence_panel_title(variable),
         .caption = fmt::format("Convergence of the closures in {}; open marks: not ok",
                                density_in_plain_text(variable)),
         .x = x,
         .y = distance_from_reference_axis(variable, *distances->reference, series),
         .series = series});
  }
  return figure;
}

Figure computing_time_figure(const results::CaseResult& case_result) {
  Figure figure{.title = problem_title_parts(case_result.problem)};
  const Solution* reference = case_result.reference_solution();
  if (reference == nullptr) return figure;
  for (const StateVariable variable : transform::kVariables) {
    const auto series = cost_series(case_result, *reference, variable);
    if (series.empty()) continue;
    figure.panels.push_back(
        {.id = fmt::format("cost-{}", name(variable)),
         .title = convergence_panel_title(variable),
         .caption = fmt::format("L1 distance in {} against computing time",
                                density_in_plain_text(variable)),
         .x = logarithmic_axis("computing time in seconds", series, &FigurePoint::x),
         .y = distance_from_reference_axis(variable, *reference, series),
         .series = series});
  }
  return figure;
}

}  // namespace fpkcheck::report
