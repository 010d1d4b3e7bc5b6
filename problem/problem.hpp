#pragma once

#include <string>
#include <vector>

#include "base/options/parameter.hpp"
#include "problem/excitation.hpp"
#include "problem/system.hpp"

namespace fpkcheck::problem {

/// A stationary problem: an oscillator and its excitation by impulses, noise or both.
struct Problem {
  std::string name;  ///< name of the case, used in reports
  System system;
  ImpulseTrain impulses = {};  ///< no impulses if noise is the only excitation
  Noise noise = {};            ///< no noise if impulses are the only excitation
  /// Transformation between the coordinate of `system` and the physical coordinate y. Solvers
  /// return moments of the physical y.
  Frame frame = {};
};

/// The total intensity lambda E[Y^2] + 2D of impulses and noise: the intensity of the Gaussian
/// white noise of equal power.
double total_intensity(const Problem& problem);

/// A section of a case file ("system", "wall", "impulse" or "noise") with its values.
struct CaseFileSection {
  std::string name;
  base::Values values;  ///< values in the order of the section's description
};

/// The descriptions of all sections of case files, in the order of case files.
const std::vector<const base::DescriptionBase*>& case_section_descriptions();

/// The sections of a case file that defines the problem: [system], and those of [wall], [impulse]
/// and [noise] that the problem needs.
std::vector<CaseFileSection> sections(const Problem& problem);

/// Builds the problem that the sections of a case file define.
/// @throws InputError that names a key if the key is missing, unknown, of the wrong type or out of
/// range; or the message of require_stationary_density()
Problem problem_from_sections(const std::string& name,
                              const std::vector<CaseFileSection>& sections);

/// A parameter of a problem in the form in which tables, titles and files display it.
struct DisplayedParameter {
  std::string section, name;    ///< section and name: "system", "damping"
  std::string symbol, typeset;  ///< symbol: "mu", "μ"; empty for a word
  std::string meaning;          ///< meaning in words: "cubic stiffness"
  base::Value value;
  bool is_default;  ///< whether the value is the default value; defaults are not displayed
};

/// All parameters of a problem, in the order of case files.
std::vector<DisplayedParameter> displayed_parameters(const Problem& problem);
/// The value of a parameter in the form in which it is displayed: a long word is replaced by its
/// display text.
base::Value display_value(const base::Parameter& parameter, const base::Value& value);

/// The text of all parameters of a problem that differ from their defaults, in one line: "c = 0.1,
/// k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1, ..".
/// @param typeset whether to use typeset symbols: "μ = 0.1"
std::string parameters_text(const Problem& problem, bool typeset = false);

/// Requires the conditions under which a stationary density exists: an excitation, a restoring
/// force that confines the motion, and dissipation that exceeds the energy input at large energies
/// (EnergyAveraging).
/// @throws InputError that states which condition is violated and which parameters to change
void require_stationary_density(const Problem& problem);

}  // namespace fpkcheck::problem
