#pragma once

#include "epc/form/closed_form.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc {

/// Density of a closed form in physical coordinates. For the closed form of a solution, the values
/// of this density equal the values of the solver's density (for the paper's oscillator on y >= 0).
/// @param problem problem that defines energies and amplitudes, in physical coordinates or in the
///        coordinates of the form; may be null for a form that needs no energy and no amplitude
/// @return density, which is normalised if the form has a constant C, or a support over which to
///         integrate. A form without constant and support gives C = 1 and an infinite box
/// @throws InputError with a message of one line: a required problem is missing, the problem has no
///         wall at the origin of the form, or the integral over the support is not a positive
///         number
transform::SmoothDensity density_of_closed_form(const ClosedForm& form,
                                                const problem::Problem* problem);

/// Whether the density of a closed form is normalised: by the constant C of the form, or by an
/// integral over the support of the form.
bool is_normalised(const ClosedForm& form);

}  // namespace fpkcheck::epc
