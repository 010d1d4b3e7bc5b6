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
  std::string name;  ///< the case's name, used in reports
  System system;
  ImpulseTrain impulses = {};  ///< none, where there is noise alone
  Noise noise = {};            ///< none, where there are impulses alone
  /// Where the system's coordinate lies on the physical axis; a solver states moments by it.
  Frame frame = {};
};

/// lambda E[Y^2] + 2D: the intensity of the Gaussian white noise of equal power.
double total_intensity(const Problem& problem);

/// A section of a case file: "system", "wall", "impulse", "noise".
struct Section {
  std::string name;
  base::Values values;  ///< in the order of its description
};

/// The sections of case files, in their order.
const std::vector<const base::Descriptions*>& case_descriptions();

/// What defines a problem besides its name, as case files hold it: [system], and what else there is.
std::vector<Section> sections(const Problem& problem);

/// The problem that such sections define.
/// @throws InputError naming the key that is missing, unknown, of the wrong type or out of range; or
/// saying why there is no stationary density (problem/confinement.hpp)
Problem problem_from(const std::string& name, const std::vector<Section>& sections);

/// A parameter as tables, titles and files show it.
struct ShownParameter {
  std::string section, name;    ///< "system", "damping"
  std::string symbol, typeset;  ///< "mu", "μ"; empty for a word
  std::string meaning;          ///< "cubic stiffness"
  base::Value value;
  bool usual;  ///< as in a file that leaves it out: need not be shown
};

/// All parameters of a problem, in the order of case files.
std::vector<ShownParameter> shown_parameters(const Problem& problem);
/// A parameter's value as those have it: a long word by what says which it is.
base::Value value_shown(const base::Parameter& parameter, const base::Value& value);

/// A problem in one line: "c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses, lambda = 1, ..".
/// @param typeset with the letters of formulas: "μ = 0.1"
std::string parameters_text(const Problem& problem, bool typeset = false);

}  // namespace fpkcheck::problem
