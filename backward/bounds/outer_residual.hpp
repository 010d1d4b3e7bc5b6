#pragma once

#include "backward/bounds/certificate.hpp"

namespace fpkcheck::backward {

/// An upper bound of |f + L V - U| / tau outside the box of the splines. Beyond the ends of an axis
/// V is constant along this axis (docs/bounds.md, "Outside the box").
/// @pre inside call_with_upward_rounding
double outer_residual_bound(const CertificateCheckInputs& context, const Functional& functional,
                            const Certificate& certificate);

}  // namespace fpkcheck::backward
