#include "report/figure/pictures.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/files/file_transaction.hpp"
#include "base/process/stop_request.hpp"
#include "report/budget/budget_figure.hpp"
#include "report/figure/convergence_figure.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/figure/density_figure.hpp"
#include "report/figure/drawing.hpp"
#include "report/figure/error_source_figure.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::report {
namespace fs = std::filesystem;
namespace {

std::string budget_file_stem(const std::string& stem) { return stem + "-budget"; }
std::string error_source_file_stem(const std::string& stem) { return stem + "-sources"; }
std::string convergence_file_stem(const std::string& stem) { return stem + "-order"; }

// @param warnings list to which a line is added for each case that has no density to draw
std::vector<PictureScript> make_picture_scripts(const results::Run& run,
                                                const FigureOptions& options,
                                                std::vector<std::string>& warnings) {
  std::vector<PictureScript> pictures;
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
    pictures.push_back(
        {stem,
         make_gnuplot_script(density_figure(case_result.problem, content, width), stem, width)});
    if (const Figure budget = budget_figure(case_result, width); !budget.panels.empty()) {
      pictures.push_back(
          {budget_file_stem(stem), make_gnuplot_script(budget, budget_file_stem(stem), width)});
    }
    if (const Figure sources = error_source_figure(case_result, width); !sources.panels.empty()) {
      pictures.push_back({error_source_file_stem(stem),
                          make_gnuplot_script(sources, error_source_file_stem(stem), width)});
    }
    if (const Figure convergence = convergence_figure(case_result); !convergence.panels.empty()) {
      pictures.push_back({convergence_file_stem(stem),
                          make_gnuplot_script(convergence, convergence_file_stem(stem), width)});
    }
  }
  return pictures;
}

}  // namespace

void remove_pictures_of_cases(const fs::path& directory, const results::Run& run) {
  for (const auto& case_result : run.cases) {
    const auto stem = results::case_file_stem(case_result.name());
    for (const auto& each : {stem, budget_file_stem(stem), error_source_file_stem(stem),
                             convergence_file_stem(stem)}) {
      remove_script_and_pictures(directory / "figures", each);
    }
  }
}

std::vector<std::string> draw_pictures_of_cases(
    const fs::path& directory, const results::Run& run, const FigureOptions& options,
    const std::string& gnuplot, const std::vector<PictureScript>& additional_pictures) {
  const fs::path figures = directory / "figures";
  std::vector<std::string> warnings;
  auto pictures = make_picture_scripts(run, options, warnings);
  pictures.insert(pictures.end(), additional_pictures.begin(), additional_pictures.end());
  fs::create_directories(figures);
  remove_pictures_of_cases(directory, run);
  for (const auto& picture : additional_pictures) remove_script_and_pictures(figures, picture.stem);
  std::vector<std::string> stems;
  for (const auto& [stem, script] : pictures) {
    base::write_file_atomically(figures / (stem + ".gp"), script);
    stems.push_back(stem);
  }
  try {
    for (auto& warning : draw_scripts_in_all_formats(gnuplot, figures, stems, options)) {
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
