#pragma once

/// Numerical limits by which the claims of the paper are judged. Each limit of a claim is derived
/// from a reason that does not depend on the computed results.
namespace fpkcheck::paper {

/// Largest L1 distance at which two densities agree, equal to the default accuracy of closures
/// (`--accuracy`). With an L1 distance of 0.02 between two densities the probabilities of any event
/// differ by at most 0.01.
inline constexpr double kMaxL1OfClaimedAgreement = 0.02;

/// Largest tail distance, the mean |log10 p - log10 MCS|, at which two tails agree: 0.2 decades, a
/// factor of 1.6. A tail distance of 0.2 decades is the resolution of the paper's simulation. At a
/// density of 1e-5, the outer end of the tail, a bin of width 0.1 contains about ten of the paper's
/// 1e7 samples. The 95 % confidence interval of a density from ten samples is +-60 %. On the
/// logarithmic axes of the paper's figures, from 1 to 1e-6, a distance of 0.2 decades is a
/// thirtieth of the axis height.
inline constexpr double kMaxTailDistanceOfClaimedAgreement = 0.2;

/// Largest L1 distance between two binned forms of one Gaussian density, from rounding and
/// quadrature errors.
inline constexpr double kMaxL1BetweenEqualGaussians = 1e-9;

/// Largest error estimate of a reference with which claims are judged, as a fraction of
/// kMaxL1OfClaimedAgreement.
inline constexpr double kMaxReferenceErrorFraction = 0.1;

}  // namespace fpkcheck::paper
