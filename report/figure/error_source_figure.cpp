#include "report/figure/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "compare/solution_assessment.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/heat_map_values.hpp"
#include "report/figure/script_text.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using results::CaseResult;
using results::MomentErrorSource;
using transform::Moments;

constexpr std::size_t kMaxSolutions = 4, kMaxSolutionsInColumn = 2;
// Outer phase-plane cells with values below kVisibleErrorFraction times the largest value are
// invisible in heat maps and omitted.
constexpr double kVisibleErrorFraction = 1e-3;

struct MomentWithErrorSources {
  const char* name;
  const char* symbol;  ///< symbol in gnuplot's enhanced text
  const char* text;
  double Moments::*member;
};
constexpr MomentWithErrorSources kMoments[] = {{"y2", "E[{/:Italic y}²]", "E[y²]", &Moments::y2},
                                               {"v2", "E[{/:Italic y}'²]", "E[y′²]", &Moments::v2}};

double largest_magnitude(const MomentErrorSource& source) {
  double most = 0;
  for (const double x : source.density.averages) most = std::max(most, std::abs(x));
  return most;
}

bool has_error_sources(const CaseResult& case_result, const std::string& id) {
  return std::ranges::all_of(kMoments, [&](const MomentWithErrorSources& moment) {
    return case_result.moment_error_source(id, moment.name) != nullptr;
  });
}

std::vector<std::string> solutions_to_show(const CaseResult& case_result, std::size_t most) {
  std::vector<std::string> ids;
  std::set<std::string> formulations;
  for (const auto* ranked : case_result.assessment.closures_ranked_by_distance()) {
    const auto& closure = *case_result.find(ranked->id);
    if (ids.size() + 1 < most && formulations.insert(closure.identity.formulation).second &&
        has_error_sources(case_result, closure.id())) {
      ids.push_back(closure.id());
    }
  }
  std::ranges::reverse(ids);  // by increasing accuracy from left to right
  for (const auto& solution : case_result.solutions) {
    if (ids.size() < most && compare::is_solution_of_full_problem(solution) &&
        has_error_sources(case_result, solution.id())) {
      ids.push_back(solution.id());
    }
  }
  return ids;
}

// Returns the window of the phase-plane cells that have a visible value in at least one heat map.
// The window of visible cells is symmetric in y', and includes y = 0 if the cells begin at y = 0.
CellIndexWindow window_of_visible_cells(const CaseResult& case_result,
                                        const std::vector<std::string>& ids) {
  const auto& cells = case_result.error_sources.front().density;
  CellIndexWindow window{.y_end = 1, .v_begin = cells.v_cell_count(), .v_end = 0};
  if (cells.y_edges.front() != 0) window.y_begin = cells.y_cell_count() - 1;
  for (const auto& id : ids) {
    for (const MomentWithErrorSources& moment : kMoments) {
      const MomentErrorSource& source = *case_result.moment_error_source(id, moment.name);
      const double least = kVisibleErrorFraction * largest_magnitude(source);
      for (std::size_t i = 0; i < source.density.y_cell_count(); ++i) {
        for (std::size_t j = 0; j < source.density.v_cell_count(); ++j) {
          if (std::abs(source.density.cell_average(i, j)) <= least) continue;
          window.y_begin = std::min(window.y_begin, i);
          window.y_end = std::max(window.y_end, i + 1);
          window.v_begin = std::min({window.v_begin, j, cells.v_cell_count() - 1 - j});
          window.v_end = std::max({window.v_end, j + 1, cells.v_cell_count() - j});
        }
      }
    }
  }
  return window;
}

// Returns a signed square root, since the colour scale would hide values that are small relative to
// the values at the wall.
double scaled_signed_root(double value, double limit) {
  return std::copysign(std::sqrt(std::abs(value) / limit), value);
}

// Returns a colour axis with tics at equal steps of the shown value. The positions of the tics on
// the colour axis are signed square roots of the shown values. The tic labels of the colour axis
// are in units of the power of ten in the axis label.
FigureAxis signed_root_colour_axis(const std::string& quantity, double limit) {
  constexpr int kMaxSteps = 5;  // largest number of tic steps on each side of 0
  const double step = choose_tick_step(0, limit, kMaxSteps);
  const auto power = static_cast<int>(std::floor(std::log10(step)));
  FigureAxis axis{quantity, -1, 1};
  if (power != 0) axis.label += replace_hyphens_by_minus_signs(fmt::format(", 10^{{{}}}", power));
  const int most = static_cast<int>(limit / step * (1 + 1e-9));
  for (int k = -most; k <= most; ++k) {
    axis.tics.push_back(
        {replace_hyphens_by_minus_signs(fmt::format("{:.0f}", k * step / std::pow(10, power))),
         scaled_signed_root(k * step, limit)});
  }
  return axis;
}

FigurePanel error_source_panel(const CaseResult& case_result, const std::string& id,
                               const MomentWithErrorSources& moment,
                               const CellIndexWindow& window) {
  constexpr int kMaxTics = 4;  // largest number of tics that fit under a map on a screen
  const auto* estimate = case_result.moment_error_estimate(id);
  const double error = estimate == nullptr ? 0 : estimate->error.*moment.member;
  const MomentErrorSource& source = *case_result.moment_error_source(id, moment.name);
  const double limit = std::max(largest_magnitude(source), 1e-300);
  const auto& y = source.density.y_edges;
  const auto& v = source.density.v_edges;
  const FigureAxis x_axis{"{/:Italic y}", y[window.y_begin], y[window.y_end], false,
                          choose_tick_step(y[window.y_begin], y[window.y_end], kMaxTics)},
      y_axis{"{/:Italic y}'", v[window.v_begin], v[window.v_end]};
  FigureHeatMap map{.x_range = {x_axis.from, x_axis.to},
                    .y_range = {y_axis.from, y_axis.to},
                    .columns = window.y_end - window.y_begin,
                    .values = cell_averages_by_velocity_rows(source.density, window),
                    .colour_axis = signed_root_colour_axis("error per area", limit),
                    .colours = {std::begin(kDivergingColours), std::end(kDivergingColours)},
                    .root_scale = limit,
                    .quantity = "error per area"};
  for (double& value : map.values) {
    constexpr double kDecimals = 1000;  // rounding of values to 1/1000, which resolves the colours
    value = std::round(kDecimals * scaled_signed_root(value, limit)) / kDecimals;
  }
  return {.id = fmt::format("errors-{}", moment.name),
          .title = fmt::format("{} of {}: {}", moment.symbol, escape_enhanced_text(id),
                               scientific_notation_text(error)),
          .caption = fmt::format("{}: error {}", moment.text,
                                 replace_hyphens_by_minus_signs(number_text(error, 2))),
          .x = x_axis,
          .y = y_axis,
          .map = std::move(map),
          .choice = id};
}

// On a screen each solution has a column of two heat maps, but a single solution has a row of two
// heat maps. In a figure on paper each solution has a row of two heat maps. In a figure for a
// single journal column all heat maps are below one another.
Figure make_error_source_figure(const CaseResult& case_result, const std::vector<std::string>& ids,
                                FigureWidth width) {
  constexpr int kColumnOnScreen = 400, kMomentCount = static_cast<int>(std::size(kMoments));
  const bool has_columns = width == FigureWidth::screen && ids.size() > 1;
  const int columns = has_columns ? static_cast<int>(ids.size()) : kMomentCount;
  Figure figure{.title = problem_title_parts(case_result.problem),
                .columns = columns,
                .screen_width = columns * kColumnOnScreen,
                .panel_height = 275};
  const bool has_error = std::ranges::any_of(ids, [&](const std::string& id) {
    return std::ranges::any_of(kMoments, [&](const MomentWithErrorSources& moment) {
      return largest_magnitude(*case_result.moment_error_source(id, moment.name)) > 0;
    });
  });
  const bool same_cells = std::ranges::all_of(case_result.error_sources, [&](const auto& source) {
    const auto& cells = case_result.error_sources.front().density;
    return source.density.y_edges == cells.y_edges && source.density.v_edges == cells.v_edges;
  });
  if (!has_error || !same_cells) return figure;
  const CellIndexWindow window = window_of_visible_cells(case_result, ids);
  for (std::size_t k = 0; k < ids.size() * std::size(kMoments); ++k) {
    const std::size_t solution = has_columns ? k % ids.size() : k / std::size(kMoments),
                      moment = has_columns ? k / ids.size() : k % std::size(kMoments);
    figure.panels.push_back(
        error_source_panel(case_result, ids[solution], kMoments[moment], window));
  }
  return figure;
}

}  // namespace

Figure error_source_figure(const CaseResult& case_result, FigureWidth width) {
  const bool narrow = width == FigureWidth::one_column;
  return make_error_source_figure(
      case_result, solutions_to_show(case_result, narrow ? kMaxSolutionsInColumn : kMaxSolutions),
      width);
}

Figure error_source_page_figure(const CaseResult& case_result) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    const bool is_new = std::ranges::find(ids, id) == ids.end();
    if (is_new && has_error_sources(case_result, id)) ids.push_back(id);
  };
  for (const auto* closure : case_result.assessment.closures_ranked_by_distance()) add(closure->id);
  for (const auto& estimate : case_result.moment_error_estimates) add(estimate.solution);
  return make_error_source_figure(case_result, ids, FigureWidth::screen);
}

}  // namespace fpkcheck::report
