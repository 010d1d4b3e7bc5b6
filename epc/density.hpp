#pragma once

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc {

/// Density of a closed form in physical coordinates. For the closed form of a solution the values
/// equal those of the solver's density (in the paper's class on y >= 0).
/// @param problem defines energies and amplitudes, in physical coordinates or in those of the form;
///        may be null for a form that needs neither
/// @return normalised if the form has a constant, or a support over which to integrate; without
///         either C = 1 and the box is infinite
/// @throws InputError on one line: a required problem is missing, the problem has no wall at the
///         origin of the form, or the integral over the support is not a positive number
transform::SmoothDensity density(const ClosedForm& form, const problem::Problem* problem);

/// Whether density() is normalised: the form has a constant or a support.
bool is_normalised(const ClosedForm& form);

}  // namespace fpkcheck::epc
