#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "control_variates/control_setup.hpp"
#include "control_variates/estimates.hpp"

namespace fpkcheck::control_variates {

/// Hotelling's test of zero mean of a vector over streams.
struct Hotelling {
  double statistic = 0;  ///< T^2 = n m^T S^-1 m
  int dimensions = 0;
  double p_value = 1;
};
/// @param values shape (dimensions, streams); the test takes the first dimensions only, at most
///        half the number of streams
Hotelling hotelling_test(const Eigen::MatrixXd& values);

/// Checks of the simulated motion, impacts and impulses against the coefficients of the problem.
struct Checks {
  /// E[L B] = 0 for the 14 polynomials y^p y'^q, 1 <= p + q <= 4: whether flights, impacts and
  /// impulses together follow the generator L. It has the sampling error of the plain estimate.
  Hotelling generator;
  /// Means of (y'' + c y' + g(y)) phi along the polynomials of the flights, relative to c (E[y'^2]
  /// E[phi^2])^1/2, for phi = 1, y, y'. The means are the error of the flights relative to the
  /// damping and have no sampling error.
  double momentum = 0, virial = 0, power = 0;
  /// Mean of y'(+) over mean of -y'(-), less r; 0 without impacts, as wall_distance.
  double restitution = 0;
  /// Mean distance from the wall of the located impacts, relative to (E[y^2])^1/2.
  double wall_distance = 0;
  /// Number, E[Y] and E[Y^2] of the drawn impulses against their law, in standard errors.
  double rate = 0, mean = 0, mean_square = 0;
  /// Largest |plain - controlled| of the six moments, in plain standard errors. The plain estimates
  /// alone depend on the law of the drawn impulses.
  double plain_moments = 0;

  /// Names of the failed checks: "flights", "restitution", "wall", "impulses", "generator",
  /// "plain". The statistical ones have a false alarm rate of 1e-4.
  std::vector<std::string> failed() const;
  /// Names of the failed checks without sampling error: flights, restitution, wall.
  std::vector<std::string> deterministic_failures() const;
};

Checks checks(const ControlSetup& setup, const Eigen::MatrixXd& generator,
              std::span<const mcs::StreamDeposit> streams, const Estimates& estimates);

}  // namespace fpkcheck::control_variates
