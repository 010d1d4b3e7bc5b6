#include "workflows/check/tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/input_error.hpp"

namespace fpkcheck::check {
namespace {

void require_positive(double value, const char* option) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError(fmt::format("{} {} (must be a positive number)", option, value));
}

}  // namespace

double Tolerances::bonferroni_threshold(std::size_t n) const {
  const double rare = std::erfc(standard_errors / std::numbers::sqrt2);
  return std::numbers::sqrt2 *
         boost::math::erfc_inv(std::max(rare / static_cast<double>(std::max<std::size_t>(n, 1)),
                                        std::numeric_limits<double>::min()));
}

void validate(const Tolerances& tolerances) {
  require_positive(tolerances.deterministic, "--tolerance");
  require_positive(tolerances.standard_errors, "--standard-errors");
}

}  // namespace fpkcheck::check
