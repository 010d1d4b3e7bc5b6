#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_format.hpp"
#include "transform/spectrum.hpp"
#include "workflows/study/functionals/functional.hpp"

/// The command `spectrum`: spectral densities of y or y' by finite volumes and by simulation.
namespace fpkcheck::study {

struct SpectrumOptions : FunctionalOptions {
  transform::StateVariable variable = transform::StateVariable::y;
  /// Frequencies "FROM:TO:N". If empty, the range from 0 to four times the mean frequency is
  /// divided into 200 intervals.
  std::optional<std::string> frequencies{};
};

const base::Description<SpectrumOptions>& spectrum_option_descriptions();

struct SpectrumStudy {
  static constexpr const char* kFileStem = "spectrum";
  problem::Problem problem;
  SpectrumOptions options;
  std::vector<transform::Spectrum> spectra;
};

/// @throws InputError for invalid options
SpectrumStudy study_spectrum(const problem::Problem& problem, const SpectrumOptions& options,
                             const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const SpectrumStudy& study);

std::string study_json_text(const SpectrumStudy& study, const std::string& command);
std::string study_csv_text(const SpectrumStudy& study);
std::string study_table_text(const SpectrumStudy& study, const report::TextFormat& format);
report::Figure study_figure(const SpectrumStudy& study);

}  // namespace fpkcheck::study
