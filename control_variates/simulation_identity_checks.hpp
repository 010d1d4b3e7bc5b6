#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "control_variates/control_variate_estimates.hpp"
#include "control_variates/control_variate_setup.hpp"

namespace fpkcheck::control_variates {

/// Result of Hotelling's test of the hypothesis that a random vector has zero mean. Each stream of
/// the simulation supplies one sample of the random vector in Hotelling's test.
struct HotellingTestResult {
  /// Hotelling's statistic T^2 = n m^T S^-1 m for n streams, mean m and sample covariance S
  double statistic = 0;
  int dimensions = 0;
  double p_value = 1;
};
/// Tests by Hotelling's T^2 whether a random vector has zero mean.
/// @param values samples of the vector, of shape (dimensions, streams). Hotelling's test uses at
///   most half as many dimensions of the vector as streams.
HotellingTestResult hotelling_test(const Eigen::MatrixXd& values);

/// Differences between a simulation and identities that an exact simulation satisfies.
struct SimulationIdentityChecks {
  /// Test of E[L B] = 0 for the generator L and the 14 polynomials B = y^p y'^q, 1 <= p + q <= 4. A
  /// nonzero mean of L B, with the generator L and a polynomial B, shows an error in the simulated
  /// flights, impacts or impulses.
  HotellingTestResult generator;
  /// Errors of the force balance: means of (y'' + c y' + g(y)) phi along the Taylor polynomials of
  /// the free flights, divided by c (E[y'^2] E[phi^2])^1/2. The test function phi of the force
  /// balance is 1 for `momentum`, y for `virial` and y' for `power`. The means of the force balance
  /// along the simulated flights have no sampling error.
  double momentum = 0, virial = 0, power = 0;
  /// Error of the simulated restitution coefficient: mean of y'(+) divided by mean of -y'(-), minus
  /// r. The value is 0 if no impact occurred.
  double restitution = 0;
  /// Mean distance between the wall and the computed positions of impacts, divided by (E[y^2])^1/2.
  /// The value is 0 if no impact occurred.
  double wall_distance = 0;
  /// Deviations of the number, the mean and the mean square of the drawn impulses from their
  /// expectations, in units of the standard error.
  double rate = 0, mean = 0, mean_square = 0;
  /// Largest difference between the estimates of a moment with and without control variates, in
  /// units of the standard error. An error in the law of the drawn impulses changes only the
  /// estimates without control variates.
  double plain_moments = 0;

  /// Names of the failed checks of a simulation: "flights", "restitution", "wall", "impulses",
  /// "generator", "plain". Each check with a sampling error has a false alarm rate of 1e-4.
  std::vector<std::string> failed_check_names() const;
  /// Names of the failed checks of a simulation that have no sampling error: "flights",
  /// "restitution", "wall".
  std::vector<std::string> failed_deterministic_check_names() const;
};

/// Computes all checks of a simulation against identities.
/// @param generator means of stream_means_of_generated_splines()
SimulationIdentityChecks compute_simulation_identity_checks(
    const ControlVariateSetup& setup, const Eigen::MatrixXd& generator,
    std::span<const mcs::DepositedSumsOfTrajectory> streams,
    const StationaryFunctionalEstimates& estimates);

}  // namespace fpkcheck::control_variates
