#pragma once

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// Gaussian white noise sqrt(2 D) W(t), alone or in addition to the impulses.
struct Noise {
  double intensity = 0;  ///< 2 D >= 0, in the unit of lambda E[Y^2]

  /// D, the coefficient of p'' in the density equation.
  double diffusion() const { return intensity / 2; }
  bool is_present() const { return intensity > 0; }
};

/// The description of the parameter.
const base::Description<Noise>& noise_description();

}  // namespace fpkcheck::problem
