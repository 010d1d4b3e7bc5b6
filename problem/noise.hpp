#pragma once

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// Gaussian white noise beside the impulses (or alone): sqrt(2 D) W(t).
struct Noise {
  double intensity = 0;  ///< 2 D >= 0, of the unit of lambda E[Y^2]

  /// D, the coefficient of p'' in the equation of the density.
  double diffusion() const { return intensity / 2; }
  bool present() const { return intensity > 0; }
};

/// The parameter as case files, tables and files name it.
const base::Description<Noise>& noise_description();

}  // namespace fpkcheck::problem
