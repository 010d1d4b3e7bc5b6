#include "report/figure/order_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/convergence_over_order.hpp"
#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_parts.hpp"
#include "report/figure/text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

constexpr const char* kTitles[] = {"displacement", "velocity"};
constexpr const char* kUncertaintyColour = "#555555";

/// The style of a family's curve: the style of the middle member of the family. Members that are
/// not ok have open marks.
struct FamilyStyle {
  std::string colour;
  PointTypes points;
};

FamilyStyle family_style(const SolutionFamily& family) {
  const auto& plot_style = family.solutions[family.solutions.size() / 2]->identity.plot_style;
  return {gnuplot_string(plot_style.colour), point_types(plot_style.symbol)};
}

std::string family_line_style(const FamilyStyle& plot_style) {
  return fmt::format("with linespoints linewidth 2 linecolor rgb {} pointtype {} pointsize 1.3",
                     plot_style.colour, plot_style.points.filled);
}

std::string open_mark_style(const FamilyStyle& plot_style) {
  return fmt::format("with points linewidth 2 linecolor rgb {} pointtype {} pointsize 1.3",
                     plot_style.colour, plot_style.points.open);
}

// An external density is drawn as a mark at its order, or as a horizontal line if the density has
// no order.
std::string external_density_style(const Solution& external_density) {
  const std::string colour = gnuplot_string(external_density.identity.plot_style.colour);
  if (!external_density.identity.order) {
    return fmt::format("with lines linewidth 2 dashtype (20,6) linecolor rgb {}", colour);
  }
  const auto [filled, open] = point_types(external_density.identity.plot_style.symbol);
  return fmt::format("with points linewidth 2 linecolor rgb {} pointtype {} pointsize 1.6", colour,
                     external_density.is_ok() ? filled : open);
}

std::string uncertainty_style(const UncertaintyLine& line) {
  return fmt::format("with lines linewidth 1.5 dashtype {} linecolor rgb '{}'",
                     std::string(line.dash) == "dot" ? "(2,4)" : "(8,4)", kUncertaintyColour);
}

std::string block_identifier(transform::Variable variable, const char* what, std::size_t number) {
  return fmt::format("{}_{}{}", name(variable), what, number);
}

/// The data blocks and the plot commands of one panel.
class OrderPanel {
 public:
  explicit OrderPanel(const ConvergenceOverOrder& distances) : distances_(distances) {
    const auto [first, last] = distances.order_range();
    from_ = first - 1;
    to_ = last + 1;
    for (const SolutionFamily& family : distances.families) add(family);
    for (const Solution* external_density : distances.external_densities) add(*external_density);
    for (const UncertaintyLine& line : distances.uncertainty_lines) {
      const std::string block = store_block("level", horizontal_line_rows(line.l1));
      plots_.push_back(fmt::format("${} using 1:2 {} notitle", block, uncertainty_style(line)));
    }
  }

  const std::string& data() const { return data_; }

  std::string commands(char letter, const PanelBox& place) const {
    return fmt::format("set title '({}) {}'\n{}set xrange [{}:{}]\nset ylabel {}\nplot {}\n\n",
                       letter, kTitles[distances_.variable == transform::Variable::y ? 0 : 1],
                       panel_position_commands(place), from_, to_,
                       gnuplot_text(fmt::format("{{/:Italic L}}_1 distance of {} to {}",
                                                density_symbol(distances_.variable),
                                                escape_enhanced_text(distances_.reference->id()))),
                       fmt::join(plots_, ", \\\n     "));
  }

 private:
  // A member that is not ok gets a white filled mark, and an open mark over the filled mark.
  void add(const SolutionFamily& family) {
    std::string all, hollow;
    for (const Solution* member : family.solutions) {
      const std::string row =
          fmt::format("{} {:.6g}\n", *member->identity.order, distances_.l1(*member));
      all += row;
      if (!member->is_ok()) hollow += row;
    }
    const FamilyStyle plot_style = family_style(family);
    plots_.push_back(fmt::format("${} using 1:2 {} notitle", store_block("family", all),
                                 family_line_style(plot_style)));
    if (hollow.empty()) return;
    const std::string block = store_block("hollow", hollow);
    plots_.push_back(
        fmt::format("${} using 1:2 with points linecolor rgb 'white' pointtype {} "
                    "pointsize 1.3 notitle",
                    block, plot_style.points.filled));
    plots_.push_back(fmt::format("${} using 1:2 {} notitle", block, open_mark_style(plot_style)));
  }

  void add(const Solution& external_density) {
    const double l1 = distances_.l1(external_density);
    const auto& order = external_density.identity.order;
    const std::string block = store_block(
        "guest", order ? fmt::format("{} {:.6g}\n", *order, l1) : horizontal_line_rows(l1));
    plots_.push_back(
        fmt::format("${} using 1:2 {} notitle", block, external_density_style(external_density)));
  }

  std::string horizontal_line_rows(double l1) const {
    return fmt::format("{0} {2:.6g}\n{1} {2:.6g}\n", from_, to_, l1);
  }

  std::string store_block(const char* what, const std::string& rows) {
    const std::string block = block_identifier(distances_.variable, what, plots_.size());
    data_ += data_block(block, rows);
    return block;
  }

  const ConvergenceOverOrder& distances_;
  int from_, to_;
  std::string data_;
  std::vector<std::string> plots_;
};

Legend order_legend(const ConvergenceOverOrder& distances) {
  Legend legend{{}, 4};
  bool any_hollow = false;
  for (const SolutionFamily& family : distances.families) {
    legend.entries.push_back({"NaN " + family_line_style(family_style(family)), family.name});
    any_hollow = any_hollow || !std::ranges::all_of(family.solutions, &Solution::is_ok);
  }
  for (const Solution* external_density : distances.external_densities) {
    legend.entries.push_back(
        {"NaN " + external_density_style(*external_density), external_density->id()});
  }
  if (any_hollow) {
    legend.entries.push_back(
        {"NaN with points linecolor rgb '#444444' linewidth 2 pointtype 6 pointsize 1.3",
         "open: not ok"});
  }
  for (const UncertaintyLine& line : distances.uncertainty_lines) {
    legend.entries.push_back({"NaN " + uncertainty_style(line), line.name});
  }
  return legend;
}

std::vector<ConvergenceOverOrder> order_panels(const results::CaseResult& case_result) {
  std::vector<ConvergenceOverOrder> all;
  for (const auto variable : transform::kVariables) {
    if (auto distances = convergence_over_order(case_result, variable))
      all.push_back(std::move(*distances));
  }
  return all;
}

}  // namespace

bool has_several_orders(const results::CaseResult& case_result) {
  return !order_panels(case_result).empty();
}

std::string order_script(const results::CaseResult& case_result, const std::string& file_stem,
                         FigureWidth width) {
  constexpr int kOnScreen = 1100;
  const auto all = order_panels(case_result);
  const bool narrow = width == FigureWidth::one_column;
  const Legend entries = order_legend(all.front());
  PanelGrid grid = panel_grid(width, kOnScreen);
  grid.columns = narrow ? 1 : static_cast<int>(all.size());
  grid.rows = narrow ? static_cast<int>(all.size()) : 1;
  grid.panel_height = narrow ? 200 : 300;
  grid.legend_height = legend_height(entries, grid.width);
  const auto title = figure_title(case_result.problem, grid.size());
  grid.title_height = title.height;

  std::string text = gnuplot_output_commands(file_stem, grid.size());
  std::string commands;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const OrderPanel panel(all[k]);
    text += panel.data();
    commands += panel.commands(static_cast<char>('a' + k), grid.panel_box(k));
  }
  text += fmt::format(
      "set tics out nomirror\nset border 3\nset grid ytics linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\nunset key\n{}"
      "set logscale y\nset format y {}\nset xtics 2\nset xlabel {}\n{}",
      PanelGrid::kLabels, kPowerOfTenFormat, gnuplot_text("order {/:Italic n} of the closure"),
      title.command);
  return text + commands + legend_strip_commands(entries, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
