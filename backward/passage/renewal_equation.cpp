#include "backward/passage/renewal_equation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/process/parallel_for.hpp"
#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::backward {
namespace {

// A trajectory ends when the weight has decayed to exp(-kMaxExponent) = 1.5e-8.
constexpr double kMaxExponent = 18;

}  // namespace

// The barycentric weights of Chebyshev points are those of Berrut and Trefethen, SIAM Review 46
// (2004) 501, equation 5.3.
ChebyshevGrid::BarycentricInterpolation::BarycentricInterpolation(double low, double high,
                                                                  int count)
    : nodes(count), barycentric_weights(count) {
  const std::vector<double> points = numerics::chebyshev_points(count);
  for (int k = 0; k < count; ++k) {
    nodes(k) = low + (high - low) * points[static_cast<std::size_t>(k)];
    barycentric_weights(k) = (k % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (k + 0.5) / count);
  }
}

void ChebyshevGrid::BarycentricInterpolation::evaluate_lagrange_polynomials(
    double x, Eigen::Ref<Eigen::VectorXd> values) const {
  for (Eigen::Index k = 0; k < nodes.size(); ++k) {
    if (x == nodes(k)) {
      values.setZero();
      values(k) = 1;
      return;
    }
  }
  values = barycentric_weights.array() / (x - nodes.array());
  values /= values.sum();
}

ChebyshevGrid::ChebyshevGrid(const Domain& domain, int y_node_count, int v_node_count)
    : domain_(domain),
      y_interpolation_(0,
                       domain.ends_at_barrier ? std::sqrt(domain.y_high - domain.y_low)
                                              : domain.y_high - domain.y_low,
                       y_node_count),
      v_interpolation_(-domain.v_max, domain.v_max, v_node_count) {
  assert(domain.y_low < domain.y_high && domain.v_max > 0 && y_node_count > 0 && v_node_count > 0);
}

void ChebyshevGrid::evaluate_y_polynomials(double y, Eigen::Ref<Eigen::VectorXd> values) const {
  const double distance = std::clamp(domain_.y_high - y, 0.0, domain_.y_high - domain_.y_low);
  y_interpolation_.evaluate_lagrange_polynomials(
      domain_.ends_at_barrier ? std::sqrt(distance) : distance, values);
}

void ChebyshevGrid::evaluate_v_polynomials(double v, Eigen::Ref<Eigen::VectorXd> values) const {
  v_interpolation_.evaluate_lagrange_polynomials(std::clamp(v, -domain_.v_max, domain_.v_max),
                                                 values);
}

std::array<double, 2> effective_amplitude_range(const problem::ImpulseLaw& law) {
  constexpr double kTailProbability = 5e-10;
  const std::vector<double> breakpoints = law.amplitude_density_breakpoints();
  const double low = breakpoints.front(), high = breakpoints.back();
  const auto quantile = [&](double probability) {
    const auto excess = [&](double y) { return law.cumulative_probability(y) - probability; };
    if (excess(low) >= 0) return low;
    if (excess(high) <= 0) return high;
    return numerics::bracketed_root(excess, low, high, 20);
  };
  return {quantile(kTailProbability), quantile(1 - kTailProbability)};
}

RenewalEquation::RenewalEquation(const problem::Problem& problem, const ChebyshevGrid& grid,
                                 double min_decay_rate, double panel_refinement, double barrier,
                                 BarrierKind barrier_kind)
    : problem_(problem),
      grid_(grid),
      barrier_(barrier),
      panel_refinement_(panel_refinement),
      motion_solver_(problem.system, barrier,
                     grid.phase_plane_domain().y_high - grid.phase_plane_domain().y_low,
                     problem.impulses.amplitude_law().amplitude_standard_deviation(),
                     panel_refinement, barrier_kind),
      max_duration_(kMaxExponent / min_decay_rate) {
  assert(problem.impulses.amplitude_law().amplitude_atoms().empty() && !problem.impulse_factor);
  const auto [low, high] = effective_amplitude_range(problem.impulses.amplitude_law());
  min_amplitude_ = low;
  max_amplitude_ = high;
}

// Returns the velocities v at which integrals along the trajectory from (y, v) are not smooth in v.
// The trajectories from these states graze the barrier or the wall.
std::vector<double> RenewalEquation::find_velocities_of_nonsmooth_integrals(double y) const {
  const auto [low, high] = velocity_range();
  const double max_speed = std::max(-low, high);
  std::vector<double> velocities{0};  // T(0, -u) = T(0, r u) at a wall has a kink at u = 0
  const auto add_velocities_of_grazing_trajectory = [&](double displacement) {
    for (const double v : motion_solver_.find_backward_crossing_velocities(
             {displacement, 0}, y, max_duration_, max_speed)) {
      velocities.push_back(v);
    }
  };
  if (std::isfinite(barrier_) && motion_solver_.acceleration({barrier_, 0}) < 0)
    add_velocities_of_grazing_trajectory(barrier_);
  const auto& wall = problem_.system.left_wall();
  if (wall && motion_solver_.acceleration({wall->position, 0}) > 0)
    add_velocities_of_grazing_trajectory(wall->position);
  return velocities;
}

std::array<double, 2> RenewalEquation::velocity_range() const {
  return {-grid_.phase_plane_domain().v_max + min_amplitude_,
          grid_.phase_plane_domain().v_max + max_amplitude_};
}

double IntervalMap::value(double x) const {
  if (is_smooth_at_begin && is_smooth_at_end) return begin + length * x;
  if (is_smooth_at_begin) return begin + length * x * (2 - x);
  if (is_smooth_at_end) return begin + length * x * x;
  return begin + length * x * x * (3 - 2 * x);
}

double IntervalMap::slope(double x) const {
  if (is_smooth_at_begin && is_smooth_at_end) return length;
  if (is_smooth_at_begin) return length * 2 * (1 - x);
  if (is_smooth_at_end) return length * 2 * x;
  return length * 6 * x * (1 - x);
}

namespace {

// Divides the interval [low, high] of x at the points where the amplitude density, as a function of
// the velocity map.value(x) after an impulse, is not smooth. The velocity before the impulse is
// v.
std::vector<double> ends_of_smooth_parts(const IntervalMap& map, double low, double high, double v,
                                         const std::vector<double>& amplitude_density_breakpoints) {
  std::vector<double> ends{low, high};
  for (const double amplitude : amplitude_density_breakpoints) {
    const double after = v + amplitude;
    if (after <= map.value(low) || after >= map.value(high)) continue;
    ends.push_back(
        numerics::bracketed_root([&](double x) { return map.value(x) - after; }, low, high, 48));
  }
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

std::vector<VelocityQuadraturePanel> RenewalEquation::divide_velocities_into_panels(
    double y, double low, double high) const {
  constexpr double kPanelWidth = 1.5;    // in standard deviations of the amplitude
  constexpr double kLargestSlope = 1.5;  // largest slope of x^2 (3 - 2 x)
  const double deviation = problem_.impulses.amplitude_law().amplitude_standard_deviation();
  std::vector<double> ends{low, high};
  for (const double v : find_velocities_of_nonsmooth_integrals(y)) {
    if (v > low && v < high) ends.push_back(v);
  }
  std::ranges::sort(ends);
  const double negligible = 1e-9 * deviation;
  // Clang 14 does not compile std::ranges::unique() of GCC 12's library.
  ends.erase(
      std::unique(ends.begin(), ends.end(), [&](double a, double b) { return b - a < negligible; }),
      ends.end());
  std::vector<VelocityQuadraturePanel> panels;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const IntervalMap map{.begin = ends[k],
                          .length = ends[k + 1] - ends[k],
                          .is_smooth_at_begin = k == 0,
                          .is_smooth_at_end = k + 2 == ends.size()};
    const int count =
        std::max(1, static_cast<int>(std::ceil(kLargestSlope * map.length * panel_refinement_ /
                                               (kPanelWidth * deviation))));
    for (int n = 0; n < count; ++n) {
      VelocityQuadraturePanel& panel = panels.emplace_back(VelocityQuadraturePanel{
          map, static_cast<double>(n) / count, static_cast<double>(n + 1) / count, {}, {}});
      for (const auto& [at, weight] :
           numerics::composite_gauss_points<VelocityQuadraturePanel::kPoints>(panel.begin,
                                                                              panel.end, 1)) {
        panel.nodes.push_back(at);
        panel.weights.push_back(weight);
      }
    }
  }
  return panels;
}

RenewalEquation::VelocityQuadrature RenewalEquation::make_velocity_quadrature(double y) const {
  constexpr unsigned kPoints = VelocityQuadraturePanel::kPoints, kPointsPerSmoothPart = 12;
  const problem::ImpulseLaw& law = problem_.impulses.amplitude_law();
  const std::vector<double> breakpoints = law.amplitude_density_breakpoints();
  const auto [low, high] = velocity_range();
  VelocityQuadrature rule;
  std::vector<Eigen::MatrixXd> panel_weights;
  for (const auto& [map, begin, end, nodes, gauss_weights] :
       divide_velocities_into_panels(y, low, high)) {
    for (const double x : nodes) rule.velocities.push_back(map.value(x));
    Eigen::MatrixXd& weights =
        panel_weights.emplace_back(Eigen::MatrixXd::Zero(grid_.v_node_count(), kPoints));
    for (int j = 0; j < grid_.v_node_count(); ++j) {
      const double v = grid_.v_node(j);
      const auto density = [&, &of = map](double x) {
        return of.slope(x) * law.density(of.value(x) - v);
      };
      const std::vector<double> parts = ends_of_smooth_parts(map, begin, end, v, breakpoints);
      if (parts.size() == 2) {
        for (std::size_t q = 0; q < kPoints; ++q) {
          weights(j, static_cast<Eigen::Index>(q)) = gauss_weights[q] * density(nodes[q]);
        }
        continue;
      }
      const numerics::QuadratureRule rule_of_parts =
          numerics::composite_gauss_rule<kPointsPerSmoothPart>(parts);
      for (Eigen::Index m = 0; m < rule_of_parts.size(); ++m) {
        const double x = rule_of_parts.points[static_cast<std::size_t>(m)];
        const std::vector<double> lagrange = numerics::lagrange_weights(nodes, x);
        weights.row(j) += rule_of_parts.weights(m) * density(x) *
                          Eigen::Map<const Eigen::RowVectorXd>(lagrange.data(), kPoints);
      }
    }
  }
  rule.weights.resize(grid_.v_node_count(), static_cast<Eigen::Index>(rule.velocities.size()));
  for (std::size_t panel = 0; panel < panel_weights.size(); ++panel) {
    rule.weights.middleCols(static_cast<Eigen::Index>(panel * kPoints), kPoints) =
        panel_weights[panel];
  }
  return rule;
}

void RenewalEquation::integrate_along_trajectory(
    const UnforcedTrajectory& trajectory, const std::vector<TimeSinceImpulseWeight>& weights,
    Eigen::Ref<Eigen::MatrixXd> node_weights, Eigen::Ref<Eigen::VectorXd> integrals_of_one) const {
  const auto count =
      static_cast<Eigen::Index>(trajectory.nodes.size() + (trajectory.passed_barrier ? 0 : 1));
  const Eigen::Index n_v = grid_.v_node_count();
  const auto weight_count = static_cast<Eigen::Index>(weights.size());
  Eigen::MatrixXd y_polynomials(grid_.y_node_count(), count),
      weighted_v_polynomials(n_v * weight_count, count);
  integrals_of_one.setZero();
  Eigen::VectorXd values(n_v);
  for (Eigen::Index n = 0; n < count; ++n) {
    const bool is_end = n == static_cast<Eigen::Index>(trajectory.nodes.size());
    const PhaseState& at =
        is_end ? trajectory.end_state : trajectory.nodes[static_cast<std::size_t>(n)].state;
    grid_.evaluate_y_polynomials(at.y, y_polynomials.col(n));
    grid_.evaluate_v_polynomials(at.v, values);
    for (Eigen::Index k = 0; k < weight_count; ++k) {
      const auto& [decay_rate, time_power] = weights[static_cast<std::size_t>(k)];
      double weight = 0;
      if (is_end) {
        const double t = trajectory.duration;
        weight =
            std::exp(-decay_rate * t) / decay_rate * (time_power == 0 ? 1 : t + 1 / decay_rate);
      } else {
        const TrajectoryQuadratureNode& node = trajectory.nodes[static_cast<std::size_t>(n)];
        weight =
            node.weight * std::exp(-decay_rate * node.time) * (time_power == 0 ? 1 : node.time);
      }
      weighted_v_polynomials.col(n).segment(k * n_v, n_v) = weight * values;
      integrals_of_one(k) += weight;
    }
  }
  node_weights.noalias() = y_polynomials * weighted_v_polynomials.transpose();
}

std::vector<RenewalEquation::MotionIntegralOperator> RenewalEquation::compute_operators(
    const std::vector<TimeSinceImpulseWeight>& weights, const base::Deadline& deadline) const {
  std::vector<double> displacements;
  for (int i = 0; i < grid_.y_node_count(); ++i) displacements.push_back(grid_.y_node(i));
  return compute_operators_at(displacements, weights, deadline);
}

std::vector<RenewalEquation::MotionIntegralOperator> RenewalEquation::compute_operators_at(
    const std::vector<double>& displacements, const std::vector<TimeSinceImpulseWeight>& weights,
    const base::Deadline& deadline) const {
  const auto weight_count = static_cast<Eigen::Index>(weights.size());
  const Eigen::Index n_v = grid_.v_node_count(), size = grid_.node_count();
  std::vector<MotionIntegralOperator> operators(weights.size());
  for (MotionIntegralOperator& one : operators) {
    const Eigen::Index row_count = static_cast<Eigen::Index>(displacements.size()) * n_v;
    one.matrix.resize(row_count, size);
    one.values_of_one.resize(row_count);
  }
  // The rows of the operators that belong to one displacement
  const auto compute_rows = [&](std::size_t i) {
    const double y = displacements[i];
    const Eigen::Index first_row = static_cast<Eigen::Index>(i) * n_v;
    const VelocityQuadrature rule = make_velocity_quadrature(y);
    const auto velocity_count = static_cast<Eigen::Index>(rule.velocities.size());
    // Integrals along the trajectories: one row for each velocity, and consecutive columns for the
    // weights
    Eigen::MatrixXd integrals(velocity_count, weight_count * size);
    Eigen::MatrixXd integrals_of_one(velocity_count, weight_count);
    Eigen::MatrixXd node_weights(grid_.y_node_count(), weight_count * n_v);
    Eigen::VectorXd trajectory_integrals_of_one(weight_count);
    for (Eigen::Index q = 0; q < velocity_count && !deadline.has_deadline_passed(); ++q) {
      const double v = rule.velocities[static_cast<std::size_t>(q)];
      integrate_along_trajectory(motion_solver_.compute_trajectory({y, v}, max_duration_), weights,
                                 node_weights, trajectory_integrals_of_one);
      integrals_of_one.row(q) = trajectory_integrals_of_one;
      for (Eigen::Index k = 0; k < weight_count; ++k) {
        for (int m = 0; m < grid_.y_node_count(); ++m) {
          integrals.row(q).segment(k * size + grid_.node_index(m, 0), n_v) =
              node_weights.row(m).segment(k * n_v, n_v);
        }
      }
    }
    for (Eigen::Index k = 0; k < weight_count; ++k) {
      MotionIntegralOperator& target = operators[static_cast<std::size_t>(k)];
      target.matrix.middleRows(first_row, n_v).noalias() =
          rule.weights * integrals.middleCols(k * size, size);
      target.values_of_one.segment(first_row, n_v).noalias() =
          rule.weights * integrals_of_one.col(k);
    }
  };
  base::parallel_for(displacements.size(), base::kOneThreadPerProcessor, compute_rows);
  if (deadline.has_deadline_passed()) return {};
  return operators;
}

RenewalEquation::MotionIntegral RenewalEquation::integrate_from_state(
    const PhaseState& start, const TimeSinceImpulseWeight& weight) const {
  // The node weights of the result are in the order of ChebyshevGrid::node_index(), row by row.
  Eigen::MatrixXd along(grid_.y_node_count(), grid_.v_node_count());
  Eigen::VectorXd one(1);
  integrate_along_trajectory(motion_solver_.compute_trajectory(start, max_duration_), {weight},
                             along, one);
  return {along.transpose().reshaped(), one(0)};
}

}  // namespace fpkcheck::backward
