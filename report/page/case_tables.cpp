#include "report/page/case_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "report/page/family_tables.hpp"
#include "report/page/html.hpp"
#include "report/page/number_text.hpp"
#include "report/page/plot.hpp"
#include "report/reasons.hpp"
#include "report/references.hpp"
#include "report/rest.hpp"
#include "report/text/outward.hpp"

namespace fpkcheck::report {
namespace {

using transform::Moments;
using transform::Solution;
using transform::Variable;

constexpr std::pair<const char*, double Moments::*> kShownMoments[] = {
    {"E[y]", &Moments::y1},
    {"E[y\u00b2]", &Moments::y2},
    {"E[y\u2032\u00b2]", &Moments::v2},
    {"E[y\u2074]", &Moments::y4},
    {"E[y\u2032\u2074]", &Moments::v4}};

/// A table with a row for each solution; each call adds a column.
class SolutionsTable {
 public:
  explicit SolutionsTable(const results::Case& one) : one_(one) {
    add_text("solution", &Solution::id);
  }

  void add_text(const std::string& header,
                const std::function<std::string(const Solution&)>& cell) {
    columns_.push_back({header, Align::left});
    for (const auto& s : one_.solutions) {
      // The list entry with the reason replaces the row.
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
    columns_.back().align = Align::right;
  }
  /// Adds a number that exists only for a density.
  void add_of_density(const std::string& header, int digits,
                      const std::function<double(const Solution&)>& number) {
    add_number(header, [&](const Solution& s) {
      return s.has_density() ? number_text(number(s), digits) : std::string(kNoValue);
    });
  }
  void add_mass_and_energy() {
    // Only the deviation from 1 is informative.
    add_of_density("mass \u2212 1", 1, [](const Solution& s) { return s.mass - 1; });
    add_of_density("energy residual", 1, [](const Solution& s) { return s.energy_residual; });
  }

  std::string html(const std::string& caption) && {
    return table_html(caption, std::move(columns_));
  }

 private:
  const results::Case& one_;
  std::vector<HtmlColumn> columns_;
};

// A number from a part that some solutions lack.
template <class Part, class Number>
std::optional<double> of(const std::optional<Part>& part, const Number& number) {
  if (!part) return std::nullopt;
  return std::invoke(number, *part);
}

}  // namespace

std::string results_table(const results::Case& one) {
  SolutionsTable table(one);
  table.add_text("solves", [](const Solution& s) { return solves_text(s.identity); });
  table.add_status();
  for (const auto& [header, member] : kShownMoments) {
    table.add_of_density(header, 4,
                         [member = member](const Solution& s) { return s.moments.*member; });
  }
  for (const double wall : walls_of_rest(one)) {
    table.add_of_density(rest_header(one, wall), 4,
                         [wall](const Solution& s) { return probability_of_rest(s, wall); });
  }
  for (const Solution* measure : references(one)) {
    for (const Variable variable : transform::kVariables) {
      table.add_number(
          fmt::format("L1 to {}, {}", measure->id(), density_text(variable)),
          [&](const Solution& s) { return l1_cell(one.l1(s.id(), measure->id(), variable)); });
    }
  }
  table.add_mass_and_energy();
  table.add_number("seconds", [](const Solution& s) { return seconds_text(s.seconds); });
  return std::move(table).html("All solutions");
}

std::string own_errors_table(const results::Case& one) {
  if (one.own_errors.empty()) return "";
  SolutionsTable table(one);
  for (const auto& [header, member] : kShownMoments) {
    table.add_number(header, [&one, member = member](const Solution& s) {
      const auto* own = one.own_error(s.id());
      return own == nullptr ? std::string(kNoValue) : number_text(own->error.*member, 2);
    });
  }
  return std::move(table).html("Errors of moments, estimated from residuals");
}

std::string moment_errors_table(const results::Case& one) {
  if (!one.bounds || one.bounds->each.empty()) return "";
  SolutionsTable table(one);
  for (const auto& [header, member] : kShownMoments) {
    const compare::Bound* bound = compare::bound_of(*one.bounds, member);
    if (bound == nullptr) continue;
    const auto [lower, upper] = outward(bound->lower, bound->upper);
    const auto error = [&, member = member](const Solution& s) -> std::string {
      const double value = s.moments.*member;
      if (!s.has_density() || !std::isfinite(value)) return std::string(kNoValue);
      if (bound->lower <= value && value <= bound->upper) return "within";
      return number_text(value - (bound->lower + bound->half_width()), 2);
    };
    table.add_number(fmt::format("{} in [{}, {}]", header, lower, upper), error);
  }
  return std::move(table).html("Errors of moments, from the guaranteed bounds");
}

std::string reasons_html(const results::Case& one) {
  std::string items;
  for (const auto& [solutions, status, reason] : reasons(one)) {
    items += fmt::format("<li><strong>{} {}</strong>: {}.</li>\n",
                         escaped(fmt::format("{}", fmt::join(solutions, ", "))), name(status),
                         escaped(reason));
  }
  return items.empty() ? "" : "<ul class=\"reasons\">\n" + items + "</ul>\n";
}

std::string diagnostics_tables(const results::Case& one) {
  using transform::StandardErrors;
  SolutionsTable table(one);
  table.add_status();
  table.add_of_density("minimum density / peak", 1,
                       [](const Solution& s) { return s.min_density; });
  table.add_mass_and_energy();
  table.add_number("standard error of the energy residual", [](const Solution& s) {
    return number_text(of(s.standard_errors, &StandardErrors::energy_residual), 1);
  });
  table.add_number("error estimate of p(y), L1", [](const Solution& s) {
    return l1_cell(of(s.error, &transform::StatedError::y_l1));
  });
  table.add_number("error estimate of p(y\u2032), L1", [](const Solution& s) {
    return l1_cell(of(s.error, &transform::StatedError::ydot_l1));
  });
  table.add_number("sampling error of p(y), L1", [](const Solution& s) {
    return l1_cell(s.sampling ? s.sampling->y : std::nullopt);
  });
  table.add_number("sampling error of p(y\u2032), L1", [](const Solution& s) {
    return l1_cell(s.sampling ? s.sampling->ydot : std::nullopt);
  });
  table.add_number("sampling error of p(y), smooth bins", [](const Solution& s) {
    return l1_cell(s.smooth_sampling ? s.smooth_sampling->y : std::nullopt);
  });
  table.add_number("sampling error of p(y\u2032), smooth bins", [](const Solution& s) {
    return l1_cell(s.smooth_sampling ? s.smooth_sampling->ydot : std::nullopt);
  });
  table.add_number("standard error of E[y\u00b2]", [](const Solution& s) {
    return number_text(of(s.standard_errors, [](const auto& e) { return e.moments.y2; }), 2);
  });
  table.add_number("standard error of E[y\u2032\u00b2]", [](const Solution& s) {
    return number_text(of(s.standard_errors, [](const auto& e) { return e.moments.v2; }), 2);
  });
  return std::move(table).html("Mass, energy and error estimates") + family_tables(one);
}

}  // namespace fpkcheck::report
