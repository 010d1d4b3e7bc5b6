#include "epc/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace fpkcheck::epc {
namespace {

using transform::counted;
using transform::Kind;
using transform::Observer;
using transform::value_of;

base::Value word(std::string_view text) { return std::string(text); }

// At high orders of the formulation moment the quadrature points depend on the path of the search,
// and so do the last digits of the solution.
bool depends_on_path(const Summary& summary) {
  constexpr int kSettledOrder = 8;
  return summary.formulation == Formulation::moment && summary.order > kSettledOrder;
}

// Scale below which a change of the coefficient of x1^p x2^q is rounding. The effect of a unit
// coefficient on the density, relative to the peak, is
// sigma_1^p sigma_2^q max |x|^p exp(-x^2/2) max |x|^q exp(-x^2/2). Relative tolerance: kRelative.
double least_scale(const Term& term, const transform::Moments& moments, double rounding) {
  constexpr double kRelative = 50e-8;
  if (!(moments.y2 > 0) || !(moments.v2 > 0)) return 0;
  const auto summit = [](int p) { return p == 0 ? 1 : std::pow(p / std::numbers::e, p / 2.0); };
  const double effect = std::pow(moments.y2, term.x1 / 2.0) * std::pow(moments.v2, term.x2 / 2.0) *
                        summit(term.x1) * summit(term.x2);
  return rounding / (effect * kRelative);
}

// Parameters that, with the coefficients, define the density for read_closed_form. They follow from
// the coefficients and the problem: a repeated run need not reproduce them. Earlier files lack
// them.
void observe_frame(const Summary& summary, Observer& observer) {
  if (!summary.frame) return;
  observer.text("coordinates", word(name(summary.frame->variables)))
      .work("log_C", value_of(summary.frame->log_constant));
  const problem::Frame& coordinates = summary.frame->coordinates;
  if (coordinates.is_identity()) return;
  observer.work("frame.origin", coordinates.origin).work("frame.mirrored", coordinates.mirrored);
}

// Parameters of the edge of the support.
void observe_edge(const Frame& frame, Observer& observer) {
  if (frame.deviations) {
    observer.work("support.sigma1", frame.deviations->x1)
        .work("support.sigma2", frame.deviations->x2);
  } else {
    observer.work("support.energy", frame.support);
  }
}

void observe_coefficients(const Summary& summary, const transform::Moments& moments,
                          Observer& observer) {
  constexpr double kRounding = 1e-14, kPathRounding = 3e-9;  // relative to the density's peak
  if (summary.coefficients.empty()) observer.empty_list("coefficients");
  const double rounding = depends_on_path(summary) ? kPathRounding : kRounding;
  for (std::size_t k = 0; k < summary.coefficients.size(); ++k) {
    const Term& term = summary.coefficients[k];
    const std::string path = fmt::format("coefficients[{}].", k);
    observer.result(path + "x1", counted(term.x1))
        .result(path + "x2", counted(term.x2))
        .add({.path = path + "a",
              .value = term.a,
              .kind = Kind::coefficient,
              .least_scale = least_scale(term, moments, rounding)});
  }
}

void observe_support(const Summary& summary, Observer& observer) {
  if (!summary.support || !summary.leading_form) {
    observer.result("support", {});
    return;
  }
  const SupportSummary& support = *summary.support;
  const LeadingForm& form = *summary.leading_form;
  // A density near 0, in units of the peak, which is sensitive to the coefficients.
  const auto observe_faint = [&](const char* path, double value) {
    observer.add({.path = path,
                  .value = value,
                  .kind = depends_on_path(summary) ? Kind::work : Kind::result,
                  .least_scale = 1e-6,
                  .delicate = true});
  };
  observer.result("support.least_radius", support.least_radius)
      .result("support.greatest_radius", support.greatest_radius)
      .result("support.y_max", support.y_max)
      .result("support.v_max", support.v_max);
  if (support.y_min != 0) observer.result("support.y_min", support.y_min);
  if (summary.frame) observe_edge(*summary.frame, observer);
  observe_faint("support.edge_density", support.edge_density);
  observe_faint("support.cut_off", support.cut_off);
  observer
      .result("support.rising_share", form.rising_share)
      // arbitrary for an isotropic leading form
      .work("support.worst_direction.x1", form.worst.x1)
      .work("support.worst_direction.x2", form.worst.x2)
      .result("support.rises_from", form.negative ? base::Value() : base::Value(form.rises_from));
}

base::Value text_of(const LeadingForm& form) {
  return word(form.negative ? "negative" : "indefinite");
}

// Leading form of the density's exponent: a confinement makes it negative for every Q_n.
base::Value leading_form(const Summary& summary) {
  if (!summary.leading_form) return {};
  if (summary.half_plane && summary.half_plane->tail == Tail::confined) return word("negative");
  return text_of(*summary.leading_form);
}

void observe_branch(const Branch& branch, Observer& observer) {
  if (branch.end == BranchEnd::not_followed) {
    observer.result("branch", {});
    return;
  }
  observer.result("branch.end", word(name(branch.end))).result("branch.furthest", branch.furthest);
  if (branch.points.empty()) observer.empty_list("branch.points", Kind::work);
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const BranchPoint& point = branch.points[k];
    const std::string path = fmt::format("branch.points[{}].", k);
    observer.work(path + "fraction", point.fraction)
        .work(path + "norm", point.norm)
        .work(path + "smallest_singular_value", point.smallest_singular_value)
        .work(path + "determinant_sign", counted(point.determinant_sign))
        .work(path + "falls", point.falls)
        .work(path + "fold", point.fold);
  }
}

void observe_half_plane(const Summary& summary, Observer& observer) {
  const HalfPlaneSummary& own = *summary.half_plane;
  observer.result("tail.kind", word(name(own.tail)))
      .result("tail.level", own.level)
      .result("tail.level_deviations", own.level_deviations)
      .result("tail.beyond_level", own.beyond_level)
      .result("tail.polynomial_leading_form", text_of(*summary.leading_form))
      .work("quadrature_change", own.quadrature_change)
      .work("homotopies", counted(own.homotopies));
}

}  // namespace

transform::Observations observations(const Summary& summary, const transform::Moments& moments) {
  Observer observer;
  observer.result("order", counted(summary.order))
      .result("formulation", word(name(summary.formulation)))
      .work("iterations", counted(summary.iterations))
      .work("residual", summary.residual)
      .work("condition", value_of(summary.condition));
  observe_frame(summary, observer);
  observe_coefficients(summary, moments, observer);
  observe_support(summary, observer);
  observer.result("leading_form", leading_form(summary))
      .result("distance_to_previous", value_of(summary.distance_to_previous));
  observe(observer, summary.balances);
  if (summary.formulation == Formulation::gaussian) {
    observer.work("plain_newton_converges", summary.plain_newton_converges);
    observer.result("disc_sensitivity", value_of(summary.disc_sensitivity));
    observe_branch(summary.branch, observer);
  }
  if (summary.half_plane) observe_half_plane(summary, observer);
  return std::move(observer).take();
}

}  // namespace fpkcheck::epc
