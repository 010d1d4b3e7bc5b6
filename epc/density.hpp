#pragma once

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc {

/// The density of a closed form on the physical axes: of a solution's own closed form the very
/// values that the solver's density has, in the paper's class on y >= 0.
/// @param problem whose energies and amplitudes they are; may be null where none is asked for.
///        In physical coordinates, or in those of the form
/// @return normalised where the form has a constant, or a support over which it can be had; without
///         either C = 1 and the box is infinite
/// @throws InputError on one line: a problem is needed and is not there, or has no wall where
///         the form has its origin, or the integral over the support is no positive number
transform::SmoothDensity density(const ClosedForm& form, const problem::Problem* problem);

/// Whether density() has the integral that the form says, or 1: it has a constant or a support.
bool is_normalised(const ClosedForm& form);

}  // namespace fpkcheck::epc
