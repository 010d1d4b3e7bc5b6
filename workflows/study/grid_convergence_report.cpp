#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "transform/solver_metric.hpp"
#include "workflows/study/grid_convergence_study.hpp"

namespace fpkcheck::study {

using base::Value;
using transform::Moments;
using transform::ObservedConvergenceOrders;
using transform::value_from_count;

StudyRecord make_study_record(const GridStudyRow& row) {
  StudyRecord record{
      {"order", value_from_count(row.order)}, {"level", value_from_count(row.level)},
      {"refinement", row.refinement},         {"nx", value_from_count(row.nx)},
      {"nv", value_from_count(row.nv)},       {"origin_refinement", row.origin_refinement}};
  add_status_and_distances(row.solution, row.l1, record);
  record.push_back(
      {"observed_order.l1", optional_member_value(row.observed, &ObservedConvergenceOrders::l1)});
  record.push_back(
      {"observed_order.y2", optional_member_value(row.observed, &ObservedConvergenceOrders::y2)});
  record.push_back(
      {"observed_order.v2", optional_member_value(row.observed, &ObservedConvergenceOrders::v2)});
  record.push_back({"y2", row.density ? Value(row.density->moments.y2) : Value()});
  record.push_back({"v2", row.density ? Value(row.density->moments.v2) : Value()});
  return record;
}

StudyRecord make_study_record(const RichardsonLimit& limit) {
  StudyRecord record{{"order", value_from_count(limit.order)},
                     {"l1_y", optional_member_value(limit.l1, &MarginalL1Distances::y)},
                     {"l1_ydot", optional_member_value(limit.l1, &MarginalL1Distances::ydot)}};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    if (moment == &Moments::v1) continue;  // E[y'] = 0 for every stationary density
    const bool known = limit.density.has_value();
    record.push_back({name, known ? Value(limit.density->moments.*moment) : Value()});
    record.push_back({fmt::format("{}_error", name), known ? Value(limit.error.*moment) : Value()});
  }
  return record;
}

StudyRecord make_study_record(const ComparedMethodRow& row) {
  const auto& identity = row.solution.identity;
  StudyRecord record{
      {"id", identity.id},
      {"method", identity.method},
      {"formulation", identity.formulation.empty() ? Value() : Value(identity.formulation)},
      {"order", identity.order ? value_from_count(*identity.order) : Value()}};
  add_status_and_distances(row.solution, row.l1, record);
  const auto& sampling = row.solution.sampling;
  if (!sampling) {
    record.push_back({"sampling_l1", {}});
    return record;
  }
  record.push_back({"sampling_l1.y", transform::value_from_optional(sampling->y)});
  record.push_back({"sampling_l1.ydot", transform::value_from_optional(sampling->ydot)});
  record.push_back({"sampling_l1.y_99", transform::value_from_optional(sampling->y_99)});
  record.push_back({"sampling_l1.ydot_99", transform::value_from_optional(sampling->ydot_99)});
  return record;
}

std::string study_json_text(const GridStudy& study, const std::string& command) {
  const RichardsonLimit& reference_richardson_limit = study.reference_richardson_limit();
  return study_records_to_json(
      GridStudy::kName, study.problem, command,
      {{"equation", std::string(problem::name(*study.grids.equation))},
       {"impact", std::string(problem::name(*study.grids.impact))},
       {"ratio", transform::kRefinementRatio},
       {"truth.order", reference_richardson_limit.failure.empty()
                           ? value_from_count(reference_richardson_limit.order)
                           : Value()},
       {"truth.reason", reference_richardson_limit.failure},
       {"truth.known_to.y", optional_member_value(study.limit_accuracy, &MarginalL1Distances::y)},
       {"truth.known_to.ydot",
        optional_member_value(study.limit_accuracy, &MarginalL1Distances::ydot)}},
      {{"limits", make_study_records(study.limits)},
       {"rows", make_study_records(study.rows)},
       {"others", make_study_records(study.others)}});
}

std::string study_csv_text(const GridStudy& study) {
  auto rows = make_study_records(study.rows);
  for (auto& row : rows) row.push_back({"id", study.grids.id});
  for (const auto& other : study.others) rows.push_back(make_study_record(other));
  return records_csv_text(
      rows, "id order level nx nv status l1_y l1_ydot observed_order=observed_order.l1 seconds");
}

namespace {

using report::wrap_text;

constexpr const char* kL1 = "L1 to the limit";
constexpr const char* kObserved = "observed order";
constexpr const char* kLimit = "Richardson limit";

std::string milliseconds_text(double seconds) {
  return fmt::format("{:.{}f}", seconds * 1000, seconds < 0.01 ? 1 : 0);
}

std::string cell_count_text(const GridStudyRow& row) {
  return fmt::format("{} x {}", row.nx, row.nv);
}

template <class Row>
std::vector<StudyRecord> records_with_times(const std::vector<Row>& rows) {
  auto all = make_study_records(rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    all[k].push_back({"ms", milliseconds_text(rows[k].solution.seconds)});
  }
  return all;
}

std::string grid_table_text(const GridStudy& study, const report::TerminalTextFormat& format) {
  auto rows = records_with_times(study.rows);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].push_back({"cells", cell_count_text(study.rows[k])});
  return records_table_text(rows,
                            {{"", "order", "order", ""},
                             {"", "cells", "cells", ""},
                             {"", "status", "status", ""},
                             {kL1, "p(y)", "l1_y", "{:.1e}"},
                             {kL1, "p(y')", "l1_ydot", "{:.1e}"},
                             {kObserved, "L1", "observed_order.l1", "{:.1f}"},
                             {kObserved, "E[y^2]", "observed_order.y2", "{:.1f}", 1},
                             {kObserved, "E[y'^2]", "observed_order.v2", "{:.1f}", 1},
                             {"", "ms", "ms", ""}},
                            format);
}

std::string richardson_limit_table_text(const GridStudy& study,
                                        const report::TerminalTextFormat& format) {
  return records_table_text(make_study_records(study.limits),
                            {{kLimit, "order", "order", ""},
                             {kLimit, "E[y^2]", "y2", "{:.8g}"},
                             {kLimit, "+-", "y2_error", "{:.0e}", 1},
                             {kLimit, "E[y'^2]", "v2", "{:.8g}"},
                             {kLimit, "+-", "v2_error", "{:.0e}", 1},
                             {kLimit, "E[y^4]", "y4", "{:.7g}", 2},
                             {kLimit, "E[y'^4]", "v4", "{:.7g}", 2},
                             {kL1, "p(y)", "l1_y", "{:.1e}"},
                             {kL1, "p(y')", "l1_ydot", "{:.1e}"}},
                            format);
}

std::string compared_method_table_text(const GridStudy& study,
                                       const report::TerminalTextFormat& format) {
  if (study.others.empty()) return "";
  return '\n' + records_table_text(records_with_times(study.others),
                                   {{"", "other methods", "id", "", report::kAlwaysShown, true},
                                    {"", "status", "status", ""},
                                    {kL1, "p(y)", "l1_y", "{:.1e}"},
                                    {kL1, "p(y')", "l1_ydot", "{:.1e}"},
                                    {"", "ms", "ms", ""}},
                                   format);
}

std::string row_name(const GridStudyRow& row) {
  return fmt::format("order {} on {} cells", row.order, cell_count_text(row));
}
std::string row_name(const ComparedMethodRow& row) { return row.solution.id(); }

struct TimedMethod {
  std::string name;
  double seconds;
};

template <class Row>
void update_fastest(const Row& row, double accuracy, std::optional<TimedMethod>& best) {
  if (!row.solution.has_status_ok() || !row.l1 || !(std::max(row.l1->y, row.l1->ydot) <= accuracy))
    return;
  if (!best || row.solution.seconds < best->seconds) best = {row_name(row), row.solution.seconds};
}

std::string fastest_method_sentence(const GridStudy& study, double accuracy) {
  std::optional<TimedMethod> grid, closure, simulation;
  for (const auto& row : study.rows) update_fastest(row, accuracy, grid);
  for (const auto& row : study.others) {
    const bool simulated = row.solution.identity.role == transform::SolutionRole::simulation;
    update_fastest(row, accuracy, simulated ? simulation : closure);
  }
  if (grid) grid->name = "finite volumes of " + grid->name;
  std::vector<TimedMethod> ways;
  for (const auto& found : {grid, closure, simulation}) {
    if (found) ways.push_back(*found);
  }
  if (ways.empty()) return "";
  std::ranges::sort(ways, {}, &TimedMethod::seconds);
  std::vector<std::string> parts;
  for (const auto& way : ways) {
    parts.push_back(fmt::format("{} in {} ms", way.name, milliseconds_text(way.seconds)));
  }
  return fmt::format("  Fastest to L1 {:.0e} in both marginals: {}.", accuracy,
                     fmt::join(parts, "; "));
}

std::string limit_accuracy_sentence(const GridStudy& study) {
  const RichardsonLimit& reference_richardson_limit = study.reference_richardson_limit();
  if (!reference_richardson_limit.failure.empty()) {
    return fmt::format("  There is no limit at the highest order: {}.",
                       reference_richardson_limit.failure);
  }
  std::string text =
      fmt::format("  The limit is that of order {}", reference_richardson_limit.order);
  if (study.limit_accuracy) {
    text += fmt::format(
        "; the limit of the next lower order differs by L1 {:.1e} in p(y) and {:.1e} in p(y'): "
        "smaller distances are not significant",
        study.limit_accuracy->y, study.limit_accuracy->ydot);
  }
  return text + '.';
}

constexpr const char* kGridLegend =
    "order: order of the transport terms; cells: numbers in y and y' (each level has sqrt 2 times "
    "as many in a direction). L1: integral of |p - limit|. observed order: from the differences of "
    "the last three levels. +-: difference between the limit and the finest grid. ms: wall-clock "
    "time of one solve; grids: null vector alone, one processor; simulation: all processors.";

}  // namespace

std::string study_table_text(const GridStudy& study, const report::TerminalTextFormat& format) {
  std::string text = wrap_text(
      fmt::format("{}; finite volumes for {}, impact {}", report::case_title(study.problem),
                  problem::name(*study.grids.equation), problem::name(*study.grids.impact)),
      format.width, 2);
  text += grid_table_text(study, format) + '\n' + richardson_limit_table_text(study, format) +
          compared_method_table_text(study, format);
  for (const auto& row : study.rows)
    text += status_reason_text(row_name(row), row.solution, format.width);
  for (const auto& row : study.others)
    text += status_reason_text(row_name(row), row.solution, format.width);
  text += wrap_text(limit_accuracy_sentence(study), format.width, 2);
  for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const auto sentence = fastest_method_sentence(study, accuracy);
    if (!sentence.empty()) text += wrap_text(sentence, format.width, 2);
  }
  return text + '\n' + wrap_text(kGridLegend, format.width);
}

}  // namespace fpkcheck::study
