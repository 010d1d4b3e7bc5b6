#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/regularisation_study.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "workflows/study/record.hpp"
#include "workflows/study/study_report.hpp"

namespace fpkcheck::study {

struct RegularisationSchemeResult : fd_fpk::RegularisationSchemeResult {
  /// Whether the Fourier symbol of the discrete operator has a growing wave.
  bool symbol_grows = false;
  /// Largest growth rate of disturbances of the density; empty if no disturbance grows.
  std::optional<double> growth_rate = {};
};

struct RegularisationStudy {
  static constexpr const char* kName = "regularisation";
  static constexpr const char* kFileStem = "study-regularisation";
  problem::Problem problem;
  /// Default regularisation length and shortest stable regularisation length of km4
  /// (fd_fpk::RegularisationStudy).
  double default_length, shortest_length;
  std::vector<RegularisationSchemeResult> rows;
};

/// Runs fd_fpk::study_regularisation(), and adds a growth rate of disturbances to each row.
RegularisationStudy study_regularisation(const problem::Problem& problem,
                                         const methods::ProgressListener& listener);
RegularisationStudy add_growth_rates(const problem::Problem& problem,
                                     const fd_fpk::RegularisationStudy& fd_study);

/// Returns whether the scheme with the default length gives a density and no growing disturbance at
/// the smallest step.
bool has_converged(const RegularisationStudy& study);

/// Files and texts of a regularisation study, from which make_study_report() makes a StudyReport.
/// If no disturbance grows, the JSON key `growth_rate` is null.
std::string study_json_text(const RegularisationStudy& study, const std::string& command);
std::string study_csv_text(const RegularisationStudy& study);
std::string study_table_text(const RegularisationStudy& study,
                             const report::TerminalTextFormat& format);
inline report::Figure study_figure(const RegularisationStudy&) { return {}; }

StudyRecord make_study_record(const RegularisationSchemeResult& row);

}  // namespace fpkcheck::study
