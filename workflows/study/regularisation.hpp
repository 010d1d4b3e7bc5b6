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

/// A closure of the series on one velocity step, with its growth.
struct RegularisationRow : fd_fpk::RegularisationRow {
  bool symbol_grows = false;
  std::optional<double> growth_rate = {};  ///< of disturbances; empty where none grows
};

/// Effect of the regularisations of the fourth derivative on a sequence of finer steps.
struct RegularisationStudy {
  static constexpr const char* kName = "regularisation";
  problem::Problem problem;
  double default_length, shortest_length;  ///< as in fd_fpk::RegularisationStudy
  std::vector<RegularisationRow> rows;
};

/// fd_fpk::study_regularisation with the growth rates of its rows.
RegularisationStudy study_regularisation(const problem::Problem& problem,
                                         const methods::ProgressListener& listener);
RegularisationStudy add_growth_rates(const problem::Problem& problem,
                                     const fd_fpk::RegularisationStudy& fd_study);

/// True when on the finest step the default length has a density and no growth.
bool has_converged(const RegularisationStudy& study);

/// The parts of a StudyOutput. JSON: the two lengths, and a row for each scheme and step;
/// `growth_rate` is null where nothing grows.
std::string json(const RegularisationStudy& study, const std::string& command);
std::string csv(const RegularisationStudy& study);
/// The rows, remarks on missing values, and sentences that summarise the numbers.
std::string table(const RegularisationStudy& study, const report::TextFormat& format);
/// Empty: this study has no figure.
inline std::string figure(const RegularisationStudy&, const std::string&, report::FigureWidth) {
  return {};
}

Record record(const RegularisationRow& row);

}  // namespace fpkcheck::study
