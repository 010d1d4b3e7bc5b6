#include "compare/check/tolerances.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

void require_positive(double value, const char* option) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError(fmt::format("{} {} (must be a positive number)", option, value));
}

}  // namespace

void validate(const Tolerances& tolerances) {
  require_positive(tolerances.deterministic, "--tolerance");
  require_positive(tolerances.standard_errors, "--standard-errors");
}

}  // namespace fpkcheck::compare
