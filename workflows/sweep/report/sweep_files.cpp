#include "workflows/sweep/report/sweep_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/files/file_transaction.hpp"
#include "base/process/stop_request.hpp"
#include "workflows/sweep/report/figure/figures.hpp"
#include "workflows/sweep/report/page/sweep_page.hpp"

namespace fpkcheck::sweep {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPage = "report.html";

// The report page embeds each picture as SVG, which is sharp at any size, or as PNG if the SVG file
// is large.
std::vector<EmbeddedPicture> drawn_pictures(const fs::path& figures,
                                            const std::vector<SweepFigure>& pictures) {
  constexpr std::uintmax_t kLargestSvg = 1'000'000;
  std::vector<EmbeddedPicture> drawn;
  for (const auto& picture : pictures) {
    fs::path file = figures / (picture.stem + ".svg");
    std::error_code error;
    const auto size = fs::file_size(file, error);
    const bool as_png = error || size > kLargestSvg;
    if (as_png) file.replace_extension(".png");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) continue;
    drawn.push_back({picture.caption,
                     as_png ? "image/png" : "image/svg+xml",
                     {std::istreambuf_iterator<char>(stream), {}}});
  }
  return drawn;
}

}  // namespace

void write_sweep_tables(const fs::path& directory, const SweepResults& results,
                        const std::string& command) {
  base::FileTransaction files;
  files.add(directory / "sweep.csv", sweep_csv_text(results));
  files.add(directory / "sweep.nc", sweep_netcdf_bytes(results, command));
  files.remove(directory / kPage);
  files.commit();
}

std::vector<std::string> write_report(const fs::path& directory, const SweepResults& results,
                                      const std::string& command,
                                      const report::FigureOptions& options,
                                      const std::string& gnuplot) {
  const auto pictures = sweep_figures(results, options.width);
  const fs::path figures = directory / "figures";
  report::FigureOptions drawn = options;
  // PNG and SVG files are always drawn, since the report page needs both formats.
  for (const auto format : {report::FigureFormat::png, report::FigureFormat::svg}) {
    if (std::ranges::count(drawn.formats, format) == 0) drawn.formats.push_back(format);
  }
  auto warnings = draw_sweep_figures(figures, pictures, drawn, gnuplot);
  if (base::stop_requested()) return warnings;
  base::write_file_atomically(directory / kPage,
                              sweep_page(results, drawn_pictures(figures, pictures), command));
  return warnings;
}

}  // namespace fpkcheck::sweep
