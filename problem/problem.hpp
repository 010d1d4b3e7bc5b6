#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/parameter_value.hpp"
#include "problem/excitation.hpp"
#include "problem/system.hpp"
#include "problem/time_dependence.hpp"

namespace fpkcheck::problem {

/// An oscillator and its excitation by impulses, noise or both.
struct Problem {
  std::string name;
  System system;
  ImpulseTrain impulses = {};
  WhiteNoise noise = {};
  /// The factor g of multiplicative noise, noise.factor; absent if g = 1.
  std::optional<NoiseFactor> noise_factor = {};
  /// The factor b(y) of parametric impulses, impulse.factor; absent if b = 1. An impulse of
  /// amplitude Y changes y' by b(y) Y. Since the displacement y is continuous, the interpretations
  /// of the impulses by Ito and by Marcus agree.
  std::optional<StateFunction> impulse_factor = {};
  /// Time dependence of the excitation, for densities over time. All computations other than
  /// densities over time require a constant excitation.
  ExcitationTimeDependence time = {};
  /// Transformation between the coordinate of `system` and the physical coordinate y. Solvers
  /// return moments of the physical coordinate y.
  WallFrame frame = {};
};

Problem without_impulses(Problem problem);
Problem without_noise(Problem problem);

/// Returns the diffusion coefficient D g(y, v)^2 of multiplicative noise with the factor g.
double noise_diffusion_coefficient(const Problem& problem, double y, double v);

/// Returns the square b(y)^2 of the factor of parametric impulses; 1 for impulses without a factor.
double squared_impulse_factor(const Problem& problem, double y);

/// Returns the total intensity lambda E[Y^2] + 2D of impulses and noise. Without factors of noise
/// and impulses, Gaussian white noise of the total intensity has the power of the excitation.
double total_excitation_intensity(const Problem& problem);

/// Returns the values of y in (y_low, y_high), in increasing order, at which the force, a factor of
/// noise or impulses, or the slope of the force or of a factor jumps.
std::vector<double> coefficient_kinks_in_y(const Problem& problem, double y_low, double y_high);
/// Returns the values of v in (v_low, v_high), in increasing order, at which the force, the noise
/// factor, or the slope of the force or of the noise factor jumps.
std::vector<double> coefficient_kinks_in_v(const Problem& problem, double v_low, double v_high);

/// A section of a case file, with the name of the section and the values of its keys.
struct CaseFileSection {
  std::string name;
  base::Values values;
};

/// Returns the descriptions of all sections of a case file except [parameters].
const std::vector<const base::OptionsDescriptionBase*>& case_section_descriptions();

/// Returns the description of a named constant, a parameter of the section [parameters].
/// @throws InputError if the name is not permitted as a constant in formulas
const base::Parameter& named_constant_parameter(std::string_view name);

/// Returns the sections of a case file that describes the problem: [system] and, if required,
/// [wall], [impulse] and [noise].
std::vector<CaseFileSection> case_file_sections(const Problem& problem);

/// Whether a case file may contain the section [time], for densities over time.
enum class CaseFileTimeSectionPolicy { refused, allowed };

/// Builds the problem from the sections of a case file.
/// @param time_section whether the sections may contain the section [time]
/// @throws InputError that names a key if the key is missing or unknown, if the value of the key
/// has the wrong type or is out of range, or if [time] is refused; also the exceptions of
/// require_stationary_density()
Problem problem_from_sections(
    const std::string& name, const std::vector<CaseFileSection>& sections,
    CaseFileTimeSectionPolicy time_section = CaseFileTimeSectionPolicy::refused);

/// A parameter of a problem as displayed in reports.
struct ReportedParameter {
  std::string section, name;  ///< section and name of the parameter: "system", "damping"
  /// Plain and typeset symbol, such as "mu" and "μ"; empty for a parameter without a symbol.
  std::string symbol, typeset;
  std::string meaning;  ///< meaning of the parameter in words: "cubic stiffness"
  base::Value value;
  bool is_default;  ///< whether the value equals the default value; reports omit default values
};

/// Returns all parameters of a problem, in the order of the case file.
std::vector<ReportedParameter> parameters_for_reports(const Problem& problem);
/// Returns the value of a parameter for reports. A long text, such as an amplitude table, is
/// replaced by the display text of the parameter.
base::Value reported_parameter_value(const base::Parameter& parameter, const base::Value& value);

/// Returns, in one line, all parameters of a problem that differ from their defaults, such as "c =
/// 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1".
/// @param typeset whether to use typeset symbols such as "μ = 0.1"
std::string non_default_parameters_text(const Problem& problem, bool typeset = false);

/// Requires the conditions under which the oscillator has a stationary density under the constant
/// excitation, without the section [time]: an excitation, a restoring force that confines the
/// motion, and dissipation that exceeds the energy input at large energies (EnergyAveraging).
/// @throws InputError that states which condition is violated and which parameters to change
void require_stationary_density(const Problem& problem);

}  // namespace fpkcheck::problem
