#pragma once

#include <string>
#include <vector>

#include "base/options/value.hpp"
#include "problem/impulse_train.hpp"
#include "problem/noise.hpp"
#include "problem/system.hpp"

namespace fpkcheck::problem {

/// One stationary problem: an oscillator and its excitation.
struct Problem {
  std::string name;  ///< name of the case, used in reports
  System system;
  ImpulseTrain impulses = {};  ///< absent where noise is the only excitation
  Noise noise = {};            ///< absent where impulses are the only excitation
  /// Transformation between the system's coordinate and the physical y; solvers state moments of y.
  Frame frame = {};
};

/// lambda E[Y^2] + 2D: the intensity of the Gaussian white noise of equal power.
double total_intensity(const Problem& problem);

/// A section of a case file: "system", "wall", "impulse", "noise".
struct Section {
  std::string name;
  base::Values values;  ///< in the order of the description
};

/// The descriptions of the sections of case files, in their order.
const std::vector<const base::DescriptionBase*>& case_descriptions();

/// The sections of a case file that define the problem: [system], and those that apply.
std::vector<Section> sections(const Problem& problem);

/// Builds the problem that such sections define.
/// @throws InputError naming the key that is missing, unknown, of the wrong type or out of range;
/// or stating why there is no stationary density (problem/confinement.hpp)
Problem problem_from_sections(const std::string& name, const std::vector<Section>& sections);

/// A parameter as tables, titles and files display it.
struct DisplayedParameter {
  std::string section, name;    ///< "system", "damping"
  std::string symbol, typeset;  ///< "mu", "μ"; empty for a word
  std::string meaning;          ///< "cubic stiffness"
  base::Value value;
  bool is_default;  ///< whether the value is the default, which displays omit
};

/// All parameters of a problem, in the order of case files.
std::vector<DisplayedParameter> displayed_parameters(const Problem& problem);
/// The value as displayed: a long word is replaced by its display text.
base::Value display_value(const base::Parameter& parameter, const base::Value& value);

/// The parameters of a problem in one line: "c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses,
/// lambda = 1, ..".
/// @param typeset use typeset symbols: "μ = 0.1"
std::string parameters_text(const Problem& problem, bool typeset = false);

}  // namespace fpkcheck::problem
