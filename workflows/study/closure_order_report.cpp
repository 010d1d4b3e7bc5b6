#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "workflows/study/closure_order_study.hpp"

namespace fpkcheck::study {

using base::Value;

StudyRecord make_study_record(const ClosureOrderStudyRow& row) {
  const auto& [identity, equation, impact] =
      std::tie(row.solution.identity, row.solution.identity.equation, row.solution.identity.impact);
  const auto number = [&](double of_density) {
    return row.solution.has_density() ? Value(of_density) : Value();
  };
  StudyRecord record{{"id", identity.id},
                     {"formulation", row.formulation},
                     {"order", transform::value_from_count(row.order)},
                     {"equation", equation ? Value(std::string(name(*equation))) : Value()},
                     {"impact", impact ? Value(std::string(name(*impact))) : Value()},
                     {"mass", number(row.solution.mass)},
                     {"min_density", number(row.solution.min_density)},
                     {"energy_residual", number(row.solution.energy_residual)}};
  add_status_and_distances(row.solution, row.l1, record);
  record.push_back({"tail_y", transform::value_from_optional(row.tail_y)});
  record.push_back({"tail_ydot", transform::value_from_optional(row.tail_ydot)});
  for (const auto& observation : row.solution.metrics) {
    // The study record of a closure already contains the values formulation and order.
    if (observation.path == "formulation" || observation.path == "order") continue;
    record.push_back({observation.path, observation.value});
  }
  return record;
}

std::string study_json_text(const ClosureOrderStudy& study, const std::string& command) {
  const auto& reference = study.reference;
  return study_records_to_json(ClosureOrderStudy::kName, study.problem, command,
                               {{"reference.id", reference.id()},
                                {"reference.status", std::string(name(reference.status))},
                                {"reference.reason", reference.reason},
                                {"reference.seconds", reference.seconds}},
                               {{"rows", make_study_records(study.rows)}});
}

std::string study_csv_text(const ClosureOrderStudy& study) {
  return records_csv_text(
      make_study_records(study.rows),
      "formulation order status iterations residual condition l1_y l1_ydot tail_y tail_ydot seconds");
}

namespace {

using report::wrap_text;

std::string closure_name(const ClosureOrderStudyRow& row) {
  return fmt::format("{} n = {}", row.formulation, row.order);
}

// Returns the sign of the leading form (terms of highest degree) of the exponent Q_n without the
// confinement term.
std::string leading_form_text(const ClosureOrderStudyRow& row) {
  const auto& metrics = row.solution.metrics;
  auto form = transform::metric_text(metrics, "tail.polynomial_leading_form");
  if (!form) form = transform::metric_text(metrics, "leading_form");
  if (!form) return report::kMissingCell;
  return *form == "negative" ? "falls" : "rises";
}

std::string closure_table_text(const ClosureOrderStudy& study,
                               const report::TerminalTextFormat& format) {
  const std::string l1 = "L1 to " + study.reference.id();
  auto rows = make_study_records(study.rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].push_back({"leading", leading_form_text(study.rows[k])});
    rows[k].push_back({"ms", study.rows[k].solution.seconds * 1000});
  }
  return records_table_text(rows,
                            {{"", "formulation", "formulation", "", report::kAlwaysShown, true},
                             {"", "n", "order", ""},
                             {"", "status", "status", ""},
                             {"", "steps", "iterations", "{:.0f}", 3},
                             {"", "cond.", "condition", "{:.0e}", 1},
                             {"", "residual", "residual", "{:.0e}", 4},
                             {"", "Q_n", "leading", "", 2, true},
                             {"", "edge", "support.edge_density", "{:.0e}", 2},
                             {"", "to n-2", "distance_to_previous", "{:.5f}", 1},
                             {l1, "p(y)", "l1_y", "{:.5f}"},
                             {l1, "p(y')", "l1_ydot", "{:.5f}"},
                             {"tail", "p(y)", "tail_y", "{:.2f}", 5},
                             {"tail", "p(y')", "tail_ydot", "{:.2f}", 5},
                             {"", "ms", "ms", "{:.0f}"}},
                            format);
}

std::string branch_end_text(const std::string& end) {
  if (end == "full_problem") return "reaches the full problem";
  if (end == "white_noise") return "returns to white noise at another root";
  if (end == "far_away") return "ends where its coefficients grow without bound";
  return "is lost by the continuation";
}

std::string branch_sentence(const ClosureOrderStudyRow& row, const SolutionBranch& branch) {
  std::vector<std::string> folds;
  for (const auto& point : branch.points) {
    if (point.fold) folds.push_back(fmt::format("{:.1f} %", 100 * point.fraction));
  }
  return fmt::format(
      "  {}: the branch of solutions from the exact density of white noise without impact losses "
      "{}{}, covers {:.1f} % of the way, and {}.",
      closure_name(row), folds.empty() ? "has no fold" : "folds at ", fmt::join(folds, ", "),
      100 * branch.largest_fraction, branch_end_text(branch.end));
}

// The sentence on convergence states a factor instead of a power of n, since convergent closures
// converge geometrically.
std::string convergence_rate_sentence(const ClosureOrderStudyRow& first,
                                      const ClosureOrderStudyRow& last) {
  const double steps = (last.order - first.order) / 2.0;
  const auto factor = [&](double MarginalL1Distances::*of) {
    return std::pow((*first.l1).*of / (*last.l1).*of, 1 / steps);
  };
  return fmt::format(" On average each n + 2 divides it by {:.1f} and {:.1f}.",
                     factor(&MarginalL1Distances::y), factor(&MarginalL1Distances::ydot));
}

// @param good table rows with status `ok` of one formulation, by increasing order n
std::string convergence_sentence(const std::string& formulation,
                                 const std::vector<const ClosureOrderStudyRow*>& good) {
  if (good.empty()) return fmt::format("{}: no order gives a density.", formulation);
  std::vector<std::string> orders;
  for (const ClosureOrderStudyRow* row : good) orders.push_back(std::to_string(row->order));
  const ClosureOrderStudyRow &first = *good.front(), &last = *good.back();
  std::string text = fmt::format("{} is ok at n = {}", formulation, join_with_and(orders));
  if (good.size() == 1) {
    return text + fmt::format(": L1 {:.2g} in p(y), {:.2g} in p(y').", first.l1->y, first.l1->ydot);
  }
  return text +
         fmt::format(
             "; from n = {} to {} the L1 distance changes from {:.2g} to {:.2g} in p(y) "
             "and from {:.2g} to {:.2g} in p(y').",
             first.order, last.order, first.l1->y, last.l1->y, first.l1->ydot, last.l1->ydot) +
         convergence_rate_sentence(first, last);
}

std::string convergence_text(const ClosureOrderStudy& study, std::size_t width) {
  std::string text;
  for (auto row = study.rows.begin(); row != study.rows.end();) {
    const std::string& formulation = row->formulation;
    std::vector<const ClosureOrderStudyRow*> good;
    for (; row != study.rows.end() && row->formulation == formulation; ++row) {
      if (row->solution.has_status_ok() && row->l1) good.push_back(&*row);
    }
    text += wrap_text("  " + convergence_sentence(formulation, good), width, 2);
  }
  return text;
}

constexpr const char* kLegend =
    "steps: Newton steps, summed over all orders and attempts. cond.: condition number of Newton's "
    "matrix in scaled functions. residual: largest residual of the equations relative to the "
    "damping c. Q_n: falls in every direction at infinity, or rises in some. edge: largest density "
    "on the edge of the support relative to the peak. to n-2: sum of the L1 distances of both "
    "marginals to those of order n-2. L1: integral of |p - reference|. tail: mean "
    "|log10 p - log10 reference| over reference densities 1e-5 .. 1e-4. ms: wall-clock time.";

}  // namespace

std::string study_table_text(const ClosureOrderStudy& study,
                             const report::TerminalTextFormat& format) {
  const std::size_t width = format.width;
  std::string text =
      wrap_text(report::case_title(study.problem), width, 2) + closure_table_text(study, format);
  for (const auto& row : study.rows)
    text += status_reason_text(closure_name(row), row.solution, width);
  text += status_reason_text(fmt::format("The reference {} is", study.reference.id()),
                             study.reference, width);
  for (const auto& row : study.rows) {
    const auto followed = read_solution_branch(row.solution.metrics);
    if (followed) text += wrap_text(branch_sentence(row, *followed), width, 4);
  }
  return text + convergence_text(study, width) + '\n' + wrap_text(kLegend, width);
}

}  // namespace fpkcheck::study
