#include "compare/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "compare/figure_script.hpp"
#include "compare/gnuplot.hpp"
#include "compare/run_directory.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;

struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string first_line(const std::string& text) {
  const auto start = text.find_first_not_of(" \n");
  return start == std::string::npos ? "it said nothing"
                                    : text.substr(start, text.find('\n', start) - start);
}

void draw(const std::string& gnuplot, const fs::path& script, const fs::path& picture) {
  replace_file(picture, [&](const fs::path& temporary) {
    const std::string format = picture.extension().string().substr(1);
    const auto outcome = run_gnuplot(gnuplot,
                                     {"format=" + gnuplot_string(format),
                                      "target=" + gnuplot_string(fs::absolute(temporary).string())},
                                     script);
    if (!outcome.found) {
      throw GnuplotMissing(fmt::format(
          "no pictures: '{}' was not found (install gnuplot, then `fpkcheck report {}` draws them)",
          gnuplot, script.parent_path().parent_path().string()));
    }
    std::error_code error;
    const auto size = fs::file_size(temporary, error);
    if (outcome.exit_code != 0 || error || size == 0) {
      throw std::runtime_error(fmt::format("{} was not drawn: gnuplot ended with code {} ({})",
                                           picture.string(), outcome.exit_code,
                                           first_line(outcome.message)));
    }
  });
}

void remove_pictures_of(const fs::path& figures, const std::string& stem) {
  std::error_code ignored;
  for (const char* extension : {".png", ".svg", ".gp"})
    fs::remove(figures / (stem + extension), ignored);
}

}  // namespace

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
        warnings.emplace_back(missing.what());
        drawing = false;
      } catch (const std::runtime_error& error) {
        warnings.emplace_back(error.what());
      }
    }
  }
  return warnings;
}

}  // namespace fpkcheck::compare
