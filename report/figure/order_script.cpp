#include "report/figure/order_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/convergence.hpp"
#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/legend_strip.hpp"
#include "report/figure/panel_grid.hpp"
#include "report/figure/script_parts.hpp"
#include "report/figure/text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

constexpr const char* kTitles[] = {"displacement", "velocity"};
constexpr const char* kOfLevels = "#555555";

/// Style of a family: that of its middle member. Members that are not ok have open marks.
struct FamilyLook {
  std::string colour;
  PointTypes points;
};

FamilyLook look_of(const Family& family) {
  const auto& look = family.solutions[family.solutions.size() / 2]->identity.look;
  return {gnuplot_string(look.colour), point_types(look.symbol)};
}

std::string with_family(const FamilyLook& look) {
  return fmt::format("with linespoints linewidth 2 linecolor rgb {} pointtype {} pointsize 1.3",
                     look.colour, look.points.filled);
}

std::string with_members(const FamilyLook& look) {
  return fmt::format("with points linewidth 2 linecolor rgb {} pointtype {} pointsize 1.3",
                     look.colour, look.points.open);
}

// An external density: a mark at its order, or a horizontal line without an order.
std::string with_guest(const Solution& guest) {
  const std::string colour = gnuplot_string(guest.identity.look.colour);
  if (!guest.identity.order) {
    return fmt::format("with lines linewidth 2 dashtype (20,6) linecolor rgb {}", colour);
  }
  const auto [filled, open] = point_types(guest.identity.look.symbol);
  return fmt::format("with points linewidth 2 linecolor rgb {} pointtype {} pointsize 1.6", colour,
                     guest.is_ok() ? filled : open);
}

std::string with_level(const Level& level) {
  return fmt::format("with lines linewidth 1.5 dashtype {} linecolor rgb '{}'",
                     std::string(level.dash) == "dot" ? "(2,4)" : "(8,4)", kOfLevels);
}

std::string name_of_block(transform::Variable variable, const char* what, std::size_t number) {
  return fmt::format("{}_{}{}", name(variable), what, number);
}

/// Data and commands of a panel.
class OrderPanel {
 public:
  explicit OrderPanel(const Convergence& found) : found_(found) {
    const auto [first, last] = found.orders();
    from_ = first - 1;
    to_ = last + 1;
    for (const Family& family : found.families) add(family);
    for (const Solution* guest : found.guests) add(*guest);
    for (const Level& level : found.levels) {
      const std::string block = put("level", across(level.l1));
      plots_.push_back(fmt::format("${} using 1:2 {} notitle", block, with_level(level)));
    }
  }

  const std::string& data() const { return data_; }

  std::string commands(char letter, const Place& place) const {
    return fmt::format("set title '({}) {}'\n{}set xrange [{}:{}]\nset ylabel {}\nplot {}\n\n",
                       letter, kTitles[found_.variable == transform::Variable::y ? 0 : 1],
                       margins(place), from_, to_,
                       gnuplot_text(fmt::format("{{/:Italic L}}_1 distance of {} to {}",
                                                density_of(found_.variable),
                                                without_marks(found_.reference->id()))),
                       fmt::join(plots_, ", \\\n     "));
  }

 private:
  // Members that are not ok get a white filled mark, then an open mark, over the filled mark.
  void add(const Family& family) {
    std::string all, hollow;
    for (const Solution* member : family.solutions) {
      const std::string row =
          fmt::format("{} {:.6g}\n", *member->identity.order, found_.l1(*member));
      all += row;
      if (!member->is_ok()) hollow += row;
    }
    const FamilyLook look = look_of(family);
    plots_.push_back(
        fmt::format("${} using 1:2 {} notitle", put("family", all), with_family(look)));
    if (hollow.empty()) return;
    const std::string block = put("hollow", hollow);
    plots_.push_back(
        fmt::format("${} using 1:2 with points linecolor rgb 'white' pointtype {} "
                    "pointsize 1.3 notitle",
                    block, look.points.filled));
    plots_.push_back(fmt::format("${} using 1:2 {} notitle", block, with_members(look)));
  }

  void add(const Solution& guest) {
    const double l1 = found_.l1(guest);
    const auto& order = guest.identity.order;
    const std::string block =
        put("guest", order ? fmt::format("{} {:.6g}\n", *order, l1) : across(l1));
    plots_.push_back(fmt::format("${} using 1:2 {} notitle", block, with_guest(guest)));
  }

  std::string across(double l1) const {
    return fmt::format("{0} {2:.6g}\n{1} {2:.6g}\n", from_, to_, l1);
  }

  std::string put(const char* what, const std::string& rows) {
    const std::string block = name_of_block(found_.variable, what, plots_.size());
    data_ += data_block(block, rows);
    return block;
  }

  const Convergence& found_;
  int from_, to_;
  std::string data_;
  std::vector<std::string> plots_;
};

Legend legend_of(const Convergence& found) {
  Legend legend{{}, 4};
  bool any_hollow = false;
  for (const Family& family : found.families) {
    legend.entries.push_back({"NaN " + with_family(look_of(family)), family.name});
    any_hollow = any_hollow || !std::ranges::all_of(family.solutions, &Solution::is_ok);
  }
  for (const Solution* guest : found.guests) {
    legend.entries.push_back({"NaN " + with_guest(*guest), guest->id()});
  }
  if (any_hollow) {
    legend.entries.push_back(
        {"NaN with points linecolor rgb '#444444' linewidth 2 pointtype 6 pointsize 1.3",
         "open: not ok"});
  }
  for (const Level& level : found.levels) {
    legend.entries.push_back({"NaN " + with_level(level), level.name});
  }
  return legend;
}

std::vector<Convergence> panels_of(const results::Case& one) {
  std::vector<Convergence> all;
  for (const auto variable : transform::kVariables) {
    if (auto found = convergence(one, variable)) all.push_back(std::move(*found));
  }
  return all;
}

}  // namespace

bool has_orders(const results::Case& one) { return !panels_of(one).empty(); }

std::string order_script(const results::Case& one, const std::string& file_stem,
                         FigureWidth width) {
  constexpr int kOnScreen = 1100;
  const auto all = panels_of(one);
  const bool narrow = width == FigureWidth::one_column;
  const Legend entries = legend_of(all.front());
  PanelGrid grid = panel_grid(width, kOnScreen);
  grid.columns = narrow ? 1 : static_cast<int>(all.size());
  grid.rows = narrow ? static_cast<int>(all.size()) : 1;
  grid.panel_height = narrow ? 200 : 300;
  grid.legend_height = legend_height(entries, grid.width);
  const auto title = figure_title(one.problem, grid.size());
  grid.title_height = title.height;

  std::string text = figure_output(file_stem, grid.size());
  std::string commands;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const OrderPanel panel(all[k]);
    text += panel.data();
    commands += panel.commands(static_cast<char>('a' + k), grid.place(k));
  }
  text += fmt::format(
      "set tics out nomirror\nset border 3\nset grid ytics linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\nunset key\n{}"
      "set logscale y\nset format y {}\nset xtics 2\nset xlabel {}\n{}",
      PanelGrid::kLabels, kPowersOfTen, gnuplot_text("order {/:Italic n} of the closure"),
      title.command);
  return text + commands + legend_strip(entries, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
