#include "compare/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::compare {

using transform::Solution;
using transform::StateVariable;

double critical_sampling_l1_distance(double quantile_99) {
  // Quantiles of |N| for a standard normal variable N at the probabilities 1 -
  // kAgreementSignificance / 2 and 0.99.
  constexpr double kQuantileOfLevel = 3.4808, kQuantile99 = 2.5758;
  static_assert(kAgreementSignificance == 1e-3);
  return kQuantileOfLevel / kQuantile99 * quantile_99;
}

std::optional<double> sampling_l1_quantile_99(const transform::MarginalSamplingErrors& sampling,
                                              StateVariable variable) {
  constexpr double kQuantileToMeanRatio = 2;
  if (const auto most = l1_error_quantile_99(sampling, variable)) return most;
  if (const auto mean = expected_l1_error(sampling, variable)) return kQuantileToMeanRatio * *mean;
  return std::nullopt;
}

std::optional<double> largest_explained_l1_distance(const Solution& first, const Solution& second,
                                                    StateVariable variable, bool over_smooth_bins) {
  double sampling_l1 = 0, stated = 0;
  int estimate_count = 0;
  for (const Solution* solution : {&first, &second}) {
    const auto& sampling =
        over_smooth_bins ? smallest_known_sampling_errors(*solution) : solution->sampling;
    const auto most = sampling ? sampling_l1_quantile_99(*sampling, variable) : std::nullopt;
    sampling_l1 = std::hypot(sampling_l1, most.value_or(0));
    if (solution->error) stated += l1_error_of_marginal(*solution->error, variable);
    if (most || solution->error) ++estimate_count;
  }
  if (estimate_count < (over_smooth_bins ? 2 : 1)) return std::nullopt;
  return critical_sampling_l1_distance(sampling_l1) + transform::kErrorSafetyFactor * stated;
}

bool solutions_agree(const Solution& first, const Solution& second,
                     std::span<const SolutionPairDistances> pairs) {
  return std::ranges::all_of(transform::kVariables, [&](StateVariable variable) {
    const SolutionPairDistances* pair =
        find_pair_distances(pairs, first.id(), second.id(), variable);
    if (pair == nullptr || !std::isfinite(pair->distances.l1)) return true;
    const auto most =
        largest_explained_l1_distance(first, second, variable, pair->l1_standard_error.has_value());
    return !most || pair->distances.l1 <= *most;
  });
}

}  // namespace fpkcheck::compare
