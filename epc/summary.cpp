#include <string_view>

#include "epc/solve.hpp"

namespace fpkcheck::epc {
namespace {

std::string_view name(Formulation formulation) {
  switch (formulation) {
    case Formulation::gaussian:
      return "gaussian";
  }
  return "";
}

using Json = nlohmann::ordered_json;

Json coefficients(const std::vector<Term>& terms) {
  Json list = Json::array();
  for (const auto& [p, q, a] : terms) list.push_back({{"x1", p}, {"x2", q}, {"a", a}});
  return list;
}

Json support(const Summary& summary) {
  if (!summary.support || !summary.leading_form) return nullptr;
  const SupportSummary& support = *summary.support;
  const LeadingForm& form = *summary.leading_form;
  return {{"least_radius", support.least_radius},
          {"greatest_radius", support.greatest_radius},
          {"y_max", support.y_max},
          {"v_max", support.v_max},
          {"edge_density", support.edge_density},
          {"cut_off", support.cut_off},
          {"rising_share", form.rising_share},
          {"worst_direction", {{"x1", form.worst.x1}, {"x2", form.worst.x2}}},
          {"rises_from", form.negative ? Json(nullptr) : Json(form.rises_from)}};
}

Json leading_form(const Summary& summary) {
  if (!summary.leading_form) return nullptr;
  return summary.leading_form->negative ? "negative" : "indefinite";
}

}  // namespace

nlohmann::ordered_json to_json(const Summary& summary) {
  return {{"order", summary.order},
          {"formulation", name(summary.formulation)},
          {"iterations", summary.iterations},
          {"residual", summary.residual},
          {"coefficients", coefficients(summary.coefficients)},
          {"support", support(summary)},
          {"leading_form", leading_form(summary)}};
}

nlohmann::ordered_json to_json(const Options& options) {
  return {{"order", options.order},
          {"formulation", name(options.formulation)},
          {"monomials", options.monomials == MonomialSet::general ? "general" : "point_symmetric"},
          {"equation", options.equation == Equation::white ? "white" : "km4"},
          {"tolerance", options.tolerance},
          {"max_iterations", options.max_iterations}};
}

}  // namespace fpkcheck::epc
