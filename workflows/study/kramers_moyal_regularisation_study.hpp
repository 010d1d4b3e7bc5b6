#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/kramers_moyal_regularisation.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "workflows/study/study_record.hpp"
#include "workflows/study/study_report.hpp"

namespace fpkcheck::study {

struct KramersMoyalRegularisationResult : fd_fpk::KramersMoyalRegularisationResult {
  /// Whether a Fourier mode grows according to the symbol of the discrete operator.
  bool symbol_grows = false;
  /// Largest growth rate of disturbances of the density; empty if no disturbance grows.
  std::optional<double> growth_rate = {};
};

struct KramersMoyalRegularisationStudy {
  static constexpr const char* kName = "regularisation";
  static constexpr const char* kFileStem = "study-regularisation";
  problem::Problem problem;
  /// Default regularisation length and shortest stable regularisation length of the equation km4
  /// (fd_fpk::KramersMoyalRegularisationStudy).
  double default_length, shortest_length;
  std::vector<KramersMoyalRegularisationResult> rows;
};

/// Runs fd_fpk::study_kramers_moyal_regularisation(), and adds a growth rate of disturbances to
/// each row of the result.
KramersMoyalRegularisationStudy study_kramers_moyal_regularisation(
    const problem::Problem& problem, const methods::ProgressListener& listener);
KramersMoyalRegularisationStudy add_density_growth_rates(
    const problem::Problem& problem, const fd_fpk::KramersMoyalRegularisationStudy& fd_study);

/// Returns whether the regularised scheme with the default length gives a density without growing
/// disturbances at the smallest velocity step.
bool has_converged(const KramersMoyalRegularisationStudy& study);

/// Files and texts of a study of the Kramers-Moyal regularisation, from which make_study_report()
/// makes a StudyReport. If no disturbance grows, the value of the JSON key `growth_rate` is null.
std::string study_json_text(const KramersMoyalRegularisationStudy& study,
                            const std::string& command);
std::string study_csv_text(const KramersMoyalRegularisationStudy& study);
std::string study_table_text(const KramersMoyalRegularisationStudy& study,
                             const report::TerminalTextFormat& format);
inline report::Figure study_figure(const KramersMoyalRegularisationStudy&) { return {}; }

StudyRecord make_study_record(const KramersMoyalRegularisationResult& row);

}  // namespace fpkcheck::study
