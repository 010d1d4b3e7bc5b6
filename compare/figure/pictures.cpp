#include "compare/figure/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "compare/budget/figure.hpp"
#include "compare/figure/drawing.hpp"
#include "compare/figure/script.hpp"
#include "compare/run_directory.hpp"

namespace fpkcheck::compare {
namespace fs = std::filesystem;

std::string picture_stem(std::string case_name) {
  std::ranges::replace_if(
      case_name,
      [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_' && c != '.'; }, '_');
  return case_name;
}

std::string budget_stem(const std::string& stem) { return stem + "-budget"; }

void remove_pictures(const fs::path& directory, const nlohmann::ordered_json& summary) {
  for (const auto& summary_case : summary.at("cases")) {
    const auto stem = picture_stem(summary_case.at("name").get<std::string>());
    for (const auto& each : {stem, budget_stem(stem)}) {
      remove_pictures_of(directory / "figures", each);
    }
  }
}

std::vector<std::string> draw_pictures(const fs::path& directory,
                                       const nlohmann::ordered_json& summary,
                                       std::span<const MarginalCurve> curves,
                                       const std::string& gnuplot) {
  const fs::path figures = directory / "figures";
  fs::create_directories(figures);
  std::vector<std::string> warnings;
  bool drawing = true;
  const auto draw_both = [&](const std::string& stem, const std::string& text) {
    const fs::path script = figures / (stem + ".gp");
    write_file(script, text);
    for (const char* format : {".png", ".svg"}) {
      if (!drawing) break;
      try {
        draw(gnuplot, script, figures / (stem + format));
      } catch (const GnuplotMissing& missing) {
        warnings.push_back(
            fmt::format("no pictures: {} (install gnuplot, then `fpkcheck report {}` draws them)",
                        missing.what(), directory.string()));
        drawing = false;
      } catch (const std::runtime_error& error) {
        warnings.emplace_back(error.what());
      }
    }
  };
  remove_pictures(directory, summary);
  for (const auto& summary_case : summary.at("cases")) {
    const auto name = summary_case.at("name").get<std::string>();
    std::vector<MarginalCurve> own;
    std::ranges::copy_if(curves, std::back_inserter(own),
                         [&](const auto& curve) { return curve.case_name == name; });
    const FigureContent content = figure_content(summary_case, own);
    const std::string stem = picture_stem(name);
    if (content.sides.empty()) {
      warnings.push_back(
          fmt::format("no picture of {}: none of its solutions has a density", name));
      continue;
    }
    draw_both(stem, figure_script(summary_case, content, stem));
    if (has_budget(summary_case)) {
      draw_both(budget_stem(stem), budget_script(summary_case, budget_stem(stem)));
    }
  }
  return warnings;
}

}  // namespace fpkcheck::compare
