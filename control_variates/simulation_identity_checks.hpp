#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "control_variates/control_variate_estimates.hpp"
#include "control_variates/control_variate_setup.hpp"

namespace fpkcheck::control_variates {

/// ControlVariateResult of Hotelling's test of the hypothesis that a random vector has zero mean.
/// Each simulation stream supplies one sample of the vector.
struct HotellingTestResult {
  /// Hotelling's T^2 = n m^T S^-1 m for n streams, sample mean m and sample covariance S
  double statistic = 0;
  int dimensions = 0;
  double p_value = 1;
};
/// Tests whether a random vector has zero mean.
/// @param values samples, of shape (dimensions, streams). At most half as many dimensions as
///   streams are used.
HotellingTestResult hotelling_test(const Eigen::MatrixXd& values);

/// Comparisons of a simulation with identities that an exact simulation satisfies.
struct SimulationIdentityChecks {
  /// Test of E[L B] = 0 for the generator L and the 14 polynomials B = y^p y'^q, 1 <= p + q <= 4. A
  /// nonzero mean of L B shows an error in the simulated flights, impacts or impulses.
  HotellingTestResult generator;
  /// Errors of the force balance: means of (y'' + c y' + g(y)) phi along the polynomials of the
  /// flights, divided by c (E[y'^2] E[phi^2])^1/2. The test function phi is 1 for `momentum`, y for
  /// `virial` and y' for `power`. The means of the force balance have no sampling error.
  double momentum = 0, virial = 0, power = 0;
  /// Error of the restitution coefficient: mean of y'(+) divided by mean of -y'(-), minus r. The
  /// value is 0 if no impact occurred.
  double restitution = 0;
  /// Mean distance between the wall and the computed impact positions, divided by (E[y^2])^1/2. The
  /// value is 0 if no impact occurred.
  double wall_distance = 0;
  /// Deviations of the number, the mean and the mean square of the drawn impulses from their
  /// expectations, in standard errors.
  double rate = 0, mean = 0, mean_square = 0;
  /// Largest difference between the estimates of a moment with and without control variates, in
  /// standard errors. An error in the law of the drawn impulses changes only the estimates without
  /// control variates.
  double plain_moments = 0;

  /// Names of the failed checks: "flights", "restitution", "wall", "impulses", "generator",
  /// "plain". Each check with a sampling error has a false alarm rate of 1e-4.
  std::vector<std::string> failed_check_names() const;
  /// Failed checks among the checks without sampling error: "flights", "restitution", "wall".
  std::vector<std::string> failed_deterministic_check_names() const;
};

/// Computes all checks of a simulation.
/// @param generator means of stream_means_of_generated_splines()
SimulationIdentityChecks compute_simulation_identity_checks(
    const ControlVariateSetup& setup, const Eigen::MatrixXd& generator,
    std::span<const mcs::DepositedSumsOfTrajectory> streams,
    const StationaryFunctionalEstimates& estimates);

}  // namespace fpkcheck::control_variates
