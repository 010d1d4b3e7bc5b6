#include "epc/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "transform/smooth_density_results.hpp"

namespace fpkcheck::epc {
namespace {

using transform::SolverMetricKind;
using transform::SolverMetricsBuilder;
using transform::value_from_count;
using transform::value_from_optional;

base::Value text_value(std::string_view text) { return std::string(text); }

// Returns whether the last digits of the solution depend on the path of the root search. At high
// closure orders of the formulation `moment` the search path determines the quadrature points.
bool is_path_dependent(const ClosureSummary& summary) {
  constexpr int kSettledOrder = 8;
  return summary.formulation == Formulation::moment && summary.order > kSettledOrder;
}

// Returns the scale below which a change of a coefficient of Q_n is a rounding error. A coefficient
// 1 of x1^p x2^q changes the density, relative to its peak, by at most sigma_1^p sigma_2^q max
// |x|^p exp(-x^2/2) max |x|^q exp(-x^2/2).
double rounding_scale_of_coefficient(const ExponentMonomial& term,
                                     const transform::Moments& moments, double rounding) {
  constexpr double kRelative = 50e-8;
  if (!(moments.y2 > 0) || !(moments.v2 > 0)) return 0;
  const auto largest_weighted_power = [](int p) {
    return p == 0 ? 1 : std::pow(p / std::numbers::e, p / 2.0);
  };
  const double effect = std::pow(moments.y2, term.x1 / 2.0) * std::pow(moments.v2, term.x2 / 2.0) *
                        largest_weighted_power(term.x1) * largest_weighted_power(term.x2);
  return rounding / (effect * kRelative);
}

// Adds the coordinates and the constant C of the closed form, for read_closed_form(). A repeated
// run need not reproduce the coordinates and the constant C of a closed form, since the
// coefficients and the problem determine them. Result files of earlier program versions lack the
// metrics of the closed form of a closure.
void add_frame_metrics(const ClosureSummary& summary, SolverMetricsBuilder& builder) {
  if (!summary.frame) return;
  builder.add_text_metric("coordinates", text_value(name(summary.frame->variables)))
      .add_diagnostic_metric("log_C", value_from_optional(summary.frame->log_constant));
  const problem::WallFrame& coordinates = summary.frame->coordinates;
  if (coordinates.is_identity()) return;
  builder.add_diagnostic_metric("frame.origin", coordinates.origin)
      .add_diagnostic_metric("frame.mirrored", coordinates.mirrored);
}

void add_edge_metrics(const ClosedFormDensityParameters& frame, SolverMetricsBuilder& builder) {
  if (frame.deviations) {
    builder.add_diagnostic_metric("support.sigma1", frame.deviations->x1)
        .add_diagnostic_metric("support.sigma2", frame.deviations->x2);
  } else {
    builder.add_diagnostic_metric("support.energy", frame.support);
  }
}

void add_coefficient_metrics(const ClosureSummary& summary, const transform::Moments& moments,
                             SolverMetricsBuilder& builder) {
  // Rounding errors of the closure density, relative to its peak density
  constexpr double kRounding = 1e-14, kPathRounding = 3e-9;
  if (summary.coefficients.empty()) builder.add_empty_list("coefficients");
  const double rounding = is_path_dependent(summary) ? kPathRounding : kRounding;
  for (std::size_t k = 0; k < summary.coefficients.size(); ++k) {
    const ExponentMonomial& term = summary.coefficients[k];
    const std::string path = fmt::format("coefficients[{}].", k);
    builder.add_result_metric(path + "x1", value_from_count(term.x1))
        .add_result_metric(path + "x2", value_from_count(term.x2))
        .add({.path = path + "a",
              .value = term.a,
              .kind = SolverMetricKind::coefficient,
              .min_scale = rounding_scale_of_coefficient(term, moments, rounding)});
  }
}

void add_support_metrics(const ClosureSummary& summary, SolverMetricsBuilder& builder) {
  if (!summary.support || !summary.leading_form) {
    builder.add_result_metric("support", {});
    return;
  }
  const DensitySupportSummary& support = *summary.support;
  const ExponentBehaviourAtInfinity& form = *summary.leading_form;
  // A density near 0 on the edge of the support is sensitive to rounding errors of coefficients.
  const auto add_small_density_metric = [&](const char* path, double value) {
    builder.add(
        {.path = path,
         .value = value,
         .kind = is_path_dependent(summary) ? SolverMetricKind::work : SolverMetricKind::result,
         .min_scale = 1e-6,
         .is_rounding_sensitive = true});
  };
  builder.add_result_metric("support.least_radius", support.least_radius)
      .add_result_metric("support.greatest_radius", support.greatest_radius)
      .add_result_metric("support.y_max", support.y_max)
      .add_result_metric("support.v_max", support.v_max);
  if (support.y_min != 0) builder.add_result_metric("support.y_min", support.y_min);
  if (summary.frame) add_edge_metrics(*summary.frame, builder);
  add_small_density_metric("support.edge_density", support.edge_density);
  add_small_density_metric("support.cut_off", support.cut_off);
  builder
      .add_result_metric("support.rising_share", form.rising_fraction)
      // If the leading form of the exponent is isotropic, the direction with the largest leading
      // coefficient is arbitrary.
      .add_diagnostic_metric("support.worst_direction.x1", form.worst.x1)
      .add_diagnostic_metric("support.worst_direction.x2", form.worst.x2)
      .add_result_metric("support.rises_from",
                         form.negative ? base::Value() : base::Value(form.rises_from));
}

base::Value leading_form_text(const ExponentBehaviourAtInfinity& form) {
  return text_value(form.negative ? "negative" : "indefinite");
}

// Returns the sign at infinity of the leading form of the exponent Q_n plus confinement term. With
// a confinement term in the exponent the leading form is negative for every polynomial Q_n.
base::Value leading_form_of_exponent(const ClosureSummary& summary) {
  if (!summary.leading_form) return {};
  if (summary.half_plane && summary.half_plane->tail == DensityTailTreatment::confined)
    return text_value("negative");
  return leading_form_text(*summary.leading_form);
}

void add_branch_metrics(const SolutionBranch& branch, SolverMetricsBuilder& builder) {
  if (branch.end == SolutionBranchEndReason::not_followed) {
    builder.add_result_metric("branch", {});
    return;
  }
  builder.add_result_metric("branch.end", text_value(name(branch.end)))
      .add_result_metric("branch.furthest", branch.furthest);
  if (branch.points.empty()) builder.add_empty_list("branch.points", SolverMetricKind::work);
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const SolutionBranchPoint& point = branch.points[k];
    const std::string path = fmt::format("branch.points[{}].", k);
    builder.add_diagnostic_metric(path + "fraction", point.fraction)
        .add_diagnostic_metric(path + "norm", point.norm)
        .add_diagnostic_metric(path + "smallest_singular_value", point.smallest_singular_value)
        .add_diagnostic_metric(path + "determinant_sign", value_from_count(point.determinant_sign))
        .add_diagnostic_metric(path + "falls", point.falls)
        .add_diagnostic_metric(path + "fold", point.fold);
  }
}

void add_half_plane_metrics(const ClosureSummary& summary, SolverMetricsBuilder& builder) {
  const HalfPlaneClosureSummary& half_plane = *summary.half_plane;
  builder.add_result_metric("tail.kind", text_value(name(half_plane.tail)))
      .add_result_metric("tail.level", half_plane.level)
      .add_result_metric("tail.level_deviations", half_plane.level_deviations)
      .add_result_metric("tail.beyond_level", half_plane.beyond_level)
      .add_result_metric("tail.polynomial_leading_form", leading_form_text(*summary.leading_form))
      .add_diagnostic_metric("quadrature_change", half_plane.quadrature_change)
      .add_diagnostic_metric("homotopies", value_from_count(half_plane.homotopies))
      .add_diagnostic_metric("relaxation_rate", half_plane.relaxation_rate)
      .add_diagnostic_metric("relaxation_frequency", half_plane.relaxation_frequency);
}

}  // namespace

transform::QuadratureMarginals store_density(const problem::Problem& problem,
                                             problem::ImpactCondition impact,
                                             const transform::SmoothDensity& density,
                                             ClosureResult& result,
                                             transform::QuadraturePanelSpacing panels) {
  auto results = transform::store_smooth_density(problem, impact, density, result.solution, panels);
  result.summary.moments = results.marginals.moments;
  result.summary.balances = results.balances;
  return std::move(results.marginals);
}

transform::Metrics solver_metrics(const ClosureSummary& summary,
                                  const transform::Moments& moments) {
  SolverMetricsBuilder builder;
  builder.add_result_metric("order", value_from_count(summary.order))
      .add_result_metric("formulation", text_value(name(summary.formulation)))
      .add_diagnostic_metric("iterations", value_from_count(summary.iterations))
      .add_diagnostic_metric("residual", summary.residual)
      .add_diagnostic_metric("condition", value_from_optional(summary.condition));
  add_frame_metrics(summary, builder);
  add_coefficient_metrics(summary, moments, builder);
  add_support_metrics(summary, builder);
  builder.add_result_metric("leading_form", leading_form_of_exponent(summary))
      .add_result_metric("distance_to_previous", value_from_optional(summary.distance_to_previous));
  add_balance_metrics(builder, summary.balances);
  if (summary.formulation == Formulation::gaussian) {
    builder.add_diagnostic_metric("plain_newton_converges", summary.plain_newton_converges);
    builder.add_result_metric("disc_sensitivity", value_from_optional(summary.disc_sensitivity));
    add_branch_metrics(summary.branch, builder);
  }
  if (summary.half_plane) add_half_plane_metrics(summary, builder);
  return std::move(builder).take_metrics();
}

}  // namespace fpkcheck::epc
