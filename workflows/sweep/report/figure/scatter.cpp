#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "report/figure/frame.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_parts.hpp"
#include "report/figure/text.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
using report::PanelGrid;
namespace {

constexpr std::size_t kMaxBins = 8;
constexpr std::size_t kMinPointsForMedian = 3;  // for the median in a section of a range
constexpr double kWordSpread = 0.6;             // width of the spread of methods, 1 being a word's

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// A varied key with the bins over which medians are taken: single values if the key has few
/// values, else sections of the range.
class BinnedKey {
 public:
  BinnedKey(const Plan& plan, std::size_t place) : axis_(plan, place), place_(place) {
    if (axis_.has_words() || axis_.values().size() <= kMaxBins) return;
    low_ = scaled(axis_.values().front());
    high_ = scaled(axis_.values().back());
    sections_ = std::clamp<std::size_t>(plan.points.size() / 10, 3, kMaxBins);
  }

  const KeyAxis& axis() const { return axis_; }
  std::size_t place() const { return place_; }
  bool is_enough(std::size_t points) const {
    return sections_ == 0 || points >= kMinPointsForMedian;
  }
  std::size_t bin(const base::Value& value) const {
    if (sections_ == 0) return axis_.cell_index(value);
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

  KeyAxis axis_;
  std::size_t place_;
  double low_ = 0, high_ = 0;
  std::size_t sections_ = 0;  // number of sections; 0 where each value is a bin
};

// The data blocks of a method: the results with the columns "x L1 point-type", and the medians over
// the bins with the columns "x median".
std::string blocks(const SweepView& view, const BinnedKey& key, std::size_t m, double offset,
                   const report::SeriesStyle& plot_style) {
  std::string points;
  std::map<std::size_t, std::vector<double>> ok;
  for (const auto& point : view.results().points) {
    const auto l1 = view.larger_l1(point.point, m);
    if (!l1 || *l1 <= 0) continue;
    const auto& value = view.plan().points[point.point][key.place()];
    const bool is_ok = point.methods[m].status == transform::Status::ok;
    points += fmt::format("{:.6g} {:.4g} {}\n", key.axis().coordinate(value) + offset, *l1,
                          is_ok ? plot_style.filled : plot_style.open);
    if (is_ok) ok[key.bin(value)].push_back(*l1);
  }
  std::string medians;
  for (const auto& [bin, values] : ok) {
    if (!key.is_enough(values.size())) continue;
    medians += fmt::format("{:.6g} {:.4g}\n", key.centre(bin) + offset, median_of(values));
  }
  // A block without results gets a row of NaN, since gnuplot rejects a data block without a row.
  const std::string none = "NaN NaN NaN\n";
  return report::data_block(fmt::format("points_{}_{}", key.place(), m),
                            points.empty() ? none : points) +
         report::data_block(fmt::format("median_{}_{}", key.place(), m),
                            medians.empty() ? none : medians);
}

std::string distance_range(const SweepView& view) {
  double low = 1, high = 1e-6;
  for (const auto& point : view.results().points) {
    for (const std::size_t m : view.compared_methods()) {
      const auto l1 = view.larger_l1(point.point, m);
      if (!l1 || *l1 <= 0) continue;
      low = std::min(low, *l1);
      high = std::max(high, *l1);
    }
  }
  constexpr double kLargest = 20, kDecades = 1e8;
  high = std::min(high, kLargest) * 1.5;
  return fmt::format("set yrange [{:.4g}:{:.4g}]\n", std::max(low / 1.5, high / kDecades), high);
}

}  // namespace

std::string scatter_script(const SweepView& view, const std::string& file_stem) {
  const Plan& plan = view.plan();
  const auto methods = view.compared_methods();
  std::vector<transform::SolutionIdentity> identities;
  for (const std::size_t m : methods) identities.push_back(plan.methods[m].identity);
  const auto looks = report::series_styles(identities);
  const double size = view.results().points.size() > 200 ? 0.35 : 0.6;

  report::Legend legend{{}, 3};
  for (std::size_t k = 0; k < methods.size(); ++k) {
    legend.entries.push_back(
        {fmt::format("NaN with linespoints lc rgb '{}' lw 2.5 dt {} pt {} ps 1", looks[k].colour,
                     looks[k].dash, looks[k].filled),
         identities[k].id});
  }
  legend.entries.push_back({"NaN with points lc rgb '#444444' lw 1.5 pt 6 ps 1", "open: not ok"});
  legend.entries.push_back({"NaN with lines lc rgb '#444444' lw 2.5", "median of ok"});
  const int keys = static_cast<int>(plan.axes.size());
  const int columns = view.medium() == report::FigureWidth::one_column ? 1 : 2;
  const PanelGrid grid{.medium = view.medium(),
                       .width = view.width(),
                       .columns = columns,
                       .rows = (keys + columns - 1) / columns,
                       .panel_height = 280,
                       .title_height = view.title().height,
                       .legend_height = report::legend_height(legend, view.width())};

  std::string data, panels;
  for (std::size_t place = 0; place < plan.axes.size(); ++place) {
    const BinnedKey key(plan, place);
    std::vector<std::string> points, medians;
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(methods.size());
      const double offset = key.axis().has_words() ? kWordSpread * (part - 0.5) : 0;
      data += blocks(view, key, methods[k], offset, looks[k]);
      points.push_back(fmt::format(
          "$points_{}_{} using 1:2:3 with points lc rgb '{}' lw 1 pt variable ps {} notitle", place,
          methods[k], looks[k].colour, size));
      medians.push_back(fmt::format(
          "$median_{}_{} using 1:2 with {} lc rgb '{}' lw 2.5 notitle", place, methods[k],
          key.axis().has_words() ? fmt::format("points pt {} ps 1.5", looks[k].filled)
                                 : "lines dt " + looks[k].dash,
          looks[k].colour));
    }
    panels += report::panel_position_commands(grid.panel_box(place)) + "unset logscale x\n" +
              key.axis().commands('x') +
              fmt::format("plot {}, \\\n     {}\n\n", fmt::join(points, ", \\\n     "),
                          fmt::join(medians, ", \\\n     "));
  }
  return report::gnuplot_output_commands(file_stem, grid.size()) + data +
         "\nset tics out nomirror\nset border 3\nset grid ytics lc rgb '#DDDDDD' lt 1 lw 0.6\n"
         "unset key\n" +
         std::string(PanelGrid::kLabels) +
         fmt::format("set logscale y\nset format y {}\n", report::kPowerOfTenFormat) +
         distance_range(view) +
         fmt::format("set ylabel {}\n",
                     report::gnuplot_text("larger {/:Italic L}_1 distance of both")) +
         view.title().command + panels + report::legend_strip_commands(legend, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::sweep
