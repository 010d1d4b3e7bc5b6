#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "methods/plot_style.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/script_text.hpp"
#include "workflows/study/grid_convergence_study.hpp"
#include "workflows/study/study_record.hpp"

namespace fpkcheck::study {
namespace {

using report::FigurePanel;
using report::FigurePoint;
using report::FigureSeries;
using transform::StateVariable;
using Distance = double MarginalL1Distances::*;

template <class Row>
std::optional<FigurePoint> distance_point(const Row& row, double abscissa, Distance distance) {
  if (!row.solution.has_status_ok() || !row.l1) return std::nullopt;
  return FigurePoint{.x = abscissa, .y = (*row.l1).*distance};
}

double solve_milliseconds(const transform::Solution& solution) { return solution.seconds * 1000; }

/// @param abscissa function that returns the abscissa of a study row
template <class Abscissa>
std::vector<FigureSeries> series_of_schemes(const GridStudy& study, Distance distance,
                                            Abscissa abscissa) {
  auto all = make_empty_figure_series(
      study.rows,
      [](const GridStudyRow& row) { return fmt::format("finite volumes, order {}", row.order); },
      [&](const GridStudyRow& row) { return distance_point(row, abscissa(row), distance); });
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto points = std::move(all[k].points);
    all[k] = report::make_empty_figure_series(all[k].name, methods::finite_volume_scheme_style(k));
    all[k].points = std::move(points);
  }
  return all;
}

std::string method_label(const ComparedMethodRow& row) {
  const auto& identity = row.solution.identity;
  if (identity.role == transform::SolutionRole::simulation) return "simulation";
  return fmt::format("closure, {}{}",
                     identity.formulation.empty() ? identity.family : identity.formulation,
                     identity.order ? ", n = 2, 4, .." : "");
}

// Returns for each scheme a dashed line through the first point of its curve with the slope of the
// nominal order.
std::vector<FigureSeries> nominal_order_lines(const GridStudy& study, Distance distance) {
  std::vector<FigureSeries> slopes;
  for (auto row = study.rows.begin(); row != study.rows.end();) {
    const int order = row->order;
    const auto end = std::find_if(row, study.rows.end(),
                                  [&](const GridStudyRow& other) { return other.order != order; });
    const double finest = std::prev(end)->refinement;
    const auto first = std::find_if(row, end, [&](const GridStudyRow& other) {
      return distance_point(other, 1, distance).has_value();
    });
    row = end;
    if (first == end) continue;
    const double l1 = (*first->l1).*distance;
    slopes.push_back({.name = "slope of the scheme's order",
                      .colour = "#AAAAAA",
                      .dash = "(6,6)",
                      .points = {{first->refinement, l1},
                                 {finest, l1 * std::pow(finest / first->refinement, -order)}}});
  }
  return slopes;
}

report::FigureAxis distance_axis(StateVariable variable, const std::vector<FigureSeries>& all) {
  return report::logarithmic_axis(fmt::format("{{/:Italic L}}_1 distance of {} to the limit",
                                              report::density_in_enhanced_text(variable)),
                                  all, &FigurePoint::y);
}

FigurePanel refinement_panel(const GridStudy& study, const std::string& title,
                             StateVariable variable, Distance distance) {
  constexpr std::array kRefinements{0.125, 0.25, 0.35, 0.5, 0.71, 1.0,
                                    1.41,  2.0,  2.83, 4.0, 5.66, 8.0};
  auto series =
      series_of_schemes(study, distance, [](const GridStudyRow& row) { return row.refinement; });
  FigurePanel panel{
      .title = "grids: " + title,
      .x = {"cells per direction, relative to the automatic grid",
            study.rows.front().refinement / 1.15, study.rows.back().refinement * 1.15, true},
      .y = distance_axis(variable, series)};
  for (const double refinement : kRefinements) {
    panel.x.tics.push_back({fmt::format("{:g}", refinement), refinement});
  }
  std::ranges::move(nominal_order_lines(study, distance), std::back_inserter(series));
  panel.series = series;
  return panel;
}

FigurePanel cost_panel(const GridStudy& study, const std::string& title, StateVariable variable,
                       Distance distance) {
  auto series = series_of_schemes(
      study, distance, [](const GridStudyRow& row) { return solve_milliseconds(row.solution); });
  std::ranges::move(make_empty_figure_series(study.others, method_label,
                                             [&](const ComparedMethodRow& row) {
                                               return distance_point(
                                                   row, solve_milliseconds(row.solution), distance);
                                             }),
                    std::back_inserter(series));
  return {
      .title = "error against cost: " + title,
      .x = report::logarithmic_axis("wall-clock time of one solve, ms", series, &FigurePoint::x),
      .y = distance_axis(variable, series),
      .series = series};
}

}  // namespace

report::Figure study_figure(const GridStudy& study) {
  report::Figure figure{.title = report::problem_title_parts(study.problem), .screen_width = 1300};
  for (const auto make_panel : {refinement_panel, cost_panel}) {
    for (const FigurePanel& panel :
         {make_panel(study, "displacement", StateVariable::y, &MarginalL1Distances::y),
          make_panel(study, "velocity", StateVariable::ydot, &MarginalL1Distances::ydot)}) {
      const bool is_empty = std::ranges::all_of(panel.series, &std::vector<FigurePoint>::empty,
                                                &FigureSeries::points);
      if (!is_empty) figure.panels.push_back(panel);
    }
  }
  return figure;
}

}  // namespace fpkcheck::study
