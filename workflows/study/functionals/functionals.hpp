#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/option_description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_layout.hpp"
#include "transform/passage.hpp"
#include "transform/sensitivities.hpp"
#include "transform/spectrum.hpp"
#include "workflows/study/functionals/functional.hpp"

/// The commands `passage`, `spectrum` and `sensitivity`: functionals of the motion.
namespace fpkcheck::study {

/// First passage of the displacement or of the energy above a barrier; one of the two is given.
struct PassageOptions : FunctionalCommandOptions {
  /// One barrier "B", or two barriers "A,B" for the exit from the interval (A, B).
  std::optional<std::string> displacement{};
  std::optional<double> energy{};
  /// Initial state "Y,V"; empty for a start at rest.
  std::optional<std::string> start{};
  /// Comma-separated times of the survival probabilities.
  std::optional<std::string> times{};
};

const base::OptionsDescription<PassageOptions>& passage_option_descriptions();

/// Returns overrides "wall.KEY=VALUE" of a case that put a wall beyond each barrier of the
/// displacement. The walls have no effect on the passage from an initial state, and may give an
/// oscillator without a stationary density a stationary density.
/// @return empty without an initial state, and for a barrier of the energy
/// @throws InputError for invalid barriers
std::vector<std::string> walls_beyond_barriers(const PassageOptions& options);

struct PassageStudy {
  static constexpr const char* kFileStem = "passage";
  problem::Problem problem;
  PassageOptions options;
  /// Passage results of the selected methods, and of the approximation by Rice's rate if the
  /// finite-volume solution has an upcrossing rate.
  std::vector<transform::FirstPassageResult> passages;
};

/// @throws InputError for invalid options
PassageStudy study_passage(const problem::Problem& problem, const PassageOptions& options,
                           const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const PassageStudy& study);

std::string study_json_text(const PassageStudy& study, const std::string& command);
std::string study_csv_text(const PassageStudy& study);
std::string study_table_text(const PassageStudy& study, const report::TerminalTextFormat& format);
/// Returns a figure of the survival probabilities, and of the mean times over all starts if a
/// method computes them.
report::Figure study_figure(const PassageStudy& study);

/// Spectral densities of y or y'.
struct SpectrumOptions : FunctionalCommandOptions {
  transform::StateVariable variable = transform::StateVariable::y;
  /// Frequencies "FROM:TO:N". If empty, the range from 0 to four times the mean frequency is
  /// divided into 200 intervals.
  std::optional<std::string> frequencies{};
};

const base::OptionsDescription<SpectrumOptions>& spectrum_option_descriptions();

struct SpectrumStudy {
  static constexpr const char* kFileStem = "spectrum";
  problem::Problem problem;
  SpectrumOptions options;
  std::vector<transform::SpectralDensity> spectra;
};

/// @throws InputError for invalid options
SpectrumStudy study_spectrum(const problem::Problem& problem, const SpectrumOptions& options,
                             const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const SpectrumStudy& study);

std::string study_json_text(const SpectrumStudy& study, const std::string& command);
std::string study_csv_text(const SpectrumStudy& study);
std::string study_table_text(const SpectrumStudy& study, const report::TerminalTextFormat& format);
report::Figure study_figure(const SpectrumStudy& study);

/// Derivatives of the stationary moments and densities with respect to parameters.
struct SensitivityOptions : FunctionalCommandOptions {
  /// Comma-separated keys of the parameters; empty for all of differentiable_parameters().
  std::optional<std::string> parameters{};
};

const base::OptionsDescription<SensitivityOptions>& sensitivity_option_descriptions();

struct SensitivityStudy {
  static constexpr const char* kFileStem = "sensitivity";
  problem::Problem problem;
  SensitivityOptions options;
  std::vector<transform::MomentSensitivities> solutions;
};

/// @throws InputError for invalid options and parameters
SensitivityStudy study_sensitivity(const problem::Problem& problem,
                                   const SensitivityOptions& options,
                                   const methods::ProgressListener& listener);

/// Returns whether the status of every method that supports the problem is `ok`.
bool has_converged(const SensitivityStudy& study);

std::string study_json_text(const SensitivityStudy& study, const std::string& command);
std::string study_csv_text(const SensitivityStudy& study);
std::string study_table_text(const SensitivityStudy& study,
                             const report::TerminalTextFormat& format);
/// Returns a figure with the elasticities, and with the derivatives of the marginal densities if a
/// method computes them.
report::Figure study_figure(const SensitivityStudy& study);

}  // namespace fpkcheck::study
