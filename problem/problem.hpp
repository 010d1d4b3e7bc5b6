#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/parameter.hpp"
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
  /// The factor b(y) of parametric impulses, impulse.factor; absent if b = 1. An impulse changes y'
  /// by b(y) Y. Since y is continuous, the senses of Ito and Marcus agree.
  std::optional<StateFunction> impulse_factor = {};
  /// Changes of the excitation in time, for densities over time. All other computations require a
  /// constant excitation.
  TimeDependence time = {};
  /// Transformation between the coordinate of `system` and the physical coordinate y. Solvers
  /// return moments of the physical coordinate y.
  WallFrame frame = {};
};

Problem without_impulses(Problem problem);
Problem without_noise(Problem problem);

/// Returns the diffusion coefficient D G(y, v) of the noise.
double noise_diffusion(const Problem& problem, double y, double v);

/// Returns b^2, the factor of E[Y^2] for impulses at the displacement y; 1 without a factor.
double square_impulse_factor(const Problem& problem, double y);

/// Returns the total intensity lambda E[Y^2] + 2D of impulses and noise, that is, the intensity of
/// Gaussian white noise of equal power if g = b = 1.
double total_intensity(const Problem& problem);

/// Returns the values of y in (low, high) at which the force, a factor of noise or impulses, or one
/// of their slopes jumps, increasing.
std::vector<double> kinks_in_y(const Problem& problem, double low, double high);
/// Returns the values of v in (low, high) at which the force, the noise factor or one of their
/// slopes jumps, increasing.
std::vector<double> kinks_in_v(const Problem& problem, double low, double high);

struct CaseFileSection {
  std::string name;
  base::Values values;
};

const std::vector<const base::DescriptionBase*>& case_section_descriptions();

/// Returns the description of a named constant, a parameter of the section [parameters].
/// @throws InputError if formulas cannot use the name
const base::Parameter& named_constant_parameter(std::string_view name);

/// Returns the sections of a case file for the problem: [system] and, if required, [wall],
/// [impulse] and [noise].
std::vector<CaseFileSection> sections(const Problem& problem);

/// Whether a case file may contain the section [time], for densities over time.
enum class TimeSection { refused, allowed };

/// @throws InputError that names a key if the key is missing or unknown, or its value has the wrong
/// type or is out of range, or if [time] is refused; also the exceptions of
/// require_stationary_density()
Problem problem_from_sections(const std::string& name, const std::vector<CaseFileSection>& sections,
                              TimeSection time = TimeSection::refused);

struct DisplayedParameter {
  std::string section, name;  ///< section and name of the parameter: "system", "damping"
  /// Plain and typeset symbol, such as "mu" and "μ"; empty for a parameter without a symbol.
  std::string symbol, typeset;
  std::string meaning;  ///< meaning of the parameter in words: "cubic stiffness"
  base::Value value;
  bool is_default;  ///< whether the value equals the default value, which is not displayed
};

std::vector<DisplayedParameter> displayed_parameters(const Problem& problem);
/// Returns the value of a parameter for display, with a long word replaced by its display text.
base::Value display_value(const base::Parameter& parameter, const base::Value& value);

/// Returns, in one line, all parameters of a problem that differ from their defaults, such as "c =
/// 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1".
/// @param typeset whether to use typeset symbols: "μ = 0.1"
std::string parameters_text(const Problem& problem, bool typeset = false);

/// Requires the conditions under which a stationary density of the constant excitation exists,
/// without the section [time]: an excitation, a restoring force that confines the motion, and
/// dissipation that exceeds the energy input at large energies (EnergyAveraging).
/// @throws InputError that states which condition is violated and which parameters to change
void require_stationary_density(const Problem& problem);

}  // namespace fpkcheck::problem
