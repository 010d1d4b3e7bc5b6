#include "report/figure/density_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <set>

#include "report/figure/layout.hpp"
#include "report/figure/panel.hpp"

namespace fpkcheck::report {
namespace {

std::string curve_block(const std::string& name, const std::vector<double>& abscissa,
                        const std::vector<double>& values, const std::vector<double>& lower,
                        const std::vector<double>& upper) {
  const auto value_at = [](const std::vector<double>& column, std::size_t k) {
    return column.empty() ? std::numeric_limits<double>::quiet_NaN() : column[k];
  };
  std::string text = name + " << EOD\n";
  for (std::size_t k = 0; k < abscissa.size(); ++k) {
    text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", abscissa[k], values[k], value_at(lower, k),
                        value_at(upper, k));
  }
  return text + "EOD\n";
}

std::string data(const FigureContent& content) {
  std::string text =
      "# Columns: abscissa, density or its difference from the reference, lower and upper end of "
      "the 95 % interval\n";
  for (const auto& marginal : content.marginals) {
    for (const auto& drawn : marginal.curves) {
      const results::Curve& c = *drawn.curve;
      const CurveDifference& d = drawn.difference;
      text += curve_block(block_name(marginal, drawn), c.abscissa, c.density, c.lower, c.upper);
      if (d.empty()) continue;
      text += curve_block(difference_block_name(marginal, drawn), d.abscissa, d.values, d.lower,
                          d.upper);
    }
  }
  return text;
}

std::string settings() {
  return "\n"
         "positive(p) = p > 0 ? p : NaN\n"
         "at_least_smallest(p) = p > smallest ? p : smallest\n"
         "set grid linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\n"
         "set tics nomirror\n"
         "set border 3\n\n";
}

/// A panel and its letter.
struct LetteredPanel {
  Panel panel;
  std::size_t marginal;
  char letter;
};

// The panels row by row, lettered as in the paper. A figure for a single journal column omits
// panels, and letters the remaining panels consecutively.
std::vector<LetteredPanel> placed_panels(const FigureContent& content, FigureWidth width) {
  std::vector<Panel> shown{Panel::linear, Panel::logarithmic};
  if (!content.reference.empty()) {
    shown.push_back(content.smooth_differences ? Panel::smooth_difference : Panel::difference);
    if (width == FigureWidth::one_column) shown.erase(shown.begin());
  }
  std::vector<LetteredPanel> placed;
  for (std::size_t marginal = 0; marginal < content.marginals.size(); ++marginal) {
    const bool of_y = content.marginals[marginal].variable == transform::Variable::y;
    for (const Panel panel : shown) {
      const char letter = panel == Panel::linear        ? (of_y ? 'a' : 'c')
                          : panel == Panel::logarithmic ? (of_y ? 'b' : 'd')
                                                        : (of_y ? 'e' : 'f');
      placed.push_back({panel, marginal, letter});
    }
  }
  if (width == FigureWidth::one_column) {
    for (std::size_t k = 0; k < placed.size(); ++k) placed[k].letter = static_cast<char>('a' + k);
  }
  return placed;
}

PanelGrid grid_for(std::size_t panels, std::size_t marginals, FigureWidth width) {
  constexpr int kOnScreen = 1500;
  const bool narrow = width == FigureWidth::one_column;
  PanelGrid grid = panel_grid(width, kOnScreen);
  grid.columns = narrow ? 1 : static_cast<int>(panels / marginals);
  grid.rows = static_cast<int>(panels) / grid.columns;
  grid.panel_height = width == FigureWidth::screen ? 280 : narrow ? 140 : 210;
  return grid;
}

std::string legend_label(const DrawnCurve& drawn) {
  const auto& solution = *drawn.solution;
  std::string label = solution.id();
  if (!solution.is_ok()) label += fmt::format(" ({})", name(solution.status));
  // A curve cannot show atoms: the label states the probabilities of the atoms.
  for (const auto& atom : solution.atoms) {
    label += fmt::format(", probability {:.3g} of rest at y = {:g}", atom.probability, atom.y);
  }
  if (!drawn.curve->lower.empty()) label += ", with 95 % intervals";
  return label;
}

std::string legend_plot(const DrawnCurve& drawn) {
  const bool with_interval = !drawn.curve->lower.empty();
  std::string plot = fmt::format("{} {}", with_interval ? "'+' using 1:(NaN):(0):(0)" : "NaN",
                                 curve_style(drawn.plot_style(), with_interval));
  if (!has_marks(drawn.solution->identity)) return plot;
  const std::string lines = "with lines ";
  return plot.replace(plot.find(lines), lines.size(), "with linespoints ") + ' ' +
         mark_style(*drawn.solution);
}

Legend legend(const FigureContent& content, FigureWidth width) {
  Legend legend{{}, 5};
  std::set<std::string> listed;
  for (const auto& marginal : content.marginals) {
    for (const auto& drawn : marginal.curves) {
      if (!listed.insert(drawn.curve->solution).second) continue;
      legend.entries.push_back({legend_plot(drawn), legend_label(drawn)});
    }
  }
  if (content.smooth_differences && listed.contains(content.reference)) {
    legend.entries.push_back({fmt::format("NaN {}", kReferenceIntervalStyle),
                              fmt::format("half-width of the interval of {}", content.reference)});
  }
  // The hint appears only in figures for a screen, since the hint names a command-line option.
  if (content.hidden_count > 0 && width == FigureWidth::screen) {
    legend.entries.push_back({"NaN with lines linetype nodraw",
                              fmt::format("{} more curves: --curves all", content.hidden_count)});
  }
  return legend;
}

}  // namespace

std::string density_script(const problem::Problem& problem, const FigureContent& content,
                           const std::string& file_stem, FigureWidth width) {
  const Legend entries = legend(content, width);
  const auto placed = placed_panels(content, width);
  PanelGrid grid = grid_for(placed.size(), content.marginals.size(), width);
  grid.legend_height = legend_height(entries, grid.width);
  const FigureTitle title = figure_title(problem, grid.size());
  grid.title_height = title.height;
  std::string panels;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    const auto& [panel, marginal, letter] = placed[k];
    panels += panel_position_commands(grid.panel_box(k)) +
              panel_commands(panel, content.marginals[marginal], letter, content.reference,
                             width != FigureWidth::screen);
  }
  return gnuplot_output_commands(file_stem, grid.size()) +
         "dot = format eq 'svg' ? 0.45 : 0.6\nmark = format eq 'svg' ? 0.8 : 1.1\n"
         // By default the box of a point type erases the lines below a confidence interval, and in
         // SVG also lines in a wide area around the interval.
         "set pointintervalbox 0.0001\n\n" +
         data(content) + settings() + PanelGrid::kLabels + title.command + panels +
         legend_strip_commands(entries, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
