#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_format.hpp"
#include "transform/sensitivities.hpp"
#include "workflows/study/functionals/functional.hpp"

/// The command `sensitivity`: derivatives of stationary moments with respect to parameters.
namespace fpkcheck::study {

struct SensitivityOptions : FunctionalOptions {
  /// Comma-separated keys of the parameters; empty for all of differentiable_parameters().
  std::optional<std::string> parameters{};
};

const base::Description<SensitivityOptions>& sensitivity_option_descriptions();

struct SensitivityStudy {
  static constexpr const char* kFileStem = "sensitivity";
  problem::Problem problem;
  SensitivityOptions options;
  std::vector<transform::Sensitivities> solutions;
};

/// @throws InputError for invalid options and parameters
SensitivityStudy study_sensitivity(const problem::Problem& problem,
                                   const SensitivityOptions& options,
                                   const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const SensitivityStudy& study);

std::string study_json_text(const SensitivityStudy& study, const std::string& command);
std::string study_csv_text(const SensitivityStudy& study);
std::string study_table_text(const SensitivityStudy& study, const report::TextFormat& format);
/// Returns a figure with the elasticities as bars.
report::Figure study_figure(const SensitivityStudy& study);

}  // namespace fpkcheck::study
