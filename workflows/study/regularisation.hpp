#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/regularisation_study.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// The regularised equation on a grid with one velocity step, with the growth rate of disturbances.
struct RegularisationRow : fd_fpk::RegularisationRow {
  bool symbol_grows = false;
  std::optional<double> growth_rate = {};  ///< of disturbances; empty where none grows
};

/// The effects of the regularisations of the fourth derivative on a sequence of decreasing velocity
/// steps.
struct RegularisationStudy {
  static constexpr const char* kName = "regularisation";
  problem::Problem problem;
  double default_length, shortest_length;  ///< as in fd_fpk::RegularisationStudy
  std::vector<RegularisationRow> rows;
};

/// The study of fd_fpk::study_regularisation, with a growth rate for each row.
RegularisationStudy study_regularisation(const problem::Problem& problem,
                                         const methods::ProgressListener& listener);
RegularisationStudy add_growth_rates(const problem::Problem& problem,
                                     const fd_fpk::RegularisationStudy& fd_study);

/// Whether the scheme with the default length has a density and no growing disturbance at the
/// smallest velocity step.
bool has_converged(const RegularisationStudy& study);

/// The files and texts of a regularisation study, from which make_report() makes a StudyReport. The JSON
/// contains the two lengths, and a row for each scheme and step; `growth_rate` is null if no
/// disturbance grows.
std::string json(const RegularisationStudy& study, const std::string& command);
std::string csv(const RegularisationStudy& study);
/// The table of the rows, remarks on missing values, and sentences that summarise the numbers.
std::string table(const RegularisationStudy& study, const report::TextFormat& format);
/// A figure without panels: the regularisation study has no figure.
inline report::Figure figure(const RegularisationStudy&) { return {}; }

Record make_record(const RegularisationRow& row);

}  // namespace fpkcheck::study
