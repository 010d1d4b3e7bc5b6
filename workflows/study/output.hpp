#pragma once

#include <string>

#include "report/figure/figure.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::study {

/// The files of a study and its text for the terminal.
struct StudyOutput {
  std::string stem;    ///< stem of its files, e.g. "study-order"
  std::string json;    ///< STEM.json; null for missing numbers
  std::string csv;     ///< STEM.csv, with a header; empty for missing numbers
  std::string table;   ///< for the terminal: tables, and sentences that summarise the numbers
  std::string figure;  ///< a gnuplot script that draws STEM.png; empty without a figure
};

/// @param command command line of the run
/// Makes the files and the text of a study.
/// @param format format of the text; less important columns are omitted if the rows exceed the
///               width
/// @param width medium and width of the figure
template <class Study>
StudyOutput output(const Study& study, const std::string& command, const report::TextFormat& format,
                   report::FigureWidth width = report::FigureWidth::screen) {
  const std::string stem = std::string("study-") + Study::kName;
  const report::Figure drawn = figure(study);
  return {stem, json(study, command), csv(study), table(study, format),
          drawn.panels.empty() ? "" : report::figure_script(drawn, stem, width)};
}

}  // namespace fpkcheck::study
