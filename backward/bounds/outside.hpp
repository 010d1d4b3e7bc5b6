#pragma once

#include "backward/bounds/check_setting.hpp"

namespace fpkcheck::backward {

/// A bound of |f + L V - U| / tau outside the box of the splines, where V is constant along each
/// axis: docs/bounds.md, "Outside the box".
/// @pre inside rounded_upward
double residual_outside(const CheckSetting& setting, const Functional& functional,
                        const Candidate& candidate);

}  // namespace fpkcheck::backward
