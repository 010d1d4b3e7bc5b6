#pragma once

#include <utility>

#include "backward/bounds/certificate.hpp"

namespace fpkcheck::backward {

struct ResidualRange {
  double least = 0, largest = 0;  ///< least <= 0 <= largest
  bool is_converged = true;       ///< false if the bisection stopped at its limit: valid, but wider
  long boxes = 0;                 ///< number of boxes processed
};

/// Encloses the range of (f + L V - U) / tau over the box of the splines. On each product of a y
/// piece and a v piece the Bernstein coefficients of the residual and the least tau bound the
/// range. Bisection stops when the bounds are within the relative tolerance of attained values.
/// @param expected (least, largest) values that are probably attained; they save work and do not
/// affect validity
/// @pre inside with_upward_rounding
ResidualRange residual_range(const CertificateContext& context, const Functional& functional,
                             const Certificate& certificate, std::pair<double, double> expected,
                             double tolerance);

}  // namespace fpkcheck::backward
