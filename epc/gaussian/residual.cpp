#include "epc/gaussian/residual.hpp"

#include <cassert>

#include "epc/gaussian/projected_formulas.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using problem::DensityEquation;

numerics::Polynomial terms_of_parity(const numerics::Polynomial& polynomial, std::size_t parity) {
  numerics::Polynomial::Coefficients a = polynomial.coefficients();
  for (std::size_t n = 1 - parity; n < a.size(); n += 2) a[n] = 0;
  return numerics::Polynomial(a);
}

// Terms of the Kramers-Moyal series with even moments of the impulse Y: lambda E[Y^2]/2! [...] +
// lambda E[Y^4]/4! [...]
double even_series(const RateTimesMoments& m, const ExponentPartialDerivatives& q) {
  const double second = q.q22 + q.q2 * q.q2;
  const double fourth = q.q2222 + 4 * q.q2 * q.q222 + 3 * q.q22 * q.q22 + 6 * q.q2 * q.q2 * q.q22 +
                        q.q2 * q.q2 * q.q2 * q.q2;
  return m[2] / 2 * second + m[4] / 24 * fourth;
}

ExponentPartialDerivatives even_series_gradient(const RateTimesMoments& m,
                                                const ExponentPartialDerivatives& q) {
  const double second = m[2] / 2, fourth = m[4] / 24;
  return {
      .q1 = 0,
      .q2 = second * 2 * q.q2 + fourth * (4 * q.q222 + 12 * q.q2 * q.q22 + 4 * q.q2 * q.q2 * q.q2),
      .q22 = second + fourth * (6 * q.q22 + 6 * q.q2 * q.q2),
      .q222 = fourth * 4 * q.q2,
      .q2222 = fourth};
}

// Terms of the Kramers-Moyal series with odd moments of the impulse Y: -lambda E[Y] Q_2 - lambda
// E[Y^3]/3! [...]
double odd_series(const RateTimesMoments& m, const ExponentPartialDerivatives& q) {
  const double third = q.q222 + 3 * q.q2 * q.q22 + q.q2 * q.q2 * q.q2;
  return -m[1] * q.q2 - m[3] / 6 * third;
}

ExponentPartialDerivatives odd_series_gradient(const RateTimesMoments& m,
                                               const ExponentPartialDerivatives& q) {
  const double third = -m[3] / 6;
  return {.q1 = 0,
          .q2 = -m[1] + third * 3 * (q.q22 + q.q2 * q.q2),
          .q22 = third * 3 * q.q2,
          .q222 = third,
          .q2222 = 0};
}

}  // namespace

DensityEquationCoefficients residual_coefficients(const problem::Problem& problem,
                                                  DensityEquation equation,
                                                  const StandardDeviations& sigma) {
  const bool higher = equation != DensityEquation::white;
  const auto& system = problem.system;
  const auto& impulses = problem.impulses;
  const bool folded = system.left_wall().has_value();
  const bool constant_restitution = !folded || system.left_wall()->has_constant_restitution();
  const numerics::Polynomial none({});
  DensityEquationCoefficients f{
      .damping = 0,
      .odd_force = none,
      .even_force = none,
      .impact_loss = constant_restitution ? 1 - system.restitution() : 0,
      .rate_times_moment = {0, impulses.rate_times_moment(1), total_excitation_intensity(problem),
                            higher ? impulses.rate_times_moment(3) : 0,
                            higher ? impulses.rate_times_moment(4) : 0},
      .jump_fraction = equation == DensityEquation::kf ? 1.0 : 0.0,
      .folded = folded};
  if (has_formulas(problem)) {
    assert(sigma.x1 > 0 && sigma.x2 > 0);
    f.damping = total_excitation_intensity(problem) / (2 * sigma.x2 * sigma.x2);
    f.damping_polynomial = numerics::Polynomial({f.damping});
    f.odd_force = numerics::Polynomial({0, sigma.x2 * sigma.x2 / (sigma.x1 * sigma.x1)});
    f.formula_fraction = 1;
    return f;
  }
  f.damping = system.damping();
  f.odd_force = folded ? terms_of_parity(system.restoring_force(), 1) : system.restoring_force();
  if (folded) f.even_force = terms_of_parity(system.restoring_force(), 0);
  f.damping_polynomial = system.damping_polynomial();
  f.rayleigh = system.rayleigh_coefficient();
  return f;
}

DensityEquationCoefficients homotopy_coefficients(const DensityEquationCoefficients& full,
                                                  double fraction) {
  DensityEquationCoefficients f = full;
  f.impact_loss *= fraction;
  for (const int order : {1, 3, 4}) f.rate_times_moment[order] *= fraction;
  f.jump_fraction *= fraction;
  f.formula_fraction *= fraction;
  return f;
}

double residual_part_without_x1_sign(const DensityEquationCoefficients& f, double x1, double x2,
                                     const ExponentPartialDerivatives& q) {
  const double drift = f.damping * x2 + f.odd_force(x1);
  return -x2 * q.q1 + drift * q.q2 + even_series(f.rate_times_moment, q) + f.damping;
}

ExponentPartialDerivatives smooth_residual_gradient(const DensityEquationCoefficients& f, double x1,
                                                    double x2,
                                                    const ExponentPartialDerivatives& q) {
  ExponentPartialDerivatives gradient = even_series_gradient(f.rate_times_moment, q);
  gradient.q1 -= x2;
  gradient.q2 += f.damping * x2 + f.odd_force(x1);
  return gradient;
}

double residual_part_odd_in_x1_sign(const DensityEquationCoefficients& f, double x1,
                                    const ExponentPartialDerivatives& q) {
  return f.even_force(x1) * q.q2 + odd_series(f.rate_times_moment, q);
}

ExponentPartialDerivatives signed_residual_gradient(const DensityEquationCoefficients& f, double x1,
                                                    const ExponentPartialDerivatives& q) {
  ExponentPartialDerivatives gradient = odd_series_gradient(f.rate_times_moment, q);
  gradient.q2 += f.even_force(x1);
  return gradient;
}

double residual_without_wall(const DensityEquationCoefficients& f, double x1, double x2,
                             const ExponentPartialDerivatives& q) {
  const double damping = f.damping_polynomial(x1), square = f.rayleigh * x2 * x2;
  const double drift = (damping + square) * x2 + f.odd_force(x1);
  return -x2 * q.q1 + drift * q.q2 + kramers_moyal_residual_part(f.rate_times_moment, 1, q) +
         damping + 3 * square;
}

ExponentPartialDerivatives residual_without_wall_gradient(const DensityEquationCoefficients& f,
                                                          double x1, double x2,
                                                          const ExponentPartialDerivatives& q) {
  ExponentPartialDerivatives gradient = kramers_moyal_residual_gradient(f.rate_times_moment, 1, q);
  gradient.q1 -= x2;
  gradient.q2 += (f.damping_polynomial(x1) + f.rayleigh * x2 * x2) * x2 + f.odd_force(x1);
  return gradient;
}

double kramers_moyal_residual_part(const RateTimesMoments& rate_times_moment, int side,
                                   const ExponentPartialDerivatives& q) {
  return even_series(rate_times_moment, q) + side * odd_series(rate_times_moment, q);
}

ExponentPartialDerivatives kramers_moyal_residual_gradient(
    const RateTimesMoments& rate_times_moment, int side, const ExponentPartialDerivatives& q) {
  const ExponentPartialDerivatives even = even_series_gradient(rate_times_moment, q),
                                   odd = odd_series_gradient(rate_times_moment, q);
  return {.q1 = 0,
          .q2 = even.q2 + side * odd.q2,
          .q22 = even.q22 + side * odd.q22,
          .q222 = even.q222 + side * odd.q222,
          .q2222 = even.q2222};
}

double impact_residual_part(const DensityEquationCoefficients& f, double x2,
                            const ExponentPartialDerivatives& q) {
  return f.impact_loss * (x2 * q.q2 + 2);
}

ExponentPartialDerivatives impact_residual_gradient(const DensityEquationCoefficients& f,
                                                    double x2) {
  return {.q1 = 0, .q2 = f.impact_loss * x2, .q22 = 0, .q222 = 0, .q2222 = 0};
}

}  // namespace fpkcheck::epc::gaussian
