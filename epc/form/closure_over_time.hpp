#pragma once

#include <string>
#include <vector>

#include "problem/initial_density.hpp"
#include "transform/joint_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc {

/// Density and moments of a closure at one time of the solution.
struct ClosureSnapshot {
  double time;
  transform::SmoothDensity density;  ///< in the coordinates of the problem
  transform::Moments moments;        ///< in physical coordinates
};

/// Densities of a closure over time, and the status of the integration in time.
struct ClosureEvolution {
  std::vector<ClosureSnapshot> snapshots;
  transform::Status status = transform::Status::ok;
  std::string reason;
  long steps = 0;          ///< time steps of CVODE
  std::string quadrature;  ///< numbers of quadrature points in both coordinates, such as "46 x 46"
  /// Largest change when quadrature points are added: of the exponent Q_n, in standard deviations,
  /// or of the rates of change of the moments, in units of the frequency
  double quadrature_change = 0;
};

/// Initial density, and output times, of a closure over time.
struct EvolutionRequest {
  problem::InitialGaussian start;
  std::vector<double> times;  ///< increasing times; the first is 0
  /// Whether the requested densities are those of the periodic state under a periodic excitation,
  /// with the last time as period. The search for the periodic state begins at the density `start`.
  bool periodic = false;
};

}  // namespace fpkcheck::epc
