#pragma once

#include <vector>

#include "epc/form/exponent_polynomial.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc::gaussian {

/// Star-shaped set in the (x1, x2) plane outside of which the closure density C exp(Q_n) is set to
/// 0. Along each direction the set ends at the first of these radii:
///  - (a) the radius at which the density has fallen to kNegligible of its peak;
///  - (b) the radius of a minimum of the exponent Q_n at which the density is below
///    kMaxSupportEdgeDensity of its peak;
///  - (c) the radius at which the exponent Q_n is smallest before the exponent Q_n exceeds its peak
///    again, up to kLargestRayRadius deviations of the weights (25)-(26). A shallow minimum of the
///    exponent Q_n at a high density is therefore not an edge of the support. If condition (19) of
///    the paper is violated, the support of the density ends where Q_n begins to rise, or before.
class DensitySupport {
 public:
  static constexpr double kNegligible = 1e-14;

  DensitySupport(const ExponentPolynomial& q, const StandardDeviations& sigma);

  bool contains(double x1, double x2) const;
  /// Smallest radius of the edge of the support, in the scaled plane (x1/sigma_1, x2/sigma_2).
  double smallest_support_radius() const { return least_radius_; }
  double largest_support_radius() const { return greatest_radius_; }
  double x1_max() const { return x1_max_; }
  double x2_max() const { return x2_max_; }

  double largest_exponent_in_support() const { return peak_; }
  /// Integral of exp(Q_n - largest_exponent_in_support()) over the support of the density.
  double integral_relative_to_peak() const { return integral_; }
  double support_edge_to_peak_density_ratio() const { return edge_ratio_; }
  /// Estimated probability outside the support of the density, relative to the probability inside:
  /// sigma_1 sigma_2 oint p(edge) dtheta. The estimated probability assumes that the density decays
  /// beyond the edge of its support like the Gaussian weights (25)-(26) of the paper.
  double probability_outside_support() const { return cut_off_; }

 private:
  void compute_integrals(const std::vector<PolynomialAlongRay>& rays);

  StandardDeviations sigma_;
  std::vector<double> radius_;  // radius of the edge in each direction of equiangular_directions()
  std::vector<double> sector_;  // radius of the set in the sector between two successive directions
  double least_radius_ = 0, greatest_radius_ = 0;
  double x1_max_ = 0, x2_max_ = 0;
  double peak_ = 0, integral_ = 0, edge_ratio_ = 0, cut_off_ = 0;
};

/// Returns ln C of the constant C in paper (17), which normalises C exp(Q_n) on its support.
double log_normalising_constant(const DensitySupport& support);

/// Returns the density of (y, y') from the density C exp(Q_n) in the (z, z') plane, by Zhuravlev's
/// transformation (5) of the paper.
transform::SmoothDensity density_from_exponent(const ExponentPolynomial& q,
                                               const DensitySupport& support, double log_constant);

/// Returns the density C exp(Q_n) of (y, v) for a problem without a wall.
transform::SmoothDensity density_without_wall(const ExponentPolynomial& q,
                                              const DensitySupport& support, double log_constant);

/// Returns the normalised closure density of a problem with or without a wall.
transform::SmoothDensity density_on_support(const ExponentPolynomial& q,
                                            const DensitySupport& support, bool has_wall);

}  // namespace fpkcheck::epc::gaussian
