#include "report/figure/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>

#include "files/pending_files.hpp"
#include "parameters/shown.hpp"
#include "process/stop.hpp"
#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {

namespace fs = std::filesystem;

namespace {

std::string first_line(const std::string& text) {
  const auto start = text.find_first_not_of(" \n");
  return start == std::string::npos
             ? "it said nothing"
             : parameters::shown(text.substr(start, text.find('\n', start) - start));
}

}  // namespace

void draw(const std::string& gnuplot, const fs::path& script, const fs::path& picture) {
  files::replace_file(picture, [&](const fs::path& temporary) {
    const std::string format = picture.extension().string().substr(1);
    const auto outcome = run_gnuplot(gnuplot,
                                     {"format=" + gnuplot_string(format),
                                      "target=" + gnuplot_string(fs::absolute(temporary).string())},
                                     script);
    if (!outcome.found) {
      throw GnuplotMissing(fmt::format("'{}' was not found", gnuplot));
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

std::vector<std::string> draw_both(const std::string& gnuplot, const fs::path& figures,
                                   const std::string& stem) {
  // What went wrong, or nothing.
  const auto attempt = [&](const char* format) -> std::vector<std::string> {
    try {
      draw(gnuplot, figures / (stem + ".gp"), figures / (stem + format));
    } catch (const GnuplotMissing&) {
      throw;
    } catch (const std::runtime_error& error) {
      return {error.what()};
    }
    return {};
  };
  auto svg = std::async(std::launch::async, attempt, ".svg");
  auto warnings = attempt(".png");
  std::ranges::move(svg.get(), std::back_inserter(warnings));
  return warnings;
}

std::vector<std::string> write_pictures(const fs::path& figures, const std::string& stem,
                                        const std::string& script, const std::string& gnuplot) {
  fs::create_directories(figures);
  files::write_file(figures / (stem + ".gp"), script);
  try {
    if (process::stop_requested()) return {};
    auto warnings = draw_both(gnuplot, figures, stem);
    return process::stop_requested() ? std::vector<std::string>() : warnings;
  } catch (const GnuplotMissing& missing) {
    return {fmt::format("no picture: {} (install gnuplot, then `cd {} && gnuplot {}.gp` draws it)",
                        missing.what(), figures.string(), stem)};
  }
}

void remove_pictures_of(const fs::path& figures, const std::string& stem) {
  std::error_code ignored;
  for (const char* extension : {".png", ".svg", ".gp"}) {
    fs::remove(figures / (stem + extension), ignored);
  }
}

}  // namespace fpkcheck::report
