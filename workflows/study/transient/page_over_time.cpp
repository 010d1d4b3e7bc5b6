#include "workflows/study/transient/comparison_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "report/figure/case_figures.hpp"
#include "report/page/html_elements.hpp"
#include "report/page/page_plots.hpp"
#include "report/page/page_sections.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/number_text.hpp"
#include "results/run.hpp"

namespace fpkcheck::study {
namespace {

using report::escape_html;
using report::html_element;
using transform::Marginal;
using transform::Moments;
using transform::StateVariable;
using transform::TransientDensities;
using transform::TransientDensitySnapshot;

constexpr const char* kSliderId = "time";
constexpr const char* kPlotPrefix = "over-time";

constexpr std::pair<const char*, double Moments::*> kMomentsInTable[] = {
    {"E[y]", &Moments::y1},       {"E[y\u00b2]", &Moments::y2},
    {"E[y\u2032]", &Moments::v1}, {"E[y\u2032\u00b2]", &Moments::v2},
    {"E[y\u2074]", &Moments::y4}, {"E[y\u2032\u2074]", &Moments::v4}};

std::string time_text(double time) { return fmt::format("t = {:.4g}", time); }

const TransientDensitySnapshot* find_snapshot(const TransientDensities& solution,
                                              std::size_t snapshot) {
  return snapshot < solution.snapshots.size() ? &solution.snapshots[snapshot] : nullptr;
}

std::string snapshot_table_html(const TransientComparison& study,
                                const TransientDensities& compared_with, std::size_t snapshot) {
  std::vector<report::HtmlTableColumn> columns{{"solution", report::TextAlignment::left}};
  for (const TransientDensities& solution : study.solutions)
    columns[0].cells.push_back(solution.id);
  const auto add_column = [&](const std::string& header, const auto& cell) {
    report::HtmlTableColumn column{header};
    for (const TransientDensities& solution : study.solutions) {
      const TransientDensitySnapshot* at = find_snapshot(solution, snapshot);
      column.cells.push_back(at ? cell(solution, *at) : std::string(report::kNoValue));
    }
    columns.push_back(std::move(column));
  };
  for (const StateVariable variable : transform::kVariables) {
    const bool of_y = variable == StateVariable::y;
    const char* density = of_y ? "p(y)" : "p(y\u2032)";
    add_column(fmt::format("L1 to {}, {}", compared_with.id, density),
               [&](const TransientDensities& solution, const TransientDensitySnapshot&) {
                 const auto l1 = l1_distances_at(solution, compared_with, snapshot);
                 return report::l1_distance_cell_text(l1 ? std::optional(of_y ? l1->y : l1->ydot)
                                                         : std::nullopt);
               });
    add_column(fmt::format("L1 error, {}", density), [&](const TransientDensities&,
                                                         const TransientDensitySnapshot& at) {
      return report::l1_distance_cell_text(
          at.error ? std::optional(of_y ? at.error->y_l1 : at.error->ydot_l1) : std::nullopt);
    });
  }
  for (const auto& [header, member] : kMomentsInTable) {
    add_column(
        header, [moment = member](const TransientDensities&, const TransientDensitySnapshot& at) {
          const double error =
              at.error ? at.error->moments.*moment : std::numeric_limits<double>::quiet_NaN();
          const std::string value = fmt::format("{:.5f}", at.moments.*moment);
          return std::isfinite(error) ? fmt::format("{} \u00b1 {:.1e}", value, error) : value;
        });
  }
  return report::table_html(fmt::format("Moments and L1 distances at {}",
                                        time_text(compared_with.snapshots[snapshot].time)),
                            std::move(columns));
}

results::DensityCurve make_density_curve(const std::string& solution, StateVariable variable,
                                         const Marginal& marginal) {
  results::DensityCurve curve{.solution = solution,
                              .variable = variable,
                              .abscissa = {},
                              .density = marginal.density,
                              .lower = marginal.lower,
                              .upper = marginal.upper};
  for (std::size_t b = 0; b < marginal.size(); ++b)
    curve.abscissa.push_back(marginal.bin_centre(b));
  return curve;
}

// Returns the densities at one time as a case result, from which the report page draws density
// plots. The curve of a solution that does not reach the selected time has the value NaN, so that
// the plots of all times have the same curves.
results::CaseResult densities_at(const TransientComparison& study,
                                 const std::vector<SelectedFunctionalMethod>& methods,
                                 const TransientDensities& compared_with, std::size_t snapshot) {
  results::CaseResult densities{study.problem};
  densities.assessment.reference = compared_with.id;
  for (const TransientDensities& solution : study.solutions) {
    if (solution.snapshots.empty()) continue;
    densities.solutions.push_back({.identity = find_method(methods, solution.id)->identity,
                                   .status = solution.status,
                                   .reason = solution.reason});
    const TransientDensitySnapshot* at = find_snapshot(solution, snapshot);
    for (const StateVariable variable : transform::kVariables) {
      Marginal marginal = marginal_of_variable(at ? *at : solution.snapshots.front(), variable);
      if (!at) {
        std::ranges::fill(marginal.density, std::numeric_limits<double>::quiet_NaN());
      }
      densities.curves.push_back(make_density_curve(solution.id, variable, marginal));
    }
  }
  return densities;
}

void extend_ranges(report::MarginalAxisRanges& all, const report::MarginalAxisRanges& other) {
  using report::MarginalAxisRanges;
  for (double MarginalAxisRanges::*least :
       {&MarginalAxisRanges::linear_from, &MarginalAxisRanges::logarithmic_from,
        &MarginalAxisRanges::least_density, &MarginalAxisRanges::least_difference}) {
    all.*least = std::min(all.*least, other.*least);
  }
  for (double MarginalAxisRanges::*largest :
       {&MarginalAxisRanges::linear_to, &MarginalAxisRanges::logarithmic_to,
        &MarginalAxisRanges::linear_top, &MarginalAxisRanges::largest_density,
        &MarginalAxisRanges::largest_difference}) {
    all.*largest = std::max(all.*largest, other.*largest);
  }
}

// Returns the plots of the densities at each time of the slider. All times have the same axis
// ranges.
std::vector<std::vector<report::ReportPagePlot>> density_plots(
    const TransientComparison& study, const TransientDensities& compared_with,
    const std::vector<std::size_t>& shown) {
  const auto methods =
      methods_selected_by_list(study.options, SelectableFunctionalMethods::with_closures);
  std::set<std::string> ids;
  for (const TransientDensities& solution : study.solutions) ids.insert(solution.id);
  std::vector<results::CaseResult> densities;
  for (const std::size_t snapshot : shown)
    densities.push_back(densities_at(study, methods, compared_with, snapshot));
  std::vector<report::DensityFigureContent> contents;
  for (const auto& at : densities) contents.push_back(report::density_content_for_page(at, ids));
  auto ranges = std::vector<report::MarginalAxisRanges>{};
  for (const auto& marginal : contents.front().marginals) ranges.push_back(marginal.ranges);
  for (const auto& content : contents) {
    for (std::size_t m = 0; m < ranges.size(); ++m)
      extend_ranges(ranges[m], content.marginals[m].ranges);
  }
  std::vector<std::vector<report::ReportPagePlot>> plots;
  for (auto& content : contents) {
    for (std::size_t m = 0; m < ranges.size(); ++m) content.marginals[m].ranges = ranges[m];
    plots.push_back(
        report::make_page_plots(report::density_figure(study.problem, content), kPlotPrefix));
  }
  return plots;
}

// Returns the plots of the moments and L1 distances over time, without the heat maps of the figure.
std::vector<report::ReportPagePlot> plots_over_time(const TransientComparison& study) {
  report::Figure figure = study_figure(study);
  std::erase_if(figure.panels, [](const report::FigurePanel& panel) { return panel.map; });
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    report::FigurePanel& panel = figure.panels[k];
    panel.id = fmt::format("panel-{}", k + 1);
    panel.caption = panel.title + " over time";
    panel.caption.front() =
        static_cast<char>(std::toupper(static_cast<unsigned char>(panel.caption.front())));
  }
  return report::make_page_plots(figure, kPlotPrefix);
}

// Returns the HTML slider that selects one of `count` times. The slider is initially at the first
// time after the initial density.
std::string slider_html(std::size_t count) {
  return fmt::format(
      "<p class=\"controls\"><label for=\"{0}\">Time</label> <input type=\"range\" id=\"{0}\" "
      "min=\"0\" max=\"{1}\" step=\"1\" value=\"1\" autocomplete=\"off\"> <output for=\"{0}\" "
      "id=\"{0}-label\"></output></p>\n",
      kSliderId, count - 1);
}

// Returns the groups of plots as JSON: the input of the script page.js.
std::string plot_groups_json(const std::vector<std::vector<report::ReportPagePlot>>& densities,
                             const std::vector<std::string>& labels,
                             const std::vector<report::ReportPagePlot>& others) {
  std::string steps;
  for (const auto& plots : densities)
    steps += (steps.empty() ? "" : ",") + report::plots_json(plots);
  return fmt::format(R"([{{"slider":{{"id":"{}","labels":{},"steps":[{}]}},"plots":{}}}])",
                     kSliderId, nlohmann::json(labels).dump(), steps, report::plots_json(others));
}

}  // namespace

std::string study_page_html(const TransientComparison& study, const std::string& command) {
  constexpr int kMostIntervalsOnPage = 100;  // a page of at most some megabytes
  const TransientDensities* const compared_with = find_reference_solution(study);
  if (compared_with == nullptr) return "";
  const auto shown = evenly_spaced_snapshots(study, kMostIntervalsOnPage);
  std::string tables, summaries;
  std::vector<std::string> labels;
  for (const std::size_t snapshot : shown) {
    labels.push_back(time_text(compared_with->snapshots[snapshot].time));
    tables += fmt::format("<div data-slider=\"{}\">\n{}</div>\n", kSliderId,
                          snapshot_table_html(study, *compared_with, snapshot));
  }
  for (const TransientDensities& solution : study.solutions) {
    summaries += html_element("li", solution_summary_text(study, solution, compared_with) + '.');
  }
  const auto densities = density_plots(study, *compared_with, shown);
  const auto others = plots_over_time(study);
  const problem::Problem* const problems[] = {&study.problem};
  const std::string title = "fpkcheck: densities over time of " + study.problem.name;
  const std::string body =
      "<main class=\"case\">\n" + html_element("h1", title) +
      html_element("p", report::case_title(study.problem)) + html_element("h2", "Densities") +
      slider_html(shown.size()) + report::plots_html(densities.front()) + tables +
      "<p class=\"small\">L1 error: error estimate of the solution, or expected sampling error of "
      "the simulation. \u00b1: error estimate of the moment, or standard error of the "
      "simulation.</p>\n" +
      html_element("h2", "Moments and distances over time") + report::plots_html(others) +
      html_element("h2", "Solutions") + "<ul>\n" + summaries + "</ul>\n" +
      html_element("h2", "The problem") + report::problem_statement(problems) +
      html_element("h2", "Command") +
      fmt::format("<pre><code>{}</code></pre>\n</main>\n", escape_html(command));
  return report::page_with_plots_html(title, body, plot_groups_json(densities, labels, others));
}

}  // namespace fpkcheck::study
