#include "report/figure/pictures.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/files/file_transaction.hpp"
#include "base/process/stop_request.hpp"
#include "report/budget/figure.hpp"
#include "report/figure/convergence_figure.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/figure/density_figure.hpp"
#include "report/figure/drawing.hpp"
#include "report/figure/error_source_figure.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::report {
namespace fs = std::filesystem;
namespace {

std::string budget_stem(const std::string& stem) { return stem + "-budget"; }
std::string sources_stem(const std::string& stem) { return stem + "-sources"; }
std::string order_stem(const std::string& stem) { return stem + "-order"; }

// @param warnings list to which a line is added for each case that has no density to draw
std::vector<PictureScript> pictures_of(const results::Run& run, const FigureOptions& options,
                                       std::vector<std::string>& warnings) {
  std::vector<PictureScript> pictures;
  for (const auto& case_result : run.cases) {
    FigureContent content = figure_content(case_result, select_curves(case_result, options.curves));
    const std::string stem = results::file_stem(case_result.name());
    if (content.marginals.empty()) {
      warnings.push_back(fmt::format(
          "no picture of {}: no solution {}", case_result.name(),
          content.hidden_count == 0 ? "has a density" : "selected by --curves has a density"));
      continue;
    }
    if (!options.curves.empty()) content.hidden_count = 0;  // the user selected the curves
    const auto width = options.width;
    pictures.push_back(
        {stem, figure_script(density_figure(case_result.problem, content, width), stem, width)});
    if (const Figure budget = budget_figure(case_result, width); !budget.panels.empty()) {
      pictures.push_back({budget_stem(stem), figure_script(budget, budget_stem(stem), width)});
    }
    if (const Figure sources = error_source_figure(case_result, width); !sources.panels.empty()) {
      pictures.push_back({sources_stem(stem), figure_script(sources, sources_stem(stem), width)});
    }
    if (const Figure convergence = convergence_figure(case_result); !convergence.panels.empty()) {
      pictures.push_back({order_stem(stem), figure_script(convergence, order_stem(stem), width)});
    }
  }
  return pictures;
}

}  // namespace

void remove_pictures(const fs::path& directory, const results::Run& run) {
  for (const auto& case_result : run.cases) {
    const auto stem = results::file_stem(case_result.name());
    for (const auto& each : {stem, budget_stem(stem), sources_stem(stem), order_stem(stem)}) {
      remove_script_and_pictures(directory / "figures", each);
    }
  }
}

std::vector<std::string> draw_pictures(const fs::path& directory, const results::Run& run,
                                       const FigureOptions& options, const std::string& gnuplot,
                                       const std::vector<PictureScript>& others) {
  const fs::path figures = directory / "figures";
  std::vector<std::string> warnings;
  auto pictures = pictures_of(run, options, warnings);
  pictures.insert(pictures.end(), others.begin(), others.end());
  fs::create_directories(figures);
  remove_pictures(directory, run);
  for (const auto& picture : others) remove_script_and_pictures(figures, picture.stem);
  std::vector<std::string> stems;
  for (const auto& [stem, script] : pictures) {
    base::write_file_atomically(figures / (stem + ".gp"), script);
    stems.push_back(stem);
  }
  try {
    for (auto& warning : draw_formats(gnuplot, figures, stems, options)) {
      warnings.push_back(std::move(warning));
    }
  } catch (const GnuplotMissing& missing) {
    warnings.push_back(
        fmt::format("no pictures: {}; install gnuplot, then run `fpkcheck report {}`",
                    missing.what(), directory.string()));
  }
  return base::stop_requested() ? std::vector<std::string>() : warnings;
}

}  // namespace fpkcheck::report
