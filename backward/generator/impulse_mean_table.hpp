#pragma once

#include <vector>

#include "backward/generator/impact_basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::backward {

/// Table of the means K B_b of the splines B_b after an impulse Y, (K V)(v) = E[V(v + Y)], for
/// every spline of an ImpactSplineBasis on every piece of the velocity axis. Each element of the
/// table is a polynomial of t = (v - begin)/(end - begin) on a piece of the velocity axis, with
/// enclosed Bernstein coefficients.
struct PostImpulseMeanTable {
  int function_count = 0;     ///< number of basis functions B_b
  int coefficient_count = 0;  ///< number of Bernstein coefficients of a polynomial, degree + 1
  /// Bernstein coefficients of the splines' means after an impulse, by piece, spline, coefficient
  std::vector<numerics::Interval> coefficients;
  /// Error bound of the tabulated polynomials: for any V = sum_b c_b B_b and all v, |K V - sum_b
  /// c_b (polynomial of b)| <= remainder_bound max_b |c_b|
  double remainder_bound = 0;

  /// Returns the Bernstein coefficients of the mean of one spline after an impulse on one piece.
  std::span<numerics::Interval> post_impulse_mean_coefficients(int piece, int function) {
    return {&coefficients[(static_cast<std::size_t>(piece) * function_count + function) *
                          coefficient_count],
            static_cast<std::size_t>(coefficient_count)};
  }
  std::span<const numerics::Interval> post_impulse_mean_coefficients(int piece,
                                                                     int function) const {
    return {&coefficients[(static_cast<std::size_t>(piece) * function_count + function) *
                          coefficient_count],
            static_cast<std::size_t>(coefficient_count)};
  }
};

/// Returns whether the program can compute guaranteed enclosures of the means K B_b and of the
/// moments for an amplitude law. All other functions of impulse_mean_table.hpp require a law with
/// guaranteed enclosures.
bool has_interval_enclosures(const problem::ImpulseLaw& law);

/// Conditions on the pieces of the velocity axis under which the polynomials of a
/// PostImpulseMeanTable are accurate.
struct VelocityPieceConstraints {
  double max_length;  ///< largest permitted length of a piece
  /// Velocities, besides the breaks of the splines B_b, at which the means K B_b are not smooth and
  /// a piece of the axis must end, in increasing order
  std::vector<double> break_velocities;
};
VelocityPieceConstraints velocity_piece_constraints(const ImpactSplineBasis& basis,
                                                    const problem::ImpulseLaw& law);

/// Computes the table of the means E[B_b(v + Y)] of all splines B_b for the amplitude law of Y.
/// @param pieces pieces of the velocity axis that satisfy velocity_piece_constraints()
PostImpulseMeanTable compute_impulse_mean_table(const ImpactSplineBasis& basis,
                                                const std::vector<VelocityAxisPiece>& pieces,
                                                const problem::ImpulseLaw& law);

/// Returns an enclosure of the moment E[Y^n] of the impulse amplitude Y, computed from the stored
/// parameters of the law.
numerics::Interval enclose_amplitude_moment(const problem::ImpulseLaw& law, int n);

// Implementations of compute_impulse_mean_table() for each law of the impulse amplitude. An
// amplitude law without an implementation of compute_impulse_mean_table() has no guaranteed bounds.
PostImpulseMeanTable tabulate_impulse_means(const problem::ExponentialLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces);
PostImpulseMeanTable tabulate_impulse_means(const problem::GaussianLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces);
PostImpulseMeanTable tabulate_impulse_means(const problem::LaplaceLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces);
PostImpulseMeanTable tabulate_impulse_means(const problem::TwoPointLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces);
PostImpulseMeanTable tabulate_impulse_means(const problem::UniformLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces);

/// Returns a table of means after an impulse whose coefficients and remainder bound are 0.
PostImpulseMeanTable make_zero_impulse_mean_table(const ImpactSplineBasis& basis,
                                                  const std::vector<VelocityAxisPiece>& pieces,
                                                  int coefficient_count);

}  // namespace fpkcheck::backward
