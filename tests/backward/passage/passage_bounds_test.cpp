#include "backward/passage/passage_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "backward/passage/mean_time_certificate.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::backward {
namespace {

using transform::FirstPassageResult;
using transform::Status;

constexpr double kBoundsSeconds = 1000;  // time limit that a busy machine keeps, in seconds

// Mean passage times by the method characteristics, with about eight digits
constexpr double kMeanOfCase1 = 114.27394;
constexpr double kMeanOfRareImpulses = 227.67038;

TEST(PassageBounds, ContainTheMeanTimeOfCase1WithinFivePercent) {
  const FirstPassageResult passage =
      bound_passage(tests::paper_case(1), {.accuracy = 0.025, .max_seconds = kBoundsSeconds}, 1.5);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  const auto [middle, half_width] = *passage.mean_from_point;
  EXPECT_LT(middle - half_width, kMeanOfCase1);
  EXPECT_GT(middle + half_width, kMeanOfCase1);
  EXPECT_LT(2 * half_width, 0.05 * kMeanOfCase1);
  EXPECT_TRUE(passage.has_guaranteed_errors);
}

TEST(PassageBounds, ContainTheMeanTimeUnderRareImpulsesWithLosses) {
  const FirstPassageResult passage =
      bound_passage(tests::make_problem({.restitution = 0.8, .rate = 0.3}),
                    {.accuracy = 0.025, .max_seconds = kBoundsSeconds}, 1.5);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  const auto [middle, half_width] = *passage.mean_from_point;
  EXPECT_LT(std::abs(middle - kMeanOfRareImpulses), half_width);
}

// A certificate of one oscillator does not satisfy the inequality of another oscillator: each fault
// changes the mean time by more than the allowance of the certificate. One test verifies all
// faults, since the certificates take seconds.
TEST(PassageBounds, FaultyCertificatesAreNotVerified) {
  const problem::Problem problem = tests::paper_case(1);
  const ImpactOscillator oscillator = impact_oscillator(problem, 1.5);
  const base::Deadline deadline(kBoundsSeconds);
  const auto certificates = compute_mean_time_certificates(problem, oscillator, deadline);
  ASSERT_TRUE(certificates);
  constexpr double kRefinement = 1.4;
  const auto bound_pair_is_proved = [&](const ImpactOscillator& verified) {
    return verify_certificate((*certificates)[0], verified, kRefinement, deadline).is_proved &&
           verify_certificate((*certificates)[1], verified, kRefinement, deadline).is_proved;
  };
  EXPECT_TRUE(bound_pair_is_proved(oscillator));
  const auto with = [&](double ImpactOscillator::*parameter, double value) {
    ImpactOscillator other = oscillator;
    other.*parameter = value;
    return other;
  };
  EXPECT_FALSE(bound_pair_is_proved(with(&ImpactOscillator::restitution, 0.95)));
  EXPECT_FALSE(bound_pair_is_proved(with(&ImpactOscillator::stiffness, -1)));
  EXPECT_FALSE(bound_pair_is_proved(with(&ImpactOscillator::stiffness, 0.97)));
  EXPECT_FALSE(
      bound_pair_is_proved(with(&ImpactOscillator::deviation, 1.01 * oscillator.deviation)));
  EXPECT_FALSE(
      bound_pair_is_proved(with(&ImpactOscillator::deviation, 0.99 * oscillator.deviation)));
  EXPECT_FALSE(bound_pair_is_proved(with(&ImpactOscillator::arrival_rate, 1.02)));

  // A certificate that is wrong by 1 % at one knot of one region violates the inequality.
  for (const Region region : kRegions) {
    MeanPassageTimeCertificate wrong = (*certificates)[0];
    Eigen::MatrixXd& values = wrong.regions[region].value;
    values(values.rows() / 2, values.cols() / 3) *= 1.01;
    EXPECT_FALSE(verify_certificate(wrong, oscillator, kRefinement, deadline).is_proved) << region;
  }

  // The bounds of second derivatives and of the quadrature error are too large on large rectangles.
  for (const MeanPassageTimeCertificate& certificate : *certificates)
    EXPECT_FALSE(verify_certificate(certificate, oscillator, 0.5, deadline).is_proved);
}

TEST(PassageBounds, AreNotOfferedForOtherProblems) {
  const auto status = [](const problem::Problem& problem,
                         std::optional<transform::PassageStartState> start = {}) {
    return bound_passage(problem, {}, 1.5, start).status;
  };
  EXPECT_EQ(status(tests::make_problem({.law = "laplace"})), Status::not_offered);
  EXPECT_EQ(status(tests::make_problem({.mean = 0.1})), Status::not_offered);
  EXPECT_EQ(status(tests::paper_case(1), transform::PassageStartState{0.5, 0}),
            Status::not_offered);
}

TEST(PassageBounds, StateThatTheTimeLimitIsReached) {
  const FirstPassageResult passage =
      bound_passage(tests::paper_case(1), {.max_seconds = 1e-3}, 1.5);
  EXPECT_EQ(passage.status, Status::failed);
  EXPECT_NE(passage.reason.find("time limit"), std::string::npos) << passage.reason;
}

}  // namespace
}  // namespace fpkcheck::backward
