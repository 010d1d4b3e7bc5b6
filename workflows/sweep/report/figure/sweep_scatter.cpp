#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "numerics/statistics.hpp"
#include "report/figure/gnuplot.hpp"
#include "workflows/sweep/report/figure/figures.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
namespace {

using report::FigureSeries;

constexpr std::size_t kMaxBins = 8;
// Smallest number of sweep points for which the figure shows the median over a section of a
// parameter range.
constexpr std::size_t kMinPointsForMedian = 3;
// Width over which the methods at a category of the axis are spread, relative to the distance of
// categories.
constexpr double kWordSpread = 0.6;

/// Bins of a varied key for medians: single values if the key has few values, otherwise sections of
/// its range.
class ParameterValueBins {
 public:
  ParameterValueBins(const SweepPlan& plan, std::size_t place) : axis_(plan, place), place_(place) {
    if (axis_.is_categorical() || axis_.values().size() <= kMaxBins) return;
    low_ = scaled(axis_.values().front());
    high_ = scaled(axis_.values().back());
    sections_ = std::clamp<std::size_t>(plan.points.size() / 10, 3, kMaxBins);
  }

  const SweepParameterAxis& axis() const { return axis_; }
  std::size_t place() const { return place_; }
  bool is_enough(std::size_t points) const {
    return sections_ == 0 || points >= kMinPointsForMedian;
  }
  std::size_t bin(const base::Value& value) const {
    if (sections_ == 0) return axis_.map_cell_index(value);
    const double part = (scaled(value) - low_) / (high_ - low_);
    return std::min(sections_ - 1, static_cast<std::size_t>(part * static_cast<double>(sections_)));
  }
  double centre(std::size_t bin) const {
    if (sections_ == 0) return axis_.coordinate(axis_.values()[bin]);
    const double coordinate =
        low_ + (static_cast<double>(bin) + 0.5) / static_cast<double>(sections_) * (high_ - low_);
    return axis_.is_logarithmic() ? std::exp(coordinate) : coordinate;
  }

 private:
  double scaled(const base::Value& value) const {
    const double number = axis_.coordinate(value);
    return axis_.is_logarithmic() ? std::log(number) : number;
  }

  SweepParameterAxis axis_;
  std::size_t place_;
  double low_ = 0, high_ = 0;
  std::size_t sections_ = 0;  // number of sections; 0 if each value is a bin
};

// Returns two scatter plot series of a method: the results, with open marks for statuses other than
// `ok`, and the medians over bins of the key.
std::vector<FigureSeries> method_series(const SweepResultsView& view, const ParameterValueBins& key,
                                        std::size_t m, double offset) {
  const auto& identity = view.sweep_plan().methods[m].identity;
  FigureSeries points = report::make_empty_figure_series(identity.id, identity.plot_style);
  points.dash = "";
  points.line_width = 1;
  points.mark_size = view.results().points.size() > 200 ? 0.35 : 0.6;
  std::map<std::size_t, std::vector<double>> ok;
  for (const auto& point : view.results().points) {
    const auto l1 = view.larger_marginal_l1(point.point, m);
    if (!l1 || *l1 <= 0) continue;
    const auto& value = view.sweep_plan().points[point.point][key.place()];
    const bool has_status_ok = point.methods[m].status == transform::Status::ok;
    points.points.push_back(
        {.x = key.axis().coordinate(value) + offset, .y = *l1, .open = !has_status_ok});
    if (has_status_ok) ok[key.bin(value)].push_back(*l1);
  }
  FigureSeries medians = report::make_empty_figure_series(
      fmt::format("median of {} where ok", identity.id), identity.plot_style);
  medians.line_width = 2.5;
  if (key.axis().is_categorical()) {
    medians.dash = "";
    medians.mark_size = 1.5;
  } else {
    medians.symbol = "";
  }
  for (const auto& [bin, values] : ok) {
    if (!key.is_enough(values.size())) continue;
    medians.points.push_back({key.centre(bin) + offset, numerics::median(values)});
  }
  return {points, medians};
}

}  // namespace

report::Figure distance_scatter_figure(const SweepResultsView& view) {
  const auto methods = view.compared_method_indices();
  report::Figure figure{.title = view.figure_title_parts(), .panel_height = 280};
  for (std::size_t place = 0; place < view.sweep_plan().axes.size(); ++place) {
    const ParameterValueBins key(view.sweep_plan(), place);
    report::FigurePanel panel{.title = report::escape_enhanced_text(key.axis().key()),
                              .x = key.axis().figure_axis(),
                              .y = {"", 0, 1}};
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(methods.size());
      const double offset = key.axis().is_categorical() ? kWordSpread * (part - 0.5) : 0;
      for (auto& series : method_series(view, key, methods[k], offset)) {
        panel.series.push_back(std::move(series));
      }
    }
    figure.panels.push_back(panel);
  }
  const auto axis = l1_distance_axis("larger {/:Italic L}_1 distance of both", figure.panels);
  for (auto& panel : figure.panels) panel.y = axis;
  return figure;
}

}  // namespace fpkcheck::sweep
