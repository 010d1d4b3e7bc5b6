#include "fd_fpk/axis/excitation.hpp"

#include <array>
#include <cmath>

#include "fd_fpk/axis/dense_solve.hpp"
#include "fd_fpk/axis/jump_matrix.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::fd_fpk {

double default_regularisation_length(const problem::ImpulseLaw& law) {
  return std::sqrt(law.moment(6) / (5 * law.moment(4)));
}

Excitation white_noise_excitation(const problem::ImpulseTrain& impulses) {
  return {.drift = impulses.rate_times_moment(1),
          .diffusion = impulses.rate_times_moment(2) / 2,
          .exchange = {}};
}

Excitation kramers_moyal_excitation(const problem::ImpulseTrain& impulses, const Axis& axis,
                                    double regularisation_length) {
  Excitation result = white_noise_excitation(impulses);
  // delta_l^4 p / l^4 = (p(v+2l) - 4 p(v+l) + 6 p(v) - 4 p(v-l) + p(v-2l)) / l^4
  // delta_l^3 p / l^3 = (p(v+2l) - 2 p(v+l) + 2 p(v-l) - p(v-2l)) / (2 l^3)
  const double fourth = impulses.rate_times_moment(4) / 24 / std::pow(regularisation_length, 4);
  const double third =
      -impulses.rate_times_moment(3) / 6 / (2 * std::pow(regularisation_length, 3));
  struct Term {
    int shift;
    double weight;
  };
  const std::array terms{Term{-2, fourth + third}, Term{-1, -4 * fourth - 2 * third},
                         Term{1, -4 * fourth + 2 * third}, Term{2, fourth - third}};
  result.exchange = Eigen::MatrixXd::Zero(axis.cell_count(), axis.cell_count());
  for (const auto& [shift, weight] : terms) {
    result.exchange += weight * shift_matrix(axis, shift * regularisation_length);
  }
  return result;
}

double pade_length_squared(const problem::ImpulseTrain& impulses) {
  const double d2 = impulses.rate_times_moment(2) / 2;
  const double a = impulses.rate_times_moment(3) / 6 / d2;
  return impulses.rate_times_moment(4) / 24 / d2 - a * a;
}

Excitation kramers_moyal_pade_excitation(const problem::ImpulseTrain& impulses, const Axis& axis,
                                         int scheme_order) {
  const double d2 = impulses.rate_times_moment(2) / 2;
  const double a = impulses.rate_times_moment(3) / 6 / d2;
  const double b = pade_length_squared(impulses);
  const Eigen::MatrixXd slope =
      divergence_operator(axis) * face_value_operator(axis, scheme_order, UpstreamSide::left);
  const Eigen::MatrixXd curvature =
      divergence_operator(axis) * face_derivative_operator(axis, scheme_order);
  const Eigen::MatrixXd denominator =
      Eigen::MatrixXd::Identity(axis.cell_count(), axis.cell_count()) + a * slope - b * curvature;
  const Eigen::MatrixXd numerator = d2 * curvature;
  return {.drift = impulses.rate_times_moment(1),
          .diffusion = 0,
          .exchange = dense_solve(denominator, numerator),
          .exchange_diffusion = d2,
          .exchange_rate = d2 / b};
}

Excitation jump_excitation(const problem::ImpulseTrain& impulses, const Axis& axis) {
  return {.drift = 0,
          .diffusion = 0,
          .exchange = impulses.arrival_rate() * jump_matrix(axis, impulses.law()),
          .exchange_drift = impulses.rate_times_moment(1),
          .exchange_diffusion = impulses.rate_times_moment(2) / 2,
          .exchange_rate = impulses.arrival_rate()};
}

AxisOperator local_excitation(const Axis& axis, const Excitation& excitation, int scheme_order) {
  const AxisOperator flux =
      excitation.diffusion * face_derivative_operator(axis, scheme_order) -
      excitation.drift * face_value_operator(axis, scheme_order, UpstreamSide::left);
  return divergence_operator(axis) * flux;
}

}  // namespace fpkcheck::fd_fpk
