#include "report/report.hpp"

#include <optional>

#include "files/pending_files.hpp"
#include "parameters/input_error.hpp"
#include "report/figure/pictures.hpp"
#include "report/page/page.hpp"
#include "report/table.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPageFile = "report.html";

// The run that was saved there; nothing where there is none of ours: then the pictures are not ours
// either.
std::optional<results::Run> earlier_run(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(directory / results::kSummaryFile, ignored)) return std::nullopt;
  try {
    return results::load_summary(directory / results::kSummaryFile);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::string> write_report(const fs::path& directory, const results::Run& run,
                                      const FigureOptions& figures,
                                      const std::vector<FileBeside>& beside) {
  const auto earlier = earlier_run(directory);
  files::PendingFiles files;
  results::add_run(files, directory, run);
  files.add(directory / kPageFile, page(run));
  for (const auto& [name, text] : beside) files.add(directory / name, text);
  files.commit();
  if (earlier) remove_pictures(directory, *earlier);
  return draw_pictures(directory, run, figures);
}

ReportAgain report_again(const fs::path& directory, const results::Run& run,
                         const TextFormat& format, const FigureOptions& figures) {
  // All of it before anything is written.
  const std::string html = page(run);
  ReportAgain again{table(run, format), {}};
  files::write_file(directory / kPageFile, html);
  again.warnings = draw_pictures(directory, run, figures);
  return again;
}

}  // namespace fpkcheck::report
