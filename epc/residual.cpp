#include "epc/residual.hpp"

#include <tuple>

namespace fpkcheck::epc {

ResidualCoefficients residual_coefficients(const problem::Problem& problem, Equation equation) {
  const bool higher = equation == Equation::km4;
  const auto& [system, impulses] = std::tie(problem.system, problem.impulses);
  return {
      .damping = system.damping(),
      .stiffness = system.stiffness(),
      .cubic = system.cubic(),
      .impact_loss = 1 - system.restitution(),
      .rate_moment = {0, impulses.rate_moment(1), impulses.rate_moment(2),
                      higher ? impulses.rate_moment(3) : 0, higher ? impulses.rate_moment(4) : 0}};
}

ResidualCoefficients partway(const ResidualCoefficients& full, double fraction) {
  ResidualCoefficients f = full;
  f.impact_loss *= fraction;
  for (const int order : {1, 3, 4}) f.rate_moment[order] *= fraction;
  return f;
}

double smooth_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q) {
  const double drift = f.damping * x2 + f.stiffness * x1 + f.cubic * x1 * x1 * x1;
  const double second = q.q22 + q.q2 * q.q2;
  const double fourth = q.q2222 + 4 * q.q2 * q.q222 + 3 * q.q22 * q.q22 + 6 * q.q2 * q.q2 * q.q22 +
                        q.q2 * q.q2 * q.q2 * q.q2;
  return -x2 * q.q1 + drift * q.q2 + f.rate_moment[2] / 2 * second +
         f.rate_moment[4] / 24 * fourth + f.damping;
}

double smooth_part_derivative(const ResidualCoefficients& f, double x1, double x2,
                              const Derivatives& q, const Derivatives& d) {
  const double drift = f.damping * x2 + f.stiffness * x1 + f.cubic * x1 * x1 * x1;
  const double second = d.q22 + 2 * q.q2 * d.q2;
  const double fourth = d.q2222 + 4 * (d.q2 * q.q222 + q.q2 * d.q222) + 6 * q.q22 * d.q22 +
                        6 * (2 * q.q2 * q.q22 * d.q2 + q.q2 * q.q2 * d.q22) +
                        4 * q.q2 * q.q2 * q.q2 * d.q2;
  return -x2 * d.q1 + drift * d.q2 + f.rate_moment[2] / 2 * second + f.rate_moment[4] / 24 * fourth;
}

double signed_part(const ResidualCoefficients& f, const Derivatives& q) {
  const double third = q.q222 + 3 * q.q2 * q.q22 + q.q2 * q.q2 * q.q2;
  return -f.rate_moment[1] * q.q2 - f.rate_moment[3] / 6 * third;
}

double signed_part_derivative(const ResidualCoefficients& f, const Derivatives& q,
                              const Derivatives& d) {
  const double third = d.q222 + 3 * (d.q2 * q.q22 + q.q2 * d.q22) + 3 * q.q2 * q.q2 * d.q2;
  return -f.rate_moment[1] * d.q2 - f.rate_moment[3] / 6 * third;
}

double impact_part(const ResidualCoefficients& f, double x2, const Derivatives& q) {
  return f.impact_loss * (x2 * q.q2 + 2);
}

double impact_part_derivative(const ResidualCoefficients& f, double x2, const Derivatives& d) {
  return f.impact_loss * x2 * d.q2;
}

}  // namespace fpkcheck::epc
