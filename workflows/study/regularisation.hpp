#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/regularisation_study.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/options.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// A way to close the series on one step, and whether anything grows.
struct RegularisationRow : fd_fpk::RegularisationRow {
  bool symbol_grows = false;
  std::optional<double> growth_rate = {};  ///< of what is not in the null vector
};

/// What the fourth derivative's regularisations do on finer and finer steps.
struct RegularisationStudy {
  static constexpr const char* kName = "regularisation";
  problem::Problem problem;
  double default_length, shortest_length;  ///< as fd_fpk::RegularisationStudy has them
  std::vector<RegularisationRow> rows;
};

/// fd_fpk::study_regularisation, with its growth rates.
RegularisationStudy study_regularisation(const problem::Problem& problem,
                                         const methods::ProgressListener& listener);
RegularisationStudy with_growth(const problem::Problem& problem,
                                const fd_fpk::RegularisationStudy& found);

/// True when the default length neither grows nor lacks a density on the finest step.
bool reached(const RegularisationStudy& study);

/// The parts of `output`. JSON: the two lengths, and a row per scheme and step; `growth_rate` is
/// null where nothing grows.
std::string json(const RegularisationStudy& study, const std::string& command);
std::string csv(const RegularisationStudy& study);
/// The rows, remarks on what is missing, and what the numbers say.
std::string table(const RegularisationStudy& study, const report::TextFormat& format);
/// There is none.
inline std::string figure(const RegularisationStudy&, const std::string&, report::FigureWidth) {
  return {};
}

Record record(const RegularisationRow& row);

}  // namespace fpkcheck::study
