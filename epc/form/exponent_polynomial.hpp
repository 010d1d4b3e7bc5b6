#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fpkcheck::epc {

/// Term a x1^p x2^q of the polynomial Q_n.
struct ExponentMonomial {
  int x1;
  int x2;
  double a;
};

/// Polynomial Q_n(x1, x2) of equation (18) of the paper, without a constant term.
class ExponentPolynomial {
 public:
  explicit ExponentPolynomial(std::vector<ExponentMonomial> terms);

  const std::vector<ExponentMonomial>& terms() const { return terms_; }
  int degree() const { return degree_; }

  double operator()(double x1, double x2) const;

  /// Returns the coefficients, lowest power first, of the polynomial rho -> Q_n(rho e1, rho e2)
  /// along the ray in the direction (e1, e2).
  std::vector<double> coefficients_along_ray(double e1, double e2) const;

 private:
  std::vector<ExponentMonomial> terms_;
  int degree_;
  // Coefficients of monomials x1^p x2^q: one row for each p = degree .. 0, q = degree - p .. 0
  std::vector<double> triangle_;
};

/// Evaluates a polynomial by Horner's method, from coefficients with the lowest power first.
inline double evaluate_polynomial(const std::vector<double>& coefficients, double rho) {
  double value = 0;
  for (std::size_t m = coefficients.size(); m-- > 0;) value = value * rho + coefficients[m];
  return value;
}

/// Returns the coefficients of the derivative of a polynomial, lowest power first.
std::vector<double> derivative_coefficients(const std::vector<double>& coefficients);

/// Standard deviations of x1 and x2, by which the (x1, x2) plane is scaled.
struct StandardDeviations {
  double x1;
  double x2;
};

/// Direction (cos theta, sin theta) in the scaled plane (x1/sigma_1, x2/sigma_2).
struct PhasePlaneDirection {
  double x1;
  double x2;
};

/// Coefficients, lowest power first, of the polynomial rho -> Q_n of the radius rho in a direction
/// of the scaled plane (x1/sigma_1, x2/sigma_2). The last coefficient is not 0.
using PolynomialAlongRay = std::vector<double>;

/// Step and largest radius of scans of the exponent Q_n along rays, in standard deviations.
inline constexpr double kRayScanStep = 0.1;
inline constexpr double kLargestRayRadius = 15;

/// Returns directions at equal angles over the whole circle; directions along the axes are exact.
const std::vector<PhasePlaneDirection>& equiangular_directions();

/// Returns how many of the first entries of equiangular_directions() have distinct values of the
/// exponent Q_n: half of all directions if all degrees in Q_n are even.
std::size_t distinct_direction_count(const ExponentPolynomial& q);

/// Returns the polynomial in the scaled radius that equals the exponent Q_n along one direction.
PolynomialAlongRay polynomial_along_ray(const ExponentPolynomial& q,
                                        const StandardDeviations& sigma,
                                        const PhasePlaneDirection& direction);

/// Behaviour of the exponent Q_n at infinity by condition (19) of the paper: sign of the
/// coefficient of the highest significant power of Q_n along each direction.
struct ExponentBehaviourAtInfinity {
  bool negative;
  PhasePlaneDirection worst;  ///< direction with the largest leading coefficient
  /// Radius in standard deviations, at most 60, beyond which the exponent Q_n rises in the
  /// direction of its steepest rise
  double rises_from = 0;
  /// Fraction of all directions of the plane in which the exponent Q_n rises at infinity
  double rising_fraction = 0;
};

/// Directions in which Q_n is examined: the whole plane, or the half-plane cos theta >= 0.
enum class PhasePlaneDirectionRange { whole, half };

/// Determines the behaviour of the exponent Q_n at infinity along equiangular_directions().
ExponentBehaviourAtInfinity leading_form(
    const ExponentPolynomial& q, const StandardDeviations& sigma,
    PhasePlaneDirectionRange plane = PhasePlaneDirectionRange::whole);

/// Determines the behaviour of Q_n at infinity along directions of the plane without scaling.
/// @param sigma unit of the radius in the result
/// @pre there is at least one direction
ExponentBehaviourAtInfinity leading_form_along_directions(
    const ExponentPolynomial& q, const std::vector<PhasePlaneDirection>& directions, double sigma);

/// Returns a clause on the behaviour of Q_n at infinity, such as "although Q_n falls at infinity".
/// @param plane name of the coordinates of the scaled plane, e.g. "(y, v) / deviations"
std::string describe_exponent_at_infinity(const ExponentBehaviourAtInfinity& form,
                                          const std::string& plane);

}  // namespace fpkcheck::epc
