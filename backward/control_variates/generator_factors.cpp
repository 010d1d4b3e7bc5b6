#include "backward/control_variates/generator_factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {

SplineValuesAtPoints evaluate_splines(const numerics::QuinticBSplines& splines,
                                      std::span<const double> points) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  SplineValuesAtPoints all{Eigen::MatrixXd::Zero(rows, splines.size()),
                           Eigen::MatrixXd::Zero(rows, splines.size())};
  for (Eigen::Index n = 0; n < rows; ++n) {
    const auto at = splines.values_and_slopes(points[static_cast<std::size_t>(n)]);
    for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
      all.values(n, at.first + l) = at.value[l];
      all.slopes(n, at.first + l) = at.slope[l];
    }
  }
  return all;
}

std::vector<WallWithRestitution> walls_with_restitution(const problem::System& system) {
  std::vector<WallWithRestitution> walls;
  if (system.left_wall())
    walls.push_back({system.left_wall()->position, system.left_wall()->restitution, 1});
  if (system.right_wall())
    walls.push_back({system.right_wall()->position, system.right_wall()->restitution, -1});
  return walls;
}

Eigen::MatrixXd spline_jumps_at_impacts(const numerics::QuinticBSplines& splines,
                                        const WallWithRestitution& wall,
                                        std::span<const double> speeds) {
  std::vector<double> before, after;
  for (const double u : speeds) {
    before.push_back(-wall.rebound_sign * u);
    after.push_back(wall.rebound_sign * wall.restitution * u);
  }
  return evaluate_splines(splines, after).values - evaluate_splines(splines, before).values;
}

std::vector<double> impact_speed_breaks(const numerics::QuinticBSplines& splines,
                                        const WallWithRestitution& wall) {
  const double end = std::max(splines.end(), -splines.begin());
  std::vector<double> breaks{0};
  for (const double at : splines.breaks()) {
    const double rebound_velocity = wall.rebound_sign * at,
                 speed =
                     rebound_velocity < 0 ? -rebound_velocity : rebound_velocity / wall.restitution;
    if (0 < speed && speed <= end) breaks.push_back(speed);
  }
  std::ranges::sort(breaks);
  // At an elastic wall (r = 1) the spline breaks before and after impacts are at the same speeds.
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

GeneratorFactors displacement_generator_factors(const problem::System& system,
                                                const numerics::QuinticBSplines& splines,
                                                std::span<const double> points) {
  const SplineValuesAtPoints a = evaluate_splines(splines, points);
  const numerics::Polynomial& damping = system.damping_polynomial();
  Eigen::VectorXd force(a.values.rows()), damping_difference(a.values.rows());
  for (Eigen::Index n = 0; n < force.size(); ++n) {
    const double y = points[static_cast<std::size_t>(n)];
    force(n) = system.restoring_force()(y);
    damping_difference(n) = damping(y) - damping.coefficient(0);
  }
  GeneratorFactors factors{a.slopes, a.values, force.asDiagonal() * a.values};
  if (damping.degree() > 0) factors.push_back(damping_difference.asDiagonal() * a.values);
  return factors;
}

GeneratorFactors velocity_generator_factors(const problem::Problem& problem,
                                            const numerics::QuinticBSplines& splines,
                                            std::span<const double> points,
                                            const Eigen::MatrixXd& means_after_impulse) {
  const problem::System& system = problem.system;
  const SplineValuesAtPoints b = evaluate_splines(splines, points);
  const Eigen::Map<const Eigen::VectorXd> v(points.data(), b.values.rows());
  Eigen::MatrixXd velocity_terms = -system.damping() * (v.asDiagonal() * b.slopes);
  if (problem.impulses.is_acting()) {
    velocity_terms = problem.impulses.arrival_rate() * (means_after_impulse - b.values) -
                     system.damping() * (v.asDiagonal() * b.slopes);
  }
  if (system.rayleigh_coefficient() != 0) {
    velocity_terms -=
        system.rayleigh_coefficient() * (v.array().cube().matrix().asDiagonal() * b.slopes);
  }
  if (problem.noise.is_acting()) {
    const double diffusion = problem.noise.diffusion();
    for (Eigen::Index n = 0; n < v.size(); ++n) {
      const double at = points[static_cast<std::size_t>(n)];
      const int first = splines.values_and_slopes(at).first;
      const auto second_derivatives = splines.second_derivatives(at);
      for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
        velocity_terms(n, first + l) += diffusion * second_derivatives[l];
      }
    }
  }
  GeneratorFactors factors{v.asDiagonal() * b.values, std::move(velocity_terms), -b.slopes};
  if (system.damping_polynomial().degree() > 0) factors.push_back(-(v.asDiagonal() * b.slopes));
  return factors;
}

namespace {

constexpr unsigned kPointsPerPart = 8;

/// Adds the values of all splines at a point, times a probability, to means after an impulse.
void add_weighted_values(const numerics::QuinticBSplines& splines, double at, double probability,
                         Eigen::Ref<Eigen::RowVectorXd> row) {
  const auto functions = splines.values_and_slopes(at);
  for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
    row(functions.first + l) += probability * functions.value[l];
  }
}

/// Divides the interval [from, to] of velocities at the breaks of the splines, and into parts not
/// longer than `max_length`. Returns the ends of the parts.
std::vector<double> ends_of_parts(const numerics::QuinticBSplines& splines, double from, double to,
                                  double max_length) {
  std::vector<double> ends{from};
  const auto divide_up_to = [&](double next) {
    const double begin = ends.back();
    const int count = std::max(1, static_cast<int>(std::ceil((next - begin) / max_length - 1e-9)));
    for (int k = 1; k < count; ++k) ends.push_back(begin + (next - begin) * k / count);
    ends.push_back(next);
  };
  const auto& breaks = splines.breaks();
  auto next = std::upper_bound(breaks.begin(), breaks.end(), from);
  for (; next != breaks.end() && *next < to; ++next) divide_up_to(*next);
  divide_up_to(to);
  return ends;
}

}  // namespace

Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseLaw& law,
                                           std::span<const double> v) {
  Eigen::MatrixXd means =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(v.size()), splines.size());
  const auto atoms = law.amplitude_atoms();
  const auto pieces = law.amplitude_density_breakpoints();
  Eigen::RowVectorXd row(splines.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    row.setZero();
    for (const auto& atom : atoms)
      add_weighted_values(splines, v[i] + atom.amplitude, atom.probability, row);
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const auto ends = ends_of_parts(splines, v[i] + pieces[k], v[i] + pieces[k + 1],
                                      law.amplitude_standard_deviation());
      const auto [points, weights] = numerics::composite_gauss_rule<kPointsPerPart>(ends);
      for (std::size_t n = 0; n < points.size(); ++n) {
        const double z = points[n];
        add_weighted_values(splines, z,
                            weights(static_cast<Eigen::Index>(n)) * law.density(z - v[i]), row);
      }
    }
    means.row(static_cast<Eigen::Index>(i)) = row;
  }
  return means;
}

Eigen::MatrixXd spline_means_after_impulse(const numerics::QuinticBSplines& splines,
                                           const problem::ImpulseTrain& impulses,
                                           std::span<const double> v) {
  if (!impulses.is_acting()) return {};
  return spline_means_after_impulse(splines, impulses.amplitude_law(), v);
}

}  // namespace fpkcheck::backward
