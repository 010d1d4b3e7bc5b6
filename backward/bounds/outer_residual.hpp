#pragma once

#include "backward/bounds/certificate.hpp"

namespace fpkcheck::backward {

/// A bound of |f + L V - U| / tau outside the box of the splines, where V is constant along each
/// axis: docs/bounds.md, "Outside the box".
/// @pre inside with_upward_rounding
double outer_residual_bound(const CertificateContext& context, const Functional& functional,
                            const Certificate& certificate);

}  // namespace fpkcheck::backward
