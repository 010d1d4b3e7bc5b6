#pragma once

#include "epc/form/closed_form_parameters.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc {

/// Returns the density of a closed form in physical coordinates.
/// @param problem problem that defines energies and amplitudes, in physical coordinates or in the
///   coordinates of the form; may be null if the form needs no energy and no amplitude
/// @return density, normalised by the constant C of the form, or else by an integral over the
///   support. A closed form without constant C and support gives C = 1 and an unbounded density.
/// @throws InputError if a required problem is missing, the problem has no wall at the origin of
///   the closed form, or the integral over the support is not positive
transform::SmoothDensity density_of_closed_form(const ClosedFormDensity& form,
                                                const problem::Problem* problem);

/// Returns whether the closed form has a constant C, or a support that normalises its density.
bool can_be_normalised(const ClosedFormDensity& form);

}  // namespace fpkcheck::epc
