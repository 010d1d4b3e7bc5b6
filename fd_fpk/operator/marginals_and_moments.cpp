#include "fd_fpk/operator/marginals_and_moments.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "fd_fpk/axis/axis_operators.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "numerics/statistics.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::fd_fpk {
namespace {

numerics::Polynomial monomial(int power, double factor = 1) {
  numerics::Polynomial::Coefficients a{};
  a[static_cast<std::size_t>(power)] = factor;
  return numerics::Polynomial(a);
}

// Returns the integral of the polynomial `weight` times a marginal density given by cell averages.
double integrate_marginal(const GridAxis& axis, const Eigen::VectorXd& marginal, int scheme_order,
                          const numerics::Polynomial& weight) {
  return axis.cell_widths().dot(
      weighted_average_operator(axis, averaging_stencil_size(scheme_order), weight) * marginal);
}

// Returns the integral of a polynomial of x1 times a polynomial of x2 times the joint density.
double integrate_joint_density(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                               int scheme_order, const numerics::Polynomial& of_x1,
                               const numerics::Polynomial& of_x2) {
  const int points = averaging_stencil_size(scheme_order);
  const Eigen::Map<const Eigen::MatrixXd> p(cell_averages.data(), grid.v_cell_count(), grid.nx());
  const Eigen::RowVectorXd v =
      grid.x2.cell_widths().transpose() * weighted_average_operator(grid.x2, points, of_x2);
  const Eigen::RowVectorXd x =
      grid.x1.cell_widths().transpose() * weighted_average_operator(grid.x1, points, of_x1);
  return v * p * x.transpose();
}

// Returns the integral of a function of x1 and x2 times the joint density, by Gauss points in the
// cells. If the force is discontinuous at x2 = 0, the density has a kink at x2 = 0, and no stencil
// may contain cells on both sides of x2 = 0.
template <class Function>
double integrate_function(const problem::System& system, const PhasePlaneGrid& grid,
                          const Eigen::VectorXd& cell_averages, int scheme_order,
                          const Function& f) {
  using Gauss = boost::math::quadrature::gauss<double, 3>;
  // Nodes and weights of Gauss's rule with three points on the unit interval.
  const double end = Gauss::abscissa()[1] / 2;
  const std::array fractions{0.5 - end, 0.5, 0.5 + end};
  const std::array weights{Gauss::weights()[1] / 2, Gauss::weights()[0] / 2,
                           Gauss::weights()[1] / 2};
  const int points = averaging_stencil_size(scheme_order);
  const auto barrier =
      system.has_force_jumps_in_v() ? std::optional(grid.v_cell_count() / 2) : std::nullopt;
  const AxisOperator of_x1 = point_value_operator(grid.x1, points, fractions),
                     of_x2 = point_value_operator(grid.x2, points, fractions, barrier);
  const Eigen::MatrixXd p =
      of_x2 *
      Eigen::Map<const Eigen::MatrixXd>(cell_averages.data(), grid.v_cell_count(), grid.nx()) *
      of_x1.transpose();
  const auto place = [&](const GridAxis& axis, Eigen::Index n) {
    const auto cell = static_cast<int>(n / 3);
    return axis.face_position(cell) + fractions[n % 3] * axis.cell_width(cell);
  };
  const auto weight = [&](const GridAxis& axis, Eigen::Index n) {
    return weights[n % 3] * axis.cell_width(static_cast<int>(n / 3));
  };
  double sum = 0;
  for (Eigen::Index i = 0; i < p.cols(); ++i) {
    double of_column = 0;
    for (Eigen::Index j = 0; j < p.rows(); ++j) {
      of_column += weight(grid.x2, j) * p(j, i) * f(place(grid.x1, i), place(grid.x2, j));
    }
    sum += weight(grid.x1, i) * of_column;
  }
  return sum;
}

Eigen::VectorXd normal_cell_averages(const GridAxis& axis, double deviation, double centre) {
  const auto cdf = [&](double x) { return numerics::normal_probability((x - centre) / deviation); };
  Eigen::VectorXd cell_averages(axis.cell_count());
  for (int i = 0; i < axis.cell_count(); ++i)
    cell_averages(i) = cdf(axis.face_position(i + 1)) - cdf(axis.face_position(i));
  return cell_averages.cwiseQuotient(axis.cell_widths());
}

}  // namespace

MarginalCellAverages marginals(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages) {
  // Column i of the matrix p contains the averages of the velocity cells in cell i of x1.
  const Eigen::Map<const Eigen::MatrixXd> p(cell_averages.data(), grid.v_cell_count(), grid.nx());
  return {p.transpose() * grid.x2.cell_widths(), p * grid.x1.cell_widths()};
}

transform::Moments moments(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                           int scheme_order) {
  const MarginalCellAverages of_cells = marginals(grid, cell_averages);
  const auto of_y = [&](int n) {
    return integrate_marginal(grid.x1, of_cells.y, scheme_order, monomial(n));
  };
  const auto of_v = [&](int n) {
    return integrate_marginal(grid.x2, of_cells.ydot, scheme_order, monomial(n));
  };
  return {.y1 = of_y(1), .y2 = of_y(2), .y4 = of_y(4), .v1 = of_v(1), .v2 = of_v(2), .v4 = of_v(4)};
}

transform::Moments physical_moments(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                                    const Eigen::VectorXd& cell_averages, int scheme_order) {
  transform::Moments result = moments(grid, cell_averages, scheme_order);
  if (frame.is_identity()) return result;
  const Eigen::VectorXd y = marginals(grid, cell_averages).y;
  // The physical displacement y = frame.origin + sign x is a polynomial of the wall coordinate x.
  const numerics::Polynomial::Coefficients y1{0, 1}, y2{0, 0, 1}, y4{0, 0, 0, 0, 1};
  const auto of_y = [&](const numerics::Polynomial::Coefficients& monomial_of_y) {
    return integrate_marginal(
        grid.x1, y, scheme_order,
        numerics::Polynomial(monomial_of_y).compose_affine(frame.origin, frame.velocity_sign()));
  };
  result.y1 = of_y(y1);
  result.y2 = of_y(y2);
  result.y4 = of_y(y4);
  result.v1 *= frame.velocity_sign();
  return result;
}

namespace {

// Returns the moments n = 0 .. 4 of the missing mass beyond the end x = end_coordinate of an axis,
// int_0^inf |x + t|^n p e^(-s t) dt, with the density p at the end and its decay rate s beyond the
// end. The density p at the end and the decay rate s follow from the slope and the curvature of the
// logarithm of the marginal density. The fit of slope and curvature of the log density uses cells
// at 0.2 to 0.6 of the distance from the end of the axis to the mean, since cells nearer to the end
// lack mass. Under white noise the returned moments contain a factor of 2 for the motion that
// returns from outside the computational box. Under impulses, the computational box also lacks the
// return path of motion that would have left the computational box; this missing density is p V /
// v.
std::array<double, 5> missing_marginal_moments(const GridAxis& axis,
                                               const Eigen::VectorXd& marginal, bool at_right_end,
                                               double end_coordinate, bool has_impulses) {
  const double end = at_right_end ? axis.faces().back() : axis.faces().front();
  const double mean =
      integrate_marginal(axis, marginal, 1, monomial(1)) / axis.cell_widths().dot(marginal);
  struct Sample {
    double distance, log;  // distance from the end of the axis; logarithm of the density
  };
  const auto sample = [&](double part) {
    const double at = end + part * (mean - end);
    int cell = 0;
    while (cell + 1 < axis.cell_count() && axis.face_position(cell + 1) < at) ++cell;
    constexpr double kNothing = 1e-300;
    return Sample{std::abs(axis.cell_centre(cell) - end),
                  std::log(std::max(kNothing, std::abs(marginal(cell))))};
  };
  const Sample far = sample(0.6), middle = sample(0.4), near = sample(0.2);
  const double least = 1 / std::abs(end - mean);
  const auto fall = [&](const Sample& from, const Sample& to) {
    const double way = from.distance - to.distance;
    return way > 0 ? std::max(least, (from.log - to.log) / way) : least;
  };
  const double steepness = fall(middle, near);
  const double steeper = std::max(0.0, steepness - fall(far, middle));
  const double p = std::exp(near.log - (steepness + steeper) * near.distance);
  const double rate = steepness + 1.5 * steeper;
  // Integration by parts gives the recurrence I_n = (|x|^n p + n I_(n-1)) / s for the tail moments
  // I_n of a density p with the decay rate s.
  std::array<double, 5> tail{};
  for (std::size_t n = 0; n < tail.size(); ++n) {
    const double lower = n == 0 ? 0 : static_cast<double>(n) * tail[n - 1];
    tail[n] = (std::pow(std::abs(end_coordinate), static_cast<double>(n)) * p + lower) / rate;
  }
  const double way = std::abs(end - mean);
  for (std::size_t n = 1; n < tail.size(); ++n) {
    tail[n] *= 1 + (has_impulses ? rate * way / static_cast<double>(n) : 1);
  }
  return tail;
}

}  // namespace

transform::Moments moments_outside_box(const problem::Problem& problem, const PhasePlaneGrid& grid,
                                       const Eigen::VectorXd& cell_averages,
                                       const transform::Moments& moments_in_box) {
  const auto [y, v] = marginals(grid, cell_averages);
  transform::Moments beyond;
  for (const bool last : {false, true}) {
    const auto of_v =
        missing_marginal_moments(grid.x2, v, last, grid.x2_max(), problem.impulses.is_acting());
    beyond.v1 += of_v[1];
    beyond.v2 += of_v[2];
    beyond.v4 += of_v[4];
  }
  for (const bool last : {false, true}) {
    if ((last ? grid.x1.right_end_condition() : grid.x1.left_end_condition()) ==
        AxisEndCondition::boundary)
      continue;
    const double end = problem.frame.physical_y(last ? grid.x1_max() : grid.x1_min());
    const auto of_y = missing_marginal_moments(grid.x1, y, last, end, false);
    // If a density lacks mass at large velocities, the density also lacks mass at large
    // displacements.
    const double second = beyond.v2 / moments_in_box.v2 / 2,
                 fourth = beyond.v4 / moments_in_box.v4 / 2;
    beyond.y1 += of_y[1] + second * std::abs(moments_in_box.y1);
    beyond.y2 += of_y[2] + second * moments_in_box.y2;
    beyond.y4 += of_y[4] + fourth * moments_in_box.y4;
  }
  return beyond;
}

Eigen::VectorXd multiply_by_coordinate(const PhasePlaneGrid& grid,
                                       const Eigen::VectorXd& cell_averages,
                                       transform::StateVariable coordinate, int scheme_order) {
  const int points = averaging_stencil_size(scheme_order);
  const Eigen::Map<const Eigen::MatrixXd> p(cell_averages.data(), grid.v_cell_count(), grid.nx());
  Eigen::VectorXd product(cell_averages.size());
  Eigen::Map<Eigen::MatrixXd> to(product.data(), grid.v_cell_count(), grid.nx());
  if (coordinate == transform::StateVariable::y) {
    to = p * weighted_average_operator(grid.x1, points, monomial(1)).transpose();
  } else {
    to = weighted_average_operator(grid.x2, points, monomial(1)) * p;
  }
  return product;
}

Eigen::VectorXd coordinate_mean_functional(const PhasePlaneGrid& grid,
                                           transform::StateVariable coordinate, int scheme_order) {
  const int points = averaging_stencil_size(scheme_order);
  Eigen::VectorXd of_x1 = grid.x1.cell_widths(), of_x2 = grid.x2.cell_widths();
  if (coordinate == transform::StateVariable::y) {
    of_x1 = weighted_average_operator(grid.x1, points, monomial(1)).transpose() * of_x1;
  } else {
    of_x2 = weighted_average_operator(grid.x2, points, monomial(1)).transpose() * of_x2;
  }
  const Eigen::MatrixXd weights = of_x2 * of_x1.transpose();
  return Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size());
}

double physical_mixed_moment(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                             const Eigen::VectorXd& cell_averages, int scheme_order) {
  const numerics::Polynomial y =
      numerics::Polynomial({0, 1}).compose_affine(frame.origin, frame.velocity_sign());
  return frame.velocity_sign() *
         integrate_joint_density(grid, cell_averages, scheme_order, y, monomial(1));
}

double mean_energy(const problem::EffectivePotential& spring_potential, const PhasePlaneGrid& grid,
                   const Eigen::VectorXd& cell_averages, int scheme_order) {
  const auto [y, v] = marginals(grid, cell_averages);
  const double kinetic = integrate_marginal(grid.x2, v, scheme_order, monomial(2, 0.5));
  if (const numerics::Polynomial* polynomial = spring_potential.polynomial_or_null()) {
    return kinetic + integrate_marginal(grid.x1, y, scheme_order, *polynomial);
  }
  const WeightedAverageMatrixBuilder of_x1(grid.x1, averaging_stencil_size(scheme_order));
  return kinetic + grid.x1.cell_widths().dot(of_x1.weighted_average_matrix([&](double x1) {
    return spring_potential(x1);
  }) * y);
}

namespace {

// Returns the integral of weight(v) p(a, v) over all velocities v into a wall at x1 = a, by the
// matrix of weighted averages on the velocity axis.
double wall_integral(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                     int scheme_order, const AxisOperator& weighted, AxisEnd end) {
  const Eigen::Map<const Eigen::MatrixXd> p(cell_averages.data(), grid.v_cell_count(), grid.nx());
  const int half = grid.v_cell_count() / 2;
  const Eigen::VectorXd wall = p * end_value_operator(grid.x1, end, scheme_order).transpose();
  const int first = end == AxisEnd::left ? 0 : half;
  return grid.x2.cell_widths().segment(first, half).dot((weighted * wall).segment(first, half));
}

}  // namespace

double wall_speed_moment(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                         int scheme_order, int speed_exponent, AxisEnd end) {
  // For velocities v into the wall the monomial equals |v|^speed_exponent.
  const bool is_negative = end == AxisEnd::left && speed_exponent % 2 == 1;
  return wall_integral(grid, cell_averages, scheme_order,
                       weighted_average_operator(grid.x2, averaging_stencil_size(scheme_order),
                                                 monomial(speed_exponent, is_negative ? -1 : 1),
                                                 grid.v_cell_count() / 2),
                       end);
}

double sum_over_impacts(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                        int scheme_order, const std::function<double(double)>& weight,
                        AxisEnd end) {
  const WeightedAverageMatrixBuilder of_x2(grid.x2, averaging_stencil_size(scheme_order),
                                           grid.v_cell_count() / 2);
  return wall_integral(
      grid, cell_averages, scheme_order,
      of_x2.weighted_average_matrix([&](double v) { return std::abs(v) * weight(std::abs(v)); }),
      end);
}

double mean_damping_power(const problem::System& system, const transform::Moments& moments,
                          const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                          int scheme_order) {
  if (system.has_constant_damping()) return system.damping() * moments.v2;
  if (!system.has_polynomial_force()) {
    return integrate_function(system, grid, cell_averages, scheme_order, [&](double x1, double x2) {
      return x2 * system.damping_force(x1, x2);
    });
  }
  return integrate_joint_density(grid, cell_averages, scheme_order, system.damping_polynomial(),
                                 monomial(2)) +
         system.rayleigh_coefficient() * moments.v4;
}

double mean_absolute_damping_power(const problem::System& system, const PhasePlaneGrid& grid,
                                   const Eigen::VectorXd& cell_averages, int scheme_order) {
  return integrate_function(system, grid, cell_averages, scheme_order, [&](double x1, double x2) {
    return std::abs(x2 * system.damping_force(x1, x2));
  });
}

problem::PowerBalanceTerms power_balance_terms(const problem::Problem& problem,
                                               problem::ImpactCondition impact,
                                               const transform::Moments& moments,
                                               const PhasePlaneGrid& grid,
                                               const Eigen::VectorXd& cell_averages,
                                               int scheme_order) {
  const problem::System& system = problem.system;
  const auto loss = [&](const std::optional<problem::Wall>& wall, AxisEnd end) {
    if (!wall) return 0.0;
    return sum_over_impacts(
        grid, cell_averages, scheme_order,
        [&](double u) { return problem::energy_loss_at_impact(*wall, impact, u); }, end);
  };
  problem::PowerBalanceTerms terms{.mean_velocity = moments.v1,
                                   .mean_square_velocity = moments.v2,
                                   .left_impact_loss = loss(system.left_wall(), AxisEnd::left),
                                   .right_impact_loss = loss(system.right_wall(), AxisEnd::right)};
  if (problem.noise_factor) {
    terms.mean_square_noise_factor = integrate_function(
        system, grid, cell_averages, scheme_order,
        [&](double x1, double x2) { return problem.noise_factor->squared_noise_factor(x1, x2); });
  }
  if (problem.impulse_factor) {
    terms.mean_square_impulse_factor = integrate_function(
        system, grid, cell_averages, scheme_order,
        [&](double x1, double) { return problem::squared_impulse_factor(problem, x1); });
  }
  terms.mean_damping_power = mean_damping_power(system, moments, grid, cell_averages, scheme_order);
  return terms;
}

double power_balance_residual(const problem::Problem& problem, problem::ImpactCondition impact,
                              const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                              int scheme_order) {
  return problem::power_balance_residual(
      problem, power_balance_terms(problem, impact, moments(grid, cell_averages, scheme_order),
                                   grid, cell_averages, scheme_order));
}

transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const PhasePlaneGrid& grid,
                                              const Eigen::VectorXd& cell_averages,
                                              int scheme_order, const WallMomentumTransfer& walls) {
  const auto [y, v] = marginals(grid, cell_averages);
  const problem::System& system = problem.system;
  problem::VirialBalanceTerms for_virial{
      .mean_displacement =
          integrate_marginal(grid.x1, y, scheme_order, monomial(1)) + walls.displacement_at_rest,
      .mean_square_velocity = integrate_marginal(grid.x2, v, scheme_order, monomial(2)),
      .mean_virial = 0};
  problem::MomentumBalanceTerms for_momentum{.mean_force = 0, .left_impact_momentum = walls.left};
  for_virial.right_impact_momentum = for_momentum.right_impact_momentum = walls.right;
  if (system.has_polynomial_force()) {
    const auto& force = system.restoring_force();
    for_virial.mean_virial =
        integrate_marginal(grid.x1, y, scheme_order, force.multiplied_by_argument());
    for_momentum.mean_force = integrate_marginal(grid.x1, y, scheme_order, force);
    if (system.rayleigh_coefficient() != 0) {
      for_virial.mean_y_cubed_velocity =
          integrate_joint_density(grid, cell_averages, scheme_order, monomial(1), monomial(3));
      for_momentum.mean_cubed_velocity = integrate_marginal(grid.x2, v, scheme_order, monomial(3));
    }
  } else {
    const auto mean = [&](const auto& f) {
      return integrate_function(system, grid, cell_averages, scheme_order, f);
    };
    for_virial.mean_virial = mean([&](double x1, double x2) { return x1 * system.force(x1, x2); });
    for_momentum.mean_force = mean([&](double x1, double x2) { return system.force(x1, x2); });
  }
  transform::BalanceResiduals residuals{
      .virial = problem::virial_balance(problem, for_virial).relative_balance_residual()};
  for (int i = 0; i < grid.nx(); ++i) {
    for_momentum.mean_absolute_force +=
        y[i] * grid.x1.cell_width(i) * std::abs(system.force(grid.x1.cell_centre(i), 0));
  }
  if (system.left_wall() || system.right_wall() || problem.impulses.rate_times_moment(1) != 0) {
    residuals.momentum =
        problem::momentum_balance(problem, for_momentum).relative_balance_residual();
  }
  return residuals;
}

WallMomentumTransfer wall_momentum_transfer(const problem::System& system,
                                            const PhasePlaneGrid& grid,
                                            const Eigen::VectorXd& cell_averages,
                                            int scheme_order) {
  const auto momentum = [&](const std::optional<problem::Wall>& wall, AxisEnd end) {
    if (!wall) return 0.0;
    return sum_over_impacts(
        grid, cell_averages, scheme_order,
        [&](double u) { return problem::momentum_change_at_impact(*wall, u); }, end);
  };
  return {.left = momentum(system.left_wall(), AxisEnd::left),
          .right = momentum(system.right_wall(), AxisEnd::right)};
}

BoxEdgeDensity relative_box_edge_density(const problem::MotionScales& scales,
                                         const PhasePlaneGrid& grid,
                                         const Eigen::VectorXd& cell_averages) {
  // The peak of a Gaussian density folded to the half-plane is 2 / (2 pi sigma_1 sigma_2).
  const double gaussian_peak =
      1 / (std::numbers::pi * scales.displacement_deviation * scales.velocity_deviation);
  return box_edge_density(grid, cell_averages,
                          std::min(gaussian_peak, cell_averages.cwiseAbs().maxCoeff()));
}

Eigen::VectorXd gaussian_cell_averages(const problem::InitialGaussian& gaussian,
                                       const PhasePlaneGrid& grid) {
  const Eigen::VectorXd y =
      normal_cell_averages(grid.x1, gaussian.displacement_deviation, gaussian.mean_displacement);
  const Eigen::VectorXd v =
      normal_cell_averages(grid.x2, gaussian.velocity_deviation, gaussian.mean_velocity);
  Eigen::VectorXd cell_averages(grid.size());
  Eigen::Map<Eigen::MatrixXd>(cell_averages.data(), grid.v_cell_count(), grid.nx()) =
      v * y.transpose();
  return cell_averages / grid.cell_areas().dot(cell_averages);
}

Eigen::VectorXd initial_gaussian(const PhasePlaneGrid& grid, const problem::MotionScales& scales) {
  return gaussian_cell_averages(
      {scales.displacement_deviation, scales.velocity_deviation, scales.centre}, grid);
}

}  // namespace fpkcheck::fd_fpk
