#include "epc/residual.hpp"

#include <tuple>

namespace fpkcheck::epc {

ResidualCoefficients residual_coefficients(const problem::Problem& problem, Equation equation) {
  const bool higher = equation != Equation::white;
  const auto& [system, impulses] = std::tie(problem.system, problem.impulses);
  return {
      .damping = system.damping(),
      .stiffness = system.stiffness(),
      .cubic = system.cubic(),
      .impact_loss = 1 - system.restitution(),
      .rate_moment = {0, impulses.rate_moment(1), impulses.rate_moment(2),
                      higher ? impulses.rate_moment(3) : 0, higher ? impulses.rate_moment(4) : 0},
      .jump_share = equation == Equation::kf ? 1.0 : 0.0};
}

ResidualCoefficients partway(const ResidualCoefficients& full, double fraction) {
  ResidualCoefficients f = full;
  f.impact_loss *= fraction;
  for (const int order : {1, 3, 4}) f.rate_moment[order] *= fraction;
  f.jump_share *= fraction;
  return f;
}

namespace {

// lambda E[Y^2]/2! [...] + lambda E[Y^4]/4! [...]
double even_series(const ResidualCoefficients& f, const Derivatives& q) {
  const double second = q.q22 + q.q2 * q.q2;
  const double fourth = q.q2222 + 4 * q.q2 * q.q222 + 3 * q.q22 * q.q22 + 6 * q.q2 * q.q2 * q.q22 +
                        q.q2 * q.q2 * q.q2 * q.q2;
  return f.rate_moment[2] / 2 * second + f.rate_moment[4] / 24 * fourth;
}

Derivatives even_series_gradient(const ResidualCoefficients& f, const Derivatives& q) {
  const double second = f.rate_moment[2] / 2, fourth = f.rate_moment[4] / 24;
  return {
      .q1 = 0,
      .q2 = second * 2 * q.q2 + fourth * (4 * q.q222 + 12 * q.q2 * q.q22 + 4 * q.q2 * q.q2 * q.q2),
      .q22 = second + fourth * (6 * q.q22 + 6 * q.q2 * q.q2),
      .q222 = fourth * 4 * q.q2,
      .q2222 = fourth};
}

}  // namespace

double smooth_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q) {
  const double drift = f.damping * x2 + f.stiffness * x1 + f.cubic * x1 * x1 * x1;
  return -x2 * q.q1 + drift * q.q2 + even_series(f, q) + f.damping;
}

Derivatives smooth_gradient(const ResidualCoefficients& f, double x1, double x2,
                            const Derivatives& q) {
  const double drift = f.damping * x2 + f.stiffness * x1 + f.cubic * x1 * x1 * x1;
  Derivatives gradient = even_series_gradient(f, q);
  gradient.q1 -= x2;
  gradient.q2 += drift;
  return gradient;
}

double signed_part(const ResidualCoefficients& f, const Derivatives& q) {
  const double third = q.q222 + 3 * q.q2 * q.q22 + q.q2 * q.q2 * q.q2;
  return -f.rate_moment[1] * q.q2 - f.rate_moment[3] / 6 * third;
}

Derivatives signed_gradient(const ResidualCoefficients& f, const Derivatives& q) {
  const double third = -f.rate_moment[3] / 6;
  return {.q1 = 0,
          .q2 = -f.rate_moment[1] + third * 3 * (q.q22 + q.q2 * q.q2),
          .q22 = third * 3 * q.q2,
          .q222 = third,
          .q2222 = 0};
}

double series_part(const ResidualCoefficients& f, int side, const Derivatives& q) {
  return even_series(f, q) + side * signed_part(f, q);
}

Derivatives series_gradient(const ResidualCoefficients& f, int side, const Derivatives& q) {
  const Derivatives even = even_series_gradient(f, q), odd = signed_gradient(f, q);
  return {.q1 = 0,
          .q2 = even.q2 + side * odd.q2,
          .q22 = even.q22 + side * odd.q22,
          .q222 = even.q222 + side * odd.q222,
          .q2222 = even.q2222};
}

double impact_part(const ResidualCoefficients& f, double x2, const Derivatives& q) {
  return f.impact_loss * (x2 * q.q2 + 2);
}

Derivatives impact_gradient(const ResidualCoefficients& f, double x2) {
  return {.q1 = 0, .q2 = f.impact_loss * x2, .q22 = 0, .q222 = 0, .q2222 = 0};
}

}  // namespace fpkcheck::epc
