#pragma once

#include <string>

#include "report/figure/figure.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::study {

struct StudyReport {
  std::string file_stem;      ///< stem of the file names, e.g. "study-order"
  std::string json;           ///< contents of STEM.json, with null for missing numbers
  std::string csv;            ///< contents of STEM.csv with a header; missing numbers are empty
  std::string text;           ///< tables, and sentences that summarise the numbers
  std::string figure_script;  ///< gnuplot script that draws STEM.png; empty without a figure
};

/// Makes the report of a study. Less important columns are omitted if table rows exceed the width
/// of `format`.
template <class Study>
StudyReport make_study_report(const Study& study, const std::string& command,
                              const report::TextFormat& format,
                              report::FigureWidth width = report::FigureWidth::screen) {
  const std::string stem = std::string("study-") + Study::kName;
  const report::Figure drawn = figure(study);
  return {stem, json(study, command), csv(study), table(study, format),
          drawn.panels.empty() ? "" : report::figure_script(drawn, stem, width)};
}

}  // namespace fpkcheck::study
