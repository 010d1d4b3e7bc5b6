#pragma once

#include <string>

#include "report/figure/figure.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::study {

struct StudyReport {
  std::string file_stem;      ///< stem of the file names, e.g. "study-order"
  std::string json;           ///< contents of STEM.json; missing numbers are null
  std::string csv;            ///< contents of STEM.csv with a header; missing numbers are empty
  std::string text;           ///< tables with sentences that summarise their numbers
  std::string figure_script;  ///< gnuplot script that draws STEM.png; empty without a figure
  std::string netcdf = {};    ///< contents of STEM.nc; empty without this file
};

/// Makes the report of a study. If table rows exceed the width of `format`, the least important
/// columns are omitted.
template <class Study>
StudyReport make_study_report(const Study& study, const std::string& command,
                              const report::TextFormat& format,
                              report::FigureWidth width = report::FigureWidth::screen) {
  const std::string stem = Study::kFileStem;
  const report::Figure drawn = figure(study);
  StudyReport report{stem, json(study, command), csv(study), table(study, format),
                     drawn.panels.empty() ? "" : report::figure_script(drawn, stem, width)};
  if constexpr (requires { netcdf(study, command); }) report.netcdf = netcdf(study, command);
  return report;
}

}  // namespace fpkcheck::study
