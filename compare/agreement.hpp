#pragma once

#include <optional>
#include <span>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// The statistical test of agreement of two solutions of the same problem, for all tables and
/// sentences.
namespace fpkcheck::compare {

/// Significance level of the test over both densities: the probability that sampling errors alone
/// make a pair of solutions disagree.
inline constexpr double kAgreementSignificance = 1e-3;

/// Critical L1 distance of a density under sampling errors, at kAgreementSignificance. Each of the
/// two densities is tested at half the level (Bonferroni). The errors are Gaussian vectors and L1
/// is a norm, so that P(L1 <= t q) >= P(|N| <= t 2.576) for t >= 1, with q the 99 % quantile (the
/// S-inequality: Latala, Oleszkiewicz, Ann. Probab. 27 (1999) 1922). Hence 1.351 q bounds the
/// quantile at this level.
/// @param quantile_99 99 % quantile of the L1 distance
double critical_sampling_l1(double quantile_99);

/// 99 % quantile of the L1 sampling error; twice the expectation if only the expectation is stated
/// (single runs nearly reach this value).
std::optional<double> sampling_l1_quantile_99(const transform::SamplingError& sampling,
                                              transform::Variable variable);

/// Critical L1 distance of a density: the largest distance that the errors of two solutions
/// explain. It is the sum of the critical distance under their independent sampling errors, at
/// kAgreementSignificance, and of their error estimates times kErrorSafetyFactor. Empty if both
/// solutions lack an error estimate. Over smooth bins, whose sampling errors are far smaller, empty
/// if either lacks it.
/// @param smooth true for a distance over smooth bins
std::optional<double> critical_l1(const transform::Solution& first,
                                  const transform::Solution& second, transform::Variable variable,
                                  bool smooth);

/// True if the errors of two solutions explain their distances in both densities. A density without
/// a distance or an error estimate counts as agreement.
bool has_agreement(const transform::Solution& first, const transform::Solution& second,
                   std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
