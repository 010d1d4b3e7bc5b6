#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_format.hpp"
#include "transform/passage.hpp"
#include "workflows/study/functionals/functional.hpp"

/// The command `passage`: first passage of the displacement above a barrier.
namespace fpkcheck::study {

struct PassageOptions : FunctionalOptions {
  std::optional<double> displacement{};
  /// Initial state "Y,V"; empty for a start at rest.
  std::optional<std::string> start{};
  /// Comma-separated times of the survival probabilities.
  std::optional<std::string> times{};
};

const base::Description<PassageOptions>& passage_option_descriptions();

struct PassageStudy {
  static constexpr const char* kFileStem = "passage";
  problem::Problem problem;
  PassageOptions options;
  /// Passage results of the selected methods, and of the approximation by Rice's rate if the
  /// finite-volume solution has an upcrossing rate.
  std::vector<transform::Passage> passages;
};

/// @throws InputError for invalid options
PassageStudy study_passage(const problem::Problem& problem, const PassageOptions& options,
                           const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const PassageStudy& study);

std::string study_json_text(const PassageStudy& study, const std::string& command);
std::string study_csv_text(const PassageStudy& study);
std::string study_table_text(const PassageStudy& study, const report::TextFormat& format);
/// Returns a figure of the survival probabilities, and of the mean times over all starts if a method
/// computes them.
report::Figure study_figure(const PassageStudy& study);

}  // namespace fpkcheck::study
