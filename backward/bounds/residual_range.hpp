#pragma once

#include <utility>

#include "backward/bounds/certificate.hpp"

namespace fpkcheck::backward {

struct ResidualRange {
  double least = 0, largest = 0;  ///< least <= 0 <= largest
  /// Whether the bisection reached its tolerance. Otherwise the range is wider, but still valid.
  bool is_converged = true;
  long boxes = 0;  ///< number of sub-boxes processed by the bisection
};

/// Encloses the range of (f + L V - U) / tau over the box of the splines. On each product of a y
/// piece and a v piece the range is bounded by the Bernstein coefficients of the residual, divided
/// by the least tau. The bisection stops when the bounds of the range differ from attained values
/// by less than the relative tolerance.
/// @param expected_range (least, largest) values that are probably attained. Good values reduce the
/// number of bisections; wrong values do not make the range invalid
/// @pre inside call_with_upward_rounding
ResidualRange residual_range(const CertificateCheckInputs& context, const Functional& functional,
                             const Certificate& certificate,
                             std::pair<double, double> expected_range, double tolerance);

}  // namespace fpkcheck::backward
