#pragma once

#include <string>

#include "report/figure/figure.hpp"
#include "report/text/text_layout.hpp"

namespace fpkcheck::study {

struct StudyReport {
  std::string file_stem;      ///< stem of the file names, e.g. "study-order"
  std::string json;           ///< contents of STEM.json; missing numbers are null
  std::string csv;            ///< contents of STEM.csv with a header; missing numbers are empty
  std::string text;           ///< tables with sentences that summarise their numbers
  std::string figure_script;  ///< gnuplot script that draws STEM.png; empty without a figure
  std::string netcdf = {};    ///< contents of STEM.nc; empty without this file
  std::string page = {};      ///< contents of STEM.html; empty without this file
};

/// Returns the files and texts of a study. If the rows of a table exceed the width of `format`, the
/// table omits its least important columns.
template <class Study>
StudyReport make_study_report(const Study& study, const std::string& command,
                              const report::TerminalTextFormat& format,
                              report::FigureWidth width = report::FigureWidth::screen) {
  const std::string stem = Study::kFileStem;
  const report::Figure drawn = study_figure(study);
  StudyReport report{stem, study_json_text(study, command), study_csv_text(study),
                     study_table_text(study, format),
                     drawn.panels.empty() ? "" : report::make_gnuplot_script(drawn, stem, width)};
  if constexpr (requires { study_netcdf_bytes(study, command); })
    report.netcdf = study_netcdf_bytes(study, command);
  if constexpr (requires { study_page_html(study, command); })
    report.page = study_page_html(study, command);
  return report;
}

}  // namespace fpkcheck::study
