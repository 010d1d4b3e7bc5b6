#include "report/page/page_sections.hpp"

#include "report/figure/script_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "report/case_solutions.hpp"
#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Moments;
using transform::Solution;
using transform::StateVariable;

constexpr std::pair<const char*, double Moments::*> kShownMoments[] = {
    {"E[y]", &Moments::y1},
    {"E[y\u00b2]", &Moments::y2},
    {"E[y\u2032\u00b2]", &Moments::v2},
    {"E[y\u2074]", &Moments::y4},
    {"E[y\u2032\u2074]", &Moments::v4}};

class SolutionsHtmlTable {
 public:
  explicit SolutionsHtmlTable(const results::CaseResult& case_result) : case_result_(case_result) {
    add_text("solution", &Solution::id);
  }

  void add_text(const std::string& header,
                const std::function<std::string(const Solution&)>& cell) {
    columns_.push_back({header, TextAlignment::left});
    for (const auto& s : case_result_.solutions) {
      // Solutions with the status `not_offered` have no table row, but an entry in the list of
      // reasons.
      if (s.status != transform::Status::not_offered) columns_.back().cells.push_back(cell(s));
    }
  }
  void add_status() {
    add_text("status", [](const Solution& s) { return std::string(name(s.status)); });
    columns_.back().is_status = true;
  }

  void add_number(const std::string& header,
                  const std::function<std::string(const Solution&)>& cell) {
    add_text(header, cell);
    columns_.back().align = TextAlignment::right;
  }
  void add_density_number(const std::string& header, int digits,
                          const std::function<double(const Solution&)>& number) {
    add_number(header, [&](const Solution& s) {
      return s.has_density() ? number_text(number(s), digits) : std::string(kNoValue);
    });
  }
  void add_mass_and_energy() {
    add_density_number("mass \u2212 1", 1, [](const Solution& s) { return s.mass - 1; });
    add_density_number("energy residual", 1, [](const Solution& s) { return s.energy_residual; });
  }

  std::string html(const std::string& caption) && {
    return table_html(caption, std::move(columns_));
  }

 private:
  const results::CaseResult& case_result_;
  std::vector<HtmlTableColumn> columns_;
};

template <class Part, class Number>
std::optional<double> optional_number(const std::optional<Part>& part, const Number& number) {
  if (!part) return std::nullopt;
  return std::invoke(number, *part);
}

}  // namespace

std::string solutions_table_html(const results::CaseResult& case_result) {
  SolutionsHtmlTable table(case_result);
  table.add_text("solves", [](const Solution& s) { return equation_and_impact_text(s.identity); });
  table.add_status();
  for (const auto& [header, member] : kShownMoments) {
    table.add_density_number(header, 4,
                             [moment = member](const Solution& s) { return s.moments.*moment; });
  }
  for (const double wall : walls_with_rest_atoms(case_result)) {
    table.add_density_number(rest_probability_header(case_result, wall), 4,
                             [wall](const Solution& s) { return rest_atom_probability(s, wall); });
  }
  for (const Solution* reference : solutions_of_full_problem(case_result)) {
    for (const StateVariable variable : transform::kVariables) {
      table.add_number(
          fmt::format("L1 to {}, {}", reference->id(), density_in_plain_text(variable)),
          [&](const Solution& s) {
            return l1_distance_cell_text(
                case_result.l1_distance(s.id(), reference->id(), variable));
          });
    }
  }
  table.add_mass_and_energy();
  table.add_number("seconds", [](const Solution& s) { return seconds_text(s.seconds); });
  return std::move(table).html("All solutions");
}

std::string residual_errors_table_html(const results::CaseResult& case_result) {
  if (case_result.moment_error_estimates.empty()) return "";
  SolutionsHtmlTable table(case_result);
  for (const auto& [header, member] : kShownMoments) {
    table.add_number(header, [&case_result, moment = member](const Solution& s) {
      const auto* estimate = case_result.moment_error_estimate(s.id());
      return estimate == nullptr ? std::string(kNoValue) : number_text(estimate->error.*moment, 2);
    });
  }
  return std::move(table).html("Errors of moments, estimated from residuals");
}

std::string guaranteed_bound_errors_table_html(const results::CaseResult& case_result) {
  if (!case_result.bounds || case_result.bounds->each.empty()) return "";
  SolutionsHtmlTable table(case_result);
  for (const auto& [header, member] : kShownMoments) {
    const compare::GuaranteedBound* bound = compare::find_moment_bound(*case_result.bounds, member);
    if (bound == nullptr) continue;
    const auto [lower, upper] = round_interval_outward(bound->lower, bound->upper);
    const auto error = [&, moment = member](const Solution& s) -> std::string {
      const double value = s.moments.*moment;
      if (!s.has_density() || !std::isfinite(value)) return std::string(kNoValue);
      if (bound->lower <= value && value <= bound->upper) return "within";
      return number_text(value - (bound->lower + bound->half_width()), 2);
    };
    table.add_number(fmt::format("{} in [{}, {}]", header, lower, upper), error);
  }
  return std::move(table).html("Errors of moments, from the guaranteed bounds");
}

std::string status_reasons_html(const results::CaseResult& case_result) {
  std::string items;
  for (const auto& [solutions, status, reason] : group_status_reasons(case_result)) {
    items += fmt::format("<li><strong>{} {}</strong>: {}.</li>\n",
                         escape_html(fmt::format("{}", fmt::join(solutions, ", "))), name(status),
                         escape_html(reason));
  }
  return items.empty() ? "" : "<ul class=\"reasons\">\n" + items + "</ul>\n";
}

std::string diagnostics_tables_html(const results::CaseResult& case_result) {
  using transform::MomentStandardErrors;
  SolutionsHtmlTable table(case_result);
  table.add_status();
  table.add_density_number("minimum density / peak", 1,
                           [](const Solution& s) { return s.min_density; });
  table.add_mass_and_energy();
  table.add_number("standard error of the energy residual", [](const Solution& s) {
    return number_text(optional_number(s.standard_errors, &MomentStandardErrors::energy_residual),
                       1);
  });
  const auto add_l1 = [&](const std::string& header, auto part, auto l1) {
    table.add_number(header, [part, l1](const Solution& s) {
      return l1_distance_cell_text(optional_number(s.*part, l1));
    });
  };
  using transform::ErrorEstimate;
  using transform::MarginalSamplingErrors;
  add_l1("error estimate of p(y), L1", &Solution::error, &ErrorEstimate::y_l1);
  add_l1("error estimate of p(y\u2032), L1", &Solution::error, &ErrorEstimate::ydot_l1);
  add_l1("sampling error of p(y), L1", &Solution::sampling, &MarginalSamplingErrors::y);
  add_l1("sampling error of p(y\u2032), L1", &Solution::sampling, &MarginalSamplingErrors::ydot);
  add_l1("sampling error of p(y), smooth bins", &Solution::smooth_sampling,
         &MarginalSamplingErrors::y);
  add_l1("sampling error of p(y\u2032), smooth bins", &Solution::smooth_sampling,
         &MarginalSamplingErrors::ydot);
  table.add_number("standard error of E[y\u00b2]", [](const Solution& s) {
    return number_text(
        optional_number(s.standard_errors, [](const auto& e) { return e.moments.y2; }), 2);
  });
  table.add_number("standard error of E[y\u2032\u00b2]", [](const Solution& s) {
    return number_text(
        optional_number(s.standard_errors, [](const auto& e) { return e.moments.v2; }), 2);
  });
  return std::move(table).html("Mass, energy and error estimates") +
         metric_tables_html(case_result);
}

}  // namespace fpkcheck::report
