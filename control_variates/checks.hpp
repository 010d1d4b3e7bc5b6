#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "control_variates/control_setup.hpp"
#include "control_variates/estimates.hpp"

namespace fpkcheck::control_variates {

/// Result of Hotelling's test whether a random vector, observed once in each stream, has zero mean.
struct HotellingTest {
  double statistic = 0;  ///< T^2 = n m^T S^-1 m: n streams, mean m, covariance S
  int dimensions = 0;
  double p_value = 1;
};
/// @param values shape (dimensions, streams); the test uses the first dimensions only, at most half
/// as many as there are streams
HotellingTest hotelling_test(const Eigen::MatrixXd& values);

/// Results of the checks that compare the simulated motion, impacts and impulses with the problem.
struct SimulationChecks {
  /// Test of E[L B] = 0 for the 14 polynomials B = y^p y'^q, 1 <= p + q <= 4: whether flights,
  /// impacts and impulses together follow the generator L. The means have the sampling error of the
  /// plain estimate.
  HotellingTest generator;
  /// Means of (y'' + c y' + g(y)) phi along the polynomials of the flights, relative to c (E[y'^2]
  /// E[phi^2])^1/2, for phi = 1, y, y' (in this order). The means are the error of the flights
  /// relative to the damping and have no sampling error.
  double momentum = 0, virial = 0, power = 0;
  /// Restitution error: mean of y'(+) divided by mean of -y'(-), less r. Without impacts
  /// `restitution` and `wall_distance` are 0.
  double restitution = 0;
  /// Mean distance between the wall and the computed positions of the impacts, relative to
  /// (E[y^2])^1/2.
  double wall_distance = 0;
  /// Deviations of the number, the mean of Y and the mean of Y^2 of the drawn impulses from their
  /// expectations, in standard errors.
  double rate = 0, mean = 0, mean_square = 0;
  /// Largest difference |plain - controlled| between the two estimates of the six moments, in plain
  /// standard errors. An error in the law of the drawn impulses affects the plain estimates only.
  double plain_moments = 0;

  /// Names of the failed checks: "flights", "restitution", "wall", "impulses", "generator",
  /// "plain". Each check with a sampling error has a false alarm rate of 1e-4.
  std::vector<std::string> failed_checks() const;
  /// Names of the failed checks without sampling error: flights, restitution, wall.
  std::vector<std::string> failed_deterministic_checks() const;
};

SimulationChecks check_simulation(const ControlSetup& setup, const Eigen::MatrixXd& generator,
                                  std::span<const mcs::StreamDeposit> streams,
                                  const FunctionalEstimates& estimates);

}  // namespace fpkcheck::control_variates
