#include "compare/page/case_tables.hpp"

#include <fmt/format.h>

#include "compare/page/html.hpp"
#include "compare/page/number_text.hpp"
#include "compare/page/solution_columns.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

std::vector<const Json*> solutions_of(const Json& summary_case, const std::string& method = "") {
  std::vector<const Json*> solutions;
  for (const auto& solution : summary_case.at("solutions")) {
    if (method.empty() || solution.at("method") == method) solutions.push_back(&solution);
  }
  return solutions;
}

SolutionColumn distance_column(const Json& summary_case, const std::string& reference,
                               Variable variable) {
  const char* const p = variable == Variable::y ? "p(y)" : "p(y\u2032)";
  return {fmt::format("L1 to {}, {}", reference, p), [&, reference, variable](const Json& s) {
            return l1_cell(
                l1_between(summary_case, s.at("id").get<std::string>(), reference, variable));
          }};
}

// Of a mass, what tells anything is how far it is from one.
SolutionColumn mass_column() {
  return {"mass \u2212 1", [](const Json& solution) {
            const auto mass = number(solution, "mass");
            return number_text(mass ? std::optional(*mass - 1) : std::nullopt, 1);
          }};
}

SolutionColumn seconds_column() {
  return {"seconds", [](const Json& s) { return seconds_text(number(s, "seconds")); }};
}

std::string behaviour(const std::string& leading_form) {
  if (leading_form == "negative") return "falls";
  return leading_form == "indefinite" ? "rises" : leading_form;
}

std::string closures_table(const Json& summary_case) {
  const SolutionColumn polynomial{
      "Q_n in the end",
      [](const Json& s) -> std::string {
        const Json* own = value_under(s, "tail.polynomial_leading_form");
        return behaviour(own ? own->get<std::string>() : word(s, "leading_form"));
      },
      Align::left};
  // Where the exponent is confined, nothing is cut off, and the estimate is meaningless.
  const SolutionColumn cut_off{
      "probability cut off", [](const Json& s) {
        const Json* support = value_under(s, "support");
        const bool confined = value_under(s, "tail") != nullptr;
        return number_text(support && !confined ? number(*support, "cut_off") : std::nullopt, 1);
      }};
  return solutions_table(
      "Closures: equations, admissibility", solutions_of(summary_case, "epc"),
      {word_column("status", "status"), plain_column("iterations", "iterations"),
       number_column("residual", "residual", 2), number_column("condition", "condition", 2),
       polynomial, word_column("tail", "tail.kind"),
       number_column("probability beyond its level", "tail.beyond_level", 1),
       number_column("support from radius", "support.least_radius", 3),
       number_column("to", "support.greatest_radius", 3),
       number_column("edge density / peak", "support.edge_density", 1), cut_off,
       number_column("L1 to order n \u2212 2", "distance_to_previous", 2), mass_column(),

       number_column("energy residual", "energy_residual", 1)});
}

std::string finite_differences_table(const Json& summary_case) {
  const SolutionColumn grid{"grid", [](const Json& s) {
                              const auto nx = number(s, "nx"), nv = number(s, "nv");
                              return nx && nv ? fmt::format("{:g} \u00d7 {:g}", *nx, *nv)
                                              : std::string(kNoValue);
                            }};
  return solutions_table(
      "Finite differences: well-posedness, stationarity, discretisation",
      solutions_of(summary_case, "fd"),
      {word_column("status", "status"), grid, plain_column("steps", "steps"),

       number_column("residual of stationarity", "residual", 1),
       number_column("stepped against direct", "stepped_against_direct", 1),
       number_column("largest growth rate", "growth_rate", 2),
       number_column("regularisation length", "regularisation_length", 3),
       l1_column("estimated error of p(y)", "error.y_l1"),
       l1_column("of p(y\u2032)", "error.ydot_l1"),
       number_column("observed order", "error.observed_order", 2), mass_column(),
       number_column("leak", "leak", 1), number_column("least density / peak", "min_density", 1),
       number_column("energy residual", "energy_residual", 1)});
}

std::string simulation_table(const Json& summary_case) {
  return solutions_table(
      "Simulation: length, chance", solutions_of(summary_case, "mcs"),
      {word_column("status", "status"), plain_column("time", "time"),
       number_column("samples", "samples", 4),
       number_column("independent samples", "effective_samples", 3),
       l1_column("sampling L1 of p(y)", "sampling_l1.y"),
       l1_column("of p(y\u2032)", "sampling_l1.ydot"),
       number_column("standard error of E[y\u00b2]", "standard_errors.y2", 2),
       number_column("of E[y\u2032\u00b2]", "standard_errors.v2", 2),
       number_column("impacts per time", "impact_rate", 5), mass_column(),
       number_column("outside the bins", "outside", 1),
       number_column("energy residual", "energy_residual", 1),
       number_column("its standard error", "standard_errors.energy_residual", 1)});
}

}  // namespace

std::string results_table(const Json& summary_case) {
  const SolutionColumn solves{
      "solves",
      [](const Json& s) { return fmt::format("{} / {}", word(s, "equation"), word(s, "impact")); },
      Align::left};
  return solutions_table(
      "All solutions", solutions_of(summary_case),
      {solves, word_column("status", "status"), number_column("E[y]", "moments.y1", 4),
       number_column("E[y\u00b2]", "moments.y2", 4),
       number_column("E[y\u2032\u00b2]", "moments.v2", 4),
       number_column("E[y\u2074]", "moments.y4", 4),
       number_column("E[y\u2032\u2074]", "moments.v4", 4),
       distance_column(summary_case, "mcs", Variable::y),
       distance_column(summary_case, "mcs", Variable::ydot),
       distance_column(summary_case, "fd-kf", Variable::y),
       distance_column(summary_case, "fd-kf", Variable::ydot), mass_column(),
       number_column("energy residual", "energy_residual", 1), seconds_column()});
}

std::string reasons_html(const Json& summary_case) {
  std::string items;
  for (const auto& solution : summary_case.at("solutions")) {
    if (is_ok(solution)) continue;
    items += fmt::format("<li><strong>{} {}</strong>: {}.</li>\n", escaped(word(solution, "id")),
                         escaped(word(solution, "status")), escaped(word(solution, "reason")));
  }
  return items.empty() ? "" : "<ul class=\"reasons\">\n" + items + "</ul>\n";
}

std::string diagnostics_tables(const Json& summary_case) {
  return closures_table(summary_case) + finite_differences_table(summary_case) +
         simulation_table(summary_case);
}

}  // namespace fpkcheck::compare
