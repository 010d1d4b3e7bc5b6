#pragma once

#include <optional>

#include "fd_fpk/excitation.hpp"

namespace fpkcheck::fd_fpk {

/// How the stationary density is reached.
enum class Stepper {
  cvode,  ///< pseudo-transient stepping by CVODE, checked against the direct null vector
  direct  ///< the null vector by inverse iteration alone
};

/// The stepper's name: "cvode", "direct".
std::string_view name(Stepper stepper);

struct Options {
  Equation equation = Equation::kf;
  Stepper stepper = Stepper::cvode;
  /// Order of the transport terms, 2 .. 8. Odd orders are upwind-biased and keep the tails clean;
  /// even ones are centred and leave grid-scale ripples of about 1e-4 of the peak.
  int order = 5;
  std::optional<int> nx{};         ///< cells in x1; automatic from equivalent linearisation
  std::optional<int> nv{};         ///< cells in x2, even; automatic likewise
  std::optional<double> x1_max{};  ///< box; automatic: widened until the wall carries no density
  std::optional<double> x2_max{};  ///< box; rounded to whole cells of the equation's lattice
  /// Step l of the fourth difference of km4; 0 is the literal scheme. Automatic:
  /// default_regularisation_length.
  std::optional<double> regularisation_length{};
  /// ||L P||_1 / ||P||_1 that counts as stationary, in units of the frequency sqrt(k_eq) of
  /// equivalent linearisation, so that the unit of time does not matter.
  double residual_tolerance = 1e-10;
};

/// @throws InputError on the first option that cannot be used
void validate(const Options& options);

}  // namespace fpkcheck::fd_fpk
