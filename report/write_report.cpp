#include "report/write_report.hpp"

#include <optional>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "report/figure/case_figures.hpp"
#include "report/page/page_sections.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPageFile = "report.html";

// Returns the run saved in a directory, or nothing if the directory has no readable summary.
// Pictures in a directory without a readable summary are kept, since these pictures may belong to
// another program.
std::optional<results::Run> load_earlier_run(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(directory / results::kSummaryFile, ignored)) return std::nullopt;
  try {
    return results::load_run_summary(directory / results::kSummaryFile);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::string> write_report(const fs::path& directory, const results::Run& run,
                                      const FigureOptions& figures,
                                      const ReportSupplement& supplement) {
  const auto earlier = load_earlier_run(directory);
  base::FileTransaction files;
  results::add_run_files(files, directory, run);
  files.add(directory / kPageFile, report_page_html(run, supplement));
  for (const auto& [name, text] : supplement.files) files.add(directory / name, text);
  files.commit();
  if (earlier) remove_pictures_of_cases(directory, *earlier);
  return draw_pictures_of_cases(directory, run, figures, "gnuplot", supplement.pictures);
}

std::string terminal_report_text(const results::Run& run, const ReportSupplement& supplement,
                                 const TerminalTextFormat& format) {
  std::string text;
  for (const auto& sentence : supplement.summary) text += wrap_text(sentence, format.width);
  if (!text.empty()) text += '\n';
  return text + terminal_tables_text(run, format) + supplement.text;
}

ReportRebuiltFromFiles rebuild_report(const fs::path& directory, const results::Run& run,
                                      const TerminalTextFormat& format,
                                      const FigureOptions& figures,
                                      const ReportSupplement& supplement) {
  // The terminal text of a report is made before any file is written, so that an exception leaves
  // all files unchanged.
  ReportRebuiltFromFiles again{terminal_report_text(run, supplement, format), {}};
  base::FileTransaction files;
  files.add(directory / kPageFile, report_page_html(run, supplement));
  for (const auto& [name, text] : supplement.files) files.add(directory / name, text);
  files.commit();
  again.warnings = draw_pictures_of_cases(directory, run, figures, "gnuplot", supplement.pictures);
  return again;
}

}  // namespace fpkcheck::report
