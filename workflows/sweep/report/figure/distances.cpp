#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/figure/gnuplot.hpp"
#include "report/figure/text.hpp"
#include "workflows/sweep/report/figure/curve_script.hpp"

namespace fpkcheck::sweep {
namespace {

using transform::Variable;

constexpr const char* kReferenceErrorColour = "#DEDEDE";
constexpr const char* kReferenceErrorEdge = "#AAAAAA";
// The styles of error estimates: a dotted line, and small dots at the points.
constexpr const char* kDotted = "lw 1.5 dt (2,4)";
constexpr const char* kDots = "pt 7 ps 0.25";
constexpr double kCrossRowHeight = 0.045;  // height of a row of crosses, 1 being the panel's

/// A builder of the gnuplot script of the distances.
class DistancesScript {
 public:
  DistancesScript(const SweepView& view, const CurvesLayout& layout) : data_(view, layout) {
    scan_points();
  }
  std::string script(const std::string& file_stem) const;

 private:
  void scan_points();
  double row_ordinate(std::size_t row) const;
  std::string absent_blocks() const;
  std::string error_estimate_plot(std::size_t slice, std::size_t m, int distance, int own) const;
  std::string panel(std::size_t slice, Variable variable) const;
  report::Legend legend() const;

  CurveData data_;
  double low_ = 0, high_ = 0;                 // ends of the ordinate's range
  std::vector<std::size_t> without_density_;  // methods that lack a density at some point
  bool has_open_marks_ = false, has_error_estimates_ = false, has_reference_errors_ = false;
};

void DistancesScript::scan_points() {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  const auto add = [&](const std::optional<double>& number) {
    if (!number || !std::isfinite(*number) || *number <= 0) return;
    low = std::min(low, *number);
    high = std::max(high, *number);
  };
  data_.for_each([&](std::size_t point, std::size_t m) {
    for (const Variable variable : transform::kVariables) {
      const auto l1 = data_.l1(point, m, variable),
                 own = data_.method_error_estimate(point, m, variable),
                 reference_error = data_.reference_error(point, variable);
      for (const auto& each : {l1, own, reference_error}) add(each);
      const auto* one = data_.view().method_result(point, m);
      has_open_marks_ = has_open_marks_ || (l1 && one->status != transform::Status::ok);
      has_error_estimates_ = has_error_estimates_ || own;
      has_reference_errors_ = has_reference_errors_ || reference_error;
    }
    if (data_.has_no_density(point, m) && std::ranges::count(without_density_, m) == 0) {
      without_density_.push_back(m);
    }
  });
  if (high == 0) low = 1e-3, high = 1;
  constexpr double kLargest = 20, kDecades = 1e8;  // L1 of two densities is at most 2
  high = 1.5 * std::min(high, kLargest);
  low_ = std::max(low / 1.5, high / kDecades);
  const double rows = kCrossRowHeight * static_cast<double>(without_density_.size());
  high_ = high * std::pow(high / low_, rows / (1 - rows));
}

double DistancesScript::row_ordinate(std::size_t row) const {
  return low_ * std::pow(high_ / low_, 1 - kCrossRowHeight * (static_cast<double>(row) + 0.5));
}

std::string DistancesScript::absent_blocks() const {
  std::string text;
  for (std::size_t s = 0; s < data_.layout().slices.size(); ++s) {
    for (std::size_t row = 0; row < without_density_.size(); ++row) {
      const std::size_t m = without_density_[row];
      std::string rows;
      for (const std::size_t point : data_.layout().slices[s].points) {
        rows += fmt::format("{:.6g} {}\n", data_.abscissa_of(point, m),
                            data_.has_no_density(point, m) ? data_cell(row_ordinate(row)) : "NaN");
      }
      text += report::data_block(fmt::format("absent_{}_{}", s, m), rows);
    }
  }
  return text;
}

// The plots of the error estimates. On a categorical axis a line connects the distance and the
// error estimate.
std::string DistancesScript::error_estimate_plot(std::size_t slice, std::size_t m, int distance,
                                                 int own) const {
  const std::string_view colour = data_.plot_style(m).colour;
  if (data_.has_words()) {
    return fmt::format(
        "$curve_{}_{} using {}:{}:(0):(${}-${}) with vectors nohead lc rgb '{}' {} notitle", slice,
        m, static_cast<int>(abscissa), distance, own, distance, colour, kDotted);
  }
  return fmt::format("$curve_{}_{} using {}:{} with linespoints lc rgb '{}' {} {} notitle", slice,
                     m, static_cast<int>(abscissa), own, colour, kDotted, kDots);
}

std::string DistancesScript::panel(std::size_t slice, Variable variable) const {
  const bool is_y = variable == Variable::y;
  std::vector<std::string> plots;
  if (has_reference_errors_) {
    plots.push_back(
        fmt::format("$floor_{0} using 1:({1:.4g}):{2} with filledcurves fc rgb '{3}' notitle, "
                    "$floor_{0} using 1:{2} with lines lc rgb '{4}' lw 1 notitle",
                    slice, low_, is_y ? 2 : 3, kReferenceErrorColour, kReferenceErrorEdge));
  }
  for (const std::size_t m : data_.view().compared_methods()) {
    const int distance = is_y ? distance_y : distance_ydot;
    if (has_error_estimates_)
      plots.push_back(
          error_estimate_plot(slice, m, distance, is_y ? error_estimate_y : error_estimate_ydot));
    plots.push_back(curve_plot_command(data_, slice, m, distance));
  }
  for (const std::size_t m : without_density_) {
    plots.push_back(
        fmt::format("$absent_{}_{} using 1:2 with points lc rgb '{}' lw 2 pt 2 ps 0.8 notitle",
                    slice, m, data_.plot_style(m).colour));
  }
  const std::string reference = data_.view().common_reference();
  return fmt::format(
      "set ylabel {}\nplot {}\n\n",
      report::gnuplot_text(fmt::format(
          "{{/:Italic L}}_1 distance of {} to {}", report::density_symbol(variable),
          reference.empty() ? "the reference" : report::escape_enhanced_text(reference))),
      fmt::join(plots, ", \\\n     "));
}

report::Legend DistancesScript::legend() const {
  report::Legend legend = curves_legend(data_, data_.view().compared_methods(), has_open_marks_);
  if (has_error_estimates_) {
    legend.entries.push_back(
        {data_.has_words()
             ? fmt::format("NaN with lines lc rgb '#444444' {}", kDotted)
             : fmt::format("NaN with linespoints lc rgb '#444444' {} {}", kDotted, kDots),
         "error estimate"});
  }
  if (has_reference_errors_) {
    legend.entries.push_back({fmt::format("NaN with boxes fs solid border rgb '{}' fc rgb '{}'",
                                          kReferenceErrorEdge, kReferenceErrorColour),
                              "error of the reference"});
  }
  if (!without_density_.empty()) {
    legend.entries.push_back({"NaN with points lc rgb '#444444' lw 2 pt 2 ps 0.8", "no density"});
  }
  return legend;
}

std::string DistancesScript::script(const std::string& file_stem) const {
  const report::Legend strip = legend();
  const report::PanelGrid grid = curves_grid(data_, strip);
  std::string text = curves_script_beginning(data_, grid, file_stem) +
                     (has_reference_errors_ ? data_.reference_error_blocks() : "") +
                     absent_blocks() +
                     fmt::format(
                         "set logscale y\nset format y {}\n"
                         "set yrange [{:.4g}:{:.4g}]\n\n",
                         report::kPowerOfTenFormat, low_, high_);
  for (std::size_t s = 0; s < data_.layout().slices.size(); ++s) {
    for (const Variable variable : transform::kVariables) {
      text += curves_panel(data_, grid, s, variable) + panel(s, variable);
    }
  }
  return text + report::legend_strip_commands(strip, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace

std::string distances_script(const SweepView& view, const CurvesLayout& layout,
                             const std::string& file_stem) {
  return DistancesScript(view, layout).script(file_stem);
}

}  // namespace fpkcheck::sweep
