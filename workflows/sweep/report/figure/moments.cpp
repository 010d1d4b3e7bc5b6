#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/figure/text.hpp"
#include "workflows/sweep/report/figure/curve_script.hpp"

namespace fpkcheck::sweep {
namespace {

using transform::Moments;
using transform::Variable;

// The axis range of the solutions that are ok, if there are any: outliers among the other solutions
// would compress the curves.
std::string moment_range(const CurveData& data, double Moments::*moment) {
  std::vector<double> ok, all;
  data.for_each([&](std::size_t point, std::size_t m) {
    const auto* one = data.view().method_result(point, m);
    if (one == nullptr || !one->moments) return;
    const double value = (*one->moments).*moment;
    if (!std::isfinite(value)) return;
    all.push_back(value);
    if (one->status == transform::Status::ok) ok.push_back(value);
  });
  const auto& range_values = ok.empty() ? all : ok;
  if (range_values.empty()) return "set yrange [0:1]\n";
  const auto [low, high] = std::ranges::minmax(range_values);
  const double room = std::max(0.06 * (high - low), 2e-4 * std::abs(high) + 1e-12);
  return fmt::format("set yrange [{:.6g}:{:.6g}]\n", low - room, high + room);
}

std::string moment_panel(const CurveData& data, std::size_t slice, Variable variable) {
  const bool is_y = variable == Variable::y;
  std::vector<std::string> plots;  // by decreasing trust: the least trusted curve is drawn last
  for (std::size_t m = data.method_count(); m-- > 0;) {
    plots.push_back(curve_plot_command(data, slice, m, is_y ? moment_y : moment_ydot));
  }
  return fmt::format("set ylabel {}\n{}plot {}\n\n",
                     report::gnuplot_text(is_y ? "E[{/:Italic y}^2]" : "E[{/:Italic y}'^2]"),
                     moment_range(data, is_y ? &Moments::y2 : &Moments::v2),
                     fmt::join(plots, ", \\\n     "));
}

}  // namespace

std::string moments_script(const SweepView& view, const CurvesLayout& layout,
                           const std::string& file_stem) {
  const CurveData data(view, layout);
  bool has_open_marks = false;
  data.for_each([&](std::size_t point, std::size_t m) {
    const auto* one = view.method_result(point, m);
    has_open_marks =
        has_open_marks || (one != nullptr && one->moments && one->status != transform::Status::ok);
  });
  std::vector<std::size_t> all(data.method_count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const report::Legend legend = curves_legend(data, all, has_open_marks);
  const report::PanelGrid grid = curves_grid(data, legend);
  std::string text = curves_script_beginning(data, grid, file_stem) + "set format y '%g'\n\n";
  for (std::size_t s = 0; s < layout.slices.size(); ++s) {
    for (const Variable variable : transform::kVariables) {
      text += curves_panel(data, grid, s, variable) + moment_panel(data, s, variable);
    }
  }
  return text + report::legend_strip_commands(legend, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::sweep
