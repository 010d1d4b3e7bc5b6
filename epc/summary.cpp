#include <string_view>

#include "epc/solve.hpp"
#include "problem/saved_fields.hpp"

namespace fpkcheck::epc {

namespace moment {
static std::string_view name(Tail tail) { return tail == Tail::confined ? "confined" : "cut"; }
}  // namespace moment

static std::string_view name(MonomialSet set) {
  return set == MonomialSet::general ? "general" : "point_symmetric";
}

namespace {

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

std::string_view name(const LeadingForm& form) { return form.negative ? "negative" : "indefinite"; }

// Of the density's exponent: a confinement makes it negative whatever Q_n does.
Json leading_form(const Summary& summary) {
  if (!summary.leading_form) return nullptr;
  if (summary.moment && summary.moment->tail == moment::Tail::confined) return "negative";
  return name(*summary.leading_form);
}

void add_moment_fields(const Summary& summary, Json& json) {
  if (!summary.moment) return;
  const MomentSummary& own = *summary.moment;
  json["tail"] = {{"kind", name(own.tail)},
                  {"level", own.level},
                  {"level_deviations", own.level_deviations},
                  {"beyond_level", own.beyond_level},
                  {"polynomial_leading_form", name(*summary.leading_form)}};
  json["quadrature_change"] = own.quadrature_change;
  json["homotopies"] = own.homotopies;
}

std::string_view name(BranchEnd end) {
  switch (end) {
    case BranchEnd::not_followed:
      return "not_followed";
    case BranchEnd::full_problem:
      return "full_problem";
    case BranchEnd::white_noise:
      return "white_noise";
    case BranchEnd::far_away:
      return "far_away";
    case BranchEnd::lost:
      return "lost";
  }
  return "";
}

Json branch(const Branch& branch) {
  if (branch.end == BranchEnd::not_followed) return nullptr;
  Json points = Json::array();
  for (const BranchPoint& point : branch.points) {
    points.push_back({{"fraction", point.fraction},
                      {"norm", point.norm},
                      {"smallest_singular_value", point.smallest_singular_value},
                      {"determinant_sign", point.determinant_sign},
                      {"falls", point.falls},
                      {"fold", point.fold}});
  }
  return {{"end", name(branch.end)}, {"furthest", branch.furthest}, {"points", points}};
}

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

void add_gaussian_fields(const Summary& summary, Json& json) {
  if (summary.formulation != Formulation::gaussian) return;
  json["disc_sensitivity"] = number_or_null(summary.disc_sensitivity);
  json["branch"] = branch(summary.branch);
}

}  // namespace

nlohmann::ordered_json to_json(const Summary& summary) {
  Json json{{"order", summary.order},
            {"formulation", name(summary.formulation)},
            {"iterations", summary.iterations},
            {"residual", summary.residual},
            {"condition", number_or_null(summary.condition)},
            {"coefficients", coefficients(summary.coefficients)},
            {"support", support(summary)},
            {"leading_form", leading_form(summary)},
            {"distance_to_previous", number_or_null(summary.distance_to_previous)}};
  add_gaussian_fields(summary, json);
  add_moment_fields(summary, json);
  return json;
}

nlohmann::ordered_json to_json(const Options& options) {
  return {{"order", options.order},
          {"formulation", name(options.formulation)},
          {"monomials", name(options.monomials)},
          {"equation", name(options.equation)},
          {"tail", name(options.tail)},
          {"tolerance", options.tolerance},
          {"max_iterations", options.max_iterations}};
}

Options options_from_json(const nlohmann::ordered_json& json) {
  problem::SavedFields saved(json, "options");
  const Options options{
      .order = saved.integer("order"),
      .formulation = saved.choice("formulation",
                                  {Formulation::gaussian, Formulation::moment, Formulation::polar}),
      .monomials = saved.choice("monomials", {MonomialSet::point_symmetric, MonomialSet::general}),
      .equation = saved.choice("equation", {Equation::white, Equation::km4, Equation::kf}),
      .tail = saved.choice("tail", {moment::Tail::confined, moment::Tail::cut}),
      .tolerance = saved.number("tolerance"),
      .max_iterations = saved.integer("max_iterations")};
  saved.require_all_read();
  return options;
}

}  // namespace fpkcheck::epc
