#include "epc/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace fpkcheck::epc {
namespace {

using transform::count_value;
using transform::Kind;
using transform::MetricBuilder;
using transform::optional_value;

base::Value word(std::string_view text) { return std::string(text); }

// Whether the last digits of the solution depend on the path of the search. At high orders of the
// formulation moment the path determines the quadrature points.
bool is_path_dependent(const Summary& summary) {
  constexpr int kSettledOrder = 8;
  return summary.formulation == Formulation::moment && summary.order > kSettledOrder;
}

// Scale below which a change of the coefficient of x1^p x2^q is rounding error. The effect of a
// unit coefficient on the density, relative to the peak, is
// sigma_1^p sigma_2^q max |x|^p exp(-x^2/2) max |x|^q exp(-x^2/2). The relative tolerance is
// kRelative.
double min_scale(const Term& term, const transform::Moments& moments, double rounding) {
  constexpr double kRelative = 50e-8;
  if (!(moments.y2 > 0) || !(moments.v2 > 0)) return 0;
  const auto largest_weighted_power = [](int p) {
    return p == 0 ? 1 : std::pow(p / std::numbers::e, p / 2.0);
  };
  const double effect = std::pow(moments.y2, term.x1 / 2.0) * std::pow(moments.v2, term.x2 / 2.0) *
                        largest_weighted_power(term.x1) * largest_weighted_power(term.x2);
  return rounding / (effect * kRelative);
}

// Adds the parameters that define the density together with the coefficients, for
// read_closed_form(). The coefficients and the problem determine these parameters: a repeated run
// need not reproduce the parameters themselves. Files of earlier program versions lack them.
void add_frame_metrics(const Summary& summary, MetricBuilder& builder) {
  if (!summary.frame) return;
  builder.text("coordinates", word(name(summary.frame->variables)))
      .work("log_C", optional_value(summary.frame->log_constant));
  const problem::Frame& coordinates = summary.frame->coordinates;
  if (coordinates.is_identity()) return;
  builder.work("frame.origin", coordinates.origin).work("frame.mirrored", coordinates.mirrored);
}

// Adds the parameters that define the edge of the support.
void add_edge_metrics(const Frame& frame, MetricBuilder& builder) {
  if (frame.deviations) {
    builder.work("support.sigma1", frame.deviations->x1)
        .work("support.sigma2", frame.deviations->x2);
  } else {
    builder.work("support.energy", frame.support);
  }
}

void add_coefficient_metrics(const Summary& summary, const transform::Moments& moments,
                             MetricBuilder& builder) {
  constexpr double kRounding = 1e-14, kPathRounding = 3e-9;  // relative to the density's peak
  if (summary.coefficients.empty()) builder.add_empty_list("coefficients");
  const double rounding = is_path_dependent(summary) ? kPathRounding : kRounding;
  for (std::size_t k = 0; k < summary.coefficients.size(); ++k) {
    const Term& term = summary.coefficients[k];
    const std::string path = fmt::format("coefficients[{}].", k);
    builder.result(path + "x1", count_value(term.x1))
        .result(path + "x2", count_value(term.x2))
        .add({.path = path + "a",
              .value = term.a,
              .kind = Kind::coefficient,
              .min_scale = min_scale(term, moments, rounding)});
  }
}

void add_support_metrics(const Summary& summary, MetricBuilder& builder) {
  if (!summary.support || !summary.leading_form) {
    builder.result("support", {});
    return;
  }
  const SupportSummary& support = *summary.support;
  const LeadingForm& form = *summary.leading_form;
  // Adds a density near 0, in units of the peak. Such a density is sensitive to the coefficients.
  const auto add_small_density_metric = [&](const char* path, double value) {
    builder.add({.path = path,
                 .value = value,
                 .kind = is_path_dependent(summary) ? Kind::work : Kind::result,
                 .min_scale = 1e-6,
                 .is_rounding_sensitive = true});
  };
  builder.result("support.least_radius", support.least_radius)
      .result("support.greatest_radius", support.greatest_radius)
      .result("support.y_max", support.y_max)
      .result("support.v_max", support.v_max);
  if (support.y_min != 0) builder.result("support.y_min", support.y_min);
  if (summary.frame) add_edge_metrics(*summary.frame, builder);
  add_small_density_metric("support.edge_density", support.edge_density);
  add_small_density_metric("support.cut_off", support.cut_off);
  builder
      .result("support.rising_share", form.rising_fraction)
      // the worst direction is arbitrary for an isotropic leading form
      .work("support.worst_direction.x1", form.worst.x1)
      .work("support.worst_direction.x2", form.worst.x2)
      .result("support.rises_from", form.negative ? base::Value() : base::Value(form.rises_from));
}

base::Value text_of(const LeadingForm& form) {
  return word(form.negative ? "negative" : "indefinite");
}

// Sign of the leading form of the density's exponent. With a confinement the leading form is
// negative for every Q_n.
base::Value leading_form(const Summary& summary) {
  if (!summary.leading_form) return {};
  if (summary.half_plane && summary.half_plane->tail == Tail::confined) return word("negative");
  return text_of(*summary.leading_form);
}

void add_branch_metrics(const Branch& branch, MetricBuilder& builder) {
  if (branch.end == BranchEnd::not_followed) {
    builder.result("branch", {});
    return;
  }
  builder.result("branch.end", word(name(branch.end))).result("branch.furthest", branch.furthest);
  if (branch.points.empty()) builder.add_empty_list("branch.points", Kind::work);
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const BranchPoint& point = branch.points[k];
    const std::string path = fmt::format("branch.points[{}].", k);
    builder.work(path + "fraction", point.fraction)
        .work(path + "norm", point.norm)
        .work(path + "smallest_singular_value", point.smallest_singular_value)
        .work(path + "determinant_sign", count_value(point.determinant_sign))
        .work(path + "falls", point.falls)
        .work(path + "fold", point.fold);
  }
}

void add_half_plane_metrics(const Summary& summary, MetricBuilder& builder) {
  const HalfPlaneSummary& half_plane = *summary.half_plane;
  builder.result("tail.kind", word(name(half_plane.tail)))
      .result("tail.level", half_plane.level)
      .result("tail.level_deviations", half_plane.level_deviations)
      .result("tail.beyond_level", half_plane.beyond_level)
      .result("tail.polynomial_leading_form", text_of(*summary.leading_form))
      .work("quadrature_change", half_plane.quadrature_change)
      .work("homotopies", count_value(half_plane.homotopies));
}

}  // namespace

transform::Metrics metrics(const Summary& summary, const transform::Moments& moments) {
  MetricBuilder builder;
  builder.result("order", count_value(summary.order))
      .result("formulation", word(name(summary.formulation)))
      .work("iterations", count_value(summary.iterations))
      .work("residual", summary.residual)
      .work("condition", optional_value(summary.condition));
  add_frame_metrics(summary, builder);
  add_coefficient_metrics(summary, moments, builder);
  add_support_metrics(summary, builder);
  builder.result("leading_form", leading_form(summary))
      .result("distance_to_previous", optional_value(summary.distance_to_previous));
  add_metrics(builder, summary.balances);
  if (summary.formulation == Formulation::gaussian) {
    builder.work("plain_newton_converges", summary.plain_newton_converges);
    builder.result("disc_sensitivity", optional_value(summary.disc_sensitivity));
    add_branch_metrics(summary.branch, builder);
  }
  if (summary.half_plane) add_half_plane_metrics(summary, builder);
  return std::move(builder).take();
}

}  // namespace fpkcheck::epc
