#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"
#include "workflows/sweep/report/figure/figures.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
namespace {

using report::FigurePanel;
using report::FigurePoint;
using report::FigureSeries;
using transform::Moments;
using transform::StateVariable;

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
// Height of a row of marks above the curves, as a fraction of the panel height.
constexpr double kMarkRowHeight = 0.045;

double value_of(const MarginalL1Values& pair, StateVariable variable) {
  return variable == StateVariable::y ? pair.y : pair.ydot;
}

/// Slice of a sweep plan: the points of one row of panels, in the order of the key on the abscissa.
struct SweepPlanSlice {
  std::string name;  ///< value of the second key, e.g. "gaussian"; may be empty
  std::vector<std::size_t> points;
};

/// Curves of a sweep along a varied key. If a sweep has two keys, the abscissa is the numerical
/// key, and each value of the second key has a slice.
class SweepCurves {
 public:
  explicit SweepCurves(const SweepResultsView& view)
      : view_(view),
        place_(view.sweep_plan().axes.size() == 2 &&
                       SweepParameterAxis(view.sweep_plan(), 0).is_categorical()
                   ? 1
                   : 0),
        along_(view.sweep_plan(), place_) {
    const SweepPlan& plan = view.sweep_plan();
    if (plan.axes.size() == 1) {
      slices_.push_back({"", std::vector<std::size_t>(plan.points.size())});
      std::iota(slices_[0].points.begin(), slices_[0].points.end(), std::size_t{0});
    } else {
      const SweepParameterAxis across(plan, 1 - place_);
      for (const auto& value : across.values()) {
        slices_.push_back({SweepParameterAxis::parameter_value_text(value), {}});
      }
      for (std::size_t point = 0; point < plan.points.size(); ++point) {
        slices_[across.map_cell_index(plan.points[point][1 - place_])].points.push_back(point);
      }
    }
    for (auto& slice : slices_) {
      std::ranges::sort(slice.points, {}, [&](std::size_t point) { return abscissa(point); });
    }
  }

  const std::vector<SweepPlanSlice>& slices() const { return slices_; }
  bool is_categorical() const { return along_.is_categorical(); }
  std::size_t method_count() const { return view_.sweep_plan().methods.size(); }

  double abscissa(std::size_t point) const {
    return along_.coordinate(view_.sweep_plan().points[point][place_]);
  }
  /// Returns the abscissa of a sweep point in the curve of a method. On a categorical axis the
  /// points of the methods are side by side at each category.
  double abscissa(std::size_t point, std::size_t m) const {
    // Width over which the methods at a category are spread, relative to the distance of
    // categories.
    constexpr double kSpread = 0.7;
    const auto count = static_cast<double>(method_count());
    const double beside = (static_cast<double>(m) - (count - 1) / 2) * kSpread / count;
    return abscissa(point) + (is_categorical() ? beside : 0);
  }

  /// Returns a figure with a row of empty panels (displacement and velocity) for each slice of the
  /// sweep plan.
  report::Figure panels() const {
    report::Figure figure{.title = view_.figure_title_parts(),
                          .panel_height = slices_.size() > 1 ? 250 : 350};
    for (const auto& slice : slices_) {
      for (const char* variable : {"displacement", "velocity"}) {
        figure.panels.push_back(
            {.title = report::escape_enhanced_text(
                 slice.name.empty() ? variable : fmt::format("{}, {}", variable, slice.name)),
             .x = along_.figure_axis(),
             .y = {"", 0, 1}});
      }
    }
    return figure;
  }

  /// Returns the curve of a method. On a categorical axis the curve of a method has marks without a
  /// line.
  /// @param value function that returns the optional ordinate of a method's result
  template <class Value>
  FigureSeries curve(const SweepPlanSlice& slice, std::size_t m, Value value) const {
    // Limits of the width of curves, since neighbouring curves with wide lines would overlap.
    constexpr double kThin = 1.5, kBroad = 2.5;
    const auto& identity = view_.sweep_plan().methods[m].identity;
    FigureSeries series = report::make_empty_figure_series(identity.id, identity.plot_style);
    if (is_categorical()) series.dash = "";
    series.line_width = std::clamp(identity.plot_style.width, kThin, kBroad);
    const std::size_t most = std::ranges::max(slices_, {}, [](const SweepPlanSlice& one) {
                               return one.points.size();
                             }).points.size();
    series.mark_size = most <= 30 ? 1.1 : most <= 80 ? 0.7 : 0.4;
    for (const std::size_t point : slice.points) {
      const auto* result = view_.method_result(point, m);
      const std::optional<double> ordinate =
          result == nullptr ? std::nullopt : value(point, m, *result);
      series.points.push_back({.x = abscissa(point, m),
                               .y = ordinate.value_or(kGap),
                               .open = ordinate && result->status != transform::Status::ok});
    }
    return series;
  }

  /// Returns short segments of the tangents at the points of a method that has slopes, without
  /// points if the method has none.
  FigureSeries tangents(const SweepPlanSlice& slice, std::size_t m, double Moments::*moment,
                        double MomentSlopes::*slope) const {
    FigureSeries series{
        .name = "derivative", .colour = "#000000", .dash = "solid", .line_width = 1.5};
    if (is_categorical() || slice.points.size() < 2) return series;
    // Half the length of a segment along the axis, relative to the mean distance of points
    constexpr double kHalfLength = 0.3;
    const bool is_logarithmic = along_.is_logarithmic();
    const double first = abscissa(slice.points.front()), last = abscissa(slice.points.back());
    const double half = kHalfLength * (is_logarithmic ? std::log(last / first) : last - first) /
                        static_cast<double>(slice.points.size() - 1);
    for (const std::size_t point : slice.points) {
      const auto* result = view_.method_result(point, m);
      const MomentSlopes* slopes =
          result == nullptr || !result->moments ? nullptr : result->find_slopes(along_.key());
      if (slopes == nullptr) continue;
      const double x = abscissa(point), y = (*result->moments).*moment;
      const double left = is_logarithmic ? x * std::exp(-half) : x - half,
                   right = is_logarithmic ? x * std::exp(half) : x + half;
      // On a logarithmic axis the tangent has the slope x df/dx with respect to the logarithm.
      const double rise = slopes->*slope * half * (is_logarithmic ? x : 1);
      series.points.push_back({left, y - rise});
      series.points.push_back({right, y + rise});
      series.points.push_back({right, kGap});
    }
    return series;
  }

 private:
  const SweepResultsView& view_;
  std::size_t place_;  // index of the key on the abscissa in the plan's axes
  SweepParameterAxis along_;
  std::vector<SweepPlanSlice> slices_;
};

class DistanceSeries {
 public:
  DistanceSeries(const SweepResultsView& view, const SweepCurves& curves,
                 const SweepPlanSlice& slice, StateVariable variable)
      : view_(view), curves_(curves), slice_(slice), variable_(variable) {}

  std::vector<FigureSeries> all() const {
    std::vector<FigureSeries> all{reference_error()};
    for (const std::size_t m : view_.compared_method_indices()) {
      const auto curve = curves_.curve(
          slice_, m, [&](std::size_t point, std::size_t method, const SweepMethodResult& result) {
            return l1_distance(point, method, result);
          });
      all.push_back(error_estimate(m, curve));
      all.push_back(curve);
    }
    return all;
  }

 private:
  std::optional<double> l1_distance(std::size_t point, std::size_t m,
                                    const SweepMethodResult& result) const {
    if (!result.l1 || view_.is_reference(point, m)) return std::nullopt;
    return value_of(*result.l1, variable_);
  }

  // Returns the area that shows the error estimate of the reference solution. On a categorical axis
  // the error estimate of the reference has a separate bar for each category.
  FigureSeries reference_error() const {
    FigureSeries series{.name = "error of the reference",
                        .colour = "#AAAAAA",
                        .dash = "solid",
                        .line_width = 1,
                        .is_area = true};
    for (const std::size_t point : slice_.points) {
      const auto error = view_.reference_error(point);
      const double x = curves_.abscissa(point), y = error ? value_of(*error, variable_) : kGap;
      if (!curves_.is_categorical()) {
        series.points.push_back({x, y});
        continue;
      }
      constexpr double kHalf = 0.48;  // half-width of a bar, relative to the width of a category
      for (const auto& place : {FigurePoint{x - kHalf, y}, {x + kHalf, y}, {x, kGap}}) {
        series.points.push_back(place);
      }
    }
    return series;
  }

  // Returns the error estimates of a method as a line of the figure. On a categorical axis a line
  // at each category connects the L1 distance and the error estimate of a method.
  FigureSeries error_estimate(std::size_t m, const FigureSeries& distances) const {
    FigureSeries series{.name = "error estimate",
                        .colour = distances.colour,
                        .dash = "(2,4)",
                        .line_width = 1.5,
                        .symbol = curves_.is_categorical() ? "" : "circle",
                        .mark_size = 0.25,
                        .legend_colour = "#444444"};
    for (std::size_t k = 0; k < slice_.points.size(); ++k) {
      const auto* result = view_.method_result(slice_.points[k], m);
      const double x = distances.points[k].x, y = distances.points[k].y;
      const bool is_known = result != nullptr && result->error && std::isfinite(y);
      if (curves_.is_categorical()) series.points.push_back({x, y});
      series.points.push_back({x, is_known ? value_of(*result->error, variable_) : kGap});
      if (curves_.is_categorical()) series.points.push_back({x, kGap});
    }
    return series;
  }

  const SweepResultsView& view_;
  const SweepCurves& curves_;
  const SweepPlanSlice& slice_;
  StateVariable variable_;
};

// Returns whether a sweep point has a reference solution, but the method has no density at this
// point.
bool lacks_density(const SweepResultsView& view, std::size_t point, std::size_t m) {
  const auto* result = view.method_result(point, m);
  return result != nullptr && !result->l1 && !view.is_reference(point, m) &&
         result->status != transform::Status::ok && !view.point_result(point)->reference.empty();
}

// Returns crosses at the top of a panel for sweep points without a density, with a series for each
// method.
std::vector<FigureSeries> no_density_series(const SweepResultsView& view, const SweepCurves& curves,
                                            const SweepPlanSlice& slice,
                                            const std::vector<std::size_t>& methods,
                                            const report::FigureAxis& axis) {
  std::vector<FigureSeries> all;
  for (std::size_t row = 0; row < methods.size(); ++row) {
    all.push_back({.name = "no density",
                   .colour = view.sweep_plan().methods[methods[row]].identity.plot_style.colour,
                   .symbol = "x",
                   .mark_size = 0.8,
                   .legend_colour = "#444444"});
    for (const std::size_t point : slice.points) {
      if (!lacks_density(view, point, methods[row])) continue;
      all.back().points.push_back(
          {curves.abscissa(point, methods[row]), status_mark_row_ordinate(axis, row)});
    }
  }
  return all;
}

// The range of the moment axis contains only `ok` solutions, since outliers among other solutions
// would compress the curves.
report::FigureAxis moment_axis(const std::string& label,
                               const std::vector<const FigurePanel*>& panels) {
  std::vector<FigureSeries> ok, all;
  for (const auto* panel : panels) {
    for (const auto& series : panel->series) {
      all.push_back(series);
      ok.push_back(series);
      std::erase_if(ok.back().points, &FigurePoint::open);
    }
  }
  const bool any_ok = std::ranges::any_of(ok, [](const FigureSeries& series) {
    return std::ranges::any_of(series.points,
                               [](const FigurePoint& point) { return std::isfinite(point.y); });
  });
  return report::linear_axis(label, any_ok ? ok : all, &FigurePoint::y);
}

}  // namespace

report::FigureAxis l1_distance_axis(const std::string& label,
                                    const std::vector<FigurePanel>& panels,
                                    std::size_t rows_above) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const auto& panel : panels) {
    const auto range = report::coordinate_range(panel.series, &FigurePoint::y, 0);
    low = std::min(low, range.least);
    high = std::max(high, range.greatest);
  }
  if (high == 0) low = 1e-3, high = 1;
  constexpr double kLargest = 20, kDecades = 1e8;  // the L1 distance of two densities is at most 2
  high = 1.5 * std::min(high, kLargest);
  low = std::max(low / 1.5, high / kDecades);
  const double rows = kMarkRowHeight * static_cast<double>(rows_above);
  return {label, low, high * std::pow(high / low, rows / (1 - rows)), true};
}

double status_mark_row_ordinate(const report::FigureAxis& axis, std::size_t row) {
  return axis.from *
         std::pow(axis.to / axis.from, 1 - kMarkRowHeight * (static_cast<double>(row) + 0.5));
}

report::Figure distance_curves_figure(const SweepResultsView& view) {
  const SweepCurves curves(view);
  report::Figure figure = curves.panels();
  std::vector<std::size_t> without_density;
  for (std::size_t m = 0; m < curves.method_count(); ++m) {
    for (std::size_t point = 0; point < view.sweep_plan().points.size(); ++point) {
      if (!lacks_density(view, point, m)) continue;
      without_density.push_back(m);
      break;
    }
  }
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const StateVariable variable = k % 2 == 0 ? StateVariable::y : StateVariable::ydot;
    figure.panels[k].series = DistanceSeries(view, curves, curves.slices()[k / 2], variable).all();
  }
  const std::string reference = view.common_reference_id();
  const auto axis = l1_distance_axis("", figure.panels, without_density.size());
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    FigurePanel& panel = figure.panels[k];
    panel.y = axis;
    panel.y.label = fmt::format(
        "{{/:Italic L}}_1 distance of {} to {}",
        report::density_in_enhanced_text(k % 2 == 0 ? StateVariable::y : StateVariable::ydot),
        reference.empty() ? "the reference" : report::escape_enhanced_text(reference));
    for (auto& series :
         no_density_series(view, curves, curves.slices()[k / 2], without_density, axis)) {
      panel.series.push_back(std::move(series));
    }
  }
  return figure;
}

report::Figure moment_curves_figure(const SweepResultsView& view) {
  const SweepCurves curves(view);
  report::Figure figure = curves.panels();
  const auto fill = [&](std::size_t first, const std::string& label, double Moments::*moment,
                        double MomentSlopes::*slope) {
    std::vector<const FigurePanel*> panels;
    for (std::size_t k = first; k < figure.panels.size(); k += 2) {
      FigurePanel& panel = figure.panels[k];
      for (std::size_t m = curves.method_count(); m-- > 0;) {
        panel.series.push_back(
            curves.curve(curves.slices()[k / 2], m,
                         [&](std::size_t, std::size_t,
                             const SweepMethodResult& result) -> std::optional<double> {
                           if (!result.moments) return std::nullopt;
                           return (*result.moments).*moment;
                         }));
        FigureSeries tangents = curves.tangents(curves.slices()[k / 2], m, moment, slope);
        if (!tangents.points.empty()) panel.series.push_back(std::move(tangents));
      }
      panels.push_back(&panel);
    }
    const report::FigureAxis axis = moment_axis(label, panels);
    for (std::size_t k = first; k < figure.panels.size(); k += 2) figure.panels[k].y = axis;
  };
  fill(0, "E[{/:Italic y}^2]", &Moments::y2, &MomentSlopes::y2);
  fill(1, "E[{/:Italic y}'^2]", &Moments::v2, &MomentSlopes::v2);
  return figure;
}

}  // namespace fpkcheck::sweep
