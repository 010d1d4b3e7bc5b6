#include "compare/figure/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

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

void remove_pictures(const fs::path& directory, const nlohmann::ordered_json& summary) {
  for (const auto& summary_case : summary.at("cases")) {
    remove_pictures_of(directory / "figures",
                       picture_stem(summary_case.at("name").get<std::string>()));
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
  for (const auto& summary_case : summary.at("cases")) {
    const auto name = summary_case.at("name").get<std::string>();
    std::vector<MarginalCurve> own;
    std::ranges::copy_if(curves, std::back_inserter(own),
                         [&](const auto& curve) { return curve.case_name == name; });
    const FigureContent content = figure_content(summary_case, own);
    const std::string stem = picture_stem(name);
    remove_pictures_of(figures, stem);
    if (content.sides.empty()) {
      warnings.push_back(
          fmt::format("no picture of {}: none of its solutions has a density", name));
      continue;
    }
    const fs::path script = figures / (stem + ".gp");
    write_file(script, figure_script(summary_case, content, stem));
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
  }
  return warnings;
}

}  // namespace fpkcheck::compare
