#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fpkcheck::epc {

/// One term a x1^p x2^q of Q_n.
struct Term {
  int x1;    ///< power p of x1
  int x2;    ///< power q of x2
  double a;  ///< coefficient a
};

/// The polynomial Q_n(x1, x2; a) of paper (18), without a constant term.
class Polynomial {
 public:
  explicit Polynomial(std::vector<Term> terms);

  const std::vector<Term>& terms() const { return terms_; }
  int degree() const { return degree_; }

  double operator()(double x1, double x2) const;

  /// Coefficients of the polynomial rho -> Q_n(rho e1, rho e2). Entry m multiplies rho^m,
  /// m = 0 .. degree.
  std::vector<double> restriction_to_ray(double e1, double e2) const;

 private:
  std::vector<Term> terms_;
  int degree_;
  std::vector<double> triangle_;  // rows p = degree .. 0, each with q = degree - p .. 0
};

/// Value at rho of the polynomial with the given coefficients, lowest power first, by Horner's
/// method.
inline double horner(const std::vector<double>& coefficients, double rho) {
  double value = 0;
  for (std::size_t m = coefficients.size(); m-- > 0;) value = value * rho + coefficients[m];
  return value;
}

/// Coefficients of the derivative of a polynomial in one variable, lowest power first.
std::vector<double> derivative_coefficients(const std::vector<double>& coefficients);

/// Standard deviations sigma_1 and sigma_2 that scale the coordinates x1 and x2.
struct StandardDeviations {
  double x1;
  double x2;
};

/// A direction (cos theta, sin theta) in the scaled plane (x1/sigma_1, x2/sigma_2).
struct Direction {
  double x1;
  double x2;
};

/// Coefficients of the polynomial rho -> Q_n along a direction of the scaled plane, lowest power
/// first. The last coefficient is not 0.
using RayCoefficients = std::vector<double>;

/// Step and upper limit of the radius in radial scans, in standard deviations.
inline constexpr double kRadialStep = 0.1;
inline constexpr double kLargestRadius = 15;

/// Directions at equal angles over the whole circle. The directions along the axes are exact: a
/// term that vanishes on an axis evaluates to 0.
const std::vector<Direction>& scan_directions();

/// Number of leading entries of scan_directions() along which the restrictions of Q_n are distinct.
/// If all degrees of Q_n are even, opposite directions are equivalent, and the first half of the
/// directions suffices.
std::size_t distinct_direction_count(const Polynomial& q);

/// Restricts Q_n to a direction of the scaled plane.
RayCoefficients restrict_to_ray(const Polynomial& q, const StandardDeviations& sigma,
                                const Direction& direction);

/// Behaviour of Q_n at infinity, by condition (19) of the paper: the sign of the coefficient of the
/// highest significant power of Q_n along each direction.
struct LeadingForm {
  bool negative;    ///< whether Q_n falls to minus infinity in every direction
  Direction worst;  ///< direction with the largest leading coefficient
  /// scaled radius, at most 60, beyond which Q_n rises in the worst direction
  double rises_from = 0;
  double rising_fraction = 0;  ///< fraction of all directions in which Q_n rises at infinity
};

/// Set of directions in which Q_n is examined: the whole plane, or the half-plane cos theta >= 0.
enum class DirectionSet { whole, half };

/// Determines the behaviour of Q_n at infinity in all directions of a set.
/// @param sigma standard deviations that scale the plane
LeadingForm leading_form(const Polynomial& q, const StandardDeviations& sigma,
                         DirectionSet plane = DirectionSet::whole);

/// Determines the behaviour of Q_n at infinity along the given directions of the unscaled plane.
/// @param sigma unit of the radius in the result
/// @pre there is at least one direction
LeadingForm leading_form_along(const Polynomial& q, const std::vector<Direction>& directions,
                               double sigma);

/// Clause that describes the behaviour of Q_n at infinity and ends a sentence, such as "although
/// Q_n falls at infinity".
/// @param plane name of the coordinates of the scaled plane, e.g. "(y, v) / deviations"
std::string leading_form_text(const LeadingForm& form, const std::string& plane);

}  // namespace fpkcheck::epc
