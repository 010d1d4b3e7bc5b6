#include "report/figure/run_gnuplot.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/files/file_transaction.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {

namespace fs = std::filesystem;

namespace {

std::string first_line_of_message(const std::string& text) {
  const auto start = text.find_first_not_of(" \n");
  return start == std::string::npos
             ? "no message"
             : base::to_printable_text(text.substr(start, text.find('\n', start) - start));
}

std::string read_all_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Runs gnuplot on a script and reports errors.
// @param target file that gnuplot writes
// @param picture file that error messages name
void run_gnuplot_script(const std::string& gnuplot, const fs::path& script,
                        const std::string& format, const fs::path& target,
                        const fs::path& picture) {
  const auto outcome = run_gnuplot(gnuplot,
                                   {"format=" + quote_for_gnuplot(format),
                                    "target=" + quote_for_gnuplot(fs::absolute(target).string())},
                                   script);
  if (!outcome.found) throw GnuplotNotFound(fmt::format("'{}' was not found", gnuplot));
  std::error_code error;
  const auto size = fs::file_size(target, error);
  if (outcome.exit_code != 0 || error || size == 0) {
    throw std::runtime_error(fmt::format("{} was not drawn: gnuplot exited with code {} ({})",
                                         picture.string(), outcome.exit_code,
                                         first_line_of_message(outcome.message)));
  }
}

// Sets the printed size in an SVG file. The program gnuplot measures an SVG in pixels and does not
// scale tics and marks. Therefore gnuplot draws the SVG with the size for a screen, and
// set_printed_size() replaces this size.
std::string set_printed_size(std::string svg, double width_mm) {
  int width = 0, height = 0;
  const auto at = svg.find(" width=\"");
  if (at == std::string::npos ||
      std::sscanf(svg.c_str() + at, " width=\"%d\" height=\"%d\"", &width, &height) != 2) {
    return svg;
  }
  const auto end = svg.find('\n', at);
  return svg.replace(
      at, end - at,
      fmt::format(" width=\"{:g}mm\" height=\"{:.2f}mm\"", width_mm, width_mm * height / width));
}

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (fs::temp_directory_path() / "fpkcheck-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("cannot create a temporary directory: check TMPDIR");
    }
    path_ = name;
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Draws a picture in the format tex, and renames the graphics file that STEM.tex includes to
// STEM-tex.pdf. The program gnuplot names the graphics file STEM.pdf, like a picture in the format
// pdf, and writes the directory into STEM.tex. The name STEM-tex.pdf in STEM.tex has no directory,
// so that LaTeX's \graphicspath applies.
void draw_latex_picture(const std::string& gnuplot, const fs::path& script,
                        const fs::path& picture) {
  const TemporaryDirectory directory;
  const fs::path drawn = directory.path() / "drawn.tex", graphics = directory.path() / "drawn.pdf";
  run_gnuplot_script(gnuplot, script, "tex", drawn, picture);
  const std::string included = picture.stem().string() + "-tex.pdf";
  std::string text = read_all_bytes(drawn);
  const std::string name = (directory.path() / "drawn").string();
  if (const auto at = text.find(name); at != std::string::npos) {
    text.replace(at, name.size(), included);
  }
  base::FileTransaction files;
  files.add(picture, text);
  files.add(picture.parent_path() / included, read_all_bytes(graphics));
  files.commit();
}

}  // namespace

void draw_picture(const std::string& gnuplot, const fs::path& script, const fs::path& picture,
                  FigureWidth width) {
  const std::string format = picture.extension().string().substr(1);
  if (format == name(FigureFormat::tex)) {
    draw_latex_picture(gnuplot, script, picture);
    return;
  }
  base::replace_file_atomically(picture, [&](const fs::path& temporary) {
    run_gnuplot_script(gnuplot, script, format, temporary, picture);
    if (format != name(FigureFormat::svg) || width == FigureWidth::screen) return;
    const std::string svg = set_printed_size(read_all_bytes(temporary), printed_width_mm(width));
    std::ofstream(temporary, std::ios::binary | std::ios::trunc) << svg;
  });
}

std::vector<std::string> write_scripts_and_draw(const fs::path& figures,
                                                const std::vector<PictureGnuplotScript>& pictures,
                                                const FigureOptions& options,
                                                const std::string& gnuplot,
                                                const std::string& subject,
                                                const std::string& remedy) {
  fs::create_directories(figures);
  for (const auto& [stem, script] : pictures) {
    base::write_file_atomically(figures / (stem + ".gp"), script);
  }
  // With more than four simultaneous gnuplot processes, a picture on a busy machine could exceed
  // its time limit.
  constexpr int kMaxProcesses = 4;
  const std::size_t formats = options.formats.size();
  std::vector<std::string> warnings(pictures.size() * formats);
  const auto draw = [&](std::size_t k) {
    if (base::stop_requested()) return;
    const std::string& stem = pictures[k / formats].stem;
    try {
      draw_picture(gnuplot, figures / (stem + ".gp"),
                   figures / fmt::format("{}.{}", stem, name(options.formats[k % formats])),
                   options.width);
    } catch (const GnuplotNotFound&) {
      throw;
    } catch (const std::runtime_error& error) {
      warnings[k] = error.what();
    }
  };
  try {
    base::parallel_for(warnings.size(), std::min(kMaxProcesses, base::available_processors()),
                       draw);
  } catch (const GnuplotNotFound& missing) {
    return {fmt::format("{}: {}{}", subject, missing.what(), remedy)};
  }
  // After a stop request a missing picture gives no warning, since the user requested the stop.
  if (base::stop_requested()) return {};
  std::erase(warnings, "");
  return warnings;
}

std::vector<std::string> write_script_and_draw(const fs::path& figures, const std::string& stem,
                                               const std::string& script,
                                               const FigureOptions& options,
                                               const std::string& gnuplot) {
  return write_scripts_and_draw(
      figures, {{stem, script}}, options, gnuplot, "no picture",
      fmt::format("; install gnuplot, then run `cd {} && gnuplot {}.gp`", figures.string(), stem));
}

void remove_script_and_pictures(const fs::path& figures, const std::string& stem) {
  std::error_code ignored;
  for (const char* ending : {".png", ".svg", ".pdf", ".tex", "-tex.pdf", ".gp"}) {
    fs::remove(figures / (stem + ending), ignored);
  }
}

}  // namespace fpkcheck::report
