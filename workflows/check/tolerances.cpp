#include "workflows/check/tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/input_error.hpp"
#include "workflows/check/case_quantities.hpp"

namespace fpkcheck::check {
namespace {

using transform::Solution;

void require_positive(double value, const char* option) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError(fmt::format("{} {} (must be a positive number)", option, value));
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double BaselineCheckTolerances::bonferroni_threshold(std::size_t comparison_count) const {
  const double rare = std::erfc(standard_errors / std::numbers::sqrt2);
  return std::numbers::sqrt2 *
         boost::math::erfc_inv(
             std::max(rare / static_cast<double>(std::max<std::size_t>(comparison_count, 1)),
                      std::numeric_limits<double>::min()));
}

void validate(const BaselineCheckTolerances& tolerances) {
  require_positive(tolerances.deterministic, "--tolerance");
  require_positive(tolerances.standard_errors, "--standard-errors");
}

bool have_independent_sampling_errors(const Solution& one, const Solution& other) {
  if (!one.standard_errors || !other.standard_errors) return false;
  const auto &errors = one.standard_errors->moments, &others = other.standard_errors->moments;
  return std::ranges::any_of(transform::kMoments, [&](const transform::NamedMoment& of) {
    return one.moments.*of.moment != other.moments.*of.moment ||
           errors.*of.moment != others.*of.moment;
  });
}

double standard_error_of_mass(const Solution& solution) {
  // A histogram of n samples with bin probabilities p_b has the expected L1 error l1 = sqrt(2/(pi
  // n)) sum sqrt(p_b (1 - p_b)). For a histogram with many bins the expected L1 error l1 exceeds
  // sqrt(2/(pi n)), and therefore 1/n <= pi/2 l1^2.
  const double l1 = solution.sampling ? solution.sampling->y.value_or(kNotANumber) : kNotANumber;
  const double one_sample = std::numbers::pi / 2 * l1 * l1;
  return std::sqrt((std::abs(1 - solution.mass) + one_sample) * one_sample);
}

void set_tolerance_from_sampling_error(
    CheckedQuantity& quantity, const std::optional<transform::MarginalSamplingErrors>& sampling,
    transform::StateVariable variable, const BaselineCheckTolerances& tolerances) {
  if (!sampling) return;
  const auto error = expected_l1_error(*sampling, variable);
  const auto most = l1_error_quantile_99(*sampling, variable);
  if (!error || !most) return;
  quantity.kind = CheckedQuantityKind::simulated_l1;
  quantity.allowed = tolerances.standard_errors;
  quantity.error += *error;
  quantity.quantile_99 += *most;
}

double standard_error_change_tolerance(const Solution& simulation, std::size_t number_of_errors,
                                       double power, const BaselineCheckTolerances& tolerances) {
  // Ratios of two standard errors have heavier tails than the normal law. The file docs/checking.md
  // has the measurement of the factor 1.25 for heavy tails.
  constexpr double kHeavyTailFactor = 1.25;
  constexpr double kDefaultStreams = 128;
  const double streams =
      metric_number(simulation.metrics, kStreamsMetric).value_or(kDefaultStreams);
  const double scatter = kHeavyTailFactor / std::sqrt(std::max(streams - 1, 1.0));
  return std::exp(power * scatter * tolerances.bonferroni_threshold(number_of_errors)) - 1;
}

}  // namespace fpkcheck::check
