#include "workflows/sweep/report/figure/figures.hpp"

#include <fmt/format.h>

#include "report/figure/run_gnuplot.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
namespace {

constexpr const char* kDistances = "sweep-distances";
constexpr const char* kMoments = "sweep-moments";
constexpr const char* kMap = "sweep-map";
constexpr const char* kScatter = "sweep-keys";

std::vector<SweepFigure> curve_figures(const SweepResultsView& view, report::FigureWidth width) {
  std::vector<SweepFigure> pictures;
  if (view.has_distances()) {
    pictures.push_back(
        {{kDistances, report::make_gnuplot_script(distance_curves_figure(view), kDistances, width)},
         "L1 distances of p(y) and p(y') to the reference of each point. Open marks: the solution "
         "is not ok. Dotted: error estimate of the method (for a discretised equation: with "
         "respect to that equation, which may differ from the problem's). Grey: error estimate of "
         "the reference, below which distances are not significant. Crosses at the top: solutions "
         "without a density."});
  }
  pictures.push_back(
      {{kMoments, report::make_gnuplot_script(moment_curves_figure(view), kMoments, width)},
       "E[y\u00b2] and E[y\u2032\u00b2]. Open marks: the solution is not ok. The axes cover the "
       "solutions that are ok."});
  return pictures;
}

SweepFigure map_figure(const SweepResultsView& view, report::FigureWidth width) {
  std::string caption =
      "The larger of the L1 distances of p(y) and p(y') to the reference of each point, by "
      "method, from 1e-4 (light) to 1. Marks show the statuses that are not ok.";
  if (const auto reference = view.common_reference_id(); !reference.empty()) {
    caption += fmt::format(" The reference is {} at all points.", reference);
  }
  return {{kMap, report::make_gnuplot_script(distance_map_figure(view), kMap, width)}, caption};
}

}  // namespace

std::vector<SweepFigure> sweep_figures(const SweepResults& results, report::FigureWidth width) {
  const SweepPlan& plan = results.plan;
  if (results.points.empty()) return {};
  const SweepResultsView view(results);
  const bool one_is_words =
      plan.axes.size() == 2 && plan.design == SweepPlanDesign::product &&
      SweepParameterAxis(plan, 0).is_categorical() != SweepParameterAxis(plan, 1).is_categorical();
  if (plan.axes.size() == 1 || one_is_words) return curve_figures(view, width);
  if (!view.has_distances()) return {};
  if (plan.axes.size() == 2) return {map_figure(view, width)};
  return {{{kScatter, report::make_gnuplot_script(distance_scatter_figure(view), kScatter, width)},
           "The larger of the L1 distances of p(y) and p(y') to the reference of each point, "
           "against each key, and the median over the solutions that are ok."}};
}

std::vector<std::string> draw_sweep_figures(const std::filesystem::path& figures,
                                            const std::vector<SweepFigure>& pictures,
                                            const report::FigureOptions& options,
                                            const std::string& gnuplot) {
  for (const char* stem : {kDistances, kMoments, kMap, kScatter}) {
    report::remove_script_and_pictures(figures, stem);
  }
  return report::write_scripts_and_draw(figures, {pictures.begin(), pictures.end()}, options,
                                        gnuplot, "no pictures",
                                        " (install gnuplot, then the same command draws them)");
}

}  // namespace fpkcheck::sweep
