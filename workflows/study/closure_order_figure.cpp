#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"
#include "workflows/study/closure_order_study.hpp"
#include "workflows/study/study_record.hpp"

namespace fpkcheck::study {
namespace {

using report::FigureSeries;
using transform::StateVariable;

report::FigurePanel distance_panel(const ClosureOrderStudy& study, const char* title,
                                   StateVariable variable, double MarginalL1Distances::*distance) {
  int highest = 2;
  for (const auto& row : study.rows) highest = std::max(highest, row.order);
  const auto series = make_empty_figure_series(
      study.rows, [](const ClosureOrderStudyRow& row) { return row.formulation; },
      [&](const ClosureOrderStudyRow& row) -> std::optional<report::FigurePoint> {
        if (!row.l1) return std::nullopt;
        return report::FigurePoint{.x = static_cast<double>(row.order),
                                   .y = (*row.l1).*distance,
                                   .open = !row.solution.has_status_ok()};
      });
  return {
      .title = title,
      .x = {"order {/:Italic n}", 1, static_cast<double>(highest + 1), false, 2},
      .y = report::logarithmic_axis(fmt::format("{{/:Italic L}}_1 distance of {} to {}",
                                                report::density_in_enhanced_text(variable),
                                                report::escape_enhanced_text(study.reference.id())),
                                    series, &report::FigurePoint::y),
      .series = series};
}

// In the figure each closure with a solution branch has a line, and each fold of a branch has a
// mark.
std::vector<FigureSeries> branch_series(const ClosureOrderStudy& study) {
  std::vector<FigureSeries> all;
  FigureSeries folds{.name = "fold of a branch", .colour = "#444444", .symbol = "circle-open"};
  for (const auto& row : study.rows) {
    const auto branch = read_solution_branch(row.solution.metrics);
    if (!branch) continue;
    all.push_back(report::make_empty_figure_series(
        fmt::format("branch: {} n = {}", row.formulation, row.order),
        row.solution.identity.plot_style));
    all.back().symbol = "";
    for (const auto& [fraction, norm, fold] : branch->points) {
      all.back().points.push_back({.x = fraction, .y = norm});
      if (fold) folds.points.push_back({.x = fraction, .y = norm});
    }
  }
  if (!all.empty()) all.push_back(folds);
  return all;
}

report::FigurePanel branch_panel(const std::vector<FigureSeries>& branches) {
  return {.title = "branches from the exact density without impact losses",
          .x = {"fraction of the way to the full problem", 0, 1.02, false, 0.1},
          .y = report::linear_axis("norm of the coefficients", branches, &report::FigurePoint::y),
          .series = branches};
}

}  // namespace

report::Figure study_figure(const ClosureOrderStudy& study) {
  report::Figure figure{
      .title = report::problem_title_parts(study.problem),
      .panels = {
          distance_panel(study, "displacement", StateVariable::y, &MarginalL1Distances::y),
          distance_panel(study, "velocity", StateVariable::ydot, &MarginalL1Distances::ydot)}};
  if (const auto branches = branch_series(study); !branches.empty()) {
    figure.panels.push_back(branch_panel(branches));
  }
  return figure;
}

}  // namespace fpkcheck::study
