#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "control_variates/combine.hpp"
#include "control_variates/prepared.hpp"

namespace fpkcheck::control_variates {

/// Hotelling's test that the mean of a vector over streams is 0.
struct Hotelling {
  double statistic = 0;  ///< T^2 = n m^T S^-1 m
  int dimensions = 0;
  double p_value = 1;
};
/// @param values shape (dimensions, streams); of more than half as many dimensions as streams the
///        first are tested alone
Hotelling hotelling(const Eigen::MatrixXd& values);

/// What a run tells of its own motion, impacts and impulses, judged by the problem's coefficients
/// alone.
struct Checks {
  /// E[L B] = 0 for the 14 polynomials y^p y'^q, 1 <= p + q <= 4: whether flights, impacts and
  /// impulses together are the process of the generator. It has the noise of the plain estimate.
  Hotelling generator;
  /// Means of (y'' + c y' + g(y)) phi along the flights' own polynomials over c (E[y'^2]
  /// E[phi^2])^1/2, phi = 1, y, y': momentum, virial, power. Without noise: the error of the
  /// flights relative to the damping.
  double momentum = 0, virial = 0, power = 0;
  /// Mean of y'(+) over mean of -y'(-), less r; 0 without impacts, as the next.
  double restitution = 0;
  /// Mean distance from the wall at which impacts were found, over (E[y^2])^1/2.
  double wall_distance = 0;
  /// The impulses as drawn against their train: number, E[Y] and E[Y^2], in standard errors.
  double rate = 0, mean = 0, mean_square = 0;
  /// The largest |plain - controlled| of the six moments in the plain standard errors: of all that
  /// goes into an estimate, the law as drawn enters the plain ones alone.
  double plain_moments = 0;

  /// Every check that sees something wrong, by name: "flights", "restitution", "wall", "impulses",
  /// "generator", "plain". Statistical ones at odds of 1e-4.
  std::vector<std::string> failed() const;
  /// Those of them that chance has no part in: flights, restitution, wall.
  std::vector<std::string> certainly_wrong() const;
};

Checks checks(const Prepared& prepared, const Eigen::MatrixXd& generator,
              std::span<const mcs::StreamDeposit> streams, const Estimates& estimates);

}  // namespace fpkcheck::control_variates
