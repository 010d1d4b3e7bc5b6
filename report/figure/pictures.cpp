#include "report/figure/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/process/stop_request.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::report {
namespace fs = std::filesystem;
namespace {

// Suffixes of the file stems of all pictures of a case.
constexpr const char *kDensities = "", *kBudget = "-budget", *kErrorSources = "-sources",
                     *kConvergence = "-order";

// @param warnings list to which a line is added for each case that has no density to draw
std::vector<PictureGnuplotScript> make_picture_scripts(const results::Run& run,
                                                       const FigureOptions& options,
                                                       std::vector<std::string>& warnings) {
  std::vector<PictureGnuplotScript> pictures;
  for (const auto& case_result : run.cases) {
    DensityFigureContent content = density_content_for_picture(
        case_result, select_solutions_to_draw(case_result, options.curves));
    const std::string stem = results::case_file_stem(case_result.name());
    if (content.marginals.empty()) {
      warnings.push_back(fmt::format(
          "no picture of {}: no solution {}", case_result.name(),
          content.hidden_count == 0 ? "has a density" : "selected by --curves has a density"));
      continue;
    }
    if (!options.curves.empty()) content.hidden_count = 0;  // the user selected the curves
    const auto width = options.width;
    const std::pair<const char*, Figure> figures[] = {
        {kDensities, density_figure(case_result.problem, content, width)},
        {kBudget, error_budget_figure(case_result, width)},
        {kErrorSources, error_source_figure(case_result, width)},
        {kConvergence, convergence_figure(case_result)}};
    for (const auto& [end, figure] : figures) {
      if (figure.panels.empty()) continue;
      pictures.push_back({stem + end, make_gnuplot_script(figure, stem + end, width)});
    }
  }
  return pictures;
}

}  // namespace

void remove_pictures_of_cases(const fs::path& directory, const results::Run& run) {
  for (const auto& case_result : run.cases) {
    const auto stem = results::case_file_stem(case_result.name());
    for (const char* end : {kDensities, kBudget, kErrorSources, kConvergence}) {
      remove_script_and_pictures(directory / "figures", stem + end);
    }
  }
}

std::vector<std::string> draw_pictures_of_cases(
    const fs::path& directory, const results::Run& run, const FigureOptions& options,
    const std::string& gnuplot, const std::vector<PictureGnuplotScript>& additional_pictures) {
  const fs::path figures = directory / "figures";
  std::vector<std::string> warnings;
  auto pictures = make_picture_scripts(run, options, warnings);
  pictures.insert(pictures.end(), additional_pictures.begin(), additional_pictures.end());
  remove_pictures_of_cases(directory, run);
  for (const auto& picture : additional_pictures) remove_script_and_pictures(figures, picture.stem);
  std::ranges::move(
      write_scripts_and_draw(
          figures, pictures, options, gnuplot, "no pictures",
          fmt::format("; install gnuplot, then run `fpkcheck report {}`", directory.string())),
      std::back_inserter(warnings));
  return base::stop_requested() ? std::vector<std::string>() : warnings;
}

}  // namespace fpkcheck::report
