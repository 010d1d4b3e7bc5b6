#pragma once

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// Gaussian white noise sqrt(2 D) W(t) as excitation, alone or in addition to the impulses.
struct Noise {
  double intensity = 0;  ///< 2 D >= 0, in the same unit as lambda E[Y^2]

  /// The diffusion coefficient D: the coefficient of p'' in the density equation.
  double diffusion() const { return intensity / 2; }
  bool is_present() const { return intensity > 0; }
};

/// The description of the parameter of the section [noise].
const base::Description<Noise>& noise_parameter_description();

}  // namespace fpkcheck::problem
