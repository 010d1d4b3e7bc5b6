#include "report/figure/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::StateVariable;

/// The kind of a panel of one marginal density: the density on a linear or on a logarithmic axis,
/// the difference from the reference solution, or the absolute difference over smooth bins.
enum class DensityPanelKind { linear, logarithmic, difference, smooth_difference };

bool shows_differences(DensityPanelKind kind) {
  return kind == DensityPanelKind::difference || kind == DensityPanelKind::smooth_difference;
}

std::string panel_title(DensityPanelKind kind, StateVariable variable, const std::string& reference,
                        bool is_short) {
  const std::string name(base::meaning_of(variable));
  const auto with_variable_name = [&](const std::string& what) {
    return is_short ? what : name + ", " + what;
  };
  switch (kind) {
    case DensityPanelKind::linear:
      return name;
    case DensityPanelKind::logarithmic:
      return is_short ? name : with_variable_name("logarithmic");
    case DensityPanelKind::difference:
      return with_variable_name("difference from " + reference);
    case DensityPanelKind::smooth_difference:
      return with_variable_name("|difference from " + reference + "|");
  }
  return "";
}

FigureAxis abscissa_axis(DensityPanelKind kind, const MarginalDensityCurves& marginal) {
  const MarginalAxisRanges& r = marginal.ranges;
  const bool is_logarithmic = kind == DensityPanelKind::logarithmic;
  const double from = is_logarithmic ? r.logarithmic_from : r.linear_from,
               to = is_logarithmic ? r.logarithmic_to : r.linear_to;
  return {marginal.variable == StateVariable::y ? "{/:Italic y}" : "{/:Italic y}'", from, to, false,
          choose_tick_step(from, to)};
}

FigureAxis ordinate_axis(DensityPanelKind kind, const MarginalDensityCurves& marginal,
                         double smallest_density) {
  const MarginalAxisRanges& r = marginal.ranges;
  const std::string density = density_in_enhanced_text(marginal.variable);
  switch (kind) {
    case DensityPanelKind::linear:
      return {density, 0, 1.08 * r.linear_top};
    case DensityPanelKind::logarithmic:
      return {density, logarithmic_axis_bottom(r, smallest_density), logarithmic_axis_top(r), true};
    case DensityPanelKind::difference: {
      // If all differences from the reference are 0, any axis range is suitable.
      const double half = r.largest_difference > 0 ? 1.1 * r.largest_difference : 1;
      return {"Δ" + density, -half, half};
    }
    case DensityPanelKind::smooth_difference: {
      const auto [least, most] = difference_axis_decades(r);
      return {"|Δ" + density + "|", least, most, true};
    }
  }
  return {};
}

// Returns the legend note with the probabilities of atoms of mass at rest, which a curve cannot
// show.
std::string atom_and_interval_note(const DrawnDensityCurve& drawn) {
  std::string label;
  for (const auto& atom : drawn.solution->atoms) {
    label += fmt::format(", probability {:.3g} of rest at y = {:g}", atom.probability, atom.y);
  }
  if (drawn.plot_style().as_points && !drawn.curve->lower.empty()) label += ", with 95 % intervals";
  return label;
}

// Returns whether the curve of a solution has marks, which distinguish curves in grey print. Curves
// of closures and external densities have marks; curves of solutions of density equations have
// lines only.
bool curve_has_marks(const transform::SolutionIdentity& identity) {
  return !identity.plot_style.as_points && (identity.role == transform::SolutionRole::closure ||
                                            identity.role == transform::SolutionRole::external);
}

// Returns the series of a curve. The series has no points if the panel shows differences from the
// reference and the curve has none.
FigureSeries curve_series(const DrawnDensityCurve& drawn, DensityPanelKind kind,
                          const std::string& reference) {
  const bool of_differences = shows_differences(kind);
  const CurveDifferenceFromReference& difference = drawn.difference;
  const auto& places = of_differences ? difference.abscissa : drawn.curve->abscissa;
  const auto& values = of_differences ? difference.values : drawn.curve->density;
  const auto& lower = of_differences ? difference.lower : drawn.curve->lower;
  const auto& upper = of_differences ? difference.upper : drawn.curve->upper;
  const auto& plot_style = drawn.plot_style();
  const std::string& id = drawn.solution->id();
  const bool has_status_ok = drawn.solution->has_status_ok();
  FigureSeries series = make_empty_figure_series(
      has_status_ok ? id : fmt::format("{} ({})", id, name(drawn.solution->status)), plot_style);
  series.line_width = plot_style.width;
  series.note = atom_and_interval_note(drawn);
  if (kind == DensityPanelKind::smooth_difference && id == reference) {
    // The panel of differences shows the half-widths of the confidence intervals as the curve of
    // the reference.
    series = {.name = fmt::format("half-width of the interval of {}", reference),
              .colour = "#444444",
              .dash = "(1,3)"};
  } else if (plot_style.as_points) {
    // Largest number of points on a simulated curve, since more points would hide the lines of
    // other curves.
    constexpr std::size_t kPointsOnACurve = 35;
    series.mark_step = std::max<std::size_t>(1, places.size() / kPointsOnACurve);
    series.dash = "";
    series.symbol = plot_style.symbol + "-open";
    series.mark_size = 0.8;
  } else if (curve_has_marks(drawn.solution->identity)) {
    series.mark_size = 1.1;
  } else {
    series.symbol = "";
  }
  series.group = id;
  series.rank = drawn.rank;
  series.is_hidden = drawn.is_hidden;
  const bool with_interval = plot_style.as_points && !lower.empty() && !upper.empty();
  for (std::size_t k = 0; k < places.size(); ++k) {
    series.points.push_back({.x = places[k], .y = values[k], .open = !has_status_ok});
    if (!with_interval) continue;
    series.points.back().lower = lower[k];
    series.points.back().upper = upper[k];
  }
  return series;
}

FigurePanel density_panel(DensityPanelKind kind, const MarginalDensityCurves& marginal,
                          const DensityFigureContent& content, bool short_title) {
  FigurePanel result{.title = escape_enhanced_text(
                         panel_title(kind, marginal.variable, content.reference, short_title)),
                     .x = abscissa_axis(kind, marginal),
                     .y = ordinate_axis(kind, marginal, content.smallest_density)};
  if (kind == DensityPanelKind::linear) result.note = density_spike_note(marginal.ranges);
  std::vector<FigureSeries*> marked;
  for (const auto& drawn : marginal.curves) {
    result.series.push_back(curve_series(drawn, kind, content.reference));
  }
  for (auto& series : result.series) {
    if (!series.symbol.empty() && !series.dash.empty()) marked.push_back(&series);
  }
  // A density curve has at most kMarksOnACurve marks, which distinguish curves in grey print. The
  // marks of different curves have different abscissae, since the curves may nearly coincide.
  constexpr std::size_t kMarksOnACurve = 8;
  for (std::size_t k = 0; k < marked.size(); ++k) {
    marked[k]->mark_step = std::max<std::size_t>(1, marked[k]->points.size() / kMarksOnACurve);
    marked[k]->first_mark = k * marked[k]->mark_step / marked.size();
  }
  return result;
}

std::string page_caption(StateVariable variable, const DensityFigureContent& content) {
  std::string caption(base::meaning_of(variable));
  caption.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(caption.front())));
  caption += fmt::format(" {}: ", variable_in_plain_text(variable));
  if (!content.reference.empty()) {
    caption += "difference from " + content.reference;
    if (content.smooth_differences) {
      caption += " over smooth bins, with the half-width of its 95 % confidence intervals";
    }
    caption += "; ";
  }
  return caption + "logarithm of the density; density";
}

}  // namespace

Figure density_figure(const problem::Problem& problem, const DensityFigureContent& content,
                      FigureWidth width) {
  const bool narrow = width == FigureWidth::one_column;
  std::vector<DensityPanelKind> shown{DensityPanelKind::linear, DensityPanelKind::logarithmic};
  if (!content.reference.empty()) {
    shown.push_back(content.smooth_differences ? DensityPanelKind::smooth_difference
                                               : DensityPanelKind::difference);
    if (narrow) shown.erase(shown.begin());
  }
  Figure figure{.title = problem_title_parts(problem),
                .columns = static_cast<int>(shown.size()),
                .screen_width = 1500,
                .panel_height = 280};
  for (const auto& marginal : content.marginals) {
    const bool of_y = marginal.variable == StateVariable::y;
    const std::string caption = page_caption(marginal.variable, content);
    for (const DensityPanelKind kind : shown) {
      figure.panels.push_back(density_panel(kind, marginal, content, width != FigureWidth::screen));
      figure.panels.back().id = fmt::format("density-{}", name(marginal.variable));
      figure.panels.back().caption = caption;
      if (narrow) continue;  // a narrow figure letters its panels consecutively
      figure.panels.back().letter = kind == DensityPanelKind::linear        ? (of_y ? "a" : "c")
                                    : kind == DensityPanelKind::logarithmic ? (of_y ? "b" : "d")
                                                                            : (of_y ? "e" : "f");
    }
  }
  // The legend note on hidden curves appears only in figures for a screen, since the note names a
  // command-line option.
  if (content.hidden_count > 0 && width == FigureWidth::screen) {
    figure.legend_note = fmt::format("{} more curves: --curves all", content.hidden_count);
  }
  return figure;
}

}  // namespace fpkcheck::report
