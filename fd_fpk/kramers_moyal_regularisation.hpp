#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/axis/excitation.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Results of one finite-difference scheme for the truncated Kramers-Moyal series, on velocity
/// cells of equal width.
struct KramersMoyalRegularisationResult {
  std::string scheme;  ///< "literal", "regularised", "0.9 l*", "1.1 l*", "pade"
  double step;         ///< width h of the velocity cells
  double length;       ///< step l of the fourth difference; 0 for the Pade scheme
  int nx = 0;          ///< numbers of cells in y (nx) and in y' (nv)
  int nv = 0;
  /// Fastest growing wave by the symbol of the discretised excitation, for waves of the density
  /// that depend only on the velocity x2
  std::optional<FastestGrowingWave> symbol = {};
  /// Rightmost eigenvalue of the whole discrete operator, per unit time. Without an unstable mode
  /// the rightmost eigenvalue is 0 and belongs to the stationary density.
  std::optional<std::complex<double>> rightmost = {};
  /// Eigenvalue of the discrete operator with the second largest real part, which gives the slowest
  /// decay rate; empty if a mode is unstable.
  std::optional<std::complex<double>> next = {};
  /// The values l1_y, l1_ydot and min_density describe the null vector of the operator, which need
  /// not be a probability density.
  std::optional<double> l1_y = {};     ///< L1 distance of p(y) to the density of kf
  std::optional<double> l1_ydot = {};  ///< L1 distance of p(y') to the density of kf
  /// Smallest cell average of the null vector, divided by the largest absolute cell average
  std::optional<double> min_density = {};
  std::string remark = {};  ///< reason why a result of this scheme is missing

  /// Returns the growth rate of the fastest growing mode; empty if no mode is unstable or no growth
  /// rate is known. The growth rate is the real part of the rightmost eigenvalue of the operator.
  /// Without eigenvalues, the growth rate is the maximum of the Fourier symbol of the excitation.
  std::optional<double> growth_rate(const problem::Problem& problem) const;
};

struct KramersMoyalRegularisationStudy {
  double default_length;  ///< default regularisation length l, with l^2 = E[Y^6] / (5 E[Y^4])
  /// Shortest stable regularisation length l*: for every shorter length the Fourier symbol of the
  /// excitation has a positive real part
  double shortest_length;
  std::vector<KramersMoyalRegularisationResult> rows;
};

struct KramersMoyalRegularisationOptions {
  /// Divisors of the default regularisation length, one for each velocity step of the study
  std::vector<int> divisions{1, 2, 4, 8};
  /// Number of grid cells in the displacement y; the growth rate depends only on waves in y'
  int nx = 16;
};

/// Computes growth rates, eigenvalues and null vectors of the truncated Kramers-Moyal equation
/// `km4` and of its Pade approximant for decreasing velocity steps. The schemes of the equation
/// `km4` have the literal or the regularised fourth difference. The study includes velocity steps
/// for which the discrete equation is ill-posed, which the solver refuses.
/// @throws InputError unless problem::has_equivalent_linearisation(problem)
KramersMoyalRegularisationStudy study_kramers_moyal_regularisation(
    const problem::Problem& problem, const KramersMoyalRegularisationOptions& options = {},
    const std::function<void(int row, int rows)>& progress = {});

}  // namespace fpkcheck::fd_fpk
