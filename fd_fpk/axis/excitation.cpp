#include "fd_fpk/axis/excitation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fd_fpk/axis/jump_matrix.hpp"
#include "problem/excitation.hpp"

namespace fpkcheck::fd_fpk {

double default_regularisation_length(const problem::ImpulseLaw& law) {
  return std::sqrt(law.moment(6) / (5 * law.moment(4)));
}

DiscretisedExcitation white_noise_excitation(const problem::ImpulseTrain& impulses) {
  return {.drift = impulses.rate_times_moment(1),
          .diffusion = impulses.rate_times_moment(2) / 2,
          .exchange = {}};
}

DiscretisedExcitation kramers_moyal_excitation(const problem::ImpulseTrain& impulses,
                                               const GridAxis& axis, double regularisation_length) {
  DiscretisedExcitation result = white_noise_excitation(impulses);
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
    result.exchange += weight * jump_matrix_of_fixed_amplitude(axis, shift * regularisation_length);
  }
  return result;
}

double pade_kernel_length_squared(const problem::ImpulseTrain& impulses) {
  const double d2 = impulses.rate_times_moment(2) / 2;
  const double a = impulses.rate_times_moment(3) / 6 / d2;
  return impulses.rate_times_moment(4) / 24 / d2 - a * a;
}

DiscretisedExcitation kramers_moyal_pade_excitation(const problem::ImpulseTrain& impulses,
                                                    const GridAxis& axis, int scheme_order) {
  const double d2 = impulses.rate_times_moment(2) / 2;
  const double a = impulses.rate_times_moment(3) / 6 / d2;
  const double b = pade_kernel_length_squared(impulses);
  const Eigen::MatrixXd slope =
      divergence_operator(axis) * face_value_operator(axis, scheme_order, UpstreamSideOfFace::left);
  const Eigen::MatrixXd curvature =
      divergence_operator(axis) * face_derivative_operator(axis, scheme_order);
  const Eigen::MatrixXd denominator =
      Eigen::MatrixXd::Identity(axis.cell_count(), axis.cell_count()) + a * slope - b * curvature;
  const Eigen::MatrixXd numerator = d2 * curvature;
  return {.drift = impulses.rate_times_moment(1),
          .diffusion = 0,
          .exchange = denominator.partialPivLu().solve(numerator),
          .preconditioner_exchange_diffusion = d2,
          .preconditioner_exchange_decay_rate = d2 / b};
}

DiscretisedExcitation jump_excitation(const problem::ImpulseTrain& impulses, const GridAxis& axis) {
  return {.drift = 0,
          .diffusion = 0,
          .exchange = impulses.arrival_rate() * jump_matrix(axis, impulses.amplitude_law()),
          .preconditioner_exchange_drift = impulses.rate_times_moment(1),
          .preconditioner_exchange_diffusion = impulses.rate_times_moment(2) / 2,
          .preconditioner_exchange_decay_rate = impulses.arrival_rate()};
}

AxisOperator drift_diffusion_matrix(const GridAxis& axis, const DiscretisedExcitation& excitation,
                                    int scheme_order) {
  const AxisOperator flux =
      excitation.diffusion * face_derivative_operator(axis, scheme_order) -
      excitation.drift * face_value_operator(axis, scheme_order, UpstreamSideOfFace::left);
  return divergence_operator(axis) * flux;
}

namespace {

FastestGrowingWave fastest_kramers_moyal_wave(const problem::ImpulseTrain& impulses,
                                              double cell_width, int stencil_size,
                                              double regularisation_length) {
  const int reach = excitation_half_bandwidth(regularisation_length, cell_width, stencil_size);
  const GridAxis axis = GridAxis::with_uniform_cells(0, cell_width, 2 * reach + 1);
  return fastest_growing_wave(axis, kramers_moyal_excitation(impulses, axis, regularisation_length),
                              stencil_size);
}

}  // namespace

FastestGrowingWave fastest_growing_wave(const GridAxis& axis,
                                        const DiscretisedExcitation& excitation, int stencil_size) {
  const int middle = axis.cell_count() / 2;
  Eigen::RowVectorXd row = drift_diffusion_matrix(axis, excitation, stencil_size).row(middle);
  if (excitation.exchange.size() > 0) row += excitation.exchange.row(middle);

  constexpr int kWaves = 2000;
  const Eigen::ArrayXd phases =
      Eigen::ArrayXd::LinSpaced(kWaves, std::numbers::pi / kWaves, std::numbers::pi);
  // The growth rate of a wave is the sum of row(middle + j) cos(j phase) over j, with the cosines
  // from a three-term recurrence.
  const Eigen::ArrayXd twice = 2 * phases.cos();
  Eigen::ArrayXd rates = Eigen::ArrayXd::Constant(kWaves, row(middle));
  Eigen::ArrayXd before = Eigen::ArrayXd::Ones(kWaves), cosines = twice / 2;
  for (int j = 1; j <= middle; ++j) {
    const double after = middle + j < axis.cell_count() ? row(middle + j) : 0;
    rates += (row(middle - j) + after) * cosines;
    before = twice * cosines - before;
    before.swap(cosines);
  }
  Eigen::Index fastest = 0;
  const double rate = rates.maxCoeff(&fastest);
  return {rate, phases(fastest) / axis.cell_width(middle)};
}

int excitation_half_bandwidth(double regularisation_length, double cell_width, int stencil_size) {
  return static_cast<int>(std::ceil(2 * regularisation_length / cell_width)) + 4 * stencil_size;
}

bool is_growing_wave(const FastestGrowingWave& wave, const problem::ImpulseTrain& impulses) {
  constexpr double kRounding = 1e-9;
  return wave.rate > kRounding * impulses.arrival_rate();
}

double shortest_stable_regularisation_length(const problem::ImpulseLaw& law) {
  constexpr double kLargestSine =
      0.5250616;  // maximum of sin^4 t / t^2, at t = 1.16556, where tan t = 2 t
  return std::sqrt(4 * kLargestSine * (law.moment(4) / 24) / (law.moment(2) / 2));
}

std::vector<double> possibly_unstable_cell_widths(const GridAxis& axis,
                                                  const problem::ImpulseLaw& law,
                                                  double regularisation_length) {
  constexpr double kSame = 1.05, kNarrow = 0.5;
  const bool are_narrow_cells_stable = regularisation_length >= default_regularisation_length(law);
  const Eigen::VectorXd all = axis.cell_widths();
  std::vector<double> sorted(all.begin(), all.end()), critical;
  std::ranges::sort(sorted);
  for (const double cell_width : sorted) {
    if (are_narrow_cells_stable && cell_width <= kNarrow * regularisation_length) continue;
    if (critical.empty() || cell_width > kSame * critical.back()) critical.push_back(cell_width);
  }
  return critical;
}

double shortest_stable_regularisation_length(const problem::ImpulseTrain& impulses,
                                             std::span<const double> widths, int stencil_size,
                                             double min_length) {
  constexpr double kStep = 1.1, kClose = 1.001;
  const auto too_short = [&](double regularisation_length) {
    return std::ranges::any_of(widths, [&](double cell_width) {
      return is_growing_wave(
          fastest_kramers_moyal_wave(impulses, cell_width, stencil_size, regularisation_length),
          impulses);
    });
  };
  if (!too_short(min_length)) return min_length;
  // The loop ends, since for long regularisation lengths diffusion dominates the fourth difference.
  double shorter = min_length, longer = kStep * min_length;
  for (; too_short(longer); longer *= kStep) shorter = longer;
  while (longer > kClose * shorter) {
    const double middle = std::sqrt(shorter * longer);
    (too_short(middle) ? shorter : longer) = middle;
  }
  return longer;
}

double default_regularisation_length(const problem::ImpulseTrain& impulses, const GridAxis& axis,
                                     int stencil_size) {
  const double regularisation_length = default_regularisation_length(impulses.amplitude_law());
  return shortest_stable_regularisation_length(
      impulses,
      possibly_unstable_cell_widths(axis, impulses.amplitude_law(), regularisation_length),
      stencil_size, regularisation_length);
}

}  // namespace fpkcheck::fd_fpk
