#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::study {

/// What a study leaves.
struct Output {
  std::string stem;    ///< of its files, e.g. "study-order"
  std::string json;    ///< STEM.json; null where there is no number
  std::string csv;     ///< STEM.csv, under a header; empty where there is no number
  std::string table;   ///< for the terminal: tables, and in sentences what the numbers say
  std::string figure;  ///< a gnuplot script that draws STEM.png; empty for none
};

/// @param command the command line of the run
/// @param format where rows do not fit, the least important columns go
/// @param width where the picture is to stand
template <class Study>
Output output(const Study& study, const std::string& command, const report::TextFormat& format,
              report::FigureWidth width = report::FigureWidth::screen) {
  const std::string stem = std::string("study-") + Study::kName;
  return {stem, json(study, command), csv(study), table(study, format), figure(study, stem, width)};
}

}  // namespace fpkcheck::study
